"""Which combinations of parameters a record fixes.

In logarithms of the parameters a combination a^p b^q is a direction. The singular value decomposition of the Jacobian
over the noise orders directions by how well the record fixes them: along v_i the standard error is 1/s_i (Seber and
Wild 2003, ch. 3.4 and 5.1). Along a direction that is not fixed, parameters may change without an effect on the
record.
"""

from dataclasses import dataclass

import numpy as np

from .fit_parameters import RANGE

NEGLIGIBLE = 0.03  # smaller exponents are left out of texts
TELLING = 0.3  # the first exponent above it is made 1; both limits are over the largest exponent
# along a direction without effect on the record, parameters may change as much as a guess may be wrong
WIDEST = np.log(RANGE)


@dataclass
class Combination:
    """A product of powers of parameters; if it is not fixed, the powers of a factor c by which the parameters change
    together.

    interval: half the 95 % interval of the logarithm of the product or of c.
    """

    exponents: dict
    interval: float
    fixed: bool

    def __str__(self):
        parts = [key if abs(power - 1) < 0.005 else f"{key}^{power:.2f}" for key, power in self.exponents.items()]
        return " x ".join(parts)

    @property
    def within(self):
        """The interval in words."""
        if self.interval < 0.5:
            return f"within {100 * np.expm1(self.interval):.2g} %"
        return f"within a factor of {np.exp(self.interval):.2g}" if self.interval < 0.99 * WIDEST else "any"


@dataclass
class Identifiable:
    """The combinations that a record fixes: `directions`, from best to worst known; the same as simple products,
    `fixed` and `free`."""

    directions: list
    fixed: list
    free: list
    axes: np.ndarray  # the directions as rows

    def __str__(self):
        head = "only this is fixed" if self.free else "fixed"
        lines = [f"{head}: {combination}, {combination.within}" for combination in self.fixed] or ["nothing is fixed"]
        for free in self.free:
            changes = [f"{key} x c^{power:.2f}".replace("c^1.00", "c") for key, power in free.exponents.items()]
            lines.append(f"not fixed: {' with '.join(changes)} fits as well, c {free.within}")
        return "\n".join(lines)

    def ellipsoid(self):
        """V diag(interval^2) V^T: the covariance of the logarithms, times the square of the quantile."""
        return self.axes.T @ np.diag([direction.interval**2 for direction in self.directions]) @ self.axes


def identifiable(keys, jacobian, noise, quantile, limit, doubt=None):
    """The Identifiable of a Jacobian d computed / d ln(parameter), a column for each key; a row for each number of
    the data.

    noise: standard deviation of a sample. quantile: of Student's t, for 95 %. limit: a direction is fixed if its
    interval is within +-limit (relative). doubt: error that each column may have (rms); a direction along which the
    history changes less than that is taken as not determined.
    """
    size, directions = told(jacobian, doubt)
    most = WIDEST / np.abs(directions).max(axis=1)
    with np.errstate(divide="ignore"):
        interval = np.minimum(quantile * noise / size, most)
    fixed = interval < np.log1p(limit)
    ordered = [Combination(words(keys, row), half, bool(known)) for row, half, known in zip(directions, interval, fixed)]
    return Identifiable(ordered, fixed_products(keys, directions, interval, fixed),
                        free_products(keys, directions[~fixed], interval[~fixed]), directions)


def told(jacobian, doubt=None):
    """Singular values and directions of a Jacobian, as many as it has columns; 0 where the value is below the
    doubt."""
    lacking = max(0, jacobian.shape[1] - len(jacobian))
    _, size, directions = np.linalg.svd(np.pad(jacobian, ((0, lacking), (0, 0))), full_matrices=False)
    if doubt is not None:
        size = np.where(size < np.sqrt(len(jacobian)) * np.linalg.norm(directions * doubt, axis=1), 0.0, size)
    return size, directions


def joined(blocks):
    """One Jacobian equivalent to several, each (jacobian, doubt) over the noise of its own data."""
    return np.vstack([size[:, None] * directions for size, directions in (told(*block) for block in blocks)])


def fixed_products(keys, directions, interval, fixed):
    """Simple products that span the fixed directions, without negligible exponents."""
    found = []
    for row in simple(directions[fixed]):
        size = np.abs(row) / np.abs(row).max()
        row = np.where(size > NEGLIGIBLE, row, 0.0) / row[np.argmax(size > TELLING)]
        found.append(Combination(words(keys, row), np.linalg.norm(directions @ row * interval), True))
    return found


def free_products(keys, rows, interval):
    """Combinations that span the directions that are not fixed, with the largest exponent 1 and the interval of their
    c."""
    found = []
    for row in simple(rows):
        row = row / row[np.argmax(np.abs(row) > 0.95 * np.abs(row).max())]
        found.append(Combination(words(keys, row), 1.0 / np.linalg.norm(rows @ row / interval), False))
    return found


def simple(rows):
    """Rows that span the same space, each with a column in which all other rows are zero."""
    return np.linalg.solve(rows[:, pivot_columns(rows)], rows) if len(rows) else rows


def pivot_columns(rows):
    """Columns on which the rows are independent, those with the largest entries first (Gram-Schmidt with
    pivoting)."""
    rest, chosen = np.array(rows), []
    for _ in range(len(rows)):
        size = np.linalg.norm(rest, axis=0)
        size[chosen] = -1.0
        best = int(np.argmax(size > (1 - 1e-6) * size.max()))  # the first of equal ones
        chosen.append(best)
        unit = rest[:, best] / np.linalg.norm(rest[:, best])
        rest = rest - np.outer(unit, unit @ rest)
    return sorted(chosen)


def words(keys, row):
    return {key: float(power) for key, power in zip(keys, row) if abs(power) > NEGLIGIBLE * np.abs(row).max()}
