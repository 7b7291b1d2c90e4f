"""What the numbers say: fronts, thresholds and exchange rates. Pure functions of what accuracy.json holds."""

import math

from results import median_of, solvers_of

# Said to be good enough for play: balls at rest within this of where they belong, and so few verdicts changed.
ENOUGH_ERROR = 1e-3  # m
ENOUGH_FLIPS = 0.01
# Accuracies that a reader may want, m.
BOUNDS = (1e-2, 1e-3, 1e-6, 1e-9)


def measured(ensemble):
    """The points of an ensemble that have a rest error."""
    return [point for point in ensemble["points"] if median_of(point, "rest_error") is not None]


def pareto_front(ensemble):
    """The points that no other beats in both median rest error and cost; cheapest first."""
    front = []
    for point in sorted(measured(ensemble), key=lambda point: (point["cost"]["ns"], median_of(point, "rest_error"))):
        if not front or median_of(point, "rest_error") < median_of(front[-1], "rest_error"):
            front.append(point)
    return front


def counts_instructions(effects):
    """Whether instructions were counted of all; they compare effects better than times, which scatter."""
    return all(effect[form].get("instructions_per_shot") for effect in effects for form in ("absent", "zero", "present")
               if effect[form])


def price_ratio(effects, effect, form):
    """How many times what a shot without the effect costs one in the form `zero` or `present` does: instructions, or else time."""
    unit = "instructions_per_shot" if counts_instructions(effects) else "ns_per_shot"
    return effect[form][unit] / effect["absent"][unit]


def is_good_enough(point):
    """In the median within ENOUGH_ERROR, and fewer than ENOUGH_FLIPS of the verdicts changed, where there are verdicts."""
    error = median_of(point, "rest_error")
    return error is not None and error < ENOUGH_ERROR and (point["verdict_flips"] or 0) < ENOUGH_FLIPS


def cheapest_within(points, bound):
    """The cheapest point whose median rest error is at most `bound`, or None."""
    good = [point for point in points if median_of(point, "rest_error") is not None and median_of(point, "rest_error") <= bound]
    return min(good, key=lambda point: point["cost"]["ns"], default=None)


def tenfold(points):
    """(factor in cost for a tenth of the error, the rate it starts at, the rate it ends at), or None.

    From the rate with the largest median rest error to the one with the smallest, the error falls E times while the cost
    grows C times: C^(1 / log10 E). None where E is below ten, and where an error is 0."""
    known = [point for point in points if median_of(point, "rest_error")]
    if len(known) < 2:
        return None
    worst = max(known, key=lambda point: (median_of(point, "rest_error"), point["hz"]))
    best = min(known, key=lambda point: (median_of(point, "rest_error"), point["hz"]))
    fall = median_of(worst, "rest_error") / median_of(best, "rest_error")
    if fall < 10 or best["hz"] < worst["hz"]:
        return None
    growth = best["cost"]["ns"] / worst["cost"]["ns"]
    return growth ** (1 / math.log10(fall)), worst["hz"], best["hz"]


def rate_of_few_flips(points):
    """The lowest rate from which on fewer than ENOUGH_FLIPS of the verdicts change, or None."""
    rate = None
    for point in sorted(points, key=lambda point: -point["hz"]):
        if point["verdict_flips"] is None or point["verdict_flips"] >= ENOUGH_FLIPS:
            break
        rate = point["hz"]
    return rate


def has_verdicts(ensemble):
    """Whether any solver ever changes a verdict, so that there is something to draw."""
    return any(point["verdict_flips"] for point in ensemble["points"])


def stepping(ensemble):
    """The groups of solvers_of without the event solver, which has no rate."""
    return {solver: points for solver, points in solvers_of(ensemble).items() if solver != "event"}
