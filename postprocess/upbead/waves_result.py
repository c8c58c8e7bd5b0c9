"""The results of `upbead waves`: a summary, with an object for each wave."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import outputs
from .errors import UserError
from .history import History
from .named import Named
from .results import Folder
from .shown import Shown
from .tables import about, data_frame, data_set

if TYPE_CHECKING:
    import pandas
    import xarray


class WavesSummary(Shown, Named):
    """The summary as a dict, shown in a notebook as a table with a figure."""

    def columns(self) -> dict[str, Any]:
        """{key: numbers of all waves, with their unit}; keys whose values are no numbers in any wave are left out."""
        waves: dict[str, Any] = self["waves"]
        keys = dict.fromkeys(key for wave in waves.values() for key, value in wave.items() if is_number(value))
        rows = {key: [wave.get(key) if is_number(wave.get(key)) else float("nan") for wave in waves.values()] for key in keys}
        return {key: History(row, outputs.unit(f"waves.NAME.{key}", "waves"), outputs.label(f"waves.NAME.{key}", "waves")) for key, row in rows.items()}

    def to_pandas(self) -> pandas.DataFrame:
        """A row for each wave, by its name; `attrs["units"]` has the unit of each column."""
        return data_frame({"wave": list(self["waves"]), **self.columns()}, "wave", about(self.get("title", ""), self))

    def to_xarray(self) -> xarray.Dataset:
        """The numbers of the waves over their names; the attribute `units` of each variable has its unit."""
        variables = {name: (("wave",), values) for name, values in self.columns().items()}
        return data_set(variables, {"wave": list(self["waves"])}, about(self.get("title", ""), self))

    def __repr__(self) -> str:
        names = list(self["waves"])
        told = ", ".join(names[:3]) + (f" and {len(names) - 3} more" if len(names) > 3 else "")
        return f"<WavesSummary '{self.get('title', '')}': waves {told}>"


def is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def read_waves(path: Folder) -> WavesSummary:
    """The summary of a folder or of a summary.json, with its waves."""
    path = Path(path)
    file = path / "summary.json" if path.is_dir() else path
    try:
        summary = json.loads(file.read_text(encoding="utf-8"), object_hook=Named)
    except OSError as error:
        raise UserError(f"cannot read '{file}': {error.strerror}") from error
    except ValueError as error:
        raise UserError(f"'{file}' is no JSON: {error}") from error
    if not isinstance(summary, dict) or not summary.get("waves") or "section" not in summary:
        raise UserError(f"'{file}' holds no waves; give the summary.json of 'upbead waves'")
    return WavesSummary(summary)
