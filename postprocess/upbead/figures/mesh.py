"""A mesh: cells in the colour of their surface, and the named curves."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from .style import plain, styled, subplots

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ..msh import Mesh

SURFACE_COLOURS = ["#f3e3b3", "#b9c6b0", "#c9ccd4", "#bfdcee", "#e6c9b8", "#d9cbe8"]


@styled
def mesh(mesh: Mesh, title: str = "", zoom: Sequence[float] | None = None) -> Figure:
    """Draws a gmsh mesh read by `upbead.msh.read`; zoom: x0, x1, y0, y1 of a part (m)."""
    figure, axes = subplots(figsize=(10, 4.5))
    handles = []
    for number, (name, cells) in enumerate(mesh.surfaces.items()):
        colour = SURFACE_COLOURS[number % len(SURFACE_COLOURS)]
        corners = [[mesh.points[node] for node in cell] for cell in cells]
        axes.add_collection(PolyCollection(corners, facecolor=colour, edgecolor="0.45", linewidth=0.3))
        handles.append(Patch(facecolor=colour, edgecolor="0.45", label=f"{plain(name)}: {len(cells)} cells"))
    for number, (name, edges) in enumerate(mesh.curves.items()):
        ends = [[mesh.points[node] for node in edge] for edge in edges]
        axes.add_collection(LineCollection(ends, color=f"C{number % 10}", linewidth=2.0))
        handles.append(Line2D([], [], color=f"C{number % 10}", linewidth=2.0, label=plain(name)))
    axes.autoscale_view()
    axes.set_aspect("equal")
    axes.grid(False)
    axes.set_xlabel("x (m)")
    axes.set_ylabel("y (m)")
    axes.set_title(plain(title))
    axes.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0.0), borderaxespad=4.5, ncol=6)
    if zoom:
        axes.set_xlim(*zoom[:2])
        axes.set_ylim(*zoom[2:])
    return figure
