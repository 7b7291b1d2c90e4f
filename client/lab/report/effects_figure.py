"""What each effect costs, and what it is worth."""

import math

from matplotlib import ticker

import style
from findings import counts_instructions, price_ratio
from numbers_in_words import percent

FORMS = {
    "zero": {"label": "in the scene, at zero", "marker": "D", "markerfacecolor": "#F0E442", "color": style.MUTED},
    "present": {"label": "in the scene", "marker": "s", "color": "#D55E00"},
}
WORTH = "#009E73"
# Multiples that an axis of costs names, as many as its range needs.
MULTIPLES = (0.5, 0.7, 0.8, 0.9, 1, 1.1, 1.2, 1.5, 2, 3, 5, 10, 20, 50, 100, 200, 500, 1000)
NEAREST_TICKS = 0.12  # of the axis


def _ticks(least, most):
    """1, and of the other multiples those that leave room for their names."""
    room = NEAREST_TICKS * math.log(1.5 * most / least)
    ticks = [1]
    for tick in MULTIPLES:
        if 0.9 * least <= tick <= 1.2 * most and all(abs(math.log(tick / other)) >= room for other in ticks):
            ticks.append(tick)
    return ticks


def _costs(axes, effects):
    """A row an effect: what a shot costs with it, as a multiple of one without."""
    every = [1.0]
    for form, looks in FORMS.items():
        rows = [(price_ratio(effects, effect, form), row) for row, effect in enumerate(effects) if effect[form]]
        every += [ratio for ratio, _ in rows]
        if rows:
            (line,) = axes.plot(*zip(*rows), linestyle="", markersize=8, zorder=3, **looks)
            line.set_gid(f"points-{form}")
    for row, effect in enumerate(effects):
        axes.plot([1, price_ratio(effects, effect, "present")], [row, row], color="#BBBBBB", linewidth=2.5, zorder=1)
    axes.axvline(1, color=style.MUTED, linewidth=1.2)
    axes.set_xscale("log")
    axes.xaxis.set_major_locator(ticker.FixedLocator(_ticks(min(every), max(every))))
    axes.xaxis.set_minor_locator(ticker.NullLocator())
    axes.xaxis.set_major_formatter(ticker.FuncFormatter(lambda value, _: f"×{value:g}"))
    axes.margins(0.1, 0.08)
    axes.set_xlabel("instructions of a shot" if counts_instructions(effects) else "CPU time of a shot")
    axes.set_title("What it costs")


def _worth(axes, effects):
    """A row an effect: how far its absence moves the balls, and how many verdicts it changes."""
    known = [(row, effect["rest_change"]) for row, effect in enumerate(effects)
             if effect["rest_change"] and effect["rest_change"]["median"]]
    for row, change in known:
        axes.plot([change["median"], change["p90"]], [row, row], color=WORTH, linewidth=2.5, zorder=1)
    if known:
        (line,) = axes.plot([change["median"] for _, change in known], [row for row, _ in known], "o", color=WORTH, markersize=8)
        line.set_gid("points-worth")
        axes.set_xscale("log")
    moved = [row for row, _ in known]
    for row, effect in enumerate(effects):
        axes.annotate(percent(effect["verdict_flips"]), (1.04, row), xycoords=("axes fraction", "data"), va="center", size=10)
        if effect["rest_change"] and row not in moved:
            axes.annotate("in the median it moves none", (0.03, row), xycoords=("axes fraction", "data"), va="center",
                          size=9, color=style.MUTED)
    axes.annotate("verdicts\nchanged", (1.04, 1.01), xycoords="axes fraction", va="bottom", size=9.5)
    axes.margins(0.08, 0.08)
    if known:
        style.length_axis(axes.xaxis, 5)
    axes.set_xlabel("how far the balls' rest moves")
    axes.set_title("What it is worth")


def figure(data, source):
    """Both sides by side; None where no effect was measured."""
    effects = data["effects"]
    if not effects:
        return None
    note = ("Left: what a shot costs with the effect, as a multiple of the same shot without it (line at ×1). Right: how far "
            "leaving it out moves where the balls rest, from the median shot to the 90th percentile, and how many shots end with "
            "other balls pocketed.")
    height = max(style.SLIDE, 2.2 + 0.36 * len(effects))
    sheet = style.Sheet("Cost and worth of each effect", note, source, count=2, columns=2, height=height, sharey=True)
    costs, worth = sheet.axes
    _costs(costs, effects)
    _worth(worth, effects)
    costs.set_yticks(range(len(effects)), [f"{effect['effect']}  ({effect['ensemble']})" for effect in effects])
    costs.invert_yaxis()
    sheet.legend(order=list)
    return sheet
