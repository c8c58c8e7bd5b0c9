"""Timed runs of whole processes, from fork to exit on one core, and their errors against a reference."""

import json
import os
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass, field

import h5py
import numpy as np

PEERS = pathlib.Path(__file__).with_name("peers")
sys.path.insert(0, str(PEERS))
import freefem  # noqa: E402  (a peer, found by the line above)
import scene  # noqa: E402

LONG = 1.5  # s: runs that take longer are timed once
clock = time.perf_counter  # or processor_time, where others compute on the same cores
ENVIRONMENT = {  # one core; where FreeFEM has its plugins
    "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "FF_LOADPATH": "/usr/lib/freefem++"}


class Failed(Exception):
    """A run that ended with an error; its message."""


@dataclass
class History:
    """The result of a run: times in s, values of the compared reading (F_T in N/m, or a pressure in Pa)."""

    time: np.ndarray
    value: np.ndarray
    peak: float
    unknowns: int = 0
    solves: int = 0
    steps: int = 0  # 0 for modes, which are exact in time
    wall: float = 0.0
    parts: dict = field(default_factory=dict)  # s

    def at(self, times):
        """Cubic through the four nearest steps."""
        first = np.clip(np.searchsorted(self.time, times) - 2, 0, len(self.time) - 4)
        t = np.stack([self.time[first + i] for i in range(4)])
        value = 0.0
        for i in range(4):
            weight = np.prod([(times - t[j]) / (t[i] - t[j]) for j in range(4) if j != i], axis=0)
            value = value + weight * self.value[first + i]
        return value

    def row(self, job, reference):
        """One line of the tables: errors are relative to the largest value of the reference."""
        if reference.wall == 0:  # the reference is a table: compared at its times
            difference = self.at(reference.time) - reference.value
        else:
            difference = self.value - reference.at(self.time)
        return {"series": job.series, "family": job.family, "label": job.label,
                "unknowns": self.unknowns, "solves": self.solves, "steps": self.steps, "wall": self.wall,
                "peak_error": float(abs(self.peak / reference.peak - 1)),
                "history_error": float(abs(difference).max() / abs(reference.peak)), "parts": self.parts}


def processor_time():
    """Processor time (s) of all finished child processes."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def timed(command, repeats):
    """Median seconds of `repeats` runs (of one run if it is long), and the output of the last run."""
    walls = []
    for _ in range(repeats):
        begin = clock()
        done = subprocess.run(list(map(str, command)), capture_output=True, text=True,
                              env={**os.environ, **ENVIRONMENT})
        walls.append(clock() - begin)
        if done.returncode:
            raise Failed(f"{' '.join(map(str, command))}\n{done.stderr[-2000:]}")
        if walls[0] > LONG:
            break
    return statistics.median(walls), done.stdout


def top_of(times, values):
    """The largest value by the parabola through the largest sample and its neighbours."""
    i = int(np.argmax(values))
    if i in (0, len(values) - 1):
        return float(values[i])
    left, middle, right = values[i - 1 : i + 2]
    return float(middle + (right - left) ** 2 / (8 * (2 * middle - left - right)))


def upbead(program, case, settings, repeats, reading="shear_force"):
    """One run of a case with other values of some keys."""
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "run", case, "--json", "--out", folder]
        for key, value in settings.items():
            command += ["--set", f"{key}={value}"]
        wall, printed = timed(command, repeats)
        with h5py.File(pathlib.Path(folder) / "results.h5") as file:
            times, values = file["history/time"][:], file[f"history/{reading}"][:]
    summary = json.loads(printed)
    found = summary["discretisation"]
    peak = summary["response"]["peak_shear"] if reading == "shear_force" else top_of(times, values)
    return History(times, values, peak, found["unknowns"], found["solves"],
                   0 if found["scheme"] == "reduced" else found["steps"], wall, summary["timing"])


def fenicsx(mesh, settings, repeats):
    """settings: the options of peers/fenicsx.py; forms that are already compiled are not compiled again."""
    with tempfile.TemporaryDirectory() as folder:
        output = pathlib.Path(folder) / "out.npz"
        command = [sys.executable, PEERS / "fenicsx.py", mesh, *settings, "-o", output]
        wall, printed = timed(command, repeats)
        data = np.load(output)
        found = json.loads(printed.splitlines()[-1])
        times, values = data["time"], data["shear"]
    unknowns, solves = found.pop("unknowns"), found.pop("solves")
    return History(times, values, top_of(times, values), unknowns, solves, solves, wall, found)


def free_fem(mesh, degree, step, repeats, adapt=(0.0, 0.0)):
    """Only FreeFem++ is timed; its input is written before."""
    with tempfile.TemporaryDirectory() as folder:
        numbers, output = pathlib.Path(folder) / "numbers", pathlib.Path(folder) / "out"
        numbers.write_text(freefem.numbers(scene.read(), 1.0, step, adapt))
        wall, _ = timed(freefem.command(mesh, degree, numbers, output), repeats)
        unknowns, solves, *parts = output.read_text().split("\n", 1)[0].split()
        times, values = np.loadtxt(output, skiprows=1, unpack=True)
    parts = dict(zip(("compile", "factorise", "march"), map(float, parts)))
    return History(times, values, top_of(times, values), int(unknowns), int(solves), int(solves), wall, parts)


def table(path, entry, model, value, sign=1):
    """An exact history of tests/reference, multiplied by `sign`."""
    found = next(case for case in json.loads(path.read_text())["cases"] if entry(case))
    values = sign * np.array(found["models"][model][value] if "models" in found else found[value])
    peak = found["models"][model]["max_abs_" + value] if "models" in found else found["peak_" + value]
    return History(np.array(found["t"]), values, peak)
