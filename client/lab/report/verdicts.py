"""How often a solver changes who pockets what, against its rate."""

import style
from findings import has_verdicts, stepping
from results import point_of

EVENT = "event"


def _draw(axes, ensemble, rates):
    smallest = 1 / ensemble["shots"]
    for solver, points in stepping(ensemble).items():
        known = [point for point in points if point["verdict_flips"] is not None]
        if known:
            way = [(rates.index(point["hz"]), point["verdict_flips"]) for point in known]
            (line,) = axes.plot(*zip(*way), label=solver, clip_on=False, zorder=3, **style.SOLVERS[solver])
            line.set_gid(f"points-{solver}")
    event = point_of(ensemble, EVENT)
    if event and event["verdict_flips"] is not None:
        axes.axhline(event["verdict_flips"], color="#000000", linewidth=0.8, linestyle=(0, (2, 3)))
        (line,) = axes.plot([len(rates)], [event["verdict_flips"]], label=EVENT, markersize=13, clip_on=False, zorder=4,
                            **{**style.SOLVERS[EVENT], "linestyle": ""})
        line.set_gid(f"points-{EVENT}")
    style.share_axis(axes, smallest)
    axes.set_xticks(range(len(rates) + 1), [f"{rate:g}" for rate in rates] + [EVENT], rotation=90, size=9)
    axes.set_xlim(-0.4, len(rates) + 0.5)


def figure(ensembles, source):
    """Panels of the ensembles that have verdicts to change; None where none has."""
    shown = [ensemble for ensemble in ensembles if has_verdicts(ensemble)]
    if not shown:
        return None
    rates = sorted({point["hz"] for ensemble in shown for point in ensemble["points"] if point["hz"]})
    note = ("A verdict flips when a ball ends in another pocket than it should, or in one where it should in none, or the other "
            "way about. Lower is better.")
    sheet = style.panels("How many shots end with another verdict than they should", note, source, len(shown), row_height=2.8)
    for panel, ensemble in zip(sheet.axes, shown):
        _draw(panel, ensemble, rates)
        style.name_panel(panel, ensemble["title"])
    sheet.name_sides("ticks a second", "share of shots")
    sheet.legend()
    return sheet
