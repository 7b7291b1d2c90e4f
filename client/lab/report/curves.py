"""Three figures with a curve a contender (`euler:30`): error within a shot, tunnelling, crowds."""

import math

import style
from numbers_in_words import listed, percent, times


def looks_of(labels):
    """Colour and marker by solver; dashes by how many of the same solver came before, so that they differ in grey too."""
    dashes = ("-", (0, (5, 1.5)), (0, (1.5, 1.5)), (0, (5, 1.5, 1.5, 1.5)), (0, (9, 3)), (0, (1, 4)))
    before = {}
    result = {}
    for label in labels:
        solver = label.partition(":")[0]
        number = before.setdefault(solver, 0)
        before[solver] += 1
        result[label] = {**style.SOLVERS[solver], "linestyle": dashes[number % len(dashes)],
                         "markerfacecolor": ("white" if number % 2 else style.SOLVERS[solver]["color"])}
    return result


def _curve(axes, label, looks, x, y, marks=1):
    # A logarithmic axis has no place for 0: the curve begins where there is an error.
    (line,) = axes.plot(x, [value if value > 0 or axes.get_yscale() != "log" else math.nan for value in y], label=label,
                        markevery=marks, markersize=5, clip_on=False, **looks)
    line.set_gid(f"curve-{label}")


def errors_in_time(ensembles, source):
    shown = [ensemble for ensemble in ensembles if ensemble["error_in_time"]]
    if not shown:
        return None
    looks = looks_of(style.in_order(curve["label"] for ensemble in shown for curve in ensemble["error_in_time"]))
    note = ("How far the balls are from where they should be at that time, in the median shot. Where the curves rise together, "
            "one collision after the other multiplies whatever error there is.")
    sheet = style.panels("How the error grows within a shot", note, source, len(shown),
                         columns=2 if len(shown) in (2, 4) else 3, row_height=2.8)
    for panel, ensemble in zip(sheet.axes, shown):
        panel.set_yscale("log")
        curves = {curve["label"]: curve for curve in ensemble["error_in_time"]}
        for label in style.in_order(curves):
            curve = curves[label]
            _curve(panel, label, looks[label], curve["t"], curve["median"], max(1, len(curve["t"]) // 8))
        style.length_axis(panel.yaxis, 8)
        style.name_panel(panel, ensemble["title"])
        panel.set_xlim(left=0)
    sheet.name_sides("time since the strike (s)", "error at that time, median")
    sheet.legend()
    return sheet


def _most_missed(curves):
    """The title: the fastest balls, for those who miss most and for those who miss none."""
    known = [curve for curve in curves if curve["missed"]]
    worst = max(known, key=lambda curve: curve["missed"][-1], default=None)
    if not worst or not worst["missed"][-1]:
        return "Collisions that a solver does not see, by speed"
    none = [curve["label"] for curve in known if not any(curve["missed"])]
    rest = f"; {listed(none)} none" if none else ""
    return f"At {worst['speed'][-1]:g} m/s {worst['label']} misses {percent(worst['missed'][-1])} of the collisions{rest}"


def tunnelling(accuracy, source):
    if not accuracy["tunnelling"]:
        return None
    curves = {curve["label"]: curve for curve in accuracy["tunnelling"]}
    looks = looks_of(style.in_order(curves))
    sheet = style.Sheet(
        _most_missed(curves.values()),
        "A solver that looks for overlaps only at the end of each tick lets fast balls pass through each other: they tunnel.",
        source)
    (axes,) = sheet.axes
    for label in style.in_order(curves):
        _curve(axes, label, looks[label], curves[label]["speed"], [100 * share for share in curves[label]["missed"]])
    axes.set_xlabel("speed of the ball (m/s)")
    axes.set_ylabel("collisions missed (%)")
    axes.set_ylim(bottom=0)
    axes.set_xlim(left=0)
    sheet.legend()
    return sheet


def _growth(curves):
    """The title: how much dearer the largest crowd is than the smallest, where it grows least and most."""
    ratios = sorted((curve["ns"][-1] / curve["ns"][0], curve["label"]) for curve in curves if len(curve["balls"]) > 1)
    sizes = {(curve["balls"][0], curve["balls"][-1]) for curve in curves if curve["balls"]}
    if not ratios or len(sizes) != 1:
        return "What a shot costs as balls are added"
    ((first, last),) = sizes
    growth = " to ".join(f"{times(ratio)}-fold ({label})" for ratio, label in dict.fromkeys((ratios[0], ratios[-1])))
    return f"From {first} balls to {last}, what a shot costs grows {growth}"


def crowds(accuracy, source):
    if not accuracy["crowds"]:
        return None
    curves = {curve["label"]: curve for curve in accuracy["crowds"]}
    looks = looks_of(style.in_order(curves))
    sheet = style.Sheet(
        _growth(curves.values()), "The thin line shows a cost that grows as the number of balls does.", source)
    (axes,) = sheet.axes
    axes.set_xscale("log", base=2)
    axes.set_yscale("log")
    for label in style.in_order(curves):
        _curve(axes, label, looks[label], curves[label]["balls"], curves[label]["ns"])
    _proportional(axes, curves.values())
    style.time_axis(axes.yaxis)
    balls = sorted({count for curve in curves.values() for count in curve["balls"]})
    axes.set_xticks(balls, [str(count) for count in balls])
    axes.minorticks_off()
    axes.set_xlabel("balls on the table")
    axes.set_ylabel("CPU time of a shot")
    sheet.legend()
    return sheet


def _proportional(axes, curves):
    """From the cheapest first point on, as a measure for the eye."""
    known = [curve for curve in curves if curve["balls"]]
    if known:
        first = min(known, key=lambda curve: curve["ns"][0])
        most = max(max(curve["balls"]) for curve in known)
        start, ns = first["balls"][0], first["ns"][0]
        axes.plot([start, most], [ns, ns * most / start], color=style.MUTED, linewidth=0.7)
