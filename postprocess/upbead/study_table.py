"""The results of `upbead study`: study.csv, study.h5 and summary.json of a folder."""

from __future__ import annotations

import csv
from collections.abc import Iterator
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import outputs
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


WORDS = ("status", "message", "checks_failing", "warnings", "void")  # columns that hold words, in a study without any, too


class StudyTable(Shown):
    """The finished runs, a row for each; `table["response.peak_shear"]` is a column as an array.

    Attributes
    ----------
    columns : list of str
        All columns, by which the table is indexed; iterating goes over them. `len` is the number of runs.
    keys, reads : list of str
        The keys that were varied, and the numbers that were read.
    failed : list of dict
        The rows of runs that failed, with their `message`.
    """

    def __init__(self, folder: Folder) -> None:
        self.folder = Path(folder)
        require(folder, "study")
        try:
            with open(self.folder / "study.csv", newline="", encoding="utf-8") as file:
                reader = csv.DictReader(file)
                rows, self.columns = list(reader), list(reader.fieldnames or [])
        except OSError as error:
            raise UserError(f"'{folder}' holds no results of 'upbead study': {error.strerror}") from error
        self.failed = [row for row in rows if row["status"] != "done"]
        self.rows = [row for row in rows if row["status"] == "done"]
        if not self.rows:
            raise UserError(f"all {len(self.failed)} runs of '{folder}' failed, see the column 'message' of study.csv")
        self.summary = read_summary(self.folder)

    @property
    def void(self) -> NDArray[np.bool_]:
        """The runs of which no verdict may be drawn, as their own warnings say; shape (runs,)."""
        return np.array([bool(row.get("void")) for row in self.rows])

    def __getitem__(self, name: str) -> Any:
        """A column as numbers, shape (runs,), nan for empty cells; a column of words as words."""
        if name not in self.columns:
            raise UnknownName(f"'{self.folder / 'study.csv'}' has no column {name}: add it to 'read' of the study{hint(name, self.columns)}")
        found = self.numbers(name)
        return self.words(name) if found is None else found

    def sound(self, name: str) -> Any:
        """The same with nan in void runs."""
        found = self[name]
        return np.where(self.void, np.nan, found) if isinstance(found, np.ndarray) else found

    def __contains__(self, name: object) -> bool:
        return name in self.columns

    def __iter__(self) -> Iterator[str]:
        return iter(self.columns)

    def __len__(self) -> int:
        return len(self.rows)

    def column(self, name: str) -> Any:
        """The same as by [name], with its unit where it has numbers."""
        found = self[name]
        return History(found, self.units.get(name) or outputs.unit(name), outputs.label(name)) if isinstance(found, np.ndarray) else found

    def to_pandas(self) -> pandas.DataFrame:
        """The finished runs as a DataFrame, a row for each run; `attrs["units"]` has the unit of each column.

        Raises
        ------
        MissingPackage
            pandas is not installed.
        """
        return data_frame({name: self.column(name) for name in self.columns}, about=about(self.name, self.summary))

    def to_xarray(self) -> xarray.Dataset:
        """The finished runs as a Dataset over their number, `run`; the attribute `units` of each variable has its unit.

        Raises
        ------
        MissingPackage
            xarray is not installed.
        """
        columns = {name: self.column(name) for name in self.columns}
        run = columns.pop("run", np.arange(len(self)))
        return data_set({name: (("run",), values) for name, values in columns.items()}, {"run": run}, about(self.name, self.summary))

    def __repr__(self) -> str:
        failed = f", {len(self.failed)} more failed" if self.failed else ""
        failed += f", {self.void.sum()} of them void" if self.void.any() else ""
        return f"<StudyTable '{self.name}': {len(self.rows)} runs{failed}; {', '.join(self.keys + self.reads)}>"

    @property
    def name(self) -> str:
        return self.folder.resolve().name

    def numbers(self, name: str) -> NDArray[np.float64] | None:
        """The column as numbers, nan where a cell is empty; None if it holds words."""
        if name in WORDS:
            return None
        try:
            return np.array([float(row[name] or "nan") for row in self.rows])
        except ValueError:
            return None

    def words(self, name: str) -> list[str]:
        return [row[name] for row in self.rows]

    @cached_property
    def _groups(self) -> tuple[list[str], list[str], dict[str, str]]:
        """Names of varied keys and of read numbers, units by name."""
        try:
            with open_h5(self.folder / "study.h5") as file:
                keys, reads = ([name for name in self.columns if name in file.get(group, {})]
                               for group in ("varied", "read"))
                units = {key: text_of(file["varied"][key].attrs.get("unit", "")) for key in keys}
        except OSError as error:
            raise UserError(f"'{self.folder}' holds no results of 'upbead study': {error}") from error
        return ["case"] * ("case" in self.columns) + keys, reads, units

    @property
    def keys(self) -> list[str]:
        """The keys that were varied."""
        return self._groups[0]

    @property
    def reads(self) -> list[str]:
        """The numbers read from each run."""
        return self._groups[1]

    @property
    def units(self) -> dict[str, str]:
        """Units of the varied keys, by name."""
        return self._groups[2]
