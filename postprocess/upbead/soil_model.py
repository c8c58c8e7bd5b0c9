"""A model of soils (soils.h5 of `upbead reduce --soils`): any soil of its box in a tenth of a second.

    with upbead.SoilModel("soils.h5", histories=["shear_force"]) as model:
        answer = model.respond("storm.csv", {"regions.seabed.shear_modulus": 25e6})
        print(answer.ratio, answer.error_estimate)

docs/soils.md has the method. The program answers, as a child that waits for further soils.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from os import PathLike, getpid
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from . import program as upbead_program
from .errors import ModelError, SoilError, UserError
from .h5 import open_h5
from .results import text_of
from .soil_answer import SoilAnswer, soil_answer
from .soil_gradient import Gradient, gradient, number
from .soil_server import SoilServer, SoilServers

Soil = Mapping[str, float]
Wave = Any  # a path, a list of paths, or (times, {load: values})

KIND, VERSION = "upbead soil model", 1
MOST_WAVES = 4  # whose servers are kept


class Axis(NamedTuple):
    """Range of a key; logarithmic: whether soils are spread over its logarithm."""

    low: float
    high: float
    logarithmic: bool


class SoilModel:
    """Any soil of a box, answered by one reduced model; a copy in another process, by pickle or fork, starts children of its own.

    Parameters
    ----------
    path : path
        soils.h5 of `upbead reduce --soils`.
    histories : list of str
        Readings whose histories are answered, too.
    friction, buoyant_weight : float, optional
        For S, in place of the case's [sliding]; -, N/m.
    end : float, optional
        Of the answers, s.
    jobs : int
        Soils at once in respond_all().
    program : path, optional

    Attributes
    ----------
    box : dict of Axis
        The range of each key.
    loads, readings : list of str
    """

    box: dict[str, Axis]
    title: str
    loads: list[str]
    readings: list[str]

    def __init__(self, path: str | PathLike[str], *, histories: Sequence[str] = (), friction: float | None = None, buoyant_weight: float | None = None,
                 end: float | None = None, jobs: int = 1, program: str | PathLike[str] | None = None) -> None:
        self.path = Path(path).resolve()
        self.options = {"histories": ",".join(histories), "friction": friction, "buoyant-weight": buoyant_weight, "end": end}
        self.jobs, self.program, self.pid = jobs, program, getpid()
        self.servers: dict[Any, Any] = {}
        try:
            with open_h5(path) as file:
                self.read(file)
        except (OSError, KeyError) as error:
            raise ModelError(f"'{path}' cannot be read as a model of soils: {error}") from error
        unknown = [name for name in histories if name not in self.readings]
        if unknown:
            raise UserError(f"the model has no reading '{unknown[0]}'; it has {', '.join(self.readings)}")

    def read(self, file: Any) -> None:
        kind, version = text_of(file.attrs.get("kind", "")), file.attrs.get("format_version")
        if kind != KIND:
            raise ModelError(f"'{self.path}' is no model of soils; give a file made by 'upbead reduce --soils'")
        if version != VERSION:
            raise ModelError(f"'{self.path}' has format {version}; this package reads format {VERSION}")
        columns = (file[f"box/{name}"][()] for name in ("low", "high", "logarithmic"))
        keys = [text_of(key) for key in file["box/key"][()]]
        self.box = {key: Axis(float(low), float(high), bool(logarithmic)) for key, low, high, logarithmic in zip(keys, *columns)}
        self.title = text_of(file.attrs.get("title", ""))
        self.loads = [text_of(name) for name in file["loads/name"][()]]
        names = [text_of(name) for name in file["family/readings/name"][()]]
        self.readings = names[: len(names) - int(file["family"].attrs["slip_readings"])]

    def __repr__(self) -> str:
        return f"<SoilModel '{self.title}': {', '.join(self.box)}; loads {', '.join(self.loads)}>"

    def respond(self, wave: Wave, soil: Soil | None = None) -> SoilAnswer:
        """The answer to a wave in a soil.

        Parameters
        ----------
        wave : path, list of paths, or (times, {load: values})
            Files of waves or of a case; or times (s), shape (N,), and values (N/m or Pa), shape (N,) or (waves, N), straight
            between the times.
        soil : dict, optional
            Values by key, SI units; keys that are not given have the case's value.

        Returns
        -------
        SoilAnswer

        Raises
        ------
        SoilError
            The soil cannot be answered.
        CaseError
            The wave or an option is wrong.
        """
        asked = {key: float(value) for key, value in (soil or {}).items()}
        wrong = [f"{key} = {value}" for key, value in asked.items() if not np.isfinite(value)]
        if wrong:
            raise SoilError(f"{', '.join(wrong)} is no finite number", asked)
        line = self.servers_of(wave).ask(asked)
        if "why" in line:
            raise SoilError(line["why"], asked)
        return soil_answer(line)

    def respond_all(self, wave: Wave, soils: Iterable[Soil]) -> list[SoilAnswer | SoilError]:
        """A list with the SoilAnswer of each soil, or with the SoilError of one that cannot be answered."""

        def answered(soil: Soil) -> SoilAnswer | SoilError:
            try:
                return self.respond(wave, soil)
            except SoilError as error:
                return error

        with ThreadPoolExecutor(max(1, self.jobs)) as pool:
            return list(pool.map(answered, soils))

    def gradient(self, wave: Wave, soil: Soil, quantity: str | Callable[[SoilAnswer], Any]) -> Gradient:
        """The Gradient of a quantity: the name of a number of a wave's answer, or a function of the SoilAnswer that gives
        a number or an array of fixed length."""
        here = self.respond(wave, soil)
        known_to = here.error * float(np.max(np.abs(number(here, quantity))))
        return gradient(self.box, here.soil, lambda at: number(self.respond(wave, at), quantity), known_to)

    def servers_of(self, wave: Wave) -> Any:
        if self.pid != getpid():  # a fork: the children are the parent's
            for servers in self.servers.values():
                servers.close()
            self.servers, self.pid = {}, getpid()
        key = name_of(wave)
        if key not in self.servers:
            while len(self.servers) >= MOST_WAVES:
                self.servers.pop(next(iter(self.servers))).close()
            self.servers[key] = SoilServers(lambda: self.begin(wave), max(1, self.jobs))
        return self.servers[key]

    def begin(self, wave: Wave) -> SoilServer:
        folder = None
        if is_table(wave):
            folder = tempfile.mkdtemp(prefix="upbead-wave-")
            wave = write_table(Path(folder) / "wave.h5", *wave)
        files = [wave] if isinstance(wave, (str, Path)) else wave
        words = [upbead_program.find(self.program), "respond", self.path, *files, "--soil", "-"]
        for option, value in self.options.items():
            words += [f"--{option}", value] if value not in (None, "") else []
        return SoilServer(list(map(str, words)), folder)

    def close(self) -> None:
        """Ends the children."""
        if self.pid == getpid():
            for servers in self.servers.values():
                servers.close()
            self.servers = {}

    def __enter__(self) -> SoilModel:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def __del__(self) -> None:
        if hasattr(self, "servers"):
            self.close()

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "servers": {}}


def is_table(wave: Wave) -> bool:
    return isinstance(wave, tuple) and len(wave) == 2 and isinstance(wave[1], dict)


def name_of(wave: Wave) -> tuple[Any, ...]:
    """What tells one wave from another: files with the time of their last change, or the numbers of a table."""
    if is_table(wave):
        return tuple((name, np.asarray(values, dtype=float).tobytes()) for name, values in [("", wave[0]), *sorted(wave[1].items())])
    files = [wave] if isinstance(wave, (str, Path)) else wave
    paths = [Path(file).resolve() for file in files]
    return tuple((str(path), path.stat().st_mtime_ns if path.exists() else 0) for path in paths)


def write_table(path: Path, time: Any, loads: Mapping[str, Any]) -> Path:
    with open_h5(path, "w") as file:
        file["time"] = np.asarray(time, dtype=float)
        for name, values in loads.items():
            file[name] = np.asarray(values, dtype=float)
    return path
