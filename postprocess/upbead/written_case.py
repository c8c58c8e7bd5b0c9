"""Cases that are made in Python: a mapping becomes a case file, a function of time or an array becomes a table that the
program reads."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from os import PathLike
from pathlib import Path
from typing import Any, Union

import numpy as np
from numpy.typing import NDArray

from .errors import UserError
from .sampled import sampled_curve, sampled_field, sampled_function
from .sampled_until import overlaid, sampled_until
from .stress_law import WORD, StressLaw
from .toml import toml_text

Case = Union[str, "PathLike[str]", Mapping[str, Any]]

# keys whose value is the path of a file or folder; a text counts as one where that is there
PATHS = ("file", "history", "gauges", "from", "against", "states", "model", "record", "case", "cases", "logo", "reduced_model", "soil_model")
MARK = "# written by upbead from Python\n"  # the first line of each file: only files that begin with it are written over
UNITS = {"force": "N/m", "traction": "Pa", "normal": "Pa", "pressure": "Pa", "displacement": "m", "velocity": "m/s", "acceleration": "m/s2",
         "body_force": "N/m3", "source": "1/s", "gravity": "m/s2"}


class Beside(str):
    """The name of a file that was written beside the case, which stays relative to it."""


def name_of(case: Case, ending: str = "") -> str:
    """The name of the folder of results: of the file, else of the title.

    >>> name_of("cases/fig2b-model.toml"), name_of({"title": "Our pier, 2nd try"}), name_of({})
    ('fig2b-model', 'our-pier-2nd-try', 'case')
    """
    if not isinstance(case, Mapping):
        return Path(case).stem + ending
    words = re.findall(r"\w+", str(case.get("title", "")).lower())
    return ("-".join(words)[:60] or "case") + ending


def as_file(case: Case, folder: Path, values: Mapping[str, Any] | None = None) -> Path:
    """The path of a case; one that is a mapping is written to given.toml in the folder, its tables beside it. `values` are those
    of --set, for the end of the run."""
    if not isinstance(case, Mapping):
        return Path(case)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        keep_of_others(folder / "given.toml")
        return write(case, folder, "given", overlaid({}, values))
    except OSError as error:
        raise UserError(f"cannot write the case to '{folder}': {error}") from error


def write(case: Mapping[str, Any], folder: Path, stem: str, changes: Mapping[str, Any] | None = None) -> Path:
    """Writes STEM.toml, a file for each table (STEM-NUMBER-NAME.csv) and for each case within (STEM-case.toml). `changes` are tables of
    other values, by --set or of the study around; they are not written, but what is sampled depends on the end of the run."""
    path = folder / f"{stem}.toml"
    plain = {key: value for key, value in case.items() if value is not None}
    end = sampled_until(case, changes)

    def within(one: Any, name: str) -> Any:  # a case of a study
        if not isinstance(one, Mapping):
            return one
        keep_of_others(folder / f"{name}.toml")
        return Beside(write(one, folder, name, {"time": {"end": end}} if end is not None else None).name)

    if "case" in plain:
        plain["case"] = within(plain["case"], f"{stem}-case")
    if isinstance(plain.get("cases"), (list, tuple)):
        plain["cases"] = [within(one, f"{stem}-case-{n}") for n, one in enumerate(plain["cases"], 1)]
    elif "cases" in plain:
        plain["cases"] = within(plain["cases"], f"{stem}-cases")
    if isinstance(plain.get("loads"), Mapping):
        plain["loads"] = {name: with_tables(name, load, end, folder / file_name(stem, n, name)) for n, (name, load) in enumerate(plain["loads"].items(), 1)}
    if isinstance(plain.get("regions"), Mapping):
        plain["regions"] = {name: with_curves(name, region) for name, region in plain["regions"].items()}
    path.write_text(MARK + toml_text(with_paths(plain, folder)), encoding="utf-8")
    return path


def file_name(stem: str, n: int, name: str) -> str:
    """Of the table of the n-th load: other letters than those of ASCII may not be known to a file system, the number tells loads apart.

    >>> file_name("given", 2, "two-\u6ce2")
    'given-2-two-_.csv'
    """
    return f"{stem}-{n}-{re.sub(r'[^-.0-9A-Za-z_]', '_', name)[:60]}.csv"


def keep_of_others(path: Path) -> None:
    """Raises UserError where a file is that Python has not written."""
    if path.exists() and (not path.is_file() or not path.read_bytes().startswith(MARK.strip().encode())):
        raise UserError(f"'{path}' would be written over, and does not begin with '{MARK.strip()}'; move it, or choose another folder by out")


def with_paths(value: Any, folder: Path, key: str = "") -> Any:
    """The same with absolute paths, as those of a case file are relative to it, those of Python to the working folder."""
    if isinstance(value, Mapping):
        return {name: with_paths(inside, folder, name) for name, inside in value.items()}
    if isinstance(value, (list, tuple)):
        return [with_paths(inside, folder, key) for inside in value]
    if isinstance(value, PathLike):
        return str(Path(value).absolute())
    if isinstance(value, str) and not isinstance(value, Beside) and key in PATHS and (Path(value).exists() or (folder / value).exists()):
        return str(Path(value).absolute())  # where it is in the folder alone it is missed by its full name
    return value


def with_curves(name: str, region: Any) -> Any:
    """A region whose law of stress may be a function, with its word, and whose curves of G/G_max and damping over the shear strain may be
    functions, with pairs in their place."""
    if not isinstance(region, Mapping):
        return region
    if isinstance(region.get("law"), StressLaw) or callable(region.get("law")):
        region = {**region, "law": WORD}
    strain = region.get("strain")
    if not isinstance(strain, Mapping):
        return region
    found = {key: sampled_curve(value) if callable(value) else value for key, value in strain.items()}
    for key, pairs in found.items():
        if callable(strain[key]) and not np.isfinite(pairs).all():
            raise UserError(f"regions.{name}.strain.{key}: the function has values that are no finite numbers between strains of 1e-7 and 0.1")
    return {**region, "strain": found}


def with_tables(name: str, load: Any, end: float | None, path: Path) -> Any:
    """A load whose history or transducers are numbers or functions, with a file in their place."""
    if not isinstance(load, Mapping):
        return load
    changed = dict(load)
    if callable(load.get("history")) or isinstance(load.get("history"), (tuple, list, np.ndarray)):
        unit = UNITS.get(str(load.get("kind", "force")), "N/m")
        write_table(path, ["time (s)", f"{name} ({unit})"], history(name, load["history"], end))
        changed["history"] = Beside(path.name)
    if callable(load.get("gauges")):
        changed |= gauges(name, load, end, path)
    return changed


def history(name: str, given: Any, end: float | None) -> NDArray[np.float64]:
    """Times and values in columns, of a function or of a pair of arrays."""
    if callable(given):
        return sampled_function(given, end_of(name, end))
    try:
        table = np.column_stack([np.asarray(column, dtype=float) for column in given])
    except (TypeError, ValueError) as error:
        raise UserError(f"loads.{name}.history: give (times, values), two arrays of one length, or a function of time") from error
    if table.ndim != 2 or table.shape[1] != 2 or len(table) < 2:
        raise UserError(f"loads.{name}.history: give (times, values), two arrays of one length, or a function of time")
    return table


def gauges(name: str, load: Mapping[str, Any], end: float | None, path: Path) -> dict[str, Any]:
    """Keys of a load whose pressure is a function p(s, t): its values at the places in `heights`, as of transducers there."""
    places = np.asarray(load.get("heights", ()), dtype=float) if not isinstance(load.get("heights"), Mapping) else np.empty(0)
    if places.ndim != 1 or places.size < 2:
        raise UserError(f"loads.{name}.heights: give the places at which p(s, t) is sampled, such as numpy.linspace(0, 16, 33)")
    pressure: Callable[[Any, Any], Any] = load["gauges"]
    write_table(path, ["time (s)", *(f"p{n} (Pa)" for n in range(1, places.size + 1))], sampled_field(pressure, places, end_of(name, end)))
    chosen = {"kind": "pressures", "to_base": "constant", "to_crest": "constant", **load}
    return {**chosen, "gauges": Beside(path.name), "heights": {f"p{n}": float(place) for n, place in enumerate(places, 1)}}


def end_of(name: str, end: float | None) -> float:
    if end is None:
        raise UserError(f"loads.{name} is a function of time, which is sampled until time.end: give that, in s")
    if not np.isfinite(end):
        raise UserError(f"loads.{name} is a function of time, which is sampled until the largest time.end: vary that by values, or with a bound (to, high)")
    return end


def write_table(path: Path, head: list[str], columns: NDArray[np.float64]) -> None:
    if not np.isfinite(columns).all():
        raise UserError(f"'{path.name}' would have values that are no finite numbers; mend the function or the arrays")
    keep_of_others(path)
    np.savetxt(path, columns, delimiter=",", header=MARK + ",".join(head), comments="", fmt="%.17g", encoding="utf-8")
