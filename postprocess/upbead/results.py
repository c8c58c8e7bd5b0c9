"""The results of `upbead run`: results.h5, summary.json and case.toml of a folder."""

import json
import tomllib
from collections.abc import Mapping
from functools import cached_property
from pathlib import Path

import h5py
import numpy as np

from .errors import UserError
from .h5 import open_h5
from .history import History
from .shown import Shown


def text_of(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def read_summary(folder):
    """The summary of a folder as a dict; empty where there is none."""
    path = Path(folder) / "summary.json"
    if not path.is_file():
        return {}
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (ValueError, RecursionError) as error:
        raise UserError(f"'{path}' is no JSON: {error}") from error


def read_case(folder):
    """The effective case of a folder, with all defaults, as a dict; empty where there is none."""
    path = Path(folder) / "case.toml"
    if not path.is_file():
        return {}
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except (ValueError, RecursionError) as error:
        raise UserError(f"'{path}' is no TOML: {error}") from error


def command_of(folder):
    """The command of the program that wrote the results of a folder, or None."""
    folder, summary = Path(folder), read_summary(folder) if Path(folder).is_dir() else {}
    for command, is_it in (
        ("sheet", "parts" in summary),
        ("study", (folder / "study.csv").is_file()),
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


def require(folder, command):
    """Raises UserError where a folder has no results of this command, and says whose it has."""
    found = command_of(folder)
    if found != command:
        whose = f"but those of 'upbead {found}'" if found else "nor of another command: give the folder that it wrote"
        raise UserError(f"'{folder}' holds no results of 'upbead {command}', {whose}")


class Result(Shown, Mapping):
    """The histories and tables of one run; a mapping of the histories by their paths below /history.

    `result["shear_force"]`, `result["caisson/displacement_x"]` are `History`: numpy arrays with `unit` and
    `description`, of the length of `result.time`. `result["/interface/slip"]`, with a slash in front, is any dataset
    of results.h5; `result.table("interface")` are all datasets of a group. SI units throughout.
    """

    def __init__(self, folder):
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
    def case(self):
        """The case with all defaults (case.toml), as a dict."""
        return read_case(self.folder)

    @property
    def title(self):
        return self.summary.get("title") or self.folder.resolve().name

    @property
    def has_caisson(self):
        return "/history/shear_force" in self.file

    def __getitem__(self, name):
        return self.dataset(name) if name.startswith("/") else self.history(name)

    def __contains__(self, name):
        return isinstance(name, str) and isinstance(self.file.get(name if name.startswith("/") else f"/history/{name}"),
                                                    h5py.Dataset)

    def __iter__(self):
        return iter(datasets(self.file["/history"]))

    def __len__(self):
        return len(datasets(self.file["/history"]))

    __eq__, __hash__ = object.__eq__, object.__hash__  # results are not compared number by number

    def __repr__(self):
        name = type(self).__name__
        return f"<{name} '{self.title}': {len(self)} histories of {self.time.size} times, to {self.time[-1]:.4g} s>"

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.file.close()

    def history(self, name):
        """One quantity over time, by its path below /history."""
        full_name = f"/history/{name}"
        history = self.dataset(full_name)
        if history.ndim != 1 or (name != "time" and history.size != self.time.size):
            raise UserError(f"'{self.path}': {full_name} has the shape {history.shape}, not that of /history/time")
        return history

    def dataset(self, name):
        """Any numbers of results.h5, by their full path."""
        data = self.file.get(name)
        if not isinstance(data, h5py.Dataset):
            raise UserError(f"'{self.path}' has no dataset {name}")
        return History(data[()], text_of(data.attrs.get("unit", "")), text_of(data.attrs.get("description", "")))

    @property
    def tables(self):
        """Names of the groups other than /history, for `table`: interface, coupled, base, at_times, dense,
        measured/NAME."""
        groups = {name: group for name, group in self.file.items() if isinstance(group, h5py.Group)}
        nested = groups.pop("measured", {})
        return [name for name in groups if name not in ("history", "fields")] + [f"measured/{name}" for name in nested]

    def table(self, name):
        """All datasets of a group other than /history, by name: {"position": History, ...}."""
        group = self.file.get(name)
        if not isinstance(group, h5py.Group):
            known = ", ".join(self.tables) or "none"
            raise UserError(f"'{self.path}' has no table '{name}'; its tables are: {known}")
        return {key: self.dataset(f"/{name}/{key}") for key in datasets(group)}

    def measured(self):
        """Measured records: {name: {"time": History, "value": History, "reading": name of the corresponding
        history}}."""
        found = {}
        for name in self.file.get("/measured", ()):
            time, value = (self.dataset(f"/measured/{name}/{key}") for key in ("time", "value"))
            marks = {**self.file[f"measured/{name}"].attrs, **self.file[f"measured/{name}/value"].attrs}
            unit, description, reading = (text_of(marks.get(key, "")) for key in ("unit", "description", "reading"))
            found[name] = {"time": time, "value": History(value, unit, description), "reading": reading}
        return found

    def probes(self):
        """{quantity: {probe: History}}, in the order of the file."""
        group = self.file.get("/history/probes")
        quantities = {}
        for probe in group or ():
            for quantity in group[probe]:
                quantities.setdefault(quantity, {})[probe] = self.history(f"probes/{probe}/{quantity}")
        return quantities


def datasets(group):
    """Paths of all numeric datasets below a group; texts are left out."""
    found = []
    group.visititems(lambda name, item: found.append(name) if is_numbers(item) else None)
    return found


def is_numbers(item):
    return isinstance(item, h5py.Dataset) and np.issubdtype(item.dtype, np.number)
