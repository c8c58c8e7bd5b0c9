#!/usr/bin/python3
"""Time of one solve, by our solver and by others, against the lower bound that the bandwidth of the machine sets.

usage: solves.py FOLDER [-o FOLDER]

The first FOLDER is the build folder, with tests/benchmark/bench_solves (build the target bench_solves). Writes
solves.{json,md,png}. One core is used; takes about a minute.
"""

import argparse
import json
import os
import pathlib
import subprocess

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

CASE = pathlib.Path(__file__).resolve().parents[2] / "cases" / "fig2b-prototype.toml"
CELLS = (0.7, 1.0, 1.5, 2.0, 2.7)  # densities of cells, relative to the default
NAMES = {"upbead": "upbead", "PETSc, minimum degree": "PETSc LDLᵀ", "CHOLMOD, simplicial": "CHOLMOD LDLᵀ",
         "MUMPS": "MUMPS"}
COLOURS = {"upbead": "#0b5394", "PETSc, minimum degree": "#b45f06", "CHOLMOD, simplicial": "#38761d",
           "MUMPS": "#741b47"}


def measure(program, cells):
    """The JSON that bench_solves prints for the prototype on that mesh, on one core."""
    one_core = {min(os.sched_getaffinity(0))}
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    arguments = [program, CASE, "mesh.refine=0", f"mesh.parameters.cells={cells}"]
    done = subprocess.run([str(a) for a in arguments], capture_output=True, text=True, check=True, env=environment,
                          preexec_fn=lambda: os.sched_setaffinity(0, one_core))
    return {"cells": cells, **json.loads(done.stdout)}


def bound(scene, where):
    """Time (s) to read upbead's factor twice, at the bandwidth of the memory or of an array as large as the factor."""
    ours = scene["solvers"][0]
    return 2 * 8 * ours["entries"] / ours["bandwidth_" + where]


def row(cells):
    return "| " + " | ".join(cells) + " |"


def solver_table(scenes):
    """A line per scene and solver."""
    lines = [row(["unknowns", "solver", "entries of L, 10⁶", "analyse, ms", "factorise, ms", "solve, ms", "residual"]),
             row(["---"] * 7)]
    for scene in scenes:
        for s in scene["solvers"]:
            lines.append(row([f"{scene['unknowns']:,}", s["name"], f"{s['entries'] / 1e6:.2f}",
                              f"{1e3 * s['analyse']:.3g}", f"{1e3 * s['factorise']:.3g}", f"{1e3 * s['solve']:.3g}",
                              f"{s['residual']:.0e}"]))
    return lines


def bound_table(scenes):
    """A line per scene: time of the solve over its bounds, also with the cell blocks and for eight right-hand sides
    at once."""
    lines = [row(["unknowns", "factor, MB", "memory, GB/s", "as large as the factor, GB/s", "solve / bound of memory",
                  "solve / bound of its size", "with the cell blocks, ms", "per column of 8, ms"]), row(["---"] * 8)]
    for scene in scenes:
        ours = scene["solvers"][0]
        lines.append(row([f"{scene['unknowns']:,}", f"{8e-6 * ours['entries']:.1f}",
                          f"{ours['bandwidth_memory'] / 1e9:.0f}", f"{ours['bandwidth_factor'] / 1e9:.0f}",
                          f"{ours['solve'] / bound(scene, 'memory'):.2f}",
                          f"{ours['solve'] / bound(scene, 'factor'):.2f}", f"{1e3 * scene['whole']['solve']:.3g}",
                          f"{1e3 * ours['solve_8_columns'] / 8:.3g}"]))
    return lines


def draw(scenes, path):
    """Time of a solve over the bound against the unknowns."""
    figure, axes = plt.subplots(figsize=(6.5, 5.0), layout="constrained")
    unknowns = [scene["unknowns"] for scene in scenes]
    for name, label in NAMES.items():
        times = [next(s["solve"] for s in scene["solvers"] if s["name"] == name) for scene in scenes]
        over = [t / bound(scene, "memory") for t, scene in zip(times, scenes)]
        axes.plot(unknowns, over, "o-", color=COLOURS[name], label=label)
    ours = [scene["solvers"][0]["solve"] / bound(scene, "factor") for scene in scenes]
    axes.plot(unknowns, ours, "o--", color=COLOURS["upbead"], mfc="white",
              label="upbead, bound of an array\nas large as the factor")
    axes.axhline(1.0, color="0.3", lw=1)
    axes.axhline(1.5, color="0.3", lw=1, ls=":")
    axes.annotate("1.5", (1.0, 1.5), xycoords=("axes fraction", "data"), xytext=(-4, 3), textcoords="offset points",
                  ha="right", fontsize=9, color="0.3")
    axes.set(xscale="log", yscale="log", xlabel="unknowns", ylabel="time of a solve / time to read the factor twice")
    ticks = [0.5, 1, 2, 5, 10]
    axes.set_yticks(ticks, [str(t) for t in ticks])
    axes.set_xticks(unknowns, [f"{n / 1000:.0f},000" for n in unknowns])
    axes.minorticks_off()
    axes.grid(alpha=0.3)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.13), ncol=3, frameon=False, fontsize=9)
    figure.savefig(path, dpi=150)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("-o", "--out", type=pathlib.Path, default=pathlib.Path("solves"))
    parser.add_argument("--draw-only", action="store_true", help="table and figure from the solves.json that is there")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    data = options.out / "solves.json"
    if not options.draw_only:
        program = options.build.resolve() / "tests/benchmark/bench_solves"
        data.write_text(json.dumps([measure(program, cells) for cells in CELLS], indent=1) + "\n")
    scenes = json.loads(data.read_text())
    (options.out / "solves.md").write_text("\n".join([*solver_table(scenes), "", *bound_table(scenes)]) + "\n")
    draw(scenes, options.out / "solves.png")


if __name__ == "__main__":
    main()
