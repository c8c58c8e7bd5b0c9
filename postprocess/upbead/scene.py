"""A scene that is built in code: the tables of a case file as objects."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from os import PathLike
from pathlib import Path
from typing import Any

from .commands import Place, Values, reduce, run
from .errors import UserError
from .reduced_model import ReducedModel
from .results import Result
from .toml import toml_text
from .written_case import PATHS, write

TABLES = ("regions", "boundaries", "loads", "probes")


class Scene(dict[str, Any]):
    """The tables of a case as a dict, with a method for each kind of table; docs/reference/case.md has all keys with units and ranges.

    Parameters
    ----------
    title : str
        Of the scene; the folder of results is named by it.
    geometry : str, optional
        A shipped geometry, with the `parameters` below.
    file : path, optional
        A .geo or .msh of gmsh, in place of a geometry.
    parameters : dict, optional
        Of the geometry: {"caisson_width": 18, ...}, m.

    Examples
    --------
    >>> column = Scene("A column", geometry="column", parameters={"height": 10})
    >>> _ = column.region("soil", "porous", shear_modulus=2e7).boundary("bottom", displacement="fixed")
    >>> column["regions"]["soil"]["kind"], column["mesh"]["geometry"]
    ('porous', 'column')
    """

    def __init__(self, title: str, geometry: str | None = None, *, file: str | PathLike[str] | None = None,
                 parameters: Mapping[str, float] | None = None, **mesh: Any) -> None:
        super().__init__(title=title)
        if (geometry is None) == (file is None):
            raise UserError("give a scene either a geometry or the file of a mesh")
        given = {"geometry": geometry, "file": file, **mesh, "parameters": dict(parameters or {}) or None}
        self["mesh"] = {key: value for key, value in given.items() if value is not None}

    @classmethod
    def read(cls, path: str | PathLike[str]) -> Scene:
        """The scene of a case file; its paths become absolute, so that the scene can be solved from anywhere."""
        path = Path(path)
        try:
            found = tomllib.loads(path.read_text(encoding="utf-8-sig"))
        except OSError as error:
            raise UserError(f"cannot read '{path}': {error.strerror}") from error
        except ValueError as error:
            raise UserError(f"'{path}' is no TOML: {error}") from error
        scene = cls.__new__(cls)
        scene.update(beside(found, path.parent))
        return scene

    def region(self, name: str, kind: str, /, **keys: Any) -> Scene:
        """A region of the mesh, [regions.NAME]: kind "porous", "solid", "rigid", "water"; keys in SI units.

        `strain` may have functions of the shear strain: modulus=f, G/G_max, and damping=f, a ratio, from strains of 1e-7 to 0.1.
        `law` may be a StressLaw, or a function that remembers nothing.
        """
        return self.table("regions", name, kind=kind, **keys)

    def boundary(self, name: str, /, **keys: Any) -> Scene:
        """A curve of the mesh, [boundaries.NAME]: displacement="fixed", pressure="open", ..."""
        return self.table("boundaries", name, **keys)

    def load(self, name: str, /, **keys: Any) -> Scene:
        """A load, [loads.NAME], on a `boundary` or a `region`.

        `history` is a path, (times, values) or a function f(t); `gauges` a path or a function p(s, t), whose values (Pa) are taken at
        the places `heights` (m): heights y of the wall, or with over_x = True places x. t in s; values in the unit of the
        load's kind, N/m of a force. A function is sampled until time.end, on steps at which straight lines between the values differ from it by at most
        1e-4 of the largest; a jump is found. It may take arrays or one number at a time.
        """
        return self.table("loads", name, **keys)

    def probe(self, name: str, /, at: tuple[float, float], **keys: Any) -> Scene:
        """A place (x, y), m, at which the fields are recorded, [probes.NAME]."""
        return self.table("probes", name, at=list(at), **keys)

    def put(self, **tables: Any) -> Scene:
        """Other keys and tables: scene.put(time={"end": 1.0}, sliding={"friction": 0.6}); those that are there are joined."""
        for key, value in tables.items():
            self[key] = {**self[key], **value} if isinstance(value, Mapping) and isinstance(self.get(key), Mapping) else value
        return self

    def table(self, part: str, name: str, /, **keys: Any) -> Scene:
        self.setdefault(part, {})[name] = keys
        return self

    def run(self, values: Values = None, out: Place = None, program: Place = None) -> Result:
        """`upbead.run` of this scene."""
        return run(self, values, out, program)

    def reduce(self, values: Values = None, out: Place = None, program: Place = None) -> ReducedModel:
        """`upbead.reduce` of this scene."""
        return reduce(self, values, out, program)

    def save(self, path: str | PathLike[str]) -> Path:
        """Writes the scene as a case file, with its tables beside it."""
        path = Path(path)
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            return write(self, path.parent, path.stem)
        except OSError as error:
            raise UserError(f"cannot write '{path}': {error.strerror}") from error

    def __repr__(self) -> str:
        counts = ", ".join(f"{len(self[name])} {name}" for name in TABLES if self.get(name))
        return f"<Scene '{self.get('title', '')}': {counts or 'empty'}>"

    def __str__(self) -> str:
        """As a case file; functions and arrays are named as such."""
        return toml_text(shown(self))


def shown(value: Any) -> Any:
    if callable(value):
        return f"<function {getattr(value, '__name__', '')}>"
    if isinstance(value, Mapping):
        return {key: shown(inside) for key, inside in value.items()}
    return value


def beside(found: dict[str, Any], folder: Path) -> dict[str, Any]:
    """Tables of a file with paths that hold from anywhere; relative ones of a file are relative to it."""
    return {key: at(value, folder, key) for key, value in found.items()}


def at(value: Any, folder: Path, key: str) -> Any:
    if isinstance(value, dict):
        return {name: at(inside, folder, name) for name, inside in value.items()}
    if isinstance(value, str) and key in PATHS and (folder / value).exists():
        return str((folder / value).absolute())
    return value
