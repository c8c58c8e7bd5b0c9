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
from .toml import toml_text

Case = Union[str, "PathLike[str]", Mapping[str, Any]]

# keys whose value is the path of a file or folder; a text counts as one where that is there
PATHS = ("file", "history", "gauges", "from", "against", "states", "model", "record", "case", "cases", "logo", "reduced_model", "soil_model")
UNITS = {"force": "N/m", "traction": "Pa", "normal": "Pa", "pressure": "Pa", "displacement": "m", "velocity": "m/s", "acceleration": "m/s2",
         "body_force": "N/m3", "source": "1/s", "gravity": "m/s2"}


def name_of(case: Case, ending: str = "") -> str:
    """The name of the folder of results: of the file, else of the title.

    >>> name_of("cases/fig2b-model.toml"), name_of({"title": "Our pier, 2nd try"}), name_of({})
    ('fig2b-model', 'our-pier-2nd-try', 'case')
    """
    if not isinstance(case, Mapping):
        return Path(case).stem + ending
    words = re.findall(r"\w+", str(case.get("title", "")).lower())
    return ("-".join(words)[:60] or "case") + ending


def as_file(case: Case, folder: Path) -> Path:
    """The path of a case; one that is a mapping is written to given.toml in the folder, its tables beside it."""
    if not isinstance(case, Mapping):
        return Path(case)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        return write(case, folder, "given")
    except OSError as error:
        raise UserError(f"cannot write the case to '{folder}': {error}") from error


def write(case: Mapping[str, Any], folder: Path, stem: str) -> Path:
    """Writes STEM.toml, a file for each table (STEM-NAME.csv) and for each case within (STEM-case.toml)."""
    path = folder / f"{stem}.toml"
    plain = {key: value for key, value in case.items() if value is not None}
    for key in ("case", "cases"):  # of a study
        if isinstance(plain.get(key), Mapping):
            plain[key] = write(plain[key], folder, f"{stem}-{key}").name
        elif isinstance(plain.get(key), (list, tuple)):
            plain[key] = [write(one, folder, f"{stem}-case-{n}").name if isinstance(one, Mapping) else absolute(one) for n, one in enumerate(plain[key], 1)]
    if isinstance(plain.get("loads"), Mapping):
        plain["loads"] = {name: with_tables(name, load, case, folder, stem) for name, load in plain["loads"].items()}
    if isinstance(plain.get("regions"), Mapping):
        plain["regions"] = {name: with_curves(name, region) for name, region in plain["regions"].items()}
    path.write_text("# written by upbead from Python\n" + toml_text(with_paths(plain, folder)), encoding="utf-8")
    return path


def with_paths(value: Any, folder: Path, key: str = "") -> Any:
    """The same with absolute paths, as those of a case file are relative to it, those of Python to the working folder."""
    if isinstance(value, Mapping):
        return {name: with_paths(inside, folder, name) for name, inside in value.items()}
    if isinstance(value, PathLike):
        return str(Path(value).absolute())
    if isinstance(value, str) and key in PATHS and not (folder / value).is_file():
        return absolute(value)
    return value


def absolute(path: str | PathLike[str]) -> str:
    found = Path(path)
    return str(found.absolute()) if isinstance(path, PathLike) or found.exists() else str(path)


def with_curves(name: str, region: Any) -> Any:
    """A region whose curves of G/G_max and damping over the shear strain may be functions, with pairs in their place."""
    strain = region.get("strain") if isinstance(region, Mapping) else None
    if not isinstance(strain, Mapping):
        return region
    found = {key: sampled_curve(value) if callable(value) else value for key, value in strain.items()}
    for key, pairs in found.items():
        if callable(strain[key]) and not np.isfinite(pairs).all():
            raise UserError(f"regions.{name}.strain.{key}: the function has values that are no finite numbers between strains of 1e-7 and 0.1")
    return {**region, "strain": found}


def with_tables(name: str, load: Any, case: Mapping[str, Any], folder: Path, stem: str) -> Any:
    """A load whose history or transducers are numbers or functions, with files in their place."""
    if not isinstance(load, Mapping):
        return load
    changed = dict(load)
    file = f"{stem}-{re.sub(r'[^-.0-9A-Za-z_]', '_', name)}.csv"
    if callable(load.get("history")) or isinstance(load.get("history"), (tuple, list, np.ndarray)):
        unit = UNITS.get(str(load.get("kind", "force")), "N/m")
        write_table(folder / file, ["time (s)", f"{name} ({unit})"], history(name, load["history"], case))
        changed["history"] = file
    if callable(load.get("gauges")):
        changed |= gauges(name, load, case, folder / file)
    return changed


def history(name: str, given: Any, case: Mapping[str, Any]) -> NDArray[np.float64]:
    """Times and values in columns, of a function or of a pair of arrays."""
    if callable(given):
        return sampled_function(given, end_of(name, case))
    try:
        table = np.column_stack([np.asarray(column, dtype=float) for column in given])
    except (TypeError, ValueError) as error:
        raise UserError(f"loads.{name}.history: give (times, values), two arrays of one length, or a function of time") from error
    if table.ndim != 2 or table.shape[1] != 2 or len(table) < 2:
        raise UserError(f"loads.{name}.history: give (times, values), two arrays of one length, or a function of time")
    return table


def gauges(name: str, load: Mapping[str, Any], case: Mapping[str, Any], path: Path) -> dict[str, Any]:
    """Keys of a load whose pressure is a function p(s, t): its values at the places in `heights`, as of transducers there."""
    places = np.asarray(load.get("heights", ()), dtype=float) if not isinstance(load.get("heights"), Mapping) else np.empty(0)
    if places.ndim != 1 or places.size < 2:
        raise UserError(f"loads.{name}.heights: give the places at which p(s, t) is sampled, such as numpy.linspace(0, 16, 33)")
    pressure: Callable[[Any, Any], Any] = load["gauges"]
    write_table(path, ["time (s)", *(f"p{n} (Pa)" for n in range(1, places.size + 1))], sampled_field(pressure, places, end_of(name, case)))
    chosen = {"kind": "pressures", "to_base": "constant", "to_crest": "constant", **load}
    return {**chosen, "gauges": path.name, "heights": {f"p{n}": float(place) for n, place in enumerate(places, 1)}}


def end_of(name: str, case: Mapping[str, Any]) -> float:
    end = (case.get("time") or {}).get("end")
    if not isinstance(end, (int, float, np.number)) or not end > 0:
        raise UserError(f"loads.{name} is a function of time, which is sampled until time.end: give that, in s")
    return float(end)


def write_table(path: Path, head: list[str], columns: NDArray[np.float64]) -> None:
    if not np.isfinite(columns).all():
        raise UserError(f"'{path.name}' would have values that are no finite numbers; mend the function or the arrays")
    np.savetxt(path, columns, delimiter=",", header=",".join(head), comments="", fmt="%.17g")
