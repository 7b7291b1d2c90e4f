"""What the figures show, in sentences whose numbers and verdicts are computed."""

from findings import (ENOUGH_ERROR, ENOUGH_FLIPS, counts_instructions, has_verdicts, is_good_enough, measured, pareto_front,
                      price_ratio, stepping, tenfold)
from numbers_in_words import listed, metres, percent, plain, time_of_ns, times
from results import median_of, point_of

# The same shots timed twice differ by 15 % on a quiet machine, and by 30 % on a busy one.
NOTICEABLE = 1.25
# A smaller share of instructions is not told.
LEAST_SAID = 1e-4


def _runs(points):
    """Points as people say them: `euler at 15 to 60 Hz, event`."""
    groups = []
    for point in points:
        if groups and groups[-1][0] == point["solver"]:
            groups[-1][1].append(point["hz"])
        else:
            groups.append((point["solver"], [point["hz"]]))
    said = []
    for solver, rates in groups:
        known = sorted(rate for rate in rates if rate)
        at = "" if not known else f" at {known[0]:g} Hz" if len(known) == 1 else f" at {known[0]:g} to {known[-1]:g} Hz"
        said.append(f"`{solver}`{at}")
    return listed(said)


def front_of(ensemble):
    """Who is on the Pareto front of one ensemble, and what that means when it is one point."""
    front = pareto_front(ensemble)
    if not front:
        return "no rest error was measured."
    if len(front) == 1:
        return f"{_runs(front)} is both the cheapest and the most exact; nothing else is on the front."
    return f"on the front, from cheap to exact: {_runs(front)}."


def event_beside_euler(ensemble):
    """How the event solver compares with Euler at 30 Hz, or None where one is missing."""
    event, euler = point_of(ensemble, "event"), point_of(ensemble, "euler:30")
    if not event or not euler or None in (median_of(event, "rest_error"), median_of(euler, "rest_error")):
        return None
    ratio = event["cost"]["ns"] / euler["cost"]["ns"]
    dearer = f"{times(ratio)} times the time" if ratio >= 1 else f"{percent(ratio)} of the time"
    error, other = median_of(event, "rest_error"), median_of(euler, "rest_error")
    if error and other > error:
        exact = f"{times(other / error)} times as exact"
    elif error > other:
        exact = "less exact"
    else:
        exact = "without error" if not error and other else "as exact"
    return (f"`event` takes {dearer} of `euler:30` ({time_of_ns(event['cost']['ns'])} against {time_of_ns(euler['cost']['ns'])}) "
            f"and is {exact} ({metres(error)} against {metres(other)}).")


def where_euler_is_enough(ensembles, label="euler:30"):
    """In which ensembles Euler at 30 Hz is good enough for play, and in which it is not and why."""
    good, bad = [], []
    for ensemble in ensembles:
        point = point_of(ensemble, label)
        if not point or median_of(point, "rest_error") is None:
            continue
        if is_good_enough(point):
            good.append(ensemble["title"])
        else:
            flips = f", {percent(point['verdict_flips'])} flipped" if has_verdicts(ensemble) else ""
            bad.append(f"{ensemble['title']} ({metres(median_of(point, 'rest_error'))}{flips})")
    bound = f"a median rest error under {metres(ENOUGH_ERROR, 1)} and under {100 * ENOUGH_FLIPS:g} % of verdicts flipped"
    enough = f"Good enough ({bound}): {listed(good)}." if good else f"Good enough ({bound}) in no ensemble."
    return f"{enough} Not good enough: {listed(bad)}." if bad else f"{enough} There is none where it is not."


def who_wins(ensembles, label="euler:30"):
    """Where the winner is another, for the ensembles that have winners."""
    said = []
    for ensemble in ensembles:
        point = point_of(ensemble, label)
        if point and point.get("winner_flips") is not None:
            share = point["winner_flips"]
            said.append(f"{ensemble['title']}: in {percent(share)} of {ensemble['shots']} shots" if share
                        else f"{ensemble['title']}: never in {ensemble['shots']} shots")
    return f"`{label}` changes who wins: {'; '.join(said)}." if said else "No ensemble here has a winner to change."


def price_of_ten(ensemble):
    """What a tenth of the error costs by each solver."""
    prices = {solver: tenfold(points) for solver, points in stepping(ensemble).items()}
    said = listed(f"`{solver}` {times(price[0])}" for solver, price in prices.items() if price)
    never = listed(f"`{solver}`" for solver, price in prices.items() if not price)
    parts = [f"a tenth of the error costs {said} times the time"] if said else []
    parts += [f"{never} did not become ten times as exact at any rate measured"] if never else []
    return "; ".join(parts) + "." if parts else None


def orders_missed(accuracy):
    """Orders that are not within 10 % of what theory expects, each with its note; those that could not be fitted, note by note."""
    missed, unfitted = [], {}
    for ensemble in accuracy["ensembles"]:
        for fit in ensemble["orders"]:
            expected, order = fit.get("expected"), fit["order"]
            if expected is None or (order is not None and abs(order - expected) <= 0.1 * expected):
                continue
            quantity, note = fit["quantity"].replace("_", " "), f": {fit['note']}" if fit.get("note") else ""
            if order is None:
                solvers = unfitted.setdefault((quantity, note), {})
                solvers.setdefault(ensemble["title"], []).append(f"`{fit['solver']}`")
                continue
            missed.append(f"{ensemble['title']}, `{fit['solver']}`, {quantity}: {order:.2f} where {plain(expected, 1)} is expected{note}")
    for (quantity, note), solvers in unfitted.items():
        where = "; ".join(f"{title} ({', '.join(names)})" for title, names in solvers.items())
        missed.append(f"No order could be fitted of {quantity}{note}. {where}")
    return missed


def simplest(accuracy):
    """The short answer to which solver to choose: where the event solver is the most exact, and where the cheapest too."""
    alone = [ensemble["title"] for ensemble in accuracy["ensembles"]
             if len(pareto_front(ensemble)) == 1 and pareto_front(ensemble)[0]["solver"] == "event"]
    fronts = [pareto_front(ensemble) for ensemble in accuracy["ensembles"] if measured(ensemble)]
    exact = sum(1 for front in fronts if front[-1]["solver"] == "event")
    said = f"The event solver is the most exact in {exact} of {len(fronts)} ensembles"
    return f"{said}, and in {listed(alone)} also the cheapest." if alone else f"{said}, and in none also the cheapest."


def effects_in_words(effects):
    """The dearest effect, the one that moves most, and what it costs to name one that does nothing."""
    dearest = max(effects, key=lambda effect: price_ratio(effects, effect, "present"))
    price = "as many instructions" if counts_instructions(effects) else "as long"
    said = [f"The dearest effect is {dearest['effect']}: a shot of {dearest['ensemble'].replace('_', ' ')} takes "
            f"{times(price_ratio(effects, dearest, 'present'))} times {price} with it as without."]
    moving = [effect for effect in effects if effect["rest_change"]]
    if moving:
        worth = max(moving, key=lambda effect: effect["rest_change"]["median"])
        said.append(f"Most is lost without {worth['effect']}: in the median shot of {worth['ensemble'].replace('_', ' ')} a ball "
                    f"rests {metres(worth['rest_change']['median'])} away, and {percent(worth['verdict_flips'])} of the verdicts change.")
    if any(effect["zero"] for effect in effects):
        said.append(_idle_in_words(effects))
    return " ".join(said)


def _idle_in_words(effects):
    """What it costs to name an effect that does nothing."""
    ratio, dearest = max((price_ratio(effects, effect, "zero"), effect["effect"]) for effect in effects if effect["zero"])
    if counts_instructions(effects):
        if ratio - 1 < LEAST_SAID:
            return "An effect that a scene names at zero takes no more instructions than one that it leaves out."
        return (f"An effect that a scene names at zero takes at most {percent(ratio - 1)} more instructions than one that it leaves "
                f"out ({dearest}), for the same shot.")
    if ratio > NOTICEABLE:
        return (f"An effect that a scene names at zero is paid for all the same: up to {times(ratio)} times the time ({dearest}), "
                "for the same shot.")
    return "An effect that a scene names at zero costs no more than one that it leaves out, within the scatter of times."
