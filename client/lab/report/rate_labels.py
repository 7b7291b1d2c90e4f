"""Puts a point's rate beside it, where it hides least."""

import numpy as np

SIZE = 7.5
# Ways out from a point, in points of type: above to the right first, where a falling line leaves room.
OFFSETS = [(reach * x, reach * y) for reach in (1, 1.4, 2, 3)
           for x, y in ((1, 8), (-1, -8), (6, 4), (-6, -4), (-1, 8), (1, -8), (6, -4), (-6, 4), (7, 0), (-7, 0))]


def _along(line, step=5):
    """Small boxes along a line, in pixels: x0, y0, x1, y1."""
    spots = []
    for start, end in zip(line, line[1:]):
        count = max(1, int(np.abs(end - start).max() / step))
        spots += [start + (end - start) * number / count for number in range(1, count)]
    return _boxes(spots, 1)


def _boxes(centres, half):
    centres = np.reshape(centres, (-1, 2))
    return np.hstack([centres - half, centres + half])


def _overlap(box, others):
    """The area of the box that the others cover, in all."""
    sides = np.minimum(box[2:], others[:, 2:]) - np.maximum(box[:2], others[:, :2])
    return float(np.prod(np.maximum(sides, 0), axis=1).sum())


def place(axes, lines):
    """`lines`: (line in data coordinates, labels, colour) for each solver. The layout must be final."""
    scale = axes.figure.dpi / 72
    renderer = axes.figure.canvas.get_renderer()
    pixels = [axes.transData.transform(points) for points, _, _ in lines]
    marks = _boxes(np.concatenate([*pixels, np.empty((0, 2))]), 4 * scale)
    ways = np.concatenate([*map(_along, pixels), np.empty((0, 4))])
    inside = np.array([axes.bbox.extents])
    taken = np.empty((0, 4))
    for (points, labels, color), line in zip(lines, pixels):
        for point, label, pixel in zip(points, labels, line):
            text = axes.annotate(label, point, xytext=(0, 0), textcoords="offset points", size=SIZE, color=color,
                                 ha="center", va="center", annotation_clip=False)
            text.set_gid(f"rate-{label}")
            extent = text.get_window_extent(renderer)
            half = np.array([extent.width, extent.height]) / 2

            def box_at(offset):
                centre = pixel + np.array(offset) * scale + (np.sign(offset[0]) * half[0], 0)
                return np.concatenate([centre - half, centre + half])

            def badness(offset):
                box = box_at(offset)
                outside = 4 * half.prod() - _overlap(box, inside)
                return (8 * _overlap(box, taken) + 4 * _overlap(box, marks) + _overlap(box, ways) + 8 * outside
                        + 6 * np.abs(offset).sum())

            best = box_at(min(OFFSETS, key=badness))
            taken = np.vstack([taken, best])
            text.set_position(((best[:2] + best[2:]) / 2 - pixel) / scale)
