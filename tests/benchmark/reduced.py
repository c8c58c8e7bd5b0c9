#!/usr/bin/python3
"""Error of F_T against the number of solves, for marches and reduced models, and times of whole commands.

usage: reduced.py FOLDER [-o FOLDER]

The first FOLDER is the build folder, with upbead and tests/benchmark/bench_reduced (build the target bench_reduced).
Writes reduced.{json,md,png}. One core is used; takes five to ten minutes.
"""

import argparse
import json
import math
import os
import pathlib
import statistics
import subprocess
import tempfile
import time

import h5py
import numpy as np
from reduced_page import draw, tables

CASES = pathlib.Path(__file__).resolve().parents[2] / "cases"
PROTOTYPE, MODEL = CASES / "fig2b-prototype.toml", CASES / "fig2b-model.toml"
UNDAMPED = ["regions.seabed.damping.ratio=0", "regions.mound.damping.ratio=0"]
NO_SEA = ["mesh.parameters.sea_front=0", "mesh.parameters.sea_back=0"]
# Name, case, overrides, the program's own shift (in 2 pi / duration).
SCENES = (("prototype, 5 % damping", PROTOTYPE, [], 1.25), ("prototype, undamped", PROTOTYPE, UNDAMPED, 1.75),
          ("prototype without the sea, 5 % damping", PROTOTYPE, NO_SEA, 1.25),
          ("1/20 model, 5 % damping", MODEL, [], 1.25))
AIM = 3e-3  # error of the history at which the numbers of solves are compared
REPEATS = 5
WAVES, SAMPLES, STEP = 2000, 2000, 1e-3
SLIDING = ["--friction", "0.6", "--buoyant-weight", "1e6"]  # chosen so that half of the waves slide the caisson


def call(arguments):
    """Standard output and wall time (s) of a process on one core."""
    one_core = {min(os.sched_getaffinity(0))}
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    begin = time.perf_counter()
    done = subprocess.run([str(a) for a in arguments], capture_output=True, text=True, check=True, env=environment,
                          preexec_fn=lambda: os.sched_setaffinity(0, one_core))
    return done.stdout, time.perf_counter() - begin


def march_solves(rows, scheme, error):
    """Solves at which a march has that error, by straight lines in log-log, where the error falls through it for the
    last time."""
    rows = [row for row in rows if row["scheme"] == scheme]
    for before, after in reversed(list(zip(rows, rows[1:]))):
        if before["history_error"] > error >= after["history_error"]:
            fall = before["history_error"] / after["history_error"]
            part = math.log(before["history_error"] / error) / math.log(fall)
            return before["solves"] * (after["solves"] / before["solves"]) ** part
    return None


def model_solves(rows, error):
    """Solves of the smallest model that has, like all larger ones, at most that error."""
    enough = None
    for row in reversed(rows):
        if row["history_error"] > error:
            return enough
        enough = row["solves"]
    return enough


def commands(program, case, overrides, folder):
    """Median wall times of whole processes, run by turns, and numbers from their summaries."""
    sets = [part for override in overrides for part in ("--set", override)]
    kinds = {"run": ["run"], "march": ["run", "--set", "time.scheme=sdirk4"], "reduce": ["reduce"]}
    walls, summaries = {kind: [] for kind in kinds}, {}
    for _ in range(REPEATS):
        for kind, (command, *more) in kinds.items():
            text, wall = call([program, command, case, *sets, *more, "--json", "--out", folder / kind])
            walls[kind].append(wall)
            summaries[kind] = json.loads(text)
    result = {kind: {"wall": statistics.median(walls[kind]), "timing": summaries[kind]["timing"],
                     "solves": summaries[kind]["discretisation"]["solves"]} for kind in kinds}
    for kind in ("run", "reduce"):
        result[kind]["reduction"] = summaries[kind].get("reduction")
    return result


def respond(program, folder):
    """Waves that one core computes in a second, without and with sliding."""
    t = STEP * np.arange(SAMPLES)
    start, peak = np.linspace(0, 0.5, WAVES)[:, None], np.linspace(0.8e6, 2.4e6, WAVES)[:, None]
    with h5py.File(folder / "waves.h5", "w") as file:
        file["time"] = t
        file["impulse"] = peak * np.maximum(0, 1 - abs((t - start) / 0.075 - 1))
    result = {"waves": WAVES, "samples": SAMPLES}
    for kind, options in (("shear", []), ("sliding", SLIDING)):
        runs = []
        for _ in range(REPEATS):
            text, wall = call([program, "respond", folder / "reduce/reduced.h5", folder / "waves.h5", "--json", "--out",
                               folder / "respond", *options])
            summary = json.loads(text)
            runs.append({"wall": wall, "per_second": summary["histories_per_second"], **summary["timing"]})
        result[kind] = {key: statistics.median(run[key] for run in runs) for key in runs[0]}
    return result


def measure(build, scene):
    name, case, overrides, shift = scene
    study = {"name": name, "shift": shift}
    study.update(json.loads(call([build / "tests/benchmark/bench_reduced", case, *overrides])[0]))
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        study["commands"] = commands(build / "upbead", case, overrides, folder)
        if scene is SCENES[0]:
            study["respond"] = respond(build / "upbead", folder)
    return study


def count(study):
    """Solves at the error AIM; adds to each model that the program chooses the solves of the march with the same
    error."""
    own = [row for row in study["reduced"] if row["shift"] == study["shift"]]
    march = {scheme: march_solves(study["march"], scheme, AIM) for scheme in ("sdirk4", "generalised_alpha")}
    at_aim = {**march, "reduced": model_solves(own, AIM), "shifts": {}}
    for shift in dict.fromkeys(row["shift"] for row in study["reduced"]):
        at_aim["shifts"][shift] = model_solves([row for row in study["reduced"] if row["shift"] == shift], AIM)
    for row in study["chosen"]:
        same = [march_solves(study["march"], scheme, row["history_error"]) for scheme in march]
        row["march"] = min(filter(None, same), default=None)
    return at_aim


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("results/reduced"))
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    results = []
    for scene in SCENES:
        results.append(measure(arguments.build, scene))
        results[-1]["at_aim"] = count(results[-1])
        (arguments.output / "reduced.json").write_text(json.dumps(results, indent=1))
        print(scene[0], flush=True)
    (arguments.output / "reduced.md").write_text(tables(results))
    draw(results, AIM, arguments.output / "reduced.png")


if __name__ == "__main__":
    main()
