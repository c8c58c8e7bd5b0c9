"""The results of `upbead expected`."""

from pathlib import Path

import numpy as np

from .errors import UserError
from .h5 import open_h5
from .results import read_summary, require
from .shown import Shown


class ExpectedResult(Shown):
    """Over the height of the waves (m): number of waves per metre, S of one wave and expected sliding distance per
    metre, by law; empty where storms were drawn and no record was summed. `lives` are S of each life (m), if any."""

    def __init__(self, folder):
        self.folder = folder = Path(folder)
        self.name = folder.name.removesuffix("-expected")
        require(folder, "expected")
        self.summary = read_summary(folder)
        try:
            with open_h5(folder / "results.h5") as file:
                heights = file.get("heights", {})
                self.height, self.waves = (np.asarray(heights.get(name, ())) for name in ("height", "waves"))
                self.distance, self.contribution = ({law: data[:] for law, data in heights.get(name, {}).items()} for name in ("distance", "contribution"))
                self.shear = self._ratio(heights)
                self.heel_pressure = heights["heel_pressure"][:] if "heel_pressure" in heights else None
                self.lives = np.asarray(file.get("lives/sliding", ()))
        except (OSError, KeyError) as error:
            raise UserError(f"'{folder}' holds no results of 'upbead expected': {error}") from error

    def __repr__(self):
        laws = f"laws {', '.join(self.distance)}" if self.distance else f"{self.lives.size} lives"
        return f"<ExpectedResult '{self.summary.get('title', '')}': {laws}>"

    @staticmethod
    def _ratio(heights):
        """Peak F_T over peak P by height, if there is a reduced model."""
        return heights["peak_shear"][:] / heights["peak_force"][:] if "peak_shear" in heights else None

    def thresholds(self):
        """Heights from which on a wave slides the caisson, for the laws that have such a height."""
        found = ((self.summary.get("expected") or {}).get("threshold_height") or {}).values()
        return [height for height in found if height is not None]
