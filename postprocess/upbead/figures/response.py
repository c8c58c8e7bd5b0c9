"""The response of a run over time: the panels of the report, which are those of Figs. 2a and 2b of Shimosako and Takahashi (1994)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..errors import UserError
from ..reporting import measured, points
from ..reporting import response as reported
from ..reporting.plot import Line, Plot
from .panels import drawn
from .style import plain, styled

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ..results import Result


@styled
def response(result: Result, until: float | None = None) -> Figure:
    """P, m x_G'', F_T and x_G of a Result with a caisson, with their peaks; or the probes of one without a caisson.

    Measured records are drawn over them. until: end of the time axis (s); default: the end of the response.
    """
    figure = draw_caisson(result) if result.has_caisson else draw_probes(result)
    return cut(figure, result, until)


@styled
def probes(result: Result, until: float | None = None) -> Figure:
    """All quantities of all probes of a Result, a panel for each quantity."""
    return cut(draw_probes(result), result, until)


def cut(figure, result, until):
    if until is not None:
        if not until > result.time[0]:
            raise UserError(f"--until {until} is not later than the first time, {result.time[0]} s")
        figure.axes[0].set_xlim(right=until)
    return figure


def draw_caisson(result):
    plot = reported.plot(result, measured.by_reading(result))
    if "interface/slip" in result.file:  # x_G includes it
        slip, length = result.dataset("/interface/slip").values, result.dataset("/interface/length").values
        plot.panels[-1].lines.append(Line("slip", np.asarray(result.time), (slip @ length) / length.sum(), 4))
    return drawn(plot, f"{plain(result.title)}\n{ratio_text(result)}")


def ratio_text(result):
    """The ratio by the summary, whose peaks are found inside the steps; else the ratio by the histories."""
    ratio, force = (result.summary.get("response") or {}).get("shear_to_force_ratio"), result.history("force").values
    if ratio is None and force.max() > 0:
        ratio = result.history("shear_force").values.max() / force.max()
    return "no force" if ratio is None else rf"max $F_T$ / max $P$ = {ratio:.3f}"


def draw_probes(result):
    quantities = result.probes()
    if not quantities:
        raise UserError(f"'{result.path}' has nothing to draw: no caisson and no probes; add [probes.NAME] to the case")
    records = measured.by_reading(result)
    panels = [points.panel(result, found, name.replace("_", " "), name, records) for name, found in quantities.items()]
    window = reported.window(np.asarray(result.time), [line.values for panel in panels for line in panel.lines if line.dash == "-"])
    return drawn(Plot("probes", panels, window=window), plain(result.title))
