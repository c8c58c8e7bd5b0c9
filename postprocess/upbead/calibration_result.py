"""The results of `upbead calibrate`."""

from pathlib import Path

import numpy as np

from .errors import UserError
from .h5 import open_h5
from .results import read_summary, require
from .shown import Shown


class CalibrationResult(Shown):
    """Its summary, and the waves by column: `columns["alpha_star"]`, ..."""

    def __init__(self, folder):
        folder = Path(folder)
        require(folder, "calibrate")
        try:
            self.summary = read_summary(folder)
            self.models = self.summary["models"]
            self.given = self.summary["given"]
            with open_h5(folder / "results.h5") as file:
                self.columns = {name: file[name][:] for name in file}
        except (OSError, KeyError) as error:
            raise UserError(f"'{folder}' holds no results of 'upbead calibrate': {error}") from error
        self.model_of_row = np.array([name.decode() for name in self.columns["model"]])

    def __repr__(self):
        return f"<CalibrationResult '{self.summary['title']}': models {', '.join(self.models)}>"

    def points(self, model, ratio, measure):
        """alpha*, k and T at the size of [section], of one model at one r; waves without tau_0 are left out."""
        k = self.columns[f"k_{measure}"]
        rows = (self.model_of_row == model) & np.isclose(self.columns["ratio"], ratio) & (k > 0)
        period = self.columns["period"][rows] / np.sqrt(self.models[model]["scale"])
        return self.columns["alpha_star"][rows], k[rows], period

    def highest(self, measure):
        """A limit below which most k are."""
        k = self.columns[f"k_{measure}"]
        return 1.05 * max(1, np.quantile(k[k > 0], 0.999)) if k.any() else 1

    def fits(self, model, measure):
        """The fits of one model, one for each r."""
        return [fit for fit in self.models[model]["fits"] if fit["measure"] == measure and fit["ratio"] is not None]
