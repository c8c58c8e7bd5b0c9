"""The results of `upbead calibrate`."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .errors import UnknownName, UserError
from .h5 import open_h5
from .history import History
from .near import hint
from .results import Folder, read_summary, require, text_of
from .shown import Shown
from .tables import about, data_frame, data_set

if TYPE_CHECKING:
    import pandas
    import xarray


class CalibrationResult(Shown, Mapping[str, Any]):
    """Its summary, and a mapping of the waves by column: "alpha_star", "k_exact", ..., a row for each wave and model.

    Attributes
    ----------
    columns : dict of ndarray, shape (waves,)
    units : dict of str
        Of each column.
    models : dict
        By its name what was found of each model, with its fits.
    """

    def __init__(self, folder: Folder) -> None:
        folder = Path(folder)
        require(folder, "calibrate")
        try:
            self.summary = read_summary(folder)
            self.models = self.summary["models"]
            self.given = self.summary["given"]
            with open_h5(folder / "results.h5") as file:
                self.columns = {name: file[name][:] for name in file}
                self.units = {name: text_of(file[name].attrs.get("unit", "")) for name in file}
        except (OSError, KeyError) as error:
            raise UserError(f"'{folder}' holds no results of 'upbead calibrate': {error}") from error
        self.model_of_row = np.array([name.decode() for name in self.columns["model"]])

    def __getitem__(self, name: str) -> Any:
        """A column with its unit; that of the models as words."""
        if name not in self.columns:
            raise UnknownName(f"the calibration has no column '{name}'{hint(name, list(self.columns))}")
        values = self.columns[name]
        if values.dtype.kind not in "fiub":
            return np.array([text_of(value) for value in values])
        return History(values, self.units[name])

    def __iter__(self) -> Iterator[str]:
        return iter(self.columns)

    def __len__(self) -> int:
        return len(self.columns)

    __eq__, __hash__ = object.__eq__, object.__hash__

    def to_pandas(self) -> pandas.DataFrame:
        """A row for each wave and model; `attrs["units"]` has the unit of each column."""
        return data_frame(dict(self), about=about(self.summary.get("title", ""), self.summary))

    def to_xarray(self) -> xarray.Dataset:
        """The columns over the number of the row; the attribute `units` of each variable has its unit."""
        rows = np.arange(len(self.model_of_row))
        return data_set({name: (("row",), values) for name, values in self.items()}, {"row": rows}, about(self.summary.get("title", ""), self.summary))

    def __repr__(self) -> str:
        return f"<CalibrationResult '{self.summary['title']}': models {', '.join(self.models)}>"

    def points(self, model: str, ratio: float, measure: str) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
        """alpha*, k and T at the size of [section], of one model at one r; waves without tau_0 are left out."""
        k = self.columns[f"k_{measure}"]
        rows = (self.model_of_row == model) & np.isclose(self.columns["ratio"], ratio) & (k > 0)
        period = self.columns["period"][rows] / np.sqrt(self.models[model]["scale"])
        return self.columns["alpha_star"][rows], k[rows], period

    def highest(self, measure: str) -> float:
        """A limit below which most k are."""
        k = self.columns[f"k_{measure}"]
        return float(1.05 * max(1, np.quantile(k[k > 0], 0.999))) if k.any() else 1

    def fits(self, model: str, measure: str) -> list[dict[str, Any]]:
        """The fits of one model, one for each r."""
        return [fit for fit in self.models[model]["fits"] if fit["measure"] == measure and fit["ratio"] is not None]
