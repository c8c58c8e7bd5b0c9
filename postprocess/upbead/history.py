"""An array with its unit."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

# Units for readers, by the unit of the file: (factor, name); used is the largest in which the peak is 1 or more.
SCALES = {
    "N/m": [(1e-6, "MN/m"), (1e-3, "kN/m"), (1.0, "N/m")],
    "Pa": [(1e-6, "MPa"), (1e-3, "kPa"), (1.0, "Pa")],
    "m": [(1e3, "mm")],
    "rad": [(1e3, "mrad")],
}


class History(np.ndarray[Any, np.dtype[np.float64]]):
    """A numpy array with `unit` and `description`, in the unit of the file (SI).

    Parameters
    ----------
    values : array_like
        Numbers of any shape.
    unit, description : str

    Slices and copies keep the unit; the result of a computation is a plain array, as its unit is not known.

    >>> force = History([0.0, 2e6, 0.0], "N/m", "wave force")
    >>> force
    History([      0., 2000000.,       0.], unit='N/m')
    >>> force[1:].unit, float(force.max())
    ('N/m', 2000000.0)
    >>> type(force / 1e6).__name__
    'ndarray'
    """

    unit: str
    description: str

    def __new__(cls, values: ArrayLike, unit: str = "", description: str = "") -> History:
        history: History = np.asarray(values, dtype=float).view(cls)
        history.unit, history.description = unit, description
        return history

    def __array_finalize__(self, source: Any) -> None:
        self.unit = getattr(source, "unit", "")
        self.description = getattr(source, "description", "")

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, out: Any = None, **options: Any) -> Any:
        if out is None:
            return getattr(ufunc, method)(*map(plain, inputs), **options)
        getattr(ufunc, method)(*map(plain, inputs), out=tuple(map(plain, out)), **options)
        return out[0] if len(out) == 1 else out

    def __array_function__(self, function: Any, types: Any, arguments: Any, options: Any) -> Any:
        found = super().__array_function__(function, types, arguments, options)
        return plain(found)

    def __repr__(self) -> str:
        return f"History({np.array2string(self.values, separator=', ', prefix='History(')}, unit={self.unit!r})"

    @property
    def values(self) -> NDArray[np.float64]:
        """The same numbers as a plain array."""
        return self.view(np.ndarray)

    def scale(self, others: Iterable[ArrayLike] = ()) -> tuple[float, str]:
        """(factor, unit) that suits this history and the others.

        >>> History([0.0, 2e3], "N/m").scale()
        (0.001, 'kN/m')
        """
        peak = max(float(np.max(np.abs(np.asarray(h)), initial=0.0)) for h in (self, *others))
        scales = SCALES.get(self.unit, [(1.0, self.unit)])
        return next((s for s in scales if peak * s[0] >= 1.0), scales[-1])


def plain(value: Any) -> Any:
    """A History as an array, anything else as it is."""
    return value.view(np.ndarray) if isinstance(value, History) else value
