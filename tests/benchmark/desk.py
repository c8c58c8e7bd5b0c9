#!/usr/bin/python3
"""Time of `upbead explain` against the length of a record of transducers, and of report.py for results.

usage: desk.py PROGRAM [-o FOLDER]

The case is cases/fig2b-model.toml with the record in place of its impulse. Each time is the median of five whole
processes; "of it the record" is the excess over the time with a record of 100 samples. Writes
FOLDER/desk.{json,md,png}.
"""

import argparse
import json
import pathlib
import shutil
import statistics
import subprocess
import tempfile
import time

import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402  (the backend must be chosen first)

ROOT = pathlib.Path(__file__).resolve().parents[2]
REPEATS = 5
CHANNELS = 20
SAMPLES = (100, 10_000, 100_000, 300_000, 1_000_000)
FOOT, TOP = 0.3, 1.1  # m: heights of the wall of the model
REPORTS = {"fig2b-model": {}, "fig2b-prototype": {}, "fig2b-prototype, fields every 20 ms": {"output.fields.every": 0.02}}


def seconds(command, **options):
    times = []
    for _ in range(REPEATS):
        begin = time.perf_counter()
        done = subprocess.run([str(part) for part in command], capture_output=True, text=True, **options)
        times.append(time.perf_counter() - begin)
        if done.returncode:
            raise SystemExit(done.stderr)
    return statistics.median(times)


def sets(values):
    return [part for key, value in values.items() for part in ("--set", f"{key}={value}")]


def write_record(folder, samples):
    """A pulse of 60 ms that runs up the wall, with noise, over 20 s, in kPa with 5 digits."""
    t = np.linspace(0.0, 20.0, samples)
    heights = np.linspace(FOOT, TOP, CHANNELS)
    crest = np.maximum(0.0, 1.0 - np.abs(t[:, None] - 10.0 - 0.01 * heights) / 0.03)
    pressure = 8.0 * crest + 0.01 * np.random.default_rng(1).standard_normal(crest.shape)
    names = [f"p{i}" for i in range(CHANNELS)]
    np.savetxt(folder / "record.csv", np.column_stack([t, pressure]), delimiter=",", comments="",
               fmt=["%.6f"] + ["%.4f"] * CHANNELS, header=",".join(["time (s)"] + [f"{name} (kPa)" for name in names]))
    return {name: float(height) for name, height in zip(names, heights)}


def write_case(folder, heights):
    text = (ROOT / "cases/fig2b-model.toml").read_text()
    head, _, rest = text.partition("[loads.impulse]")
    load = ('[loads.impulse]\nboundary = "front"\nkind = "pressures"\ngauges = "record.csv"\nrecord_start = 9.9\n'
            f"heights = {{ {', '.join(f'{name} = {height:.4f}' for name, height in heights.items())} }}\n"
            'to_base = "constant"\nto_crest = "constant"\n\n')
    (folder / "case.toml").write_text(head + load + rest[rest.index("\n[") + 1 :])
    shutil.copy(ROOT / "cases/fig2b-model-slow.csv", folder)


def records(program):
    rows = []
    for samples in SAMPLES:
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            write_case(folder, write_record(folder, samples))
            size = (folder / "record.csv").stat().st_size
            whole = seconds([program, "explain", folder / "case.toml"])
        rows.append({"samples": samples, "bytes": size, "seconds": whole})
        print(rows[-1], flush=True)
    return rows


def reports(program):
    rows = []
    for name, settings in REPORTS.items():
        with tempfile.TemporaryDirectory() as folder:
            case = ROOT / "cases" / f"{name.split(',')[0]}.toml"
            subprocess.run([program, "run", case, "--out", folder, *sets(settings)], check=True, capture_output=True)
            report = seconds(["/usr/bin/python3", ROOT / "postprocess/report.py", folder])
            size = sum(path.stat().st_size for path in pathlib.Path(folder).glob("*.html"))
        rows.append({"results": name, "seconds": report, "bytes": size})
        print(rows[-1], flush=True)
    return rows


def table(found):
    least = found["records"][0]["seconds"]
    lines = ["| samples of 20 channels | MB | explain (s) | of it the record (s) |", "|---:|---:|---:|---:|"]
    lines += [f"| {row['samples']:,} | {row['bytes'] / 1e6:.3g} | {row['seconds']:.2f} | {row['seconds'] - least:.2f} |"
              for row in found["records"]]
    lines += ["", "| report of | page (MB) | seconds |", "|---|---:|---:|"]
    lines += [f"| {row['results']} | {row['bytes'] / 1e6:.1f} | {row['seconds']:.1f} |" for row in found["reports"]]
    return "\n".join(lines) + "\n"


def draw(found, path):
    rows = found["records"]
    figure, axes = plt.subplots(figsize=(6, 4), layout="constrained")
    axes.plot([row["samples"] / 1e6 for row in rows], [row["seconds"] for row in rows], "o-", label="upbead explain")
    axes.plot(1.0, 2.0, "v", color="0.4", label="asked of 10$^6$ samples: at most 2 s")
    axes.set(xlabel="samples of 20 channels (10$^6$)", ylabel="whole process (s)", ylim=(0.0, 2.2))
    axes.legend()
    figure.savefig(path, dpi=150)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("results/desk"))
    options = parser.parse_args()
    program = options.program.resolve()
    found = {"records": records(program), "reports": reports(program)}
    options.output.mkdir(parents=True, exist_ok=True)
    (options.output / "desk.json").write_text(json.dumps(found, indent=1) + "\n")
    (options.output / "desk.md").write_text(table(found))
    draw(found, options.output / "desk.png")
    print(table(found))


if __name__ == "__main__":
    main()
