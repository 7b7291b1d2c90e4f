"""The report's tables, in Markdown."""

import re

from findings import BOUNDS, ENOUGH_FLIPS, cheapest_within, has_verdicts, rate_of_few_flips, stepping, tenfold
from numbers_in_words import NOTHING, metres, percent, plain, quantity, time_of_ns, times
from results import median_of, point_of, solvers_of

RATES = (30, 120, 480, 1920)


def table(heads, rows):
    """Rows of words below their heads; columns of numbers to the right."""
    rule = ["---:" if all(re.match(r"-?\d|–", row[column]) for row in rows) else "---" for column in range(len(heads))]
    return "\n".join("| " + " | ".join(row) + " |" for row in [heads, rule, *rows])


def _chosen(ensemble):
    """The points of RATES, and the event solver."""
    return [point for points in solvers_of(ensemble).values() for point in points if point["hz"] in (*RATES, None)]


def _spread(point, name):
    spread = point.get(name)
    return [metres(spread[part]) for part in ("median", "p90", "max")] if spread else [NOTHING] * 3


def main_table(ensemble):
    """Cost, errors and verdicts of one ensemble."""
    heads = ["solver", "time a shot", "worst tick", "error at rest: median", "90th percentile", "largest", "verdicts flipped",
             "winners flipped", "events that match", "missed a shot", "invented a shot"]
    rows = [[f"`{point['label']}`", time_of_ns(point["cost"]["ns"]), time_of_ns(point["cost"].get("worst_tick_ns")),
             *_spread(point, "rest_error"), percent(point["verdict_flips"]), percent(point.get("winner_flips")),
             percent((point.get("matching_events") or {}).get("share")), plain(point.get("missed"), 2),
             plain(point.get("invented"), 2)]
            for point in _chosen(ensemble)]
    return _without_empty(heads, rows)


def _without_empty(heads, rows):
    kept = [column for column in range(len(heads)) if column < 2 or any(row[column] != NOTHING for row in rows)]
    return table([heads[column] for column in kept], [[row[column] for column in kept] for row in rows])


def impacts_table(ensemble):
    """Errors of the first impact and of the energy, or None where none was measured."""
    names = ("impact_time_error", "impact_place_error", "impact_velocity_error", "energy_drift")
    points = [point for point in _chosen(ensemble) if any(point.get(name) for name in names)]
    if not points:
        return None
    rows = [[f"`{point['label']}`", quantity(median_of(point, names[0]), "s"), metres(median_of(point, names[1])),
             quantity(median_of(point, names[2]), "m/s"), plain(median_of(point, names[3]))] for point in points]
    return _without_empty(["solver", "first impact: time", "place", "velocity", "energy, of that at the start"], rows)


def bounds_table(ensemble):
    """The cheapest way to some accuracies, solver by solver."""
    rows = []
    for solver, points in solvers_of(ensemble).items():
        cells = []
        for bound in BOUNDS:
            point = cheapest_within(points, bound)
            rate = f" ({point['hz']:g} Hz)" if point and point["hz"] else ""
            cells.append(f"{time_of_ns(point['cost']['ns'])}{rate}" if point else NOTHING)
        rows.append([f"`{solver}`", *cells])
    return table(["solver", *(f"to {metres(bound, 1)}" for bound in BOUNDS)], rows)


def tenfold_table(ensembles):
    """What a tenth of the error costs, in times the time, with the rates between which it was measured."""
    solvers = list(dict.fromkeys(solver for ensemble in ensembles for solver in stepping(ensemble)))
    rows = []
    for ensemble in ensembles:
        prices = [tenfold(stepping(ensemble).get(solver, [])) for solver in solvers]
        rows.append([ensemble["title"], *(f"{times(price[0])} ({price[1]:g} to {price[2]:g} Hz)" if price else NOTHING
                                          for price in prices)])
    return table(["ensemble", *(f"`{solver}`" for solver in solvers)], rows)


def _fit_in_words(fit):
    if not fit or fit["order"] is None:
        return NOTHING
    known = fit["low"] is not None and fit["high"] is not None
    return f"{fit['order']:.2f}" + (f" ({fit['low']:.2f} to {fit['high']:.2f})" if known else "")


def orders_table(ensembles):
    """All fitted orders with their confidence, a column an error; None where none was fitted."""
    quantities = list(dict.fromkeys(fit["quantity"] for ensemble in ensembles for fit in ensemble["orders"]))
    rows = []
    for ensemble in ensembles:
        fits = {(fit["solver"], fit["quantity"]): fit for fit in ensemble["orders"]}
        for solver in dict.fromkeys(solver for solver, _ in fits):
            known = [fits.get((solver, quantity)) for quantity in quantities]
            expected = next((fit["expected"] for fit in known if fit and fit.get("expected") is not None), None)
            rows.append([ensemble["title"], f"`{solver}`", *map(_fit_in_words, known), plain(expected, 1)])
    heads = ["ensemble", "solver", *(quantity.replace("_", " ") for quantity in quantities), "expected"]
    return table(heads, rows) if rows else None


def flips_table(ensembles):
    """Share of shots whose verdict flips, or None where none ever does."""
    rows = []
    for ensemble in filter(has_verdicts, ensembles):
        event = point_of(ensemble, "event")
        for solver, points in stepping(ensemble).items():
            chosen = [point_of(ensemble, f"{solver}:{rate}") for rate in RATES]
            rate = rate_of_few_flips(points)
            rows.append([ensemble["title"], f"`{solver}`",
                         *(percent(point["verdict_flips"]) if point else NOTHING for point in [*chosen, event]),
                         f"{rate:g} Hz" if rate else "no rate here"])
    heads = ["ensemble", "solver", *(f"{rate} Hz" for rate in RATES), "`event`", f"under {100 * ENOUGH_FLIPS:g} % from"]
    return table(heads, rows) if rows else None


def _horizon(point):
    seconds = (point.get("matching_events") or {}).get("horizon_median") if point else None
    return NOTHING if seconds is None else f"{plain(seconds)} s"


def horizons_table(ensembles):
    """Until when the events are the reference's, in the median shot, at 30 Hz and at each solver's highest rate."""
    rows = []
    for ensemble in ensembles:
        for solver, points in solvers_of(ensemble).items():
            first = point_of(ensemble, f"{solver}:30") if points[-1]["hz"] else None
            row = [_horizon(first), _horizon(points[-1])]
            if row != [NOTHING] * 2:
                rows.append([ensemble["title"], f"`{solver}`", *row, f"{points[-1]['hz']:g} Hz" if points[-1]["hz"] else NOTHING])
    return table(["ensemble", "solver", "at 30 Hz", "at its highest rate", "which is"], rows) if rows else None


def effects_table(data):
    """Cost in the three forms, and worth."""
    rows = []
    for effect in data["effects"]:
        absent, zero, present = effect["absent"], effect["zero"] or {}, effect["present"]
        change = effect["rest_change"] or {}
        rows.append([effect["effect"], effect["ensemble"].replace("_", " "), time_of_ns(absent["ns_per_shot"]),
                     time_of_ns(zero.get("ns_per_shot")), time_of_ns(present["ns_per_shot"]),
                     plain(present["ns_per_shot"] / absent["ns_per_shot"]), metres(change.get("median")),
                     metres(change.get("p90")), percent(effect["verdict_flips"])])
    heads = ["effect", "ensemble", "a shot without", "at zero", "with it", "ratio", "moves the rest by (median)",
             "90th percentile", "verdicts changed"]
    return table(heads, rows) if rows else None


def instructions_table(data):
    """Instructions in the three forms, a shot and a ball-step; None where they were not counted."""
    rows = []
    for effect in data["effects"]:
        forms = [effect["absent"], effect["zero"] or {}, effect["present"]]
        shots = [form.get("instructions_per_shot") for form in forms]
        if shots[0] is None or shots[2] is None:
            continue
        steps = [form.get("instructions_per_ball_step") for form in forms]
        rows.append([effect["effect"], effect["ensemble"].replace("_", " "), *map(_whole, shots), plain(shots[2] / shots[0]),
                     *map(_whole, steps)])
    heads = ["effect", "ensemble", "a shot without", "at zero", "with it", "ratio", "a ball-step without", "at zero", "with it"]
    return table(heads, rows) if rows else None


def _whole(instructions):
    return NOTHING if instructions is None else f"{instructions:,.0f}"


def _cost(cost):
    return [time_of_ns(cost["ns"] if cost else None), _whole(cost.get("instructions") if cost else None)]


def kernels_table(data):
    """What each kernel costs."""
    rows = [[f"`{kernel['kernel']}`", kernel.get("ensemble", NOTHING).replace("_", " "), *_cost(kernel["per_ball_step"]),
             *_cost(kernel["per_event"]), *_cost(kernel["per_shot"]), _cost(kernel.get("per_shot_by_everything"))[0]]
            for kernel in data["kernels"]]
    heads = ["kernel", "ensemble", "a ball-step", "instructions", "an event", "instructions", "a shot", "instructions",
             "the same by `everything`"]
    return _without_empty(heads, rows) if rows else None
