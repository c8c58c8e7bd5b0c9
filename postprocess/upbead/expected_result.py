"""The results of `upbead expected`."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import h5py
import numpy as np
from numpy.typing import NDArray

from .errors import UnknownName, UserError
from .h5 import open_h5
from .history import History
from .near import hint
from .results import Folder, datasets, read_summary, require, text_of
from .shown import Shown
from .tables import about, data_frame, data_set

if TYPE_CHECKING:
    import pandas
    import xarray


class ExpectedResult(Shown, Mapping[str, History]):
    """Over the height of the waves (m): number of waves per metre, S of one wave and expected sliding distance per
    metre, by law; empty where storms were drawn and no record was summed. `lives` are S of each life (m), if any.

    A mapping of what results.h5 has over the height, "waves", "distance/paper", ..., each with its unit.
    """

    def __init__(self, folder: Folder) -> None:
        self.folder = folder = Path(folder)
        self.name = folder.name.removesuffix("-expected")
        require(folder, "expected")
        self.summary = read_summary(folder)
        try:
            with open_h5(folder / "results.h5") as file:
                heights = file.get("heights", {})
                self._over_height = {name: with_unit(heights[name]) for name in datasets(heights)} if heights else {}
                self.height, self.waves = (np.asarray(heights.get(name, ())) for name in ("height", "waves"))
                self.distance, self.contribution = ({law: data[:] for law, data in heights.get(name, {}).items()} for name in ("distance", "contribution"))
                self.shear = self._ratio(heights)
                self.heel_pressure = heights["heel_pressure"][:] if "heel_pressure" in heights else None
                self.lives = np.asarray(file.get("lives/sliding", ()))
        except (OSError, KeyError) as error:
            raise UserError(f"'{folder}' holds no results of 'upbead expected': {error}") from error

    def __getitem__(self, name: str) -> History:
        if name not in self._over_height:
            raise UnknownName(f"'{self.folder}' has no '{name}' over the height{hint(name, {one: values.description for one, values in self.items()})}")
        return self._over_height[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._over_height)

    def __len__(self) -> int:
        return len(self._over_height)

    __eq__, __hash__ = object.__eq__, object.__hash__

    def to_pandas(self) -> pandas.DataFrame:
        """What there is over the height of the waves (m); `attrs["units"]` has the unit of each column."""
        return data_frame(dict(self), "height" if "height" in self else None, about(self.summary.get("title", ""), self.summary))

    def to_xarray(self) -> xarray.Dataset:
        """What there is over the height of the waves (m); the attribute `units` of each variable has its unit."""
        variables = {name: (("height",), values) for name, values in self.items() if name != "height"}
        return data_set(variables, {"height": self["height"]} if "height" in self else {}, about(self.summary.get("title", ""), self.summary))

    def __bool__(self) -> bool:
        return True  # of lives alone, too

    def __repr__(self) -> str:
        laws = f"laws {', '.join(self.distance)}" if self.distance else f"{self.lives.size} lives"
        return f"<ExpectedResult '{self.summary.get('title', '')}': {laws}>"

    @staticmethod
    def _ratio(heights: Any) -> NDArray[np.float64] | None:
        """Peak F_T over peak P by height, if there is a reduced model."""
        return heights["peak_shear"][:] / heights["peak_force"][:] if "peak_shear" in heights else None

    def thresholds(self) -> list[float]:
        """Heights from which on a wave slides the caisson, for the laws that have such a height."""
        found = ((self.summary.get("expected") or {}).get("threshold_height") or {}).values()
        return [height for height in found if height is not None]


def with_unit(data: h5py.Dataset) -> History:
    return History(data[()], text_of(data.attrs.get("unit", "")), text_of(data.attrs.get("description", "")))
