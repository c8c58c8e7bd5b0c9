"""The results of `upbead study`: study.csv, study.h5 and summary.json of a folder."""

import csv
from functools import cached_property
from pathlib import Path

import numpy as np

from .errors import UserError
from .h5 import open_h5
from .results import read_summary, require, text_of
from .shown import Shown


class StudyTable(Shown):
    """The finished runs, a row for each; `table["response.peak_shear"]` is a column as an array."""

    def __init__(self, folder):
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

    def __getitem__(self, name):
        """A column as numbers, nan for empty cells; a column of words as words."""
        if name not in self.columns:
            raise UserError(f"'{self.folder / 'study.csv'}' has no column {name}: add it to 'read' of the study")
        found = self.numbers(name)
        return self.words(name) if found is None else found

    def __len__(self):
        return len(self.rows)

    def __repr__(self):
        failed = f", {len(self.failed)} more failed" if self.failed else ""
        return f"<StudyTable '{self.name}': {len(self.rows)} runs{failed}; {', '.join(self.keys + self.reads)}>"

    @property
    def name(self):
        return self.folder.resolve().name

    def numbers(self, name):
        """The column as numbers, nan where a cell is empty; None if it holds words."""
        try:
            return np.array([float(row[name] or "nan") for row in self.rows])
        except ValueError:
            return None

    def words(self, name):
        return [row[name] for row in self.rows]

    @cached_property
    def _groups(self):
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
    def keys(self):
        """The keys that were varied."""
        return self._groups[0]

    @property
    def reads(self):
        """The numbers read from each run."""
        return self._groups[1]

    @property
    def units(self):
        """Units of the varied keys, by name."""
        return self._groups[2]
