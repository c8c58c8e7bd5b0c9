"""Reads the tables that a run whose caisson may slip wrote besides its histories.

That is /interface (by time and node) and /coupled (over time, of the caisson that slips as a whole).
"""

from __future__ import annotations

from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from .errors import UserError
from .results import Folder, Result

SMALL = 1e-9  # of the largest slip or opening: smaller values are round-off


class SlipResult(Result):
    """A Result with position and length of the bottom's nodes, and slip, opening, shear, normal by time and node.

    Attributes
    ----------
    position, length : ndarray, shape (M,), m
        Of each node of the bottom, from its seaward end.
    slip, opening : ndarray, shape (N, M), m
    shear, normal : ndarray, shape (N, M), N/m
        Forces of the nodes.
    """

    def __init__(self, folder: Folder) -> None:
        super().__init__(folder)
        self.position, self.length = self.array("interface/position"), self.array("interface/length")
        shape = (self.time.size, self.position.size)
        self.slip, self.opening, self.shear, self.normal = (
            self.array(f"interface/{name}", shape) for name in ("slip", "opening", "shear_force", "normal_force"))

    def array(self, name: str, shape: tuple[int, ...] | None = None) -> NDArray[np.float64]:
        """A dataset outside /history as a plain array."""
        if not isinstance(self.file.get(name), h5py.Dataset):
            raise UserError(f"'{self.path}' has no dataset /{name}: run the case with "
                            "regions.caisson.interface.kind = \"friction\" and a load that slides or lifts the caisson")
        values = self.dataset(f"/{name}").values
        if shape is not None and values.shape != shape:
            raise UserError(f"'{self.path}': /{name} has the shape {values.shape}, not {shape}")
        return values

    def has_coupled(self) -> bool:
        """Whether the results have the slip as a whole; if not, summary["sliding"]["why_not_coupled"] gives the
        reason."""
        return "coupled" in self.file

    def number(self, path: str) -> Any:
        """A number of the summary, by its keys with dots."""
        value: Any = self.summary
        for key in path.split("."):
            value = value.get(key) if isinstance(value, dict) else None
        if value is None:
            raise UserError(f"'{self.folder / 'summary.json'}' has no number {path}")
        return value

    def is_open(self) -> NDArray[np.bool_]:
        """Whether a node is open, by time and node."""
        opened: NDArray[np.bool_] = self.opening > SMALL * max(np.max(np.abs(self.opening)), np.max(np.abs(self.slip)))
        return opened

    def slips(self) -> NDArray[np.bool_]:
        """Whether a node in contact slips in the step that ends at a time; at the first time none does."""
        moved = np.abs(np.diff(self.slip, axis=0, prepend=self.slip[:1])) > SMALL * np.max(np.abs(self.slip))
        slipping: NDArray[np.bool_] = moved & ~self.is_open()
        return slipping

    def contact(self) -> NDArray[np.float64]:
        """Share of the bottom's width in contact, over time."""
        share: NDArray[np.float64] = np.where(self.is_open(), 0.0, self.length).sum(axis=1) / self.length.sum()
        return share
