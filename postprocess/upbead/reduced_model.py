"""A reduced model (reduced.h5 of `upbead reduce`): a sum of modes, evaluated by numpy alone.

    model = ReducedModel("prototype.h5")
    time = np.linspace(0.0, 2.0, 2001)
    answer = model.respond(time, {"impact": force})     # N/m at those times
    print(model.peaks(time, {"impact": force}).largest / force.max())   # peaks between those times, too
"""

from __future__ import annotations

from collections.abc import Mapping
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .errors import ModelError
from .h5 import open_h5
from .history import History
from .modal_peaks import Peaks, Pieces, largest
from .near import hint
from .results import text_of
from .shown import Shown
from .wave_table import read_wave

__all__ = ["ModelError", "ReducedModel", "fine", "phi_functions", "read_wave"]

KIND, VERSIONS = "upbead reduced model", (1, 2)  # 2: with /still_water, whose push is no part of F_T
# factors of the differences of nested models, as in `upbead respond`: docs/reduced.md
SAFETY_OF_MODEL, SAFETY_OF_MIDDLE = 1.2, 1.5


def phi_functions(x: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
    """exp(x), phi_1 = (exp(x) - 1)/x and phi_2 = (phi_1 - 1)/x, by their series near 0, where the closed forms suffer
    from cancellation."""
    small = np.abs(x) < 0.5
    safe = np.where(small, 1.0, x)
    near = np.where(small, x, 0.0)
    phi_2 = np.zeros_like(x)
    for n in range(20, 1, -1):  # Horner: sum of x^j / (j + 2)!
        phi_2 = (1.0 + near * phi_2) / n
    phi_2 = np.where(small, phi_2, ((np.exp(safe) - 1.0) / safe - 1.0) / safe)
    phi_1 = 1.0 + x * phi_2
    return 1.0 + x * phi_1, phi_1, phi_2


def _texts(dataset: Any) -> list[str]:
    return [text_of(text) for text in dataset[()]]


def warnings_in(file: Any) -> list[dict[str, Any]]:
    """Those of a model's file; files of before them have none."""
    if "warnings" not in file:
        return []
    rows = zip(*(_texts(file[f"warnings/{key}"]) for key in ("name", "what", "cure")), file["warnings/number"][()])
    return [
        {"name": name, "cure": cure, "text": f"{what}; {cure}" if cure else what, "voids": bool(number[2])}
        for name, what, cure, number in rows
    ]


class ReducedModel(Shown):
    """A sum of modes; docs/output.md has the layout of the file.

    z_m' = pole_m z_m + sum_k load_mk f_k,  y_i = Re sum_m reading_im z_m + feedthrough_ik f_k + impulse_ik int f_k dt

    Attributes
    ----------
    loads, readings : list of str
        K names of what acts, I names of what is answered.
    units, descriptions : dict of str
        By reading.
    pole : ndarray of complex, shape (M,), 1/s
    load : ndarray of complex, shape (M, K)
    reading : ndarray of complex, shape (I, M)
    feedthrough, impulse : ndarray, shape (I, K)
    warnings : list of dict
        Of its scene, as a run tells them: name, text, cure, and whether no verdict may be drawn (voids).
    """

    loads: list[str]
    readings: list[str]
    units: dict[str, str]
    descriptions: dict[str, str]
    duration: NDArray[np.float64]
    validity: dict[str, Any]
    caisson_mass: float
    title: str
    warnings: list[dict[str, Any]]
    nested: list[ReducedModel] | None
    pole: NDArray[np.complex128]
    load: NDArray[np.complex128]
    reading: NDArray[np.complex128]
    feedthrough: NDArray[np.float64]
    impulse: NDArray[np.float64]

    def __init__(self, path: str | PathLike[str]) -> None:
        self.path = Path(path)
        if not self.path.exists():
            raise ModelError(f"there is no file '{path}'; 'upbead reduce' makes a reduced model")
        try:
            with open_h5(path) as file:
                self._read(file, path)
        except (OSError, KeyError) as error:
            raise ModelError(f"'{path}' cannot be read as a reduced model: {error}") from error

    def _read(self, file: Any, path: str | PathLike[str]) -> None:
        if text_of(file.attrs.get("kind", "")) != KIND:
            raise ModelError(f"'{path}' is no reduced model; give a file made by 'upbead reduce'")
        if file.attrs["format_version"] not in VERSIONS:
            raise ModelError(f"'{path}' has format {file.attrs['format_version']}; this package reads formats 1 and 2")

        self._read_modes(file["modes"])
        self.loads, self.readings = _texts(file["loads/name"]), _texts(file["readings/name"])
        self.duration = file["loads/duration"][()]  # s, of each load in the case
        self.load_units = dict(zip(self.loads, _texts(file["loads/unit"]))) if "loads/unit" in file else {}
        self.units = dict(zip(self.readings, _texts(file["readings/unit"])))
        self.descriptions = dict(zip(self.readings, _texts(file["readings/description"])))
        self.validity = dict(file["validity"].attrs)
        self.caisson_mass = file["case"].attrs["caisson_mass"]  # kg/m
        self.title = text_of(file.attrs.get("title", ""))
        self.warnings = warnings_in(file)

        self.nested = None  # the larger models for error estimates; None for files of older versions
        if "nested" in file:
            self.nested = [self._larger(file[f"nested/{name}"]) for name in ("middle", "reference")]

    def _read_modes(self, group: Any) -> None:
        def pairs(name: str) -> Any:
            values = group[name][()]
            return values[..., 0] + 1j * values[..., 1]

        self.pole, self.load, self.reading = pairs("pole"), pairs("load"), pairs("reading")
        self.feedthrough, self.impulse = group["feedthrough"][()], group["impulse"][()]

    def _larger(self, group: Any) -> ReducedModel:
        model = object.__new__(ReducedModel)
        model._read_modes(group)
        model.loads, model.readings, model.units = self.loads, ["shear_force"], {"shear_force": "N/m"}
        model.descriptions, model.nested = {"shear_force": self.descriptions["shear_force"]}, None
        return model

    def __repr__(self) -> str:
        return f"<ReducedModel '{self.title}': loads {', '.join(self.loads)}; {self.pole.size} modes>"

    def respond(self, time: ArrayLike, loads: Mapping[str, ArrayLike]) -> dict[str, History]:
        """All readings at the times, from rest at t = 0.

        Parameters
        ----------
        time : array_like, shape (N,), s
            Ascending, time[0] = 0.
        loads : dict of array_like, shape (N,), N/m or Pa
            By name, linear between the times; loads that are not given are zero. A first value other than zero is a
            jump at t = 0, which has no effect on row 0.

        Returns
        -------
        dict of History, shape (N,)
            By reading, with its unit. The response is exact for any steps.
        """
        time = np.asarray(time, dtype=float)
        f = self._loads_as_rows(time, loads)
        z, _, integral = self._states(time, f)
        f_before = f.copy()
        f_before[:, 0] = 0.0
        y = (z @ self.reading.T).real.T + self.feedthrough @ f_before + self.impulse @ integral
        return {name: History(row, self.units[name], self.descriptions[name]) for name, row in zip(self.readings, y)}

    def _states(self, time: NDArray[np.float64], f: NDArray[np.float64]) -> tuple[NDArray[np.complex128], NDArray[np.complex128], NDArray[np.float64]]:
        """Modes and what drives them, a row for each time, and the integrals of the loads."""
        z = np.zeros((time.size, self.pole.size), dtype=complex)
        step = np.diff(time)
        drive = f.T @ self.load.T  # a row for each time, a column for each mode
        known = None
        for n, h in enumerate(step):
            if known is None or abs(h - known) > 1e-12 * h:  # equal steps share their exponentials
                known = h
                decay, phi_1, phi_2 = phi_functions(self.pole * h)
            z[n + 1] = decay * z[n] + h * ((phi_1 - phi_2) * drive[n] + phi_2 * drive[n + 1])
        integral = np.zeros_like(f)
        integral[:, 1:] = np.cumsum(0.5 * step * (f[:, 1:] + f[:, :-1]), axis=1)
        return z, drive, integral

    def peaks(self, time: ArrayLike, loads: Mapping[str, ArrayLike], reading: str = "shear_force") -> Peaks:
        """Largest and least value of a reading, between the times, too: within 1e-9 of the largest magnitude. Arguments as of
        respond()."""
        time = np.asarray(time, dtype=float)
        f = self._loads_as_rows(time, loads)
        i = self._number("reading", reading, self.readings)
        z, drive, integral = self._states(time, f)
        step = np.diff(time)
        slope = np.diff(f) / step
        rest = np.array([self.feedthrough[i] @ f[:, :-1] + self.impulse[i] @ integral[:, :-1],
                         self.feedthrough[i] @ slope + self.impulse[i] @ f[:, :-1], self.impulse[i] @ slope])
        steps = Pieces(time[:-1], step, z[:-1], drive[:-1], np.diff(drive, axis=0) / step[:, None], rest)
        found = (largest(steps, self.pole, self.reading[i], phi_functions, sign) for sign in (1, -1))
        return Peaks(*(number for one in found for number in one))

    @staticmethod
    def _number(what: str, name: str, known: list[str]) -> int:
        if name not in known:
            raise ModelError(f"the model has no {what} '{name}'{hint(name, known)}")
        return known.index(name)

    def error_estimate(self, time: ArrayLike, loads: Mapping[str, ArrayLike]) -> float | None:
        """A bound of the error of F_T's history by the model, over its largest value, the same as by `upbead
        respond`; None if the model's file has no nested models. Arguments as of respond()."""
        if self.nested is None:
            return None
        answers = [np.asarray(model.respond(time, loads)["shear_force"]) for model in (self, *self.nested)]
        model, middle, reference = answers
        peak = float(np.abs(model).max())
        if peak == 0.0:
            return 0.0
        return float(SAFETY_OF_MODEL * np.abs(reference - model).max()
                     + SAFETY_OF_MIDDLE * np.abs(reference - middle).max()) / peak

    def transfer(self, reading: str, load: str, frequency: ArrayLike) -> NDArray[np.complex128]:
        """Reading per unit of a load over frequency.

        Parameters
        ----------
        reading, load : str
            One of `readings`, one of `loads`.
        frequency : array_like, shape (F,), Hz

        Returns
        -------
        ndarray of complex, shape (F,)
        """
        s = 2j * np.pi * np.asarray(frequency, dtype=float)[:, None]
        i, k = self._number("reading", reading, self.readings), self._number("load", load, self.loads)
        product = self.reading[i] * self.load[:, k]
        both = product / (s - self.pole) + product.conj() / (s - self.pole.conj())
        found: NDArray[np.complex128] = self.feedthrough[i, k] + self.impulse[i, k] / s[:, 0] + 0.5 * both.sum(axis=1)
        return found

    def _loads_as_rows(self, time: NDArray[np.float64], loads: Mapping[str, ArrayLike]) -> NDArray[np.float64]:
        if time.ndim != 1 or time.size < 2 or time[0] != 0.0 or not np.all(np.diff(time) > 0):
            raise ModelError("the times must ascend, and begin with 0")
        rows = np.zeros((len(self.loads), time.size))
        for name, values in loads.items():
            if name not in self.loads:
                raise ModelError(f"'{name}' is no load of the model; its loads are: {', '.join(self.loads)}")
            if np.shape(values) != time.shape:
                raise ModelError(f"the load '{name}' has not as many values as there are times")
            rows[self.loads.index(name)] = values
        return rows


def fine(time: NDArray[np.float64], loads: Mapping[str, NDArray[np.float64]], model: ReducedModel, end: float) -> tuple[NDArray[np.float64], dict[str, NDArray[np.float64]]]:
    """The wave on steps that resolve a peak, as in 'upbead respond'; zero outside its own times."""
    step = min(1.0 / (20.0 * model.validity["highest_frequency"]), *(model.duration[model.duration > 0] / 50.0))
    grid = np.linspace(0.0, end, max(2, int(np.ceil(end / step)) + 1))
    grid = np.union1d(grid, time[(time >= 0.0) & (time <= end)])
    return grid, {name: np.interp(grid, time, values, left=0.0, right=0.0) for name, values in loads.items()}
