"""The results of `upbead run`: results.h5, summary.json and case.toml of a folder."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Iterator, Mapping
from functools import cached_property
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

import h5py
import numpy as np

from . import told
from .errors import UnknownName, UserError
from .h5 import open_h5
from .history import History
from .named import Named, named
from .near import hint
from .shown import Shown
from .tables import about, data_frame, data_set, long_columns

if TYPE_CHECKING:
    import pandas
    import xarray

Folder = str | PathLike[str]


def text_of(value: Any) -> str:
    return value.decode() if isinstance(value, bytes) else str(value)


def read_summary(folder: Folder) -> Named:
    """The summary of a folder as a dict; empty where there is none."""
    path = Path(folder) / "summary.json"
    if not path.is_file():
        return Named()
    try:
        found: Named = json.loads(path.read_text(encoding="utf-8"), object_hook=Named)
        return found
    except (ValueError, RecursionError) as error:
        raise UserError(f"'{path}' is no JSON: {error}") from error


def read_case(folder: Folder) -> Named:
    """The effective case of a folder, with all defaults, as a dict; empty where there is none."""
    path = Path(folder) / "case.toml"
    if not path.is_file():
        return Named()
    try:
        found: Named = named(tomllib.loads(path.read_text(encoding="utf-8")))
        return found
    except (ValueError, RecursionError) as error:
        raise UserError(f"'{path}' is no TOML: {error}") from error


def command_of(folder: Folder) -> str | None:
    """The command of the program that wrote the results of a folder, or None."""
    folder, summary = Path(folder), read_summary(folder) if Path(folder).is_dir() else Named()
    for command, is_it in (
        ("sheet", "parts" in summary),
        # another command's summary beside it is newer: each command leaves the files of others
        ("study", (folder / "study.csv").is_file() and (not summary or "runs" in summary)),
        ("reliability", "modes" in summary and "codes" in summary),
        ("waves", isinstance(summary.get("waves"), dict) and "section" in summary),
        ("expected", "expected" in summary),
        ("calibrate", "models" in summary and "given" in summary),
        ("run", (folder / "results.h5").is_file()),
        ("respond", (folder / "responses.h5").is_file()),
        ("reduce", (folder / "reduced.h5").is_file()),
    ):
        if is_it:
            return command
    return None


def require(folder: Folder, command: str) -> None:
    """Raises UserError where a folder has no results of this command, and says whose it has."""
    found = command_of(folder)
    if found != command:
        whose = f"but those of 'upbead {found}'" if found else "nor of another command: give the folder that it wrote"
        raise UserError(f"'{folder}' holds no results of 'upbead {command}', {whose}")


class Result(Shown, Mapping[str, History]):
    """The histories and tables of one run; a mapping of the histories by their paths below /history.

    Attributes
    ----------
    folder : Path
        Where results.h5, summary.json and case.toml are.
    time : History, shape (N,), s
        Of every history.
    summary : dict
        summary.json: docs/output.md has each key with its unit.

    Notes
    -----
    `result["shear_force"]`, `result["caisson/displacement_x"]` are `History`: numpy arrays with `unit` and
    `description`, of the length of `result.time`. `result["/interface/slip"]`, with a slash in front, is any dataset
    of results.h5; `result.table("interface")` are all datasets of a group. SI units throughout.
    """

    def __init__(self, folder: Folder) -> None:
        self.folder = folder = Path(folder)
        if not folder.is_dir():
            raise UserError(f"there is no folder '{folder}'")
        path, whose = folder / "results.h5", command_of(folder)
        if not path.is_file():
            told = f"it holds results of 'upbead {whose}'" if whose else "is it the folder of a finished run?"
            raise UserError(f"'{folder}' has no results.h5: {told}")
        require(folder, "run")
        try:
            self.file = open_h5(path)
        except OSError as error:
            raise UserError(f"'{path}' is no HDF5 file, or is not complete: {error}") from error
        self.path = path
        self.time = self.history("time")
        if self.time.size < 2:
            raise UserError(f"'{path}': /history/time has fewer than two times")
        self.summary = read_summary(folder)

    @cached_property
    def case(self) -> Named:
        """The case with all defaults (case.toml), as a dict."""
        return read_case(self.folder)

    @property
    def title(self) -> str:
        return str(self.summary.get("title") or self.folder.resolve().name)

    @property
    def has_caisson(self) -> bool:
        return "/history/shear_force" in self.file

    def __getitem__(self, name: str) -> History:
        return self.dataset(name) if name.startswith("/") else self.history(name)

    def __contains__(self, name: object) -> bool:
        return isinstance(name, str) and isinstance(self.file.get(name if name.startswith("/") else f"/history/{name}"),
                                                    h5py.Dataset)

    def __iter__(self) -> Iterator[str]:
        return iter(datasets(self.file["/history"]))

    def __len__(self) -> int:
        return len(datasets(self.file["/history"]))

    __eq__, __hash__ = object.__eq__, object.__hash__  # results are not compared number by number

    def __repr__(self) -> str:
        name = type(self).__name__
        why = told.void(self.summary)
        return f"<{name} '{self.title}': {len(self)} histories of {self.time.size} times, to {self.time[-1]:.4g} s{f'; VOID: {why}' if why else ''}>"

    def __enter__(self) -> Result:
        return self

    def __exit__(self, *_: object) -> None:
        self.file.close()

    def history(self, name: str) -> History:
        """One quantity over time, shape (N,), by its path below /history."""
        full_name = f"/history/{name}"
        history = self.dataset(full_name)
        if history.ndim != 1 or (name != "time" and history.size != self.time.size):
            raise UserError(f"'{self.path}': {full_name} has the shape {history.shape}, not that of /history/time")
        return history

    def dataset(self, name: str) -> History:
        """Any numbers of results.h5, by their full path."""
        data = self.file.get(name)
        if not isinstance(data, h5py.Dataset):
            raise UnknownName(f"'{self.path}' has no dataset {name}{hint(name, self.meanings(name))}")
        return History(data[()], text_of(data.attrs.get("unit", "")), text_of(data.attrs.get("description", "")))

    def meanings(self, name: str) -> dict[str, str]:
        """{dataset: its description} of those that might be meant: the histories, or with a slash in front all of the file."""
        inside = name.startswith("/history/")
        group = self.file["/history"] if inside else self.file
        marks = {one: text_of(group[one].attrs.get("description", "")) for one in datasets(group)}
        return {one if inside else f"/{one}": mark for one, mark in marks.items()}

    @property
    def tables(self) -> list[str]:
        """Names of the groups other than /history, for `table`: interface, coupled, base, at_times, dense,
        measured/NAME."""
        groups = {name: group for name, group in self.file.items() if isinstance(group, h5py.Group)}
        nested = groups.pop("measured", {})
        return [name for name in groups if name not in ("history", "fields")] + [f"measured/{name}" for name in nested]

    def table(self, name: str) -> dict[str, History]:
        """All datasets of a group other than /history, by name: {"position": History, ...}."""
        group = self.file.get(name)
        if not isinstance(group, h5py.Group):
            known = ", ".join(self.tables) or "none"
            raise UnknownName(f"'{self.path}' has no table '{name}'; its tables are: {known}")
        return {key: self.dataset(f"/{name}/{key}") for key in datasets(group)}

    def to_pandas(self, table: str | None = None) -> pandas.DataFrame:
        """The histories as a DataFrame over time (s), or a table by its name.

        Parameters
        ----------
        table : str, optional
            One of `tables`. Of a table over time and place each pair is a row: interface has N times M nodes.

        Returns
        -------
        pandas.DataFrame
            `attrs["units"]` and `attrs["descriptions"]` have those of each column; SI units. `attrs["void"]` is why no verdict may be drawn,
            where that is so.

        Raises
        ------
        MissingPackage
            pandas is not installed.
        """
        known = about(self.title, self.summary)
        if table is None:
            return data_frame({"time": self.time, **{name: self[name] for name in self if name != "time"}}, "time", known)
        return data_frame(long_columns(self.table(table), self.time), about=known)

    def to_xarray(self, table: str | None = None) -> xarray.Dataset:
        """The histories as a Dataset over time (s), or a table by its name, over time and place.

        Parameters
        ----------
        table : str, optional
            One of `tables`.

        Returns
        -------
        xarray.Dataset
            Each variable has the attributes `units` and `long_name`; SI units.

        Raises
        ------
        MissingPackage
            xarray is not installed.
        """
        known = about(self.title, self.summary)
        if table is None:
            return data_set({name: (("time",), self[name]) for name in self if name != "time"}, {"time": self.time}, known)
        columns = self.table(table)
        dimensions = {name: self.dimensions(values) for name, values in columns.items()}
        axes = {"time": self.time} if any("time" in found for found in dimensions.values()) else {}
        axes |= {"position": columns["position"]} if dimensions.get("position") == ("place",) else {}
        variables = {name: (tuple("position" if one == "place" and "position" in axes else one for one in dimensions[name]), values)
                     for name, values in columns.items() if name not in axes}
        return data_set(variables, axes, known)

    def dimensions(self, values: History) -> tuple[str, ...]:
        """What the axes of a dataset are: time where an axis is as long as it, first; else a place or its number."""
        names = ["time" if axis == 0 and size == self.time.size else "place" if axis == values.ndim - 1 else f"axis_{axis}"
                 for axis, size in enumerate(values.shape)]
        return tuple(f"{name}_{size}" if name.startswith("axis") else name for name, size in zip(names, values.shape))

    def measured(self) -> dict[str, dict[str, Any]]:
        """Measured records: {name: {"time": History, "value": History, "reading": name of the corresponding
        history}}."""
        found = {}
        for name in self.file.get("/measured", ()):
            time, value = (self.dataset(f"/measured/{name}/{key}") for key in ("time", "value"))
            marks = {**self.file[f"measured/{name}"].attrs, **self.file[f"measured/{name}/value"].attrs}
            unit, description, reading = (text_of(marks.get(key, "")) for key in ("unit", "description", "reading"))
            found[name] = {"time": time, "value": History(value, unit, description), "reading": reading}
        return found

    def probes(self) -> dict[str, dict[str, History]]:
        """{quantity: {probe: History}}, in the order of the file."""
        group = self.file.get("/history/probes")
        quantities: dict[str, dict[str, History]] = {}
        for probe in group or ():
            for quantity in group[probe]:
                quantities.setdefault(quantity, {})[probe] = self.history(f"probes/{probe}/{quantity}")
        return quantities


def datasets(group: Any) -> list[str]:
    """Paths of all numeric datasets below a group; texts are left out."""
    found: list[str] = []
    group.visititems(lambda name, item: found.append(name) if is_numbers(item) else None)
    return found


def is_numbers(item: object) -> bool:
    return isinstance(item, h5py.Dataset) and np.issubdtype(item.dtype, np.number)
