"""The fields of a run as frames of an animation: corners of cells near the caisson, displacement, pore pressure, strength."""

from dataclasses import dataclass, field

import numpy as np

from . import vtu
from ..errors import UserError

DISPLACEMENT, PRESSURE, MOBILISED = "displacement_(m)", "pore_pressure_(Pa)", "mobilised_strength_(1)"
BYTES = 600_000  # of all frames together: 0.8 MB in the page, which stays below 1.5 MB
OF_CELL = 5.5  # bytes in a frame: five for each node; there are 1.1 nodes per cell
FEWEST = 12  # frames; with fewer there is no motion to see
GROUND, WATER, RIGID = 0, 1, 2


@dataclass
class Frames:
    """Nodes with their place (m), cells of four nodes with their kind, and values by frame and node."""

    times: np.ndarray
    points: np.ndarray
    cells: np.ndarray
    kinds: np.ndarray
    displacement: np.ndarray  # frame, node, direction (m)
    pressure: np.ndarray  # frame, node (Pa)
    mobilised: np.ndarray | None  # frame, cell: share of the strength, nan where elastic; None where no soil yields
    seams: np.ndarray = field(default_factory=lambda: np.empty((0, 2), dtype=int))  # pairs of nodes: the lines between two regions of ground


def read(pvd, window):
    """The Frames of cells whose middle lies in the window (x0, x1); raises UserError if they cannot be shown."""
    steps = vtu.times(pvd)
    if not steps:
        raise UserError(f"'{pvd}' names no fields")
    first = vtu.arrays(steps[0][1], ("points", "types", MOBILISED))
    points = first["points"][:, :2].astype(float)
    patches = vtu.corners(len(points), len(first["types"]))
    regions = region_of(steps[0][1], len(patches))
    middle = points[patches].mean(axis=1)
    seen = (middle[:, 0] >= window[0]) & (middle[:, 0] <= window[1])
    patches, regions = patches[seen], regions[seen]
    if not len(patches):
        raise UserError("no cell of the fields lies near the caisson")
    chosen = [steps[index] for index in thinned(len(steps), len(patches), MOBILISED in first)]
    times, fields = np.array([time for time, _ in chosen]), [of_file(path, patches, len(points)) for _, path in chosen]
    moved, pressed, mobilised = (None if part[0] is None else np.array(part) for part in zip(*fields))
    return merged(times, points[patches.ravel()], moved, pressed, mobilised, regions)


def region_of(path, patches):
    """The number of each patch's region; all alike in files of before they had them."""
    numbers = vtu.regions(path)[1]
    return np.zeros(patches, dtype=int) if numbers is None else numbers.reshape(patches, -1)[:, 0]


def of_file(path, patches, points):
    """Displacement and pressure at the corners of the patches, and the mobilised strength of each patch (None: no
    soil yields)."""
    found, used = vtu.arrays(path, (DISPLACEMENT, PRESSURE, MOBILISED)), patches.ravel()
    if DISPLACEMENT not in found or len(found[DISPLACEMENT]) != points:
        raise UserError(f"'{path}' has no field {DISPLACEMENT} on the mesh of the first one")
    pressed = found[PRESSURE][used] if PRESSURE in found else np.zeros(len(used))
    # all points of a cell have the same value
    mobilised = found[MOBILISED][patches[:, 0]] if MOBILISED in found else None
    return found[DISPLACEMENT][used, :2], pressed, mobilised


def thinned(frames, cells, yields=False):
    """The evenly spaced frames that are kept so that the page stays small; if soil yields a cell takes one more
    byte."""
    most = int(BYTES / (cells * (OF_CELL + yields)))
    if most < FEWEST:
        raise UserError(f"{cells} cells near the caisson are too many for a page; ParaView opens fields.pvd")
    return np.unique(np.linspace(0, frames - 1, min(frames, most)).round().astype(int))


def merged(times, points, moved, pressed, mobilised=None, regions=None):
    """Corners at one place become one node, but separate nodes for ground, water and rigid bodies, whose fields
    differ there."""
    count = len(points) // 4
    still = ~np.any(moved.reshape(len(times), count, -1), axis=(0, 2))
    dry = ~np.any(pressed.reshape(len(times), count, -1), axis=(0, 2))
    kinds = np.where(still & ~dry, WATER, np.where(dry & ~still, RIGID, GROUND))
    size = max(np.ptp(points[:, 0]), np.ptp(points[:, 1]))
    key = np.column_stack([np.round(points / (1e-6 * size)), np.repeat(kinds, 4)])
    _, first, node = np.unique(key, axis=0, return_index=True, return_inverse=True)
    cells = node.reshape(count, 4)
    between = seams(cells[kinds == GROUND], regions[kinds == GROUND]) if regions is not None else np.empty((0, 2), dtype=int)
    return Frames(times, points[first], cells, kinds, moved[:, first], pressed[:, first], mobilised, between)


def seams(cells, regions):
    """Sides between cells of two regions."""
    beside = {}
    for cell, region in zip(cells.tolist(), regions.tolist()):
        for a, b in zip(cell, [*cell[1:], cell[0]]):
            beside.setdefault((min(a, b), max(a, b)), set()).add(region)
    return np.array([side for side, both in beside.items() if len(both) > 1], dtype=int).reshape(-1, 2)
