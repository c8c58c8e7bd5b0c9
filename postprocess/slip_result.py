"""Reads what a run whose caisson may slip wrote beside its histories.

That is /interface (by time and node) and /coupled (of the caisson that slips as a whole).
"""

import h5py
import numpy as np

from common import UserError
from histories import Result

SMALL = 1e-9  # of the largest slip or opening: less is round-off


class SlipResult(Result):
    """Arrays by time and node of the bottom; all in SI units."""

    def __init__(self, folder):
        super().__init__(folder)
        self.position, self.length = self.array("interface/position"), self.array("interface/length")
        shape = (self.time.size, self.position.size)
        self.slip, self.opening, self.shear, self.normal = (
            self.array(f"interface/{name}", shape) for name in ("slip", "opening", "shear_force", "normal_force"))

    def array(self, name, shape=None):
        data = self.file.get(name)
        if not isinstance(data, h5py.Dataset):
            raise UserError(f"'{self.path}' has no dataset /{name}: run the case with "
                            "regions.caisson.interface.kind = \"friction\" and a load that slides or lifts the caisson")
        values = np.asarray(data[()], dtype=float)
        if shape is not None and values.shape != shape:
            raise UserError(f"'{self.path}': /{name} has the shape {values.shape}, not {shape}")
        return values

    def number(self, path):
        """A number of the summary, by its keys with dots."""
        value = self.summary
        for key in path.split("."):
            value = value.get(key) if isinstance(value, dict) else None
        if value is None:
            raise UserError(f"'{self.folder / 'summary.json'}' has no number {path}")
        return value

    def is_open(self):
        return self.opening > SMALL * max(np.max(np.abs(self.opening)), np.max(np.abs(self.slip)))

    def slips(self):
        """Whether a node that touches slips in the step that ends at a time; nobody slips at the first."""
        moved = np.abs(np.diff(self.slip, axis=0, prepend=self.slip[:1])) > SMALL * np.max(np.abs(self.slip))
        return moved & ~self.is_open()

    def contact(self):
        """Share of the bottom's width in contact, over time."""
        return np.where(self.is_open(), 0.0, self.length).sum(axis=1) / self.length.sum()
