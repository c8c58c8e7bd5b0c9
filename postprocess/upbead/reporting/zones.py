"""Drawings of where soil has yielded: a value of each cell near the caisson at the last written time, in classes of
colour."""

from dataclasses import dataclass

import numpy as np

from . import geometry, vtu
from .language import say
from .markup import Markup, join, tag
from ..errors import UserError

MOBILISED, DISSIPATED = "mobilised_strength_(1)", "dissipated_energy_(J_m3)"
COLOURS = ["#f2f2f2", "#fee6b0", "#fdc26a", "#f5923e", "#de5a2a", "#a82014", "#5c0a12"]
LIMITS = [0.25, 0.5, 0.7, 0.85, 0.95, 0.999]  # of the classes of strength
WIDTH, HEIGHT = 860, 300  # px; HEIGHT is the maximum


@dataclass
class Zones:
    """Corners of the cells near the caisson (m), and for each cell the mobilised strength and the dissipated energy;
    nan where elastic."""

    time: float
    corners: np.ndarray  # cell, corner, direction
    mobilised: np.ndarray
    dissipated: np.ndarray


def read(pvd, window):
    """The Zones of the last fields: cells whose middle is in the window (x0, x1); None if no soil may yield."""
    steps = vtu.times(pvd)
    if not steps:
        raise UserError(f"'{pvd}' names no fields")
    time, path = steps[-1]
    found = vtu.arrays(path, ("points", "types", MOBILISED, DISSIPATED))
    if MOBILISED not in found:
        return None
    points = found["points"][:, :2].astype(float)
    patches = vtu.corners(len(points), len(found["types"]))
    middle = points[patches].mean(axis=1)[:, 0]
    patches = patches[(middle >= window[0]) & (middle <= window[1])]
    one = patches[:, 0]  # a value of a cell is the same at all its points
    return Zones(time, points[patches], found[MOBILISED][one].astype(float), found[DISSIPATED][one].astype(float))


def classes(values, limits):
    """For each value the number of limits that it reaches; -1 for nan."""
    return np.where(np.isnan(values), -1, np.searchsorted(limits, np.nan_to_num(values), side="right"))


def drawing(corners, number, limits, told, label):
    """An SVG of cells in the colour of their class, with the scale below; elastic ones are outlined."""
    low, high = corners.min(axis=(0, 1)), corners.max(axis=(0, 1))
    scale = min(WIDTH / (high[0] - low[0]), HEIGHT / (high[1] - low[1]))
    placed = np.stack([corners[..., 0] - low[0], high[1] - corners[..., 1]], axis=-1) * scale
    size = (high - low) * scale
    parts = [tag("path", d=outline(placed[number == k]), fill=colour(k)) for k in range(len(limits) + 1) if np.any(number == k)]
    parts += [tag("polygon", points=" ".join(f"{x:.1f},{y:.1f}" for x, y in loop), class_="elastic") for loop in around(placed[number < 0])]
    parts += scale_parts(limits, told, size[1] + 14)
    box = f"-1 -1 {max(size[0], 60.0 * (len(limits) + 1)) + 2:.1f} {size[1] + 48:.1f}"
    return tag("svg", *parts, viewBox=box, role="img", aria_label=label)


def around(cells):
    """The loops around cells; corners at one place are one."""
    flat = np.round(cells.reshape(-1, 2), 1)
    places, node = np.unique(flat, axis=0, return_inverse=True)
    return geometry.outline(node.reshape(-1, 4).tolist(), places.tolist()) if len(cells) else []


def colour(number):
    return COLOURS[number]


def outline(cells):
    return "".join("M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in cell) + "Z" for cell in cells)


def scale_parts(limits, told, top):
    parts = []
    for k in range(len(limits) + 1):
        parts.append(tag("rect", x=60 * k, y=f"{top:.1f}", width=60, height=10, fill=COLOURS[k]))
    for k, limit in enumerate(limits):
        parts.append(tag("text", told(limit), x=60 * (k + 1), y=f"{top + 24:.1f}", class_="tick", text_anchor="middle"))
    return parts


def of_mobilised(zones):
    number = classes(zones.mobilised, LIMITS)
    return drawing(zones.corners, number, LIMITS, lambda v: f"{100 * v:g} %", say("share of strength mobilised by cell"))


def of_dissipated(zones):
    """The drawing of dissipated energy, in decades below the largest; empty if none was dissipated."""
    values = np.where(np.isnan(zones.mobilised), np.nan, zones.dissipated)
    largest = np.nanmax(values, initial=0.0)
    if not largest > 0:
        return Markup("")
    top = 10.0 ** np.floor(np.log10(largest))
    limits = [top * factor for factor in (1e-4, 1e-3, 1e-2, 0.1, 0.3, 1.0)]
    number = classes(values, limits)
    return drawing(zones.corners, number, limits, lambda v: f"{v:.2g}", say("energy taken by the soil by cell, J/m³"))


def figures(zones):
    """Both drawings as figures of the page."""
    both = (
        ("mobilised", of_mobilised(zones), "Share of its strength that each cell mobilises"),
        ("dissipated", of_dissipated(zones), "Energy that each cell has taken by yielding, J/m³"),
    )
    return join(
        tag("figure", drawn, tag("figcaption", say("{what}, at {time} s. Outlined: what stays elastic, and what is rigid.", what=say(what), time=f"{zones.time:.4g}")), id=name, class_="zones")
        for name, drawn, what in both
        if drawn
    )
