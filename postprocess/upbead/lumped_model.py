"""The simplest reduced model: the caisson's mass on one spring and dashpot, F_T = c x' + k x."""

import numpy as np

from .errors import UserError
from .h5 import open_h5
from .results import text_of
from .shown import Shown


def complex_numbers(dataset):
    return dataset[..., 0] + 1j * dataset[..., 1]


def pairs(values):
    values = np.asarray(values, dtype=complex)
    return np.stack([values.real, values.imag], axis=-1)


class Source(Shown):
    """Data from the reduced model: the mode that carries most of F_T under a load."""

    def __init__(self, path, load):
        try:
            with open_h5(path) as file:
                loads, readings = [[text_of(t) for t in file[name][:]] for name in ("loads/name", "readings/name")]
                self.title = text_of(file.attrs["title"])
                self.case = dict(file["case"].attrs)
                self.validity = dict(file["validity"].attrs)
                peaks = file["loads/peak"][:]
                self.index = loads.index(load) if load else int(np.argmax(peaks))
                self.load, self.peak = loads[self.index], peaks[self.index]
                self.duration = file["loads/duration"][self.index]
                self.force = file["modes/feedthrough"][readings.index("force"), self.index]
                pole = complex_numbers(file["modes/pole"])
                answer = (complex_numbers(file["modes/reading"])[readings.index("shear_force")]
                          * complex_numbers(file["modes/load"])[:, self.index])
        except (OSError, KeyError, ValueError) as error:
            raise UserError(f"'{path}' is no reduced model with a caisson and that load: {error}") from error
        swings = np.abs(pole.imag) > 0
        share = np.where(swings, np.abs(answer / pole), 0)  # share under a lasting force
        self.pole = pole[share.argmax()]

    def __repr__(self):
        return f"<Source '{self.title}': {self.frequency:.3g} Hz, damping {100 * self.damping:.3g} %, load {self.load}>"

    @property
    def frequency(self):
        """Undamped natural frequency (Hz)."""
        return abs(self.pole) / (2 * np.pi)

    @property
    def damping(self):
        """Damping ratio."""
        return -self.pole.real / abs(self.pole)


def write_lumped(path, source):
    """One mode z' = pole z + P; F_T = Re(shear z), of m x'' + c x' + k x = P.

    Returns its frequency (Hz) and damping ratio.
    """
    mass = source.case["caisson_mass"]
    rate, half = abs(source.pole), -source.pole.real  # omega_n, zeta omega_n
    pole = complex(-half, np.sqrt(rate**2 - half**2))
    x = -1j / (mass * pole.imag)
    with open_h5(path, "w") as file:
        file.attrs.update(title=f"one mass for: {source.title}", program="lumped_model.py",
                          kind="upbead reduced model", format_version=1)
        file["case"] = ""
        file["case"].attrs.update(source.case)
        file["loads/name"], file["loads/unit"] = [source.load], ["N/m"]
        file["loads/peak"], file["loads/duration"] = [source.peak], [source.duration]
        file["readings/name"] = ["force", "shear_force", "caisson/displacement_x"]
        file["readings/unit"] = ["N/m", "N/m", "m"]
        file["readings/description"] = ["P", "F_T = c x' + k x", "x"]
        file["modes/pole"] = pairs([pole])
        file["modes/load"] = pairs([[source.force]])
        file["modes/reading"] = pairs([[0], [mass * (rate**2 + 2 * half * pole) * x], [x]])
        file["modes/feedthrough"] = np.array([[source.force], [0.0], [0.0]])
        file["modes/impulse"] = np.zeros((3, 1))
        file.create_group("validity").attrs.update(source.validity)
    return rate / (2 * np.pi), half / rate
