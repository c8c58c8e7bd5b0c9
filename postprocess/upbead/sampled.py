"""Functions of time as tables that are linear in between, as the program reads them."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .errors import UserError

FIRST = 2000  # intervals to begin with: a pulse of a hundredth of the run has 20 points
TOLERANCE = 1e-4  # of the largest value: what the table may differ from the function in the middle of an interval
HALVINGS = 12
SUDDEN = 1e-12  # of the run: what changes within this jumps, and is written as two samples at one time, as the program reads jumps
STRAINS = (1e-7, 1e-1)  # of a curve of soil
PER_DECADE, OF_CURVE = 10, 1e-3  # points to begin with, and what the table may differ from the curve


def sampled_function(function: Callable[[Any], Any], end: float) -> NDArray[np.float64]:
    """Times (s) and values of f(t) from 0 to the end, in columns: intervals are halved until the table follows f.

    >>> table = sampled_function(lambda t: max(0.0, 1.0 - t), 2.0)
    >>> table.shape[1], float(table[0, 1]), float(table[-1, 0])
    (2, 1.0, 2.0)
    """
    time, rows = refined(lambda times: called(function, times)[:, None], steps(end), sudden=SUDDEN * end)
    return np.column_stack([time, rows])


def sampled_field(function: Callable[[Any, Any], Any], places: ArrayLike, end: float) -> NDArray[np.float64]:
    """Times (s) and values of p(s, t) at the places, a column for each."""
    at = [float(place) for place in np.asarray(places, dtype=float)]

    def rows_at(times: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.column_stack([called(functools.partial(function, place), times) for place in at])

    time, rows = refined(rows_at, steps(end), sudden=SUDDEN * end)
    return np.column_stack([time, rows])


def steps(end: float) -> NDArray[np.float64]:
    return np.linspace(0.0, end, FIRST + 1)


def sampled_curve(function: Callable[[Any], Any]) -> list[list[float]]:
    """Pairs of shear strain and G/G_max, or damping, of a curve of soil: straight over the logarithm of the strain, as the program
    reads them.

    >>> pairs = sampled_curve(lambda strain: 1 / (1 + strain / 1e-3))
    >>> pairs[0][0], round(pairs[-1][1], 4)
    (1e-07, 0.0099)
    """
    low, high = np.log10(STRAINS)
    decades = np.linspace(low, high, int(PER_DECADE * (high - low)) + 1)
    at, rows = refined(lambda logs: called(function, 10.0**logs)[:, None], decades, OF_CURVE)
    return [[float(f"{10.0**one:.12g}"), float(value)] for one, value in zip(at, rows[:, 0])]


def called(function: Callable[[Any], Any], times: NDArray[np.float64]) -> NDArray[np.float64]:
    """Values of a function that takes arrays, or one number at a time."""
    try:
        values = np.asarray(function(times), dtype=float)
        if values.shape == times.shape:
            return values
    except (TypeError, ValueError):  # `if t < 0.1` and the like
        pass
    one_by_one = [function(float(t)) for t in times]
    try:
        return np.array([float(value) for value in one_by_one], dtype=float)
    except (TypeError, ValueError) as error:
        raise UserError(f"a function gives '{one_by_one[0]!r}' at {float(times[0]):g}; let it give one number at each place") from error


def refined(rows_at: Callable[[NDArray[np.float64]], NDArray[np.float64]], grid: NDArray[np.float64], tolerance: float = TOLERANCE,
            sudden: float | None = None) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The grid, halved where straight lines miss the function in the middle by more than the tolerance over the largest value; split
    at a jump where `sudden` says within which length that is."""
    time, rows = grid, rows_at(grid)
    open_ones = np.arange(len(grid) - 1)  # numbers of the intervals that are still looked at
    for _ in range(HALVINGS):
        middle = 0.5 * (time[open_ones] + time[open_ones + 1])
        found = rows_at(middle)
        error = np.abs(found - 0.5 * (rows[open_ones] + rows[open_ones + 1])).max(axis=1)
        wrong = np.flatnonzero(error > tolerance * max(np.abs(rows).max(), np.abs(found).max()))
        if not wrong.size:
            break
        split = [(middle[[n]], found[[n]]) for n in wrong]
        for n, i in enumerate(open_ones[wrong]):
            jump = jump_between(rows_at, time[i : i + 2], rows[i : i + 2], sudden) if sudden else None
            split[n] = jump or split[n]
        count = np.array([len(times) for times, _ in split])
        after = np.repeat(open_ones[wrong] + 1, count)
        time, rows = np.insert(time, after, np.concatenate([times for times, _ in split])), np.insert(rows, after, np.concatenate([new for _, new in split]), axis=0)
        first = open_ones[wrong] + np.cumsum(count) - count
        open_ones = np.concatenate([np.arange(i, i + n + 1) for i, n in zip(first, count)])
        open_ones = open_ones[time[open_ones + 1] > time[open_ones]]
    return (time, rows) if sudden is None else thinned(time, rows, tolerance)


def jump_between(rows_at: Callable[[NDArray[np.float64]], NDArray[np.float64]], times: NDArray[np.float64], ends: NDArray[np.float64],
                 sudden: float) -> tuple[NDArray[np.float64], NDArray[np.float64]] | None:
    """Two samples at the time of a jump, one where the jump is at an end of the interval; None where most of the change is no jump.
    Of a slope the half with the larger change has half of it, of a jump all."""
    (low, high), (below, above) = times, ends
    most = 0.5 * np.abs(above - below).max()
    while high - low > sudden:
        middle = 0.5 * (low + high)
        if not low < middle < high:
            break
        row = rows_at(np.array([middle]))[0]
        left, right = np.abs(row - below).max(), np.abs(above - row).max()
        if max(left, right) <= most:
            return None
        if left >= right:
            high, above = middle, row
        else:
            low, below = middle, row
    if low == times[0]:
        return times[:1], above[None]
    if high == times[1]:
        return times[1:], below[None]
    return np.array([low, low]), np.array([below, above])


def thinned(time: NDArray[np.float64], rows: NDArray[np.float64], tolerance: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Without the neighbours of jumps that straight lines do not need: the program's step follows from the shortest interval."""
    jump = np.flatnonzero(np.diff(time) == 0)
    fixed = {*jump, *(jump + 1), 0, len(time) - 1}
    gone: set[int] = set()
    for i in (int(one) for one in np.concatenate([jump - 1, jump + 2])):
        if i in fixed or i < 0 or {i - 1, i, i + 1} & gone:
            continue
        share = (time[i] - time[i - 1]) / (time[i + 1] - time[i - 1])
        error = np.abs(rows[i] - rows[i - 1] - share * (rows[i + 1] - rows[i - 1])).max()
        if error <= tolerance * np.abs(rows).max():
            gone.add(i)
    kept = np.setdiff1d(np.arange(len(time)), list(gone)).astype(int)
    return time[kept], rows[kept]
