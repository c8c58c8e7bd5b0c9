#!/usr/bin/python3
"""One run on several processes: time by phase, memory, and whether the results agree.

usage: ranks.py PROGRAM [--processes N ...] [--repeats N] [--cells C ...] [-o FOLDER]

cases/fig2b-prototype.toml marched by sdirk4 on several meshes. Writes FOLDER/ranks.{json,md}. Times are medians, of the
first process, which waits for the slowest one in every solve; the numbers of processes take turns, so that other load on
the machine affects all alike. Memory is that of the largest process.
"""

import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import h5py
import numpy as np

CASE = pathlib.Path(__file__).resolve().parents[2] / "cases/fig2b-prototype.toml"
CELLS = (0.7, 1.5, 2.7)
PHASES = ("mesh", "compile", "factorise", "march")
MPIRUN = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none"]
# starts a program, and adds its memory (kB) as a line to a file
WATCH = ("import resource, subprocess, sys; code = subprocess.call(sys.argv[2:]); "
         "open(sys.argv[1], 'a').write(f'{resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss}\\n'); sys.exit(code)")


def run(program, cells, n):
    with tempfile.TemporaryDirectory() as folder:
        memory = pathlib.Path(folder) / "memory.txt"
        command = [sys.executable, "-c", WATCH, str(memory), str(program), "run", str(CASE), "--json", "--out", folder + "/run",
                   "--set", "time.scheme=sdirk4",
                   "--set", f"mesh.parameters.cells={cells}"]
        if n > 1:
            command = [*MPIRUN, "-n", str(n), *command]
        environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
        begin = time.perf_counter()
        done = subprocess.run(command, capture_output=True, text=True, env=environment)
        wall = time.perf_counter() - begin
        if done.returncode != 0:
            raise SystemExit(f"{' '.join(command)}\n{done.stderr}")
        with h5py.File(pathlib.Path(folder) / "run/results.h5") as file:
            shear = file["history/shear_force"][:]
        largest = max(map(int, memory.read_text().split())) * 1024
    summary = json.loads(done.stdout)
    return {"wall": wall, **{phase: summary["timing"][phase] for phase in PHASES},
            "solve": summary["timing"]["march"] / summary["discretisation"]["solves"],
            "memory": largest, "unknowns": summary["discretisation"]["unknowns"], "shear": shear}


def measure(program, cells, processes, repeats):
    runs = {n: [] for n in processes}
    for _ in range(repeats):
        for n in processes:
            runs[n].append(run(program, cells, n))
    first = runs[processes[0]][0]["shear"]
    rows = []
    for n, of_n in runs.items():
        row = {key: statistics.median(one[key] for one in of_n) for key in ("wall", "solve", "memory", *PHASES)}
        difference = max(np.abs(one["shear"] - first).max() for one in of_n) / np.abs(first).max()
        rows.append({"unknowns": of_n[0]["unknowns"], "processes": n, **row, "difference": float(difference)})
    return rows


def table(rows):
    lines = ["| unknowns | processes | " + " | ".join(PHASES)
             + " | march, per solve | whole process | faster | memory | F_T differs by |",
             "|---:|---:|" + "---:|" * (len(PHASES) + 5)]
    for row in rows:
        alone = next(r for r in rows if r["unknowns"] == row["unknowns"])
        lines.append(f"| {row['unknowns']:,} | {row['processes']} | " + " | ".join(f"{row[p]:.2f} s" for p in PHASES)
                     + f" | {1e3 * row['solve']:.2f} ms"
                     + f" | {row['wall']:.2f} s | {alone['wall'] / row['wall']:.2f} | {row['memory'] / 1e9:.2f} GB | {row['difference']:.0e} |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--processes", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--cells", type=float, nargs="+", default=CELLS, help="mesh.parameters.cells")
    parser.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("results/ranks"))
    arguments = parser.parse_args()
    rows = [row for cells in arguments.cells
            for row in measure(arguments.program.resolve(), cells, arguments.processes, arguments.repeats)]
    arguments.output.mkdir(parents=True, exist_ok=True)
    (arguments.output / "ranks.json").write_text(json.dumps(rows, indent=1))
    (arguments.output / "ranks.md").write_text(table(rows))
    print(table(rows))


if __name__ == "__main__":
    main()
