"""Sliding distance against the safety factor, as Fig. 10 of Shimosako and Takahashi (1994)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, TYPE_CHECKING

import numpy as np
from matplotlib.lines import Line2D

from ..errors import UserError
from .style import plain, styled, subplots

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FORMULAS = {"paper": "eq. (7)", "exact": "eqs. (4) and (6), integrated", "combined": "standing wave and pulse"}
COLOURS = ["tab:blue", "tab:red", "tab:green", "tab:purple", "tab:orange", "tab:brown"]
LINES = ["-", "--", ":", "-."]


@styled
def sliding_safety(summaries: Sequence[Mapping[str, Any]], formula: str = "paper", low: float = 0.6, high: float = 1.0) -> Figure:
    """A curve for each summary of `upbead waves`, a point for each of its waves, for safety factors from low to high.

    Colours stand for the friction coefficient, line styles for the design.
    """
    if not low < high:
        raise UserError(f"--range {low} {high}: the first number must be the smaller one")
    figure, axes = subplots(figsize=(5.6, 3.8))
    titles = sorted({s["title"] for s in summaries})
    frictions = sorted({s["section"]["friction"] for s in summaries})
    largest = 0.0
    for summary in summaries:
        safety, distance = curve(summary, formula)
        line = LINES[titles.index(summary["title"]) % len(LINES)]
        colour = COLOURS[frictions.index(summary["section"]["friction"]) % len(COLOURS)]
        axes.plot(safety, distance, line, color=colour, lw=1.3)
        inside = np.linspace(max(low, safety[0]), min(high, safety[-1]), 100)
        largest = max(largest, np.interp(inside, safety, distance).max())
    if largest == 0:
        raise UserError(f"no wave with a safety factor from {low} to {high} slides the caisson")
    axes.set(xlim=(low, high), ylim=(0, 1.05 * largest), xlabel="safety factor against sliding",
             ylabel="sliding distance $S$ (m)", title=f"S by {FORMULAS[formula]}")
    handles = [Line2D([], [], color="black", ls=LINES[i % len(LINES)], label=plain(t)) for i, t in enumerate(titles)]
    handles += [Line2D([], [], color=COLOURS[i % len(COLOURS)], label=rf"$\mu$ = {f:g}")
                for i, f in enumerate(frictions)]
    axes.legend(handles=handles)
    return figure


def curve(summary, formula):
    """Safety factors in ascending order, and S."""
    points = sorted((w["safety_sliding"], w[f"sliding_{formula}"]) for w in summary["waves"].values())
    return np.array(points).T
