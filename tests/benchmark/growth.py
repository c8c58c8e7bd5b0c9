#!/usr/bin/python3
"""Time and memory of one run against the number of unknowns.

usage: growth.py PROGRAM [--before OLD] [--processor-time] [--largest CELLS] [-o FOLDER]

cases/fig2b-prototype.toml with finer and finer cells, by the default (a reduced model) and marched with sdirk4; by
another program in turns, where one is given. --processor-time: whole processes alone, by the processor's time (user and
system, all threads), for machines that others use too. Writes FOLDER/growth.{json,md,png}; exponents are slopes of
log(time) over log(unknowns) from 20,000 on.
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


def run(program, scheme, cells, by_processor):
    """Times, largest memory and times of phases of one process."""
    with tempfile.TemporaryDirectory() as folder:
        command = [str(program), "run", str(CASE), "--json", "--out", folder, "--set", f"time.scheme={scheme}",
                   "--set", f"mesh.parameters.cells={cells}"]
        output = pathlib.Path(folder) / "stdout"
        actions = [(os.POSIX_SPAWN_OPEN, 1, str(output), os.O_CREAT | os.O_WRONLY, 0o600)]
        environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
        begin = time.perf_counter()
        process = os.posix_spawn(program, command, environment, file_actions=actions)
        _, status, usage = os.wait4(process, 0)
        wall = time.perf_counter() - begin
        if status != 0:
            raise SystemExit(f"{' '.join(command)} failed")
        summary = json.loads(output.read_text())
    return {"cells": cells, "unknowns": summary["discretisation"]["unknowns"],
            "whole process": usage.ru_utime + usage.ru_stime if by_processor else wall, "memory": 1024 * usage.ru_maxrss,
            **({} if by_processor else {phase: summary["timing"][phase] for phase in PHASES})}


def exponent(rows, key):
    large = [row for row in rows if row["unknowns"] > COUNTED_FROM]
    return float(np.polyfit(*np.log([[row["unknowns"] for row in large], [row[key] for row in large]]), 1)[0])


def in_turns(program, before, *of):
    row = run(program, *of)
    if before:
        old = run(before, *of)
        row |= {key + " before": old[key] for key in ("whole process", "memory")}
    return row


def table(results):
    lines = []
    for name, rows in results.items():
        keys = [key for key in (*PHASES, "whole process", "whole process before", "memory", "memory before") if key in rows[0]]
        lines += [f"### {name}", "", "| unknowns | " + " | ".join(keys) + " |", "|---:|" + "---:|" * len(keys)]
        lines += [f"| {row['unknowns']:,} | " + " | ".join(
            f"{row[key] / 1e9:.2f} GB" if "memory" in key else f"{row[key]:.2f} s" for key in keys) + " |" for row in rows]
        if sum(row["unknowns"] > COUNTED_FROM for row in rows) > 1:
            lines.append("| exponent | " + " | ".join(f"{exponent(rows, key):.2f}" for key in keys) + " |")
        lines.append("")
    return "\n".join(lines)


def draw(results, path):
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.8))
    for name, rows in results.items():
        unknowns = [row["unknowns"] for row in rows]
        for when, style in (("", "o-"), (" before", "--")):
            if "whole process" + when not in rows[0]:
                continue
            colour = {"color": axes[0].lines[-1].get_color()} if when else {}
            axes[0].loglog(unknowns, [row["whole process" + when] for row in rows], style, label=name + when, **colour)
            axes[1].loglog(unknowns, [row["memory" + when] / 1e9 for row in rows], style, **colour)
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
    parser.add_argument("--before", type=pathlib.Path, help="another program, in turns with the first")
    parser.add_argument("--processor-time", action="store_true")
    parser.add_argument("--largest", type=float, default=math.inf, help="value of mesh.parameters.cells to stop at")
    parser.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("results/growth"))
    arguments = parser.parse_args()
    before = arguments.before and arguments.before.resolve()
    results = {name: [in_turns(arguments.program.resolve(), before, scheme, cells, arguments.processor_time)
                      for cells in CELLS if cells <= arguments.largest] for name, scheme in SCHEMES.items()}
    arguments.output.mkdir(parents=True, exist_ok=True)
    (arguments.output / "growth.json").write_text(json.dumps(results, indent=1))
    (arguments.output / "growth.md").write_text(table(results))
    draw(results, arguments.output / "growth.png")
    print(table(results))


if __name__ == "__main__":
    main()
