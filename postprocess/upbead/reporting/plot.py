"""The content of a plot: panels one below the other over one axis; each panel has lines and marked points."""

import math
from dataclasses import dataclass, field

import numpy as np

from . import units
from .language import told
from .markup import runs
from .series import largest, rounded, thinned

SIGNS = {"-": "", "--": "7 4", ":": "2 3"}


@dataclass
class Line:
    """`symbol`: empty where a panel has one line and its title names it. `colour` is a number of the style sheet's colours, `dash` one of SIGNS."""

    symbol: str
    x: np.ndarray
    values: np.ndarray
    colour: int = 0
    dash: str = "-"
    dots: bool = False  # single values, not a line


@dataclass
class Panel:
    """Lines of one unit (SI). Panels of the same `group` share their scale."""

    unit: str
    lines: list
    marks: list = field(default_factory=list)  # [(x, value)]
    group: str = ""
    height: int = 130
    title: str = ""
    from_zero: bool = True  # of scattered values zero says nothing, and hides the scatter


@dataclass
class Plot:
    """`name` is the figure's id; `window` the range shown at first, by default all."""

    name: str
    panels: list
    axis: tuple = ("time", "s")
    window: tuple | None = None
    log: bool = False  # of an axis of positive values over decades

    def extent(self):
        ends = [(np.min(line.x), np.max(line.x)) for panel in self.panels for line in panel.lines if len(line.x)]
        low, high = min(end[0] for end in ends), max(end[1] for end in ends)
        return (float(low), float(high)) if high > low else (float(low), float(low) + 1.0)

    def factor(self, panel):
        """(factor, unit) in which a panel and those of its group are drawn."""
        peers = [p for p in self.panels if p is panel or (panel.group and p.group == panel.group)]
        peak = max((largest(line.values) for p in peers for line in p.lines), default=0.0)
        factor, unit = units.scale(panel.unit, peak, room=10.0)
        if peak > 0 and not 1e-2 <= peak * factor < 1e6:  # with a power of ten before the unit the ticks are short
            power = math.floor(math.log10(peak * factor))
            return factor / 10.0**power, f"10{units.superscript(power)} {units.pretty(unit)}".strip()
        return factor, unit

    def data(self):
        """The plot for JSON: thinned, rounded, in the units in which it is drawn."""
        name = told(self.axis[0])
        factor = units.scale(self.axis[1], self.extent()[1] - self.extent()[0])
        extent = [self.along(end * factor[0]) for end in self.extent()]
        window = [self.along(end * factor[0]) for end in self.window] if self.window else extent
        return {
            "axis": f"{name} ({units.pretty(factor[1])})" if units.pretty(factor[1]) else name,
            "symbol": [name, units.pretty(factor[1])],
            "extent": extent,
            "window": window,
            "log": self.log,
            "panels": [self._panel(panel, factor[0]) for panel in self.panels],
        }

    def along(self, x):
        """Where a value of the axis is drawn: of an axis over decades at its logarithm."""
        return np.log10(x) if self.log else x

    def _panel(self, panel, x_factor):
        factor, unit = self.factor(panel)
        marks = []
        for x, value in panel.marks:
            what = f"{units.plain(value * factor)} {units.pretty(unit)}"
            marks.append({"x": self.along(x * x_factor), "y": value * factor, "text": what})
        return {
            "unit": units.pretty(unit),
            "group": panel.group,
            "height": panel.height,
            "title": panel.title,
            "from_zero": panel.from_zero,
            "marks": marks,
            "lines": [self._line(line, x_factor, factor) for line in panel.lines],
        }

    def _line(self, line, x_factor, factor):
        x, values = thinned(line.x, line.values)
        return {
            "symbol": runs(line.symbol),
            "colour": line.colour,
            "dash": SIGNS[line.dash],
            "dots": line.dots,
            "x": rounded(self.along(x * x_factor), 7),
            "y": rounded(values * factor),
        }
