"""The fields of a run as frames of an animation: corners of cells near the caisson, displacement and pore pressure."""

from dataclasses import dataclass

import numpy as np

from report import vtu
from upbead.errors import UserError

DISPLACEMENT, PRESSURE = "displacement_(m)", "pore_pressure_(Pa)"
NUMBERS = 360_000  # of all frames together, 2 bytes each: 1 MB in the page
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


def read(pvd, window):
    """The Frames of cells whose middle lies in the window (x0, x1); raises UserError where they cannot be shown."""
    steps = vtu.times(pvd)
    if not steps:
        raise UserError(f"'{pvd}' names no fields")
    first = vtu.arrays(steps[0][1], ("points", "types"))
    points = first["points"][:, :2].astype(float)
    patches = vtu.corners(len(points), len(first["types"]))
    middle = points[patches].mean(axis=1)
    patches = patches[(middle[:, 0] >= window[0]) & (middle[:, 0] <= window[1])]
    if not len(patches):
        raise UserError("no cell of the fields lies near the caisson")
    chosen = thinned(len(steps), len(patches))
    used = patches.ravel()
    moved, pressed = [], []
    for index in chosen:
        found = vtu.arrays(steps[index][1], (DISPLACEMENT, PRESSURE))
        if DISPLACEMENT not in found or len(found[DISPLACEMENT]) != len(points):
            raise UserError(f"'{steps[index][1]}' has no field {DISPLACEMENT} on the mesh of the first one")
        moved.append(found[DISPLACEMENT][used, :2])
        pressed.append(found[PRESSURE][used] if PRESSURE in found else np.zeros(len(used)))
    times = np.array([steps[index][0] for index in chosen])
    return merged(times, points[used], np.array(moved), np.array(pressed))


def thinned(frames, cells):
    """Which frames are kept, evenly, so that the page stays small; about one node and three numbers for a cell."""
    most = NUMBERS // (3 * cells)
    if most < FEWEST:
        raise UserError(f"{cells} cells near the caisson are too many for a page; ParaView opens fields.pvd")
    return np.unique(np.linspace(0, frames - 1, min(frames, most)).round().astype(int))


def merged(times, points, moved, pressed):
    """Corners at one place become one node, apart for ground, water and rigid bodies, whose fields differ there."""
    count = len(points) // 4
    still = ~np.any(moved.reshape(len(times), count, -1), axis=(0, 2))
    dry = ~np.any(pressed.reshape(len(times), count, -1), axis=(0, 2))
    kinds = np.where(still & ~dry, WATER, np.where(dry & ~still, RIGID, GROUND))
    size = max(np.ptp(points[:, 0]), np.ptp(points[:, 1]))
    key = np.column_stack([np.round(points / (1e-6 * size)), np.repeat(kinds, 4)])
    _, first, node = np.unique(key, axis=0, return_index=True, return_inverse=True)
    return Frames(times, points[first], node.reshape(count, 4), kinds, moved[:, first], pressed[:, first])
