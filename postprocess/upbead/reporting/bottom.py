"""The caisson's bottom in each frame of the animation: its nodes that stick, slip or are open, and its slip."""

import numpy as np

from . import units
from .frames import GROUND, RIGID
from .language import say, spoken
from ..slip_result import SlipResult

STICKS, SLIPS, OPEN = 0, 1, 2
STATES = [("sticks", "#39424e"), ("slips", "#d95f02"), ("is open", "#1f78b4")]


def contact(result, frames):
    """For JSON: the state of each node in each frame, and its position between nodes of the frames; None if the
    results have no states of nodes."""
    if "interface/slip" not in result.file:
        return None
    pairs = facing(frames)
    if len(pairs) < 2:
        return None
    with SlipResult(result.folder) as slip:
        rows = np.abs(frames.times[:, None] - slip.time.values).argmin(axis=1)
        states = np.where(slip.is_open(), OPEN, np.where(slip.slips(), SLIPS, STICKS))[rows]
        place = np.interp(slip.position, frames.points[pairs[:, 0], 0], np.arange(len(pairs)))
        told = [words(state, slip.length, slip.opening[row], slip.slip[row]) for state, row in zip(states, rows)]
    return {
        "pairs": pairs.tolist(),
        "place": [round(float(p), 4) for p in place],
        "states": ["".join(map(str, state)) for state in states],
        "told": told,
        "names": [say(name) for name, _ in STATES],
        "colours": [colour for _, colour in STATES],
    }


def facing(frames):
    """[node of the caisson, node of the ground] at the same place, from the sea landward: the lowest at each x."""
    size = np.ptp(frames.points, axis=0).max()
    keys = [tuple(key) for key in np.round(frames.points / (1e-6 * size)).astype(int)]
    of_kind = {kind: np.unique(frames.cells[frames.kinds == kind]) for kind in (GROUND, RIGID)}
    ground = {keys[node]: node for node in of_kind[GROUND]}
    lowest = {}
    for node in of_kind[RIGID]:
        x, y = keys[node]
        if (x, y) in ground and y < lowest.get(x, (np.inf,))[0]:
            lowest[x] = y, node, ground[x, y]
    return np.array([lowest[x][1:] for x in sorted(lowest)]).reshape(-1, 2)


def words(state, length, opening, slip):
    """A description of one frame, for readers who cannot see it."""
    shares = [float(length[state == kind].sum() / length.sum()) for kind in (STICKS, SLIPS, OPEN)]
    parts = [f"{100 * share:.0f} % {say(name)}" for share, (name, _) in zip(shares, STATES) if share > 0]
    parts += [say("gap up to {gap}", gap=length_of(float(opening.max())))] if shares[OPEN] > 0 else []
    mean = length_of(float(np.average(slip, weights=length)))
    return say("bottom: {states}; mean slip {slip}", states=("、" if spoken() == "ja" else ", ").join(parts), slip=mean)


def length_of(metres):
    """A length, below a metre to a tenth of a millimetre, which is enough for values that change from frame to
    frame."""
    factor, unit = units.scale("m", metres)
    return f"{units.plain(round(metres * factor, 1 if unit == 'mm' else 3))} {unit}"


def as_a_whole(result, frames):
    """Slip (m) in each frame of a caisson that slips as a whole, which is not in the fields; None if there is no such
    slip."""
    if "interface/slip" in result.file or "coupled/slip" not in result.file:
        return None
    time, slip = (result.file[f"coupled/{name}"][()] for name in ("time", "slip"))
    found = np.interp(frames.times, time, slip)
    return found if np.any(found) else None
