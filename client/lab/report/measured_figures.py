"""Published points and curves beside those of the models."""

import style

# Okabe and Ito's palette; dashes tell the same in grey.
COLOURS = ("#D55E00", "#0072B2", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#777777", "#882255")
DASHES = ("-", (0, (5, 1.5)), (0, (1.5, 1.5)), (0, (5, 1.5, 1.5, 1.5)))
POINTS = ("o", "^", "s", "D", "v", "P", "X", "<")


def figure(one, source):
    """Published points and curves in black, the models in colour."""
    sheet = style.Sheet(one["title"], one["note"], source)
    (axes,) = sheet.axes
    number = 0
    for curve in one["curves"]:
        looks = {"color": "#000000", "linewidth": 2.2, "marker": "*", "markersize": 13}
        if not curve["published"]:
            looks = {"color": COLOURS[number % len(COLOURS)], "marker": POINTS[number % len(POINTS)], "markersize": 6}
            number += 1
        if curve["points"]:
            looks["linestyle"] = ""
        else:
            looks["marker"] = ""
            looks["linestyle"] = "-" if curve["published"] else DASHES[number % len(DASHES)]
        (line,) = axes.plot(curve["x"], curve["y"], label=curve["label"], clip_on=False, **looks)
        line.set_gid(f"curve-{curve['label']}")
    if any(value < 0 for curve in one["curves"] for value in curve["y"]):
        axes.axhline(0, color=style.MUTED, linewidth=0.8)
    axes.set_xlabel(one["x"])
    axes.set_ylabel(one["y"])
    sheet.legend(order=list, columns=2 if max(len(curve["label"]) for curve in one["curves"]) > 30 else 3)
    return sheet
