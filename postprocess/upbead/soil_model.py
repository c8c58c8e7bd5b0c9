"""A model of soils (soils.h5 of `upbead reduce --soils`): any soil of its box in a tenth of a second.

    with upbead.SoilModel("soils.h5", histories=["shear_force"]) as model:
        answer = model.respond("storm.csv", {"regions.seabed.shear_modulus": 25e6})
        print(answer.ratio, answer.error_estimate)

docs/soils.md has the method. The program answers, as a child that waits for further soils.
"""

import tempfile
from concurrent.futures import ThreadPoolExecutor
from os import getpid
from pathlib import Path
from typing import NamedTuple

import numpy as np

from . import program as upbead_program
from .errors import ModelError, SoilError, UserError
from .h5 import open_h5
from .results import text_of
from .soil_answer import soil_answer
from .soil_gradient import gradient, number
from .soil_server import SoilServer, SoilServers

KIND, VERSION = "upbead soil model", 1
MOST_WAVES = 4  # whose servers are kept


class Axis(NamedTuple):
    """Range of a key; logarithmic: whether soils are spread over its logarithm."""

    low: float
    high: float
    logarithmic: bool


class SoilModel:
    """box: {key: Axis}. loads, readings: names. A copy in another process, by pickle or fork, starts children of its own."""

    def __init__(self, path, *, histories=(), friction=None, buoyant_weight=None, end=None, jobs=1, program=None):
        """histories: readings whose histories are answered, too. friction, buoyant_weight: for S, in place of the case's
        [sliding]. end: of the answers (s). jobs: soils at once in respond_all()."""
        self.path = Path(path).resolve()
        self.options = {"histories": ",".join(histories), "friction": friction, "buoyant-weight": buoyant_weight, "end": end}
        self.jobs, self.program, self.servers, self.pid = jobs, program, {}, getpid()
        try:
            with open_h5(path) as file:
                self.read(file)
        except (OSError, KeyError) as error:
            raise ModelError(f"'{path}' cannot be read as a model of soils: {error}") from error
        unknown = [name for name in histories if name not in self.readings]
        if unknown:
            raise UserError(f"the model has no reading '{unknown[0]}'; it has {', '.join(self.readings)}")

    def read(self, file):
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

    def __repr__(self):
        return f"<SoilModel '{self.title}': {', '.join(self.box)}; loads {', '.join(self.loads)}>"

    def respond(self, wave, soil=None):
        """The SoilAnswer of a soil, {key: value}; keys that are not given have the case's value.

        wave: path of a file of waves or of a case, a list of such, or (times, {load: values}), straight between the
        times, values of shape (N) or (waves, N). Raises SoilError where the soil cannot be answered, CaseError where the
        wave or an option is wrong.
        """
        asked = {key: float(value) for key, value in (soil or {}).items()}
        wrong = [f"{key} = {value}" for key, value in asked.items() if not np.isfinite(value)]
        if wrong:
            raise SoilError(f"{', '.join(wrong)} is no finite number", asked)
        line = self.servers_of(wave).ask(asked)
        if "why" in line:
            raise SoilError(line["why"], asked)
        return soil_answer(line)

    def respond_all(self, wave, soils):
        """A list with the SoilAnswer of each soil, or with the SoilError of one that cannot be answered."""

        def answered(soil):
            try:
                return self.respond(wave, soil)
            except SoilError as error:
                return error

        with ThreadPoolExecutor(max(1, self.jobs)) as pool:
            return list(pool.map(answered, soils))

    def gradient(self, wave, soil, quantity):
        """The Gradient of a quantity: the name of a number of a wave's answer, or a function of the SoilAnswer that gives
        a number or an array of fixed length."""
        whole = self.respond(wave, soil).soil
        return gradient(self.box, whole, lambda at: number(self.respond(wave, at), quantity))

    def servers_of(self, wave):
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

    def begin(self, wave):
        folder = None
        if is_table(wave):
            folder = tempfile.mkdtemp(prefix="upbead-wave-")
            wave = write_table(Path(folder) / "wave.h5", *wave)
        files = [wave] if isinstance(wave, (str, Path)) else wave
        words = [upbead_program.find(self.program), "respond", self.path, *files, "--soil", "-"]
        for option, value in self.options.items():
            words += [f"--{option}", value] if value not in (None, "") else []
        return SoilServer(list(map(str, words)), folder)

    def close(self):
        """Ends the children."""
        if self.pid == getpid():
            for servers in self.servers.values():
                servers.close()
            self.servers = {}

    def __enter__(self):
        return self

    def __exit__(self, *error):
        self.close()

    def __del__(self):
        if hasattr(self, "servers"):
            self.close()

    def __getstate__(self):
        return {**self.__dict__, "servers": {}}


def is_table(wave):
    return isinstance(wave, tuple) and len(wave) == 2 and isinstance(wave[1], dict)


def name_of(wave):
    """What tells one wave from another: files with the time of their last change, or the numbers of a table."""
    if is_table(wave):
        return tuple((name, np.asarray(values, dtype=float).tobytes()) for name, values in [("", wave[0]), *sorted(wave[1].items())])
    files = [wave] if isinstance(wave, (str, Path)) else wave
    paths = [Path(file).resolve() for file in files]
    return tuple((str(path), path.stat().st_mtime_ns if path.exists() else 0) for path in paths)


def write_table(path, time, loads):
    with open_h5(path, "w") as file:
        file["time"] = np.asarray(time, dtype=float)
        for name, values in loads.items():
            file[name] = np.asarray(values, dtype=float)
    return path
