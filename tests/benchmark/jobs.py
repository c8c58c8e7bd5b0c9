#!/usr/bin/python3
"""Time and memory of typical jobs of users, on a designer's section of 58,644 unknowns.

usage: jobs.py PROGRAM [PROGRAM ...] [--names OLD NEW] [--only JOB ...] [--repeats N] [-o FOLDER]

The section is cases/designer/church-roof.toml. Programs take turns, job by job. Times are medians over whole
processes: wall time, which is meaningful on an idle machine only, and in brackets processor time (user and system,
all threads and children), which is nearly the same on a busy machine. Memory is that of the largest process. A job of
more than ten seconds of processor time is run once; the time of making the reduced models that `respond` and
`expected` need is not included. BLAS has one thread. Writes FOLDER/jobs.{json,md}.

All jobs of two programs take about 8 minutes on two idle cores:

    tests/benchmark/jobs.py OLD/upbead build/upbead --names before after
"""

import argparse
import json
import os
import pathlib
import statistics
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
SECTION = ROOT / "cases/designer/church-roof.toml"
LONG = 10.0  # s of processor time: not repeated
SOILS = ("seabed", "subsoil", "mound")
ELASTIC = {"kind": "solid", "youngs_modulus": 30e9, "poissons_ratio": 0.2}

# The wave of the section, sampled like a record from a flume: a row every 10 ms.
KINKS = ((0.0, 0.0), (0.1, 4.0e6), (0.3, 1.2e6), (4.0, 1.2e6), (4.3, 0.0), (6.0, 0.0))
# Ten such waves in 100 s, each by its height over that of the single wave: a train in which the larger waves slide
# the caisson.
TRAIN = (0.5, 0.8, 0.6, 1.0, 0.7, 0.4, 0.9, 0.5, 0.75, 0.6)
PERIOD = 10.0  # s
# Fifty years of the storms of design.toml by the caisson's own dynamics.
STORMS = """title = "The designer's section in storms, by its own dynamics"
[section]
water_depth = 12.0
foundation_depth = 7.0
berm_depth = 7.0
crest = 10.0
width = 20.0
berm_width = 8.0
bed_slope = 0.02
weight = 7.004e6
submerged_weight = 5.589e6
friction = 0.6
[sea]
states = "{states}"
years = 50
highest = 2.0
[life]
years = 50
simulated_lives = 200
[dynamics]
model = "{model}"
load = "wave"
"""
STUDY = """title = "The designer's section: 50 soils"
case = "{case}"
sample = "random"
n = 50
seed = 1
read = ["response.peak_shear", "sliding.sliding_coupled"]
[vary."regions.seabed.shear_modulus"]
distribution = "log_normal"
mean = 40e6
cov = 0.3
[vary."regions.seabed.hydraulic_conductivity"]
distribution = "log_uniform"
low = 1e-5
high = 1e-3
"""


def settings(values):
    return [part for key, value in values.items() for part in ("--set", f"{key}={json.dumps(value)}")]


def run(values=None, case=SECTION):
    return lambda folder: ["run", case, "--out", folder / "out", *settings(values or {})]


def wave(folder):
    rows, (time, force) = [], KINKS[0]
    for later, value in KINKS[1:]:
        steps = round((later - time) / 0.01)
        rows += [(time + i * 0.01, force + (value - force) * i / steps) for i in range(steps)]
        time, force = later, value
    text = "\n".join(["time,wave"] + [f"{t:.2f},{f:.6g}" for t, f in [*rows, KINKS[-1]]])
    (folder / "wave.csv").write_text(text + "\n")
    return ["respond", folder / "model/reduced.h5", folder / "wave.csv", "--out", folder / "out"]


def train(folder):
    rows = [(i * PERIOD + t, part * f) for i, part in enumerate(TRAIN) for t, f in KINKS[:-1]] + [(len(TRAIN) * PERIOD, 0.0)]
    (folder / "train.csv").write_text("\n".join(["time,wave"] + [f"{t:.2f},{f:.6g}" for t, f in rows]) + "\n")
    text = SECTION.read_text().replace('file = "plain.geo"', f'file = "{SECTION.parent / "plain.geo"}"')
    lines = ['history = "train.csv"' if line.startswith("pulse = ") else line for line in text.splitlines()]
    (folder / "train.toml").write_text("\n".join(lines).replace("end = 6", f"end = {len(TRAIN) * PERIOD:g}") + "\n")
    return ["run", folder / "train.toml", "--out", folder / "out"]


def storms(folder):
    (folder / "storms.toml").write_text(
        STORMS.format(states=ROOT / "cases/designer/storms.csv", model=folder / "model/reduced.h5"))
    return ["expected", folder / "storms.toml", "--out", folder / "out"]


def study(folder):
    (folder / "study.toml").write_text(STUDY.format(case=SECTION))
    return ["study", folder / "study.toml", "--out", folder / "out"]


FIELDS = {"output.fields.every": 0.05, **{f"regions.{soil}.strength.friction_angle": 35.0 for soil in SOILS}}
# job: (title, words of the command, time that it should take at most (s))
JOBS = {
    "run": ("`run`", run(), 2.0),
    "fields": ("`run` with 120 fields and strength", run(FIELDS), 5.0),
    "friction": ("`run`, friction node by node", run({"regions.caisson.interface.kind": "friction"}), 10.0),
    "reduce": ("`reduce`", lambda folder: ["reduce", SECTION, "--out", folder / "out"], None),
    "respond": ("`respond` to one wave of 6 s", wave, None),
    "train": ("`run` of ten waves, 100 s", train, None),
    "study": ("`study`, 50 runs over k and G", study, 60.0),
    "expected": ("`expected`, 50 years by own dynamics", storms, 15.0),
    "refine": ("`mesh.refine = \"auto\"` at 0.1 %, elastic caisson",
               run({"mesh.refine": "auto", "accuracy.tolerance": 1e-3,
                    **{f"regions.caisson.{key}": value for key, value in ELASTIC.items()}}), 15.0),
    "equivalent-linear": ("equivalent-linear soil, prototype", run(case=ROOT / "cases/one-soil/prototype.toml"), 2.0),
}
WITH_MODEL = ("respond", "expected")


def measure(program, words):
    """Wall time and processor time (s), and largest memory (bytes), of one process and its children."""
    command = [str(word) for word in (program, *words)]
    nothing = [(os.POSIX_SPAWN_OPEN, 1, "/dev/null", os.O_WRONLY, 0), (os.POSIX_SPAWN_OPEN, 2, "/dev/null", os.O_WRONLY, 0)]
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    begin = time.perf_counter()
    process = os.posix_spawn(program, command, environment, file_actions=nothing)
    _, status, usage = os.wait4(process, 0)
    wall = time.perf_counter() - begin
    if status:
        raise SystemExit(f"{' '.join(command)} failed; run it to see why")
    return wall, usage.ru_utime + usage.ru_stime, 1024 * usage.ru_maxrss


def measure_job(job, programs, repeats):
    """{program: medians and every run}"""
    words = JOBS[job][1]
    runs = [[] for _ in programs]
    with tempfile.TemporaryDirectory() as name:
        folders = [pathlib.Path(name) / str(i) for i in range(len(programs))]
        for folder, program in zip(folders, programs):
            folder.mkdir()
            if job in WITH_MODEL:
                measure(program, ["reduce", SECTION, "--out", folder / "model"])
        for _ in range(repeats):
            for folder, program, mine in zip(folders, programs, runs):
                if not mine or mine[0][1] < LONG:
                    mine.append(measure(program, words(folder)))
    return [{"wall": statistics.median(wall for wall, _, _ in mine),
             "seconds": statistics.median(seconds for _, seconds, _ in mine), "memory": max(size for _, _, size in mine),
             "runs": mine} for mine in runs]


def table(found, names):
    cells = " | ".join(f"{name} (processor) | memory" for name in names)
    lines = [f"| job | {cells} | wanted |", "|---" + "|---:" * (2 * len(names) + 1) + "|"]
    for job, rows in found.items():
        told = " | ".join(f"{row['wall']:.3g} s ({row['seconds']:.3g} s) | {row['memory'] / 1e6:.0f} MB" for row in rows)
        wanted = f"{JOBS[job][2]:g} s" if JOBS[job][2] else "-"
        lines.append(f"| {JOBS[job][0]} | {told} | {wanted} |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path, nargs="+")
    parser.add_argument("--names", nargs="+", help="of the programs, for the table")
    parser.add_argument("--only", nargs="+", choices=JOBS, default=list(JOBS))
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("results/jobs"))
    options = parser.parse_args()
    programs = [program.resolve() for program in options.program]
    names = options.names or [str(program) for program in options.program]
    options.output.mkdir(parents=True, exist_ok=True)
    path = options.output / "jobs.json"
    found = {}
    for job in options.only:
        found[job] = measure_job(job, programs, options.repeats)
        print(job, [f"{row['wall']:.3g} s ({row['seconds']:.3g} s), {row['memory'] / 1e6:.0f} MB" for row in found[job]],
              flush=True)
        path.write_text(json.dumps({"programs": names, "jobs": found}, indent=1) + "\n")
    (options.output / "jobs.md").write_text(table(found, names))
    print(table(found, names))


if __name__ == "__main__":
    main()
