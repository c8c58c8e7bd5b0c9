"""The results of `upbead expected`."""

import json
from pathlib import Path


from .errors import UserError
from .h5 import open_h5
from .shown import Shown


class ExpectedResult(Shown):
    """Over the height of the waves (m): number of waves per metre, S of one wave and expected sliding distance per
    metre, by law."""

    def __init__(self, folder):
        folder = Path(folder)
        self.name = folder.name.removesuffix("-expected")
        try:
            self.summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
            with open_h5(folder / "results.h5") as file:
                heights = file["heights"]
                self.height, self.waves = heights["height"][:], heights["waves"][:]
                self.distance = {law: data[:] for law, data in heights["distance"].items()}
                self.contribution = {law: data[:] for law, data in heights["contribution"].items()}
                self.shear = self._ratio(heights)
                self.heel_pressure = heights["heel_pressure"][:] if "heel_pressure" in heights else None
        except (OSError, KeyError, json.JSONDecodeError) as error:
            raise UserError(f"'{folder}' holds no results of 'upbead expected': {error}") from error

    def __repr__(self):
        return f"<ExpectedResult '{self.summary['title']}': laws {', '.join(self.distance)}>"

    @staticmethod
    def _ratio(heights):
        """Peak F_T over peak P by height, if there is a reduced model."""
        return heights["peak_shear"][:] / heights["peak_force"][:] if "peak_shear" in heights else None

    def thresholds(self):
        """Heights from which on a wave slides the caisson, for the laws that have such a height."""
        found = self.summary["expected"]["threshold_height"].values()
        return [height for height in found if height is not None]
