"""The prefix of a unit in which numbers are shown, in reports and figures alike."""

import math
from collections.abc import Iterable

# From 10,000 on the next prefix is used where results are compared at a glance: P = 1,600 kN/m and F_T = 634.6 kN/m.
PREFIXES = [(1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, "")]
PREFIXED = ("N/m", "Pa", "N m/m", "N s/m", "J/m", "N/m2", "N", "N m")
LONGEST, SHORTEST = 3e4, 0.01  # numbers that still are read at a glance
NEAR = 100.0  # a width and a slip have each its own unit
SMALL = {"m": (1.0, 1e3, "mm"), "rad": (1.0, 1e3, "mrad")}  # below: factor, name


def scale(unit: str, peak: float, room: float = 1.0) -> tuple[float, str]:
    """(factor, unit): the factor of values in `unit` for a prefix that suits the largest value `peak`.

    A prefix is used for values from `room` times the prefix on; with 10, 1,600 kN/m does not become 1.6 MN/m.
    """
    peak = abs(peak)
    if unit in PREFIXED:
        for size, prefix in PREFIXES:
            if peak >= size * (room if size > 1e3 else 1.0):
                return 1.0 / size, prefix + unit
        return 1.0, unit
    if unit in SMALL and 0 < peak < SMALL[unit][0]:
        return SMALL[unit][1:]
    return 1.0, unit


def common(unit: str, values: Iterable[float | None], room: float = 10.0) -> tuple[float, str] | None:
    """(factor, unit) in which all these values stand in one table: 6,980 and 10,070 kPa, 80 and 0.02 MPa; None where no unit suits
    all of them."""
    sizes = sorted(abs(value) for value in values if value and math.isfinite(value))
    if not sizes:
        return None
    if unit in SMALL and sizes[-1] > NEAR * sizes[0]:
        return None
    small, large = scale(unit, sizes[0], room), scale(unit, sizes[-1], room)
    if sizes[-1] * small[0] < LONGEST:
        return small
    return large if sizes[0] * large[0] >= SHORTEST else None


def pretty(unit: str) -> str:
    """m2 as m², N s/m as N s/m, and 1 as nothing."""
    return "" if unit in ("1", "-") else unit.replace("m2", "m²").replace("m3", "m³").replace("s2", "s²")
