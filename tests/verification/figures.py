"""Figures of the verification as SVG: the exact solution as lines, the simulation as points."""

import io
import re

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402

COLOURS = ["#1b6ca8", "#c8553d", "#3a7d44", "#7d5ba6", "#b8860b", "#4a4a4a"]
matplotlib.rcParams.update({
    "svg.fonttype": "none", "font.family": "sans-serif", "font.size": 9, "axes.spines.top": False, "axes.spines.right": False,
    "axes.grid": True, "grid.color": "#e4e4e4", "grid.linewidth": 0.6, "axes.axisbelow": True, "legend.frameon": False,
    "legend.fontsize": 8, "lines.linewidth": 1.3, "axes.titlesize": 9, "axes.prop_cycle": matplotlib.cycler(color=COLOURS)})


class Figure:
    """Panels side by side; `panel` gives matplotlib's axes with labels set."""

    def __init__(self, panels=1, width=None, height=3.0):
        self.figure, axes = plt.subplots(1, panels, figsize=(width or 4.2 * panels, height), squeeze=False, layout="constrained")
        self.panels = list(axes[0])
        self.next = 0

    def panel(self, x_label, y_label, title=""):
        axes = self.panels[self.next]
        self.next += 1
        axes.set_xlabel(x_label)
        axes.set_ylabel(y_label)
        axes.set_title(title)
        return axes

    def svg(self, name):
        """The drawing; `name` keeps its identifiers apart from those of other figures of the page."""
        matplotlib.rcParams["svg.hashsalt"] = name
        for axes in self.panels:
            if axes.get_legend_handles_labels()[1]:
                axes.legend()
        text = io.StringIO()
        self.figure.savefig(text, format="svg", metadata={"Date": None, "Creator": None})
        plt.close(self.figure)
        drawing = text.getvalue()
        drawing = drawing[drawing.index("<svg"):]
        identifiers = set(re.findall(r'\bid="([^"]+)"', drawing))
        return re.sub(r'(\bid="|href="#|url\(#)([^")]+)', lambda m: m[1] + (f"{name}-{m[2]}" if m[2] in identifiers else m[2]), drawing)


def exact(axes, x, y, label=None, colour="#222222", **more):
    axes.plot(x, y, color=colour, label=label, zorder=1, **more)


def simulated(axes, x, y, label=None, colour=COLOURS[0], most=160, **more):
    """Points, thinned evenly to at most `most`."""
    step = max(1, -(-len(x) // most))
    axes.plot(x[::step], y[::step], "o", markersize=2.6, color=colour, label=label, markeredgewidth=0, zorder=2, **more)
