"""Least squares by scipy for a model that is computed at several points at once."""

from dataclasses import dataclass

import numpy as np

from .errors import UserError

STEP = 0.02  # of ln(parameter), for differences: far above the roughness of reduced models (docs/fit.md)
LOOK = np.log(1.7)  # step of the first search, in ln(parameter)
MARGIN = 1e-9  # by which bounds are widened, as scipy needs its start within them


@dataclass
class Solution:
    x: np.ndarray
    computed: np.ndarray
    jacobian: np.ndarray  # d computed / d x
    doubt: np.ndarray  # of each number of it
    converged: bool


def scipy_part(name):
    """A module of scipy, which only fits need."""
    import importlib

    try:
        return importlib.import_module(f"scipy.{name}")
    except ImportError as error:
        raise UserError("a fit needs scipy; install it (Debian: python3-scipy)") from error


def differences(compute, x, low, high):
    """The Jacobian of compute at x by central differences, and the error (rms) that each column may have.

    One-sided at a bound, and if a run on the other side failed (its result is nan).

    This doubt is half the change of the slope from one side to the other, which includes the roughness of the runs.
    """
    jacobian, doubt = slopes(compute, x, low, high)
    return jacobian, np.sqrt(np.mean(doubt**2, axis=0))


def slopes(compute, x, low, high):
    """The same with the doubt of each number of the Jacobian."""
    ends = []
    for j in range(len(x)):
        for end in (max(low[j], x[j] - STEP), min(high[j], x[j] + STEP)):
            point = np.array(x)
            point[j] = end
            ends.append(point)
    centre, *answers = compute([x, *ends])
    columns, doubt = [], []
    for j in range(len(x)):
        (left, below), (right, above) = ((end[j], answer if np.isfinite(answer).all() else None)
                                         for end, answer in zip(ends[2 * j : 2 * j + 2], answers[2 * j : 2 * j + 2]))
        if below is None or above is None or left == x[j] or right == x[j]:
            left, below = (x[j], centre) if below is None else (left, below)
            right, above = (x[j], centre) if above is None else (right, above)
            doubt.append(np.zeros_like(centre))
        else:
            doubt.append((above - 2 * centre + below) / (right - left))
        columns.append((above - below) / (right - left) if right > left else np.zeros_like(centre))
    return np.stack(columns, axis=1), np.stack(doubt, axis=1)


def misfit(answers, measured):
    """Sums of squares; infinite if a run failed."""
    sums = [np.sum((answer - measured) ** 2) for answer in answers]
    return np.where(np.isfinite(sums), sums, np.inf)


def compass(compute, measured, x, low, high, rounds=6, size=misfit):
    """A better start than x: the best of steps along each coordinate, repeated while one is better.

    Direct search with a constant step (Kolda, Lewis and Torczon 2003). From a guess that is wrong by about a period,
    least squares alone first go far astray; with this search the fits of docs/fit.md took 48 runs instead of 62 to
    66.
    """
    best = size(compute([x]), measured)[0]
    for _ in range(rounds):
        points = [np.clip(x + sign * LOOK * unit, low, high) for unit in np.eye(len(x)) for sign in (-1, 1)]
        sums = size(compute(points), measured)
        if not sums.min() < best:
            break
        best, x = sums.min(), points[int(np.argmin(sums))]
    return x


def search(compute, measured, low, high, per_parameter=8, size=misfit):
    """The best of some points spread evenly over the box: those of Sobol's sequence, the first of which is the lowest
    corner."""
    bits = int(np.ceil(np.log2(per_parameter * len(low))))
    unit = scipy_part("stats").qmc.Sobol(len(low), scramble=False).random_base2(bits)
    points = list(low + (high - low) * unit)
    return points[int(np.argmin(size(compute(points), measured)))]


def least_squares(compute, measured, begin, low, high, scale):
    """The x between low and high with the least sum of squares of (compute(x) - measured)/scale.

    compute: list of points -> list of arrays, nan where the model cannot be computed. scale: of each number.
    Trust-region reflective steps (Branch, Coleman and Li 1999) of scipy.optimize, of least norm, so that combinations
    that the data do not fix stay near the start. It ends when a step changes the misfit by less than 1e-4: for 1,000
    samples, a step of at most a third of a standard error.
    """
    found = scipy_part("optimize").least_squares(  # over x - begin, so that the first step may have length 1
        lambda z: (compute([begin + z])[0] - measured) / scale, np.zeros(len(begin)),
        jac=lambda z: differences(compute, begin + z, low, high)[0] / np.reshape(scale, (-1, 1)),
        bounds=(low - begin - MARGIN, high - begin + MARGIN), method="trf", ftol=1e-4, xtol=1e-5, gtol=1e-9, max_nfev=40)
    x = begin + found.x
    return Solution(x, compute([x])[0], *slopes(compute, x, low, high), found.status > 0)
