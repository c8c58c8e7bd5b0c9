#!/usr/bin/python3
"""Error of F_T against work, for time schemes and meshes, on cases/fig2b-prototype.toml.

usage: accuracy.py PROGRAM [-o FOLDER]

Writes FOLDER/accuracy.{json,md,png}. Times are of whole processes, the median of three; errors are relative to the peak
of F_T of the finest run of each study: of the peak itself, and the largest of the whole history.
"""

import argparse
import json
import pathlib
import statistics
import subprocess
import tempfile
import time

import h5py
import matplotlib
import matplotlib.ticker
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402  (the backend must be chosen first)

CASE = pathlib.Path(__file__).resolve().parents[2] / "cases/fig2b-prototype.toml"
DURATION = 0.15  # s, of the impulse
UNDAMPED = {"regions.seabed.damping.ratio": 0.0, "regions.mound.damping.ratio": 0.0}


class Run:
    """One run of the case with other values of some keys; marched, as steps and solves are what is studied."""

    def __init__(self, program, settings, repeats=1):
        arguments = [str(program), "run", str(CASE), "--json"]
        for key, value in {"time.scheme": "sdirk4", **settings}.items():
            arguments += ["--set", f"{key}={value}"]
        walls = []
        with tempfile.TemporaryDirectory() as folder:
            for _ in range(repeats):
                begin = time.perf_counter()
                done = subprocess.run(arguments + ["--out", folder], capture_output=True, text=True, check=True)
                walls.append(time.perf_counter() - begin)
            with h5py.File(pathlib.Path(folder) / "results.h5") as file:
                self.time, self.shear = file["history/time"][:], file["history/shear_force"][:]
        self.wall = statistics.median(walls)
        self.summary = json.loads(done.stdout)
        self.peak = self.summary["response"]["peak_shear"]

    def row(self, label, reference):
        history = np.interp(self.time, reference.time, reference.shear) - self.shear
        return {
            "label": label,
            "unknowns": self.summary["discretisation"]["unknowns"],
            "solves": self.summary["discretisation"]["solves"],
            "peak_error": abs(self.peak / reference.peak - 1),
            "history_error": float(abs(history).max() / reference.peak),
            "wall": self.wall,
        }


def scheme_study(program, extra, name):
    reference = Run(program, {**extra, "time.step": DURATION / 600})
    rows = []
    for scheme, fractions in (("sdirk4", (4, 8, 16, 32, 64)), ("generalised_alpha", (16, 32, 64, 128, 256))):
        for fraction in fractions:
            settings = {**extra, "time.scheme": scheme, "time.step": DURATION / fraction}
            rows.append(Run(program, settings, 3).row(f"{scheme}, td/{fraction}", reference))
    return {"name": name, "rows": rows}


def mesh_study(program):
    def settings(degree, cells, grading):
        return {"mesh.degree": degree, "mesh.parameters.cells": cells, "mesh.parameters.grading": grading}

    reference = Run(program, settings(3, 1.5, 30))
    meshes = [(2, 1, 1), (2, 2, 1), (2, 0.35, 12), (2, 0.5, 12), (2, 0.7, 12), (2, 1, 12), (2, 1.5, 12), (2, 2, 12),
              (2, 1, 30), (3, 0.35, 12), (3, 0.5, 12), (3, 0.7, 12), (3, 1, 12)]
    rows = [Run(program, settings(*mesh), 3).row("degree %g, cells %g, grading %g" % mesh, reference) for mesh in meshes]
    return {"name": "mesh", "rows": rows}


def table(study):
    lines = [f"### {study['name']}", "", "| | unknowns | solves | error of peak | error of history | wall time |",
             "|---|---:|---:|---:|---:|---:|"]
    for row in study["rows"]:
        lines.append(f"| {row['label']} | {row['unknowns']} | {row['solves']} | {row['peak_error']:.1e} | "
                     f"{row['history_error']:.1e} | {row['wall']:.2f} s |")
    return "\n".join(lines) + "\n"


def draw(studies, path):
    figure, axes = plt.subplots(1, len(studies), figsize=(4.2 * len(studies), 4), sharey=True)
    for ax, study in zip(axes, studies):
        groups = {}
        for row in study["rows"]:
            groups.setdefault(row["label"].split(",")[0], []).append(row)
        for label, rows in groups.items():
            ax.loglog([r["wall"] for r in rows], [r["history_error"] for r in rows], "o", label=label)
        ax.set_title(study["name"])
        ax.set_xlabel("wall time of the whole process (s)")
        ax.xaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())
        ax.set_xticks([0.5, 1, 2, 5], ["0.5", "1", "2", "5"])
        ax.grid(alpha=0.3)
        ax.legend(fontsize="small")
    axes[0].set_ylabel("largest error of $F_T(t)$ over its peak")
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("results/accuracy"))
    arguments = parser.parse_args()
    studies = [scheme_study(arguments.program, {}, "time, 5 % damping"),
               scheme_study(arguments.program, UNDAMPED, "time, undamped"), mesh_study(arguments.program)]
    arguments.output.mkdir(parents=True, exist_ok=True)
    (arguments.output / "accuracy.json").write_text(json.dumps(studies, indent=1))
    (arguments.output / "accuracy.md").write_text("\n".join(map(table, studies)))
    draw(studies, arguments.output / "accuracy.png")
    print("\n".join(map(table, studies)))


if __name__ == "__main__":
    main()
