"""The largest value of a sum of modes between the times at which loads change their slope.

Within a step z'' = z''(0) exp(p s), as loads are straight there, so that a reading leaves its chord by no more than

    sum_m |r_m z_m''(0)| min(h^2/8, 2/|p_m|^2) + |c_2| h^2/8,

c_2 what the load's integral adds. Steps whose chord and this bound stay below the largest value found are left out, others are
halved, until the bound is met.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

TOLERANCE = 1e-9  # of the largest magnitude at the times
HALVINGS = 40


class Peaks(NamedTuple):
    """Largest and least value of a reading, and when (s): between the given times, too, and right after a jump at t = 0."""

    largest: float
    largest_time: float
    least: float
    least_time: float


@dataclass
class Pieces:
    """Parts of steps, n of them: begin and length (s); states and drives of M modes at the begin, and the drives' slopes; the part of the
    reading that is no mode's, a parabola c[0] + c[1] s + c[2] s^2/2."""

    begin: NDArray[np.float64]
    length: NDArray[np.float64]
    z: NDArray[np.complex128]
    drive: NDArray[np.complex128]
    slope: NDArray[np.complex128]
    c: NDArray[np.float64]

    def of(self, chosen: Any) -> Pieces:
        return Pieces(self.begin[chosen], self.length[chosen], self.z[chosen], self.drive[chosen], self.slope[chosen], self.c[:, chosen])

    def at(self, share: float, pole: NDArray[np.complex128], phi: Any) -> Pieces:
        """The rest of each from this share of its length on."""
        s = share * self.length
        decay, phi_1, phi_2 = phi(pole * s[:, None])
        z = decay * self.z + s[:, None] * phi_1 * self.drive + s[:, None] ** 2 * phi_2 * self.slope
        c = np.array([self.c[0] + self.c[1] * s + self.c[2] * s**2 / 2, self.c[1] + self.c[2] * s, self.c[2]])
        return Pieces(self.begin + s, self.length - s, z, self.drive + s[:, None] * self.slope, self.slope, c)


def largest(pieces: Pieces, pole: NDArray[np.complex128], row: NDArray[np.complex128], phi: Any, sign: int) -> tuple[float, float]:
    """(value, time) of the largest sign * reading."""
    best, when = -np.inf, 0.0
    for turn in range(HALVINGS):
        ends = pieces.at(1.0, pole, phi)
        begins, values = (sign * ((one.z @ row).real + one.c[0]) for one in (pieces, ends))
        for found, times in ((begins, pieces.begin), (values, ends.begin)):
            if found.size and found.max() > best:
                best, when = float(found.max()), float(times[found.argmax()])
        if turn == 0:
            tolerance = TOLERANCE * max(np.abs(begins).max(), np.abs(values).max())
        bound = np.maximum(begins, values) + leaves(pieces, pole, row)
        pieces = pieces.of(bound > best + tolerance)
        if not pieces.begin.size:
            break
        second = pieces.at(0.5, pole, phi)
        pieces.length = pieces.length / 2
        pieces = Pieces(*(np.concatenate([getattr(one, name) for one in (pieces, second)], axis=1 if name == "c" else 0)
                          for name in ("begin", "length", "z", "drive", "slope", "c")))
    return sign * best, when


def leaves(pieces: Pieces, pole: NDArray[np.complex128], row: NDArray[np.complex128]) -> NDArray[np.float64]:
    """By how much the reading leaves its chord at most."""
    h = pieces.length[:, None]
    bend = np.abs(pole * (pole * pieces.z + pieces.drive) + pieces.slope)
    growth = np.exp(np.maximum(pole.real * h, 0.0))
    far = growth * np.minimum(h**2 / 8, 2 / np.maximum(np.abs(pole), 1e-300) ** 2)
    left: NDArray[np.float64] = (bend * far) @ np.abs(row) + np.abs(pieces.c[2]) * pieces.length**2 / 8
    return left
