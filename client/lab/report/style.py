"""How every figure looks: type, colours, axes in units that people say, and files that are the same for the same numbers."""

import textwrap

import matplotlib
import numpy as np
from PIL import Image
from matplotlib import ticker
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from numbers_in_words import metres, time_of_ns

# Okabe and Ito's palette ("Color Universal Design", 2008); markers and dashes tell the same in grey.
SOLVERS = {
    "euler": {"color": "#D55E00", "marker": "o", "linestyle": "-"},
    "semi_implicit": {"color": "#E69F00", "marker": "^", "linestyle": "--"},
    "exact_arc": {"color": "#0072B2", "marker": "s", "linestyle": "-."},
    "overlap": {"color": "#CC79A7", "marker": "X", "linestyle": ":"},
    "event": {"color": "#000000", "marker": "*", "linestyle": (0, (5, 1, 1, 1, 1, 1))},
}
MUTED = "#555555"
WIDTH = 10  # inches: a slide of 16:9 at 160 dots an inch is 1600 by 900
SLIDE = 5.625
DPI = 160

# A user's own matplotlibrc would change the figures.
matplotlib.rcdefaults()
matplotlib.rcParams.update({
    "font.family": "DejaVu Sans", "font.size": 11, "axes.titlesize": 12, "axes.labelsize": 12, "legend.fontsize": 10.5,
    "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True, "axes.axisbelow": True,
    "grid.color": "#DDDDDD", "grid.linewidth": 0.7, "lines.linewidth": 1.6, "lines.markersize": 6.5,
    "legend.frameon": False, "svg.fonttype": "path", "svg.hashsalt": "poolhall",
})


def ink(solver):
    """The solver's colour, dark enough for small type on white."""
    return tuple(0.62 * part for part in matplotlib.colors.to_rgb(SOLVERS[solver]["color"]))


def in_order(labels):
    """Labels such as `euler:30`: solvers in one order everywhere, slowest rates first."""
    solvers = list(SOLVERS)

    def place(label):
        solver, _, rate = label.partition(":")
        return solvers.index(solver), float(rate or 0)

    return sorted(set(labels), key=place)


class Sheet:
    """A figure with what is seen as its title, how to read it and the legend below, and where it comes from at its foot.

    `axes` are those of its panels, row by row; places that `count` leaves over stay empty."""

    def __init__(self, title, note, source, *, count=1, columns=1, height=SLIDE, **subplots):
        columns = min(columns, count)
        self.fig = Figure(figsize=(WIDTH, height), dpi=DPI, layout="constrained")
        FigureCanvasAgg(self.fig)
        self.height = height
        self.top = 0.12  # inches from the upper edge that are taken
        self._lines(title, 84, 0.27, size=14, weight="bold")
        self._lines(note, 118, 0.2, size=10.5, color=MUTED)
        self.bottom = 0.1
        for line in reversed(textwrap.wrap(source, 165)):
            self.fig.text(0.012, self.bottom / height, line, size=7.5, color=MUTED)
            self.bottom += 0.15
        grid = self.fig.subplots(-(-count // columns), columns, squeeze=False, **subplots)
        self.axes = list(grid.flat)[:count]
        self.columns = columns
        for spare in list(grid.flat)[count:]:
            spare.remove()
        self._leave_room()

    def _lines(self, text, letters, step, **looks):
        for line in textwrap.wrap(text, letters):
            self.fig.text(0.012, 1 - self.top / self.height, line, va="top", **looks)
            self.top += step

    def _leave_room(self):
        margin = 0.08
        rest = 1 - (self.top + self.bottom + 2 * margin) / self.height
        self.fig.get_layout_engine().set(rect=(0.005, (self.bottom + margin) / self.height, 0.99, rest), h_pad=0.06, w_pad=0.06)

    def name_sides(self, x, y):
        """The names of all panels' axes, said once a column and once a row."""
        for number, panel in enumerate(self.axes):
            if number + self.columns >= len(self.axes):
                panel.set_xlabel(x)
            if number % self.columns == 0:
                panel.set_ylabel(y)

    def legend(self, order=in_order, columns=5):
        """Of all panels, each label once, above them, where it hides no point."""
        handles = {}
        for panel in self.axes:
            for handle, label in zip(*panel.get_legend_handles_labels()):
                handles.setdefault(label, handle)
        labels = order(handles)
        columns = min(columns, len(labels))
        # matplotlib fills columns; readers read rows.
        rows = -(-len(labels) // columns)
        places = [row * columns + column for column in range(columns) for row in range(rows)]
        labels = [labels[place] for place in places if place < len(labels)]
        self.fig.legend([handles[label] for label in labels], labels, loc="upper left", ncol=columns, handlelength=3,
                        bbox_to_anchor=(0.005, 1 - (self.top - 0.02) / self.height), borderaxespad=0, columnspacing=1.6)
        self.top += 0.06 + 0.23 * rows
        self._leave_room()

    def settle(self):
        """Fixes the layout, so that what is added has its final place."""
        self.fig.canvas.draw()
        self.fig.set_layout_engine("none")

    def save(self, folder, name):
        """folder/name.svg and .png, without date or version, so that they differ only where the numbers do."""
        self.fig.savefig(folder / f"{name}.svg", metadata={"Date": None, "Creator": "poolhall report", "Title": name})
        self.fig.canvas.draw()
        picture = Image.fromarray(np.asarray(self.fig.canvas.buffer_rgba())).convert("RGB")
        # A palette: a third of the bytes, and nobody sees it.
        picture.quantize(128, dither=Image.Dither.NONE).save(folder / f"{name}.png", optimize=True, dpi=(DPI, DPI))


def panels(title, note, source, count, *, columns=3, row_height=2.5, **subplots):
    """A sheet of small multiples."""
    rows = -(-count // min(columns, count))
    return Sheet(title, note, source, count=count, columns=columns, height=max(SLIDE, 1.5 + row_height * rows), **subplots)


def name_panel(axes, title):
    """In two lines where one is too short."""
    axes.set_title(textwrap.fill(title, 30))


class _Decades(ticker.LogLocator):
    """Tens, with 2 and 5 where there are few; and one tick at `zero`, where what is 0 is drawn."""

    def __init__(self, few, ticks, zero):
        super().__init__(subs=(1, 2, 5) if few else (1,), numticks=ticks)
        self.zero = zero

    def __call__(self):
        ticks = super().__call__()
        return ticks if self.zero is None else [self.zero, *(tick for tick in ticks if tick > 3 * self.zero)]


def _log(axis, words, ticks, zero=None):
    low, high = axis.get_view_interval()
    axis.set_major_locator(_Decades(high < 50 * low, ticks, zero))
    axis.set_major_formatter(ticker.FuncFormatter(lambda value, _: "0" if value == zero else words(value, 1)))
    axis.set_minor_locator(ticker.NullLocator())


def length_axis(axis, ticks=9, zero=None):
    """Logarithmic, in metres: 1 µm, 1 mm, 1 cm; `zero` is where 0 is drawn. To be called when all is drawn."""
    _log(axis, metres, ticks, zero)


def time_axis(axis, ticks=9):
    """Logarithmic, from nanoseconds: 10 µs, 1 ms. To be called when all is drawn."""
    _log(axis, time_of_ns, ticks)


def share_axis(axes, smallest):
    """In percent, from 0 over the smallest share that is not 0 to all, by tens."""
    axes.set_yscale("symlog", linthresh=smallest, linscale=0.4)
    ticks = [0] + [10.0 ** power for power in range(-4, 1) if 10.0 ** power >= 0.99 * smallest]
    axes.yaxis.set_major_locator(ticker.FixedLocator(ticks))
    axes.yaxis.set_minor_locator(ticker.NullLocator())
    axes.yaxis.set_major_formatter(ticker.FuncFormatter(lambda value, _: f"{100 * value:g} %"))
    axes.set_ylim(-0.15 * smallest, 1.3)
