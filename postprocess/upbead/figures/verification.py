"""Exact solutions as lines, computed values as dots."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, TYPE_CHECKING

from .style import styled, subplots

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@styled
def verification(records: Sequence[Mapping[str, Any]]) -> Figure | None:
    """A panel for each name among the curves of a problem's records; None where it has no curves."""
    panels: dict[str, list[Any]] = {}
    for record in records:
        for curve in record["curves"]:
            panels.setdefault(curve["panel"], []).append(curve)
    if not panels:
        return None
    columns = min(3, len(panels))
    rows = -(-len(panels) // columns)
    figure, grid = subplots(rows, columns, figsize=(4 * columns, 2.8 * rows), squeeze=False)
    for axes, (title, curves) in zip(grid.flat, panels.items()):
        draw_panel(axes, title, curves)
    for axes in list(grid.flat)[len(panels) :]:
        axes.remove()
    figure.tight_layout()
    return figure


def draw_panel(axes, title, curves):
    """The exact solution as lines, computed values as dots."""
    for i, curve in enumerate(curves):
        color = f"C{i % 10}"
        axes.plot(curve["abscissa"], curve["exact"], "-", color=color, lw=1, label=curve["label"] or None)
        axes.plot(curve["abscissa"], curve["computed"], ".", color=color, ms=4)
    if "(log-log)" in title:
        axes.set_xscale("log")
        axes.set_yscale("log")
    elif "(log)" in curves[0]["x"]:
        axes.set_xscale("log")
    axes.set_title(title.replace(" (log-log)", ""), fontsize=8)
    axes.set_xlabel(curves[0]["x"].replace(" (log)", ""), fontsize=8)
    axes.set_ylabel(curves[0]["y"], fontsize=8)
    axes.tick_params(labelsize=7, which="both")
    longest = max(len(curve["label"]) for curve in curves)
    if longest > 40:  # too long for inside the panel
        axes.legend(fontsize=6, loc="upper center", bbox_to_anchor=(0.5, -0.18))
    elif longest > 0:
        axes.legend(fontsize=6)
