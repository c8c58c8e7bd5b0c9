"""Mobilised strength of the soil in each frame of the animation, and the place of failure at rest if the strength is
reduced."""

import base64
import re

import numpy as np

from .language import say
from .zones import COLOURS
from .zones import LIMITS as CLASSES

ELASTIC, STEPS = 255, 250  # values of a byte: soil without strength; the whole strength
ZONE = 0.95  # share of the strength; cells that mobilise more are outlined
AT = re.compile(r"at \(([-+.\deE]+), ([-+.\deE]+)\)")


def summary(frames):
    """For JSON: a byte for each cell in each frame; None where no soil yields."""
    if frames.mobilised is None:
        return None
    share = np.clip(np.nan_to_num(frames.mobilised), 0.0, 1.0)
    coded = np.where(np.isnan(frames.mobilised), ELASTIC, np.round(STEPS * share)).astype("u1")
    return {
        "data": base64.b64encode(coded.tobytes()).decode(),
        "steps": STEPS,
        "zone": ZONE,
        "limits": CLASSES,
        "colours": COLOURS,
        "told": [
            say("{part} % of the soil in this picture mobilises {zone} % of its strength or more", part=f"{100 * part:.1f}", zone=f"{100 * ZONE:.0f}")
            for part in shares(frames)
        ],
    }


def shares(frames):
    """By frame: the share of the area of soil that may yield in which at least ZONE is mobilised."""
    corners = frames.points[frames.cells]
    a, b = corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]
    area = 0.5 * np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0])
    yields = ~np.isnan(frames.mobilised[0])
    full = in_zone(frames.mobilised)
    return (full * area).sum(axis=1) / max(area[yields].sum(), 1e-300)


def in_zone(mobilised):
    return np.nan_to_num(mobilised) >= ZONE


def failing(summary):
    """((x, y), lower, upper) of the strength reduction of a run's summary; None if it was not asked for, or the
    ground does not fail."""
    found = summary.get("safety") or {}
    place = AT.search(found.get("fails_at") or "")
    return ((float(place[1]), float(place[2])), found.get("lower"), found.get("upper")) if place else None
