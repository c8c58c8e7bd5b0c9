"""A reduced model (reduced.h5 of `upbead reduce`): a sum of modes, evaluated by numpy alone.

    model = ReducedModel("prototype.h5")
    time = np.linspace(0.0, 2.0, 2001)
    answer = model.respond(time, {"impact": force})     # N/m at those times
    print(answer["shear_force"].max() / answer["force"].max())
"""

import csv

import h5py
import numpy as np

from .errors import ModelError
from .history import History
from .results import text_of

KIND, VERSION = "upbead reduced model", 1


def phi_functions(x):
    """exp(x), phi_1 = (exp(x) - 1)/x and phi_2 = (phi_1 - 1)/x, by their series near 0, where these cancel."""
    small = np.abs(x) < 0.5
    safe = np.where(small, 1.0, x)
    near = np.where(small, x, 0.0)
    phi_2 = np.zeros_like(x)
    for n in range(20, 1, -1):  # Horner: sum of x^j / (j + 2)!
        phi_2 = (1.0 + near * phi_2) / n
    phi_2 = np.where(small, phi_2, ((np.exp(safe) - 1.0) / safe - 1.0) / safe)
    phi_1 = 1.0 + x * phi_2
    return 1.0 + x * phi_1, phi_1, phi_2


def _texts(dataset):
    return [text_of(text) for text in dataset[()]]


class ReducedModel:
    """A sum of modes; docs/output.md has the layout of the file.

    z_m' = pole_m z_m + sum_k load_mk f_k,  y_i = Re sum_m reading_im z_m + feedthrough_ik f_k + impulse_ik int f_k dt
    """

    def __init__(self, path):
        try:
            with h5py.File(path, "r") as file:
                self._read(file, path)
        except (OSError, KeyError) as error:
            raise ModelError(f"'{path}' cannot be read as a reduced model: {error}") from error

    def _read(self, file, path):
        if text_of(file.attrs.get("kind", "")) != KIND:
            raise ModelError(f"'{path}' is no reduced model; give a file made by 'upbead reduce'")
        if file.attrs["format_version"] != VERSION:
            raise ModelError(f"'{path}' has format {file.attrs['format_version']}; this package reads format {VERSION}")

        def pairs(name):
            values = file[f"modes/{name}"][()]
            return values[..., 0] + 1j * values[..., 1]

        self.pole, self.load, self.reading = pairs("pole"), pairs("load"), pairs("reading")
        self.feedthrough, self.impulse = file["modes/feedthrough"][()], file["modes/impulse"][()]
        self.loads, self.readings = _texts(file["loads/name"]), _texts(file["readings/name"])
        self.duration = file["loads/duration"][()]  # s, of each load in the case
        self.units = dict(zip(self.readings, _texts(file["readings/unit"])))
        self.descriptions = dict(zip(self.readings, _texts(file["readings/description"])))
        self.validity = dict(file["validity"].attrs)
        self.caisson_mass = file["case"].attrs["caisson_mass"]  # kg/m
        self.title = text_of(file.attrs.get("title", ""))

    def __repr__(self):
        return f"<ReducedModel '{self.title}': loads {', '.join(self.loads)}; {self.pole.size} modes>"

    def respond(self, time, loads):
        """All readings at the times, {name: History}, from rest at t = 0.

        time: ascending (s), time[0] = 0. loads: {name: array}, straight between the times; what is not given is zero.
        Exact, whatever the steps. A first value that is not zero is a jump at t = 0, of which row 0 knows nothing yet.
        """
        time = np.asarray(time, dtype=float)
        f = self._loads_as_rows(time, loads)
        z = np.zeros((time.size, self.pole.size), dtype=complex)
        step = np.diff(time)
        drive = f.T @ self.load.T  # one row a time, one column a mode
        known = None
        for n, h in enumerate(step):
            if known is None or abs(h - known) > 1e-12 * h:  # equal steps share their exponentials
                known = h
                decay, phi_1, phi_2 = phi_functions(self.pole * h)
            z[n + 1] = decay * z[n] + h * ((phi_1 - phi_2) * drive[n] + phi_2 * drive[n + 1])
        integral = np.zeros_like(f)
        integral[:, 1:] = np.cumsum(0.5 * step * (f[:, 1:] + f[:, :-1]), axis=1)
        f_before = f.copy()
        f_before[:, 0] = 0.0
        y = (z @ self.reading.T).real.T + self.feedthrough @ f_before + self.impulse @ integral
        return {name: History(row, self.units[name], self.descriptions[name]) for name, row in zip(self.readings, y)}

    def transfer(self, reading, load, frequency):
        """Reading per unit of the load at frequencies (Hz), complex."""
        s = 2j * np.pi * np.asarray(frequency, dtype=float)[:, None]
        i, k = self.readings.index(reading), self.loads.index(load)
        product = self.reading[i] * self.load[:, k]
        both = product / (s - self.pole) + product.conj() / (s - self.pole.conj())
        return self.feedthrough[i, k] + self.impulse[i, k] / s[:, 0] + 0.5 * both.sum(axis=1)

    def _loads_as_rows(self, time, loads):
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


def read_wave(path, model):
    """Times and {load: values} of a CSV file with a header, as 'upbead respond' reads it."""
    try:
        with open(path, newline="", encoding="utf-8-sig") as file:
            names, *rows = [[cell.strip() for cell in row] for row in csv.reader(file) if row]
        columns = np.array(rows, dtype=float).T
    except (OSError, ValueError) as error:
        raise ModelError(f"'{path}' cannot be read as a table of numbers below a header: {error}") from error
    if len(columns) < 2 or len(columns) != len(names):
        raise ModelError(f"'{path}': give a time (s) and a load in every row")
    if len(names) == 2 and len(model.loads) == 1:
        names[1] = model.loads[0]
    return columns[0], dict(zip(names[1:], columns[1:]))


def fine(time, loads, model, end):
    """The wave on steps that show a peak, as 'upbead respond' takes them; zero outside its own times."""
    step = min(1.0 / (20.0 * model.validity["highest_frequency"]), *(model.duration[model.duration > 0] / 50.0))
    grid = np.linspace(0.0, end, max(2, int(np.ceil(end / step)) + 1))
    grid = np.union1d(grid, time[(time >= 0.0) & (time <= end)])
    return grid, {name: np.interp(grid, time, values, left=0.0, right=0.0) for name, values in loads.items()}
