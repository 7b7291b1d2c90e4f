"""Error against cost, the habit of the field (Hairer, Nørsett, Wanner, "Solving Ordinary Differential Equations I", II.10)."""

import rate_labels
import style
from findings import measured
from measurements import unknown_of
from numbers_in_words import metres, time_of_ns
from results import median_of, point_of, solvers_of

ERROR = "error at rest, median"
COST = "CPU time of a shot"
HOW_TO_READ = "Error: how far the balls rest from where they should. Down is more exact, left is cheaper."
BANDS = "Shaded: what is not known of a shot on a table, however it is computed."


def seen(ensemble):
    """The title: the event solver beside Euler at 30 Hz where there are both."""
    event, euler = point_of(ensemble, "event"), point_of(ensemble, "euler:30")
    if not event or not euler or None in (median_of(event, "rest_error"), median_of(euler, "rest_error")):
        return f"{ensemble['title']}: error against cost"
    return (f"{ensemble['title']}: event {metres(median_of(event, 'rest_error'), 2)} off in {time_of_ns(event['cost']['ns'], 2)}"
            f" a shot, euler at 30 Hz {metres(median_of(euler, 'rest_error'), 2)} in {time_of_ns(euler['cost']['ns'], 2)}")


def _zero(ensemble):
    """Where an error of 0 is drawn on the logarithmic axis: a decade below the least other."""
    errors = [median_of(point, "rest_error") for point in measured(ensemble)]
    return min([error for error in errors if error], default=1e-15) / 10 if 0 in errors else None


def draw(axes, ensemble, ticks):
    """A line a solver; its gid is `points-SOLVER`. `ticks`: at most so many on each axis.

    Returns the lines drawn, for their labels."""
    zero = _zero(ensemble)
    lines = []
    for solver, points in solvers_of(ensemble).items():
        known = [point for point in points if median_of(point, "rest_error") is not None]
        if not known:
            continue
        way = [(point["cost"]["ns"], median_of(point, "rest_error") or zero) for point in known]
        looks = {**style.SOLVERS[solver], **({"linestyle": ""} if len(way) == 1 else {})}
        size = 15 if solver == "event" else None
        (line,) = axes.plot(*zip(*way), label=solver, markersize=size, clip_on=False, zorder=3, **looks)
        line.set_gid(f"points-{solver}")
        lines.append((way, ["" if point["hz"] is None else f"{point['hz']:g}" for point in known], style.ink(solver)))
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.margins(0.07, 0.09)
    style.time_axis(axes.xaxis, ticks[0])
    style.length_axis(axes.yaxis, ticks[1], zero)
    return lines


def _bands(axes, ensemble, validate):
    """What is not known of the ensemble's shots, where that is something."""
    unknown = unknown_of(validate, ensemble["name"])
    if unknown is None or not unknown["placement"]["median"]:
        return
    top = max(axes.get_ylim()[1], 2 * unknown["coefficients"]["median"])
    for part, shade, label in (("placement", "#F3E9D2", "balls 0.1 mm off"), ("coefficients", "#E0D3B0", "another table's coefficients")):
        band = axes.axhspan(max(unknown[part]["median"], 1e-18), top, color=shade, zorder=0, label=label)
        band.set_gid(f"band-{part}")
    axes.set_ylim(top=top)


def figure(ensemble, validate, source):
    """One ensemble, every point with its rate."""
    note = f"{HOW_TO_READ} Numbers at the points are ticks a second; event has none."
    if unknown_of(validate, ensemble["name"]):
        note += f" {BANDS}"
    sheet = style.Sheet(seen(ensemble), note, source)
    (axes,) = sheet.axes
    lines = draw(axes, ensemble, (7, 9))
    _bands(axes, ensemble, validate)
    axes.set_xlabel(COST)
    axes.set_ylabel(ERROR)
    sheet.legend(order=_solvers_first)
    sheet.settle()
    rate_labels.place(axes, [line for line in lines if line[1] != [""]])
    return sheet


def _solvers_first(labels):
    """Solvers in their order, then the bands."""
    solvers = style.in_order(label for label in labels if label in style.SOLVERS)
    return solvers + [label for label in labels if label not in style.SOLVERS]


def overview(ensembles, validate, source):
    """All ensembles as small multiples."""
    note = f"{HOW_TO_READ} A line runs from the lowest rate, left, to the highest."
    if validate:
        note += f" {BANDS}"
    title = "What accuracy costs in time, ensemble by ensemble"
    sheet = style.panels(title, note, source, len(ensembles))
    for panel, ensemble in zip(sheet.axes, ensembles):
        draw(panel, ensemble, (5, 7))
        _bands(panel, ensemble, validate)
        style.name_panel(panel, ensemble["title"])
        for line in panel.lines:
            line.set_markersize(line.get_markersize() * 0.65)
    sheet.name_sides(COST, ERROR)
    sheet.legend(order=_solvers_first)
    return sheet
