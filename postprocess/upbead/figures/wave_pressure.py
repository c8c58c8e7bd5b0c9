"""Pressure over the height of the wall, with and without alpha_I: Figs. 7 and 9 of Shimosako and Takahashi (1994)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, TYPE_CHECKING

import numpy as np

from ..errors import UserError
from .style import plain, styled, subplots

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@styled
def wave_pressure(summaries: Sequence[Mapping[str, Any]], wave: str | None = None, measured: Sequence[Any] | None = None) -> Figure:
    """A panel for each summary of `upbead waves`.

    wave: its name, if there are several. measured: for each summary None, or rows of height above still water (m) and
    pressure (Pa).
    """
    measured = measured or [None] * len(summaries)
    if len(measured) != len(summaries):
        raise UserError(f"{len(summaries)} summaries, but {len(measured)} files of --measured; give as many")
    size = (4.4 * len(summaries), 4.4)
    figure, rows = subplots(1, len(summaries), sharex=True, sharey=True, squeeze=False, figsize=size)
    for axes, summary, points in zip(rows[0], summaries, measured):
        draw_one(axes, summary, wave, points)
    rows[0, 0].set_xlim(left=0)
    rows[0, 0].set_ylabel("height above still water (m)")
    return figure


def pick(summary, name):
    """The wave of that name; without a name the only wave."""
    waves = summary["waves"]
    if name is None and len(waves) > 1:
        raise UserError(f"the summary has {len(waves)} waves; choose one with --wave: {', '.join(waves)}")
    if name is not None and name not in waves:
        raise UserError(f"there is no wave '{name}'; the summary has {', '.join(waves)}")
    return name or next(iter(waves)), waves[name or next(iter(waves))]


def profile(section, eta_star, p):
    """Heights above still water (m) and pressures (kPa) from the caisson's bottom to the upper end of the
    pressure."""
    top = min(eta_star, section["crest"])
    return np.array([-section["foundation_depth"], 0.0, top]), np.array([p["p3"], p["p1"], p["p4"]]) / 1e3


def draw_one(axes, summary, name, points):
    section = summary["section"]
    name, wave = pick(summary, name)
    for p, style, label in ((wave, "-", r"with $\alpha_I$"), (wave["without_alpha_I"], "--", r"$\alpha_2$ alone")):
        height, pressure = profile(section, wave["eta_star"], p)
        colour = "tab:red" if style == "-" else "tab:blue"
        axes.plot(pressure, height, style, color=colour, lw=1.5,
                  label=f"{label}: P = {p['force'] / 1e6:.3g} MN/m")
    if points is not None:
        axes.plot(points[:, 1] / 1e3, points[:, 0], "o", color="black", ms=4, label="measured")
    axes.axhline(0, color="black", lw=0.6)
    axes.plot([0, 0], [-section["foundation_depth"], section["crest"]], color="black", lw=4, solid_capstyle="butt")
    axes.set(xlabel="pressure (kPa)", title=f"{plain(summary['title'] or name)}\nH = {wave['height']:.3g} m, "
             f"T = {wave['period']:.3g} s, " + rf"$\alpha^*$ = {wave['alpha_star']:.2g}")
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.14))
