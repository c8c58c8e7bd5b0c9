"""Reads the histories of a result folder (results.h5, summary.json)."""

import json
from dataclasses import dataclass

import h5py
import numpy as np

from common import UserError

# Units that people read, by the unit of the file: (factor, name), the largest that keeps the peak at 1 or more.
SCALES = {
    "N/m": [(1e-6, "MN/m"), (1e-3, "kN/m"), (1.0, "N/m")],
    "Pa": [(1e-6, "MPa"), (1e-3, "kPa"), (1.0, "Pa")],
    "m": [(1e3, "mm")],
    "rad": [(1e3, "mrad")],
}


@dataclass
class History:
    """One quantity over time, in the unit of the file (SI)."""

    values: np.ndarray
    unit: str
    description: str

    def scale(self, others=()):
        """(factor, unit) in which this and the others are read best."""
        peak = max(float(np.max(np.abs(h.values), initial=0.0)) for h in (self, *others))
        scales = SCALES.get(self.unit, [(1.0, self.unit)])
        return next((s for s in scales if peak * s[0] >= 1.0), scales[-1])


class Result:
    """The histories of one run. Paths are below /history, as 'caisson/displacement_x'."""

    def __init__(self, folder):
        self.folder = folder
        if not folder.is_dir():
            raise UserError(f"there is no folder '{folder}'")
        path = folder / "results.h5"
        if not path.is_file():
            raise UserError(f"'{folder}' has no results.h5: is it the folder of a finished run?")
        try:
            self.file = h5py.File(path, "r")
        except OSError as error:
            raise UserError(f"'{path}' is no HDF5 file, or is not complete: {error}") from error
        self.path = path
        self.time = self.history("time").values
        if self.time.size < 2:
            raise UserError(f"'{path}': /history/time has fewer than two times")
        self.summary = self._read_summary()

    def _read_summary(self):
        path = self.folder / "summary.json"
        if not path.is_file():
            return {}
        try:
            return json.loads(path.read_text(encoding="utf-8"))
        except ValueError as error:
            raise UserError(f"'{path}' is no JSON: {error}") from error

    @property
    def title(self):
        return self.summary.get("title") or self.folder.resolve().name

    @property
    def has_caisson(self):
        return "/history/shear_force" in self.file

    def history(self, name):
        full_name = f"/history/{name}"
        data = self.file.get(full_name)
        if not isinstance(data, h5py.Dataset):
            raise UserError(f"'{self.path}' has no dataset {full_name}")
        values = np.asarray(data[()], dtype=float)
        if values.ndim != 1 or (name != "time" and values.size != self.time.size):
            raise UserError(f"'{self.path}': {full_name} has the shape {values.shape}, not that of /history/time")

        def attribute(key):
            value = data.attrs.get(key, "")
            return value.decode() if isinstance(value, bytes) else str(value)

        return History(values, attribute("unit"), attribute("description"))

    def probes(self):
        """{quantity: {probe: History}}, in the order of the file."""
        group = self.file.get("/history/probes")
        quantities = {}
        for probe in group or ():
            for quantity in group[probe]:
                quantities.setdefault(quantity, {})[probe] = self.history(f"probes/{probe}/{quantity}")
        return quantities
