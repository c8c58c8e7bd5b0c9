#!/usr/bin/python3
"""Time and memory of one run against the number of unknowns.

usage: growth.py PROGRAM [--largest CELLS] [-o FOLDER]

cases/fig2b-prototype.toml with finer and finer cells, by the default (a reduced model) and marched with 80 steps of
sdirk4. Writes FOLDER/growth.{json,md,png}; exponents are slopes of log(time) over log(unknowns) from 20,000 on.
"""

import argparse
import json
import math
import os
import pathlib
import tempfile
import time

import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402  (the backend must be chosen first)

CASE = pathlib.Path(__file__).resolve().parents[2] / "cases/fig2b-prototype.toml"
CELLS = (0.35, 0.7, 1, 1.5, 2.2, 3.2, 4.6, 6.8)
SCHEMES = {"reduced model": "auto", "marched": "sdirk4"}
PHASES = ("mesh", "compile", "factorise", "march")
COUNTED_FROM = 20000  # unknowns: with fewer, the start of the process takes most of the time


def run(program, scheme, cells):
    """Wall time, largest memory and times of phases of one process."""
    with tempfile.TemporaryDirectory() as folder:
        command = [str(program), "run", str(CASE), "--json", "--out", folder, "--set", f"time.scheme={scheme}",
                   "--set", f"mesh.parameters.cells={cells}"]
        output = pathlib.Path(folder) / "stdout"
        begin = time.perf_counter()
        actions = [(os.POSIX_SPAWN_OPEN, 1, str(output), os.O_CREAT | os.O_WRONLY, 0o600)]
        process = os.posix_spawn(program, command, os.environ, file_actions=actions)
        _, status, usage = os.wait4(process, 0)
        wall = time.perf_counter() - begin
        if status != 0:
            raise SystemExit(f"{' '.join(command)} failed")
        summary = json.loads(output.read_text())
    return {"cells": cells, "unknowns": summary["discretisation"]["unknowns"], "wall": wall,
            "memory": 1024 * usage.ru_maxrss, **{phase: summary["timing"][phase] for phase in PHASES}}


def exponent(rows, key):
    large = [row for row in rows if row["unknowns"] > COUNTED_FROM]
    return float(np.polyfit(*np.log([[row["unknowns"] for row in large], [row[key] for row in large]]), 1)[0])


def table(results):
    lines = []
    for name, rows in results.items():
        lines += [f"### {name}", "", "| unknowns | " + " | ".join(PHASES) + " | whole process | memory |",
                  "|---:|" + "---:|" * (len(PHASES) + 2)]
        lines += [f"| {row['unknowns']:,} | " + " | ".join(f"{row[phase]:.2f} s" for phase in PHASES)
                  + f" | {row['wall']:.2f} s | {row['memory'] / 1e9:.2f} GB |" for row in rows]
        if sum(row["unknowns"] > COUNTED_FROM for row in rows) > 1:
            lines.append("| exponent | " + " | ".join(f"{exponent(rows, key):.2f}" for key in (*PHASES, "wall", "memory"))
                         + " |")
        lines.append("")
    return "\n".join(lines)


def draw(results, path):
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.8))
    for name, rows in results.items():
        unknowns = [row["unknowns"] for row in rows]
        axes[0].loglog(unknowns, [row["wall"] for row in rows], "o-", label=name)
        axes[1].loglog(unknowns, [row["memory"] / 1e9 for row in rows], "o-", label=name)
    for ax, label in zip(axes, ("time of the whole process (s)", "largest memory (GB)")):
        ax.set_xlabel("unknowns")
        ax.set_ylabel(label)
        ax.grid(alpha=0.3, which="both")
    axes[0].legend()
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--largest", type=float, default=math.inf, help="value of mesh.parameters.cells to stop at")
    parser.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("results/growth"))
    arguments = parser.parse_args()
    results = {name: [run(arguments.program.resolve(), scheme, cells) for cells in CELLS if cells <= arguments.largest]
               for name, scheme in SCHEMES.items()}
    arguments.output.mkdir(parents=True, exist_ok=True)
    (arguments.output / "growth.json").write_text(json.dumps(results, indent=1))
    (arguments.output / "growth.md").write_text(table(results))
    draw(results, arguments.output / "growth.png")
    print(table(results))


if __name__ == "__main__":
    main()
