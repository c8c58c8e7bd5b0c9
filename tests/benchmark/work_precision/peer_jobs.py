"""The jobs of the peers: graded and uniform meshes, steps that suit them, and options of their solvers."""

import pathlib
import subprocess
import sys
from dataclasses import dataclass

import compare
import run
import scenes

GEOMETRY = scenes.ROOT / "meshes/composite.geo"
UNIFORM, GRADED, STEEP = 1, 12, 30  # grading: largest cell over that at the caisson's corners
CELLS = {GRADED: (0.25, 0.35, 0.5, 0.7, 1, 1.4), STEEP: (0.5, 1), UNIFORM: (0.5, 1, 2, 3.5)}
ADAPTED = ((0.03, 6), (0.01, 4), (0.003, 3), (0.001, 2))  # err and hmax (m) of adaptmesh, from the coarsest uniform mesh
SOLVERS = ("amd", "nd", "mumps")
LARGEST_OF_DEGREE_3 = 0.5  # density of cells; on finer meshes degree 2 was as accurate


@dataclass
class PeerJob:
    series: str
    family: str
    label: str
    run: object  # repeats -> History


def steps_for(cells, grading):
    """Steps (s), each of which meets the kinks of the pulse; the more accurate the mesh, the smaller."""
    if grading == STEEP:
        return 5e-3, 2.5e-3, 1.25e-3
    return (7.5e-3, 5e-3, 2.5e-3) if cells >= 1 else (15e-3, 7.5e-3, 5e-3)


def make_meshes(folder, quick):
    """{(grading, cells): path without suffix}"""
    found = {}
    for grading, all_cells in CELLS.items():
        for cells in all_cells[:: 2 if quick else 1]:
            path = pathlib.Path(folder) / f"grading{grading}_cells{cells}"
            subprocess.run([sys.executable, run.PEERS / "meshes.py", GEOMETRY, path, f"cells={cells}",
                            f"grading={grading}"], check=True)
            found[grading, cells] = path
    return found


def jobs(folder, quick):
    """All runs of both peers on meshes that are made here."""
    meshes = make_meshes(folder, quick)
    start = max(cells for grading, cells in meshes if grading == UNIFORM)
    found = adapted_jobs(meshes[UNIFORM, start], ADAPTED[:: 2 if quick else 1], quick)
    for (grading, cells), path in meshes.items():
        series = ", uniform" if grading == UNIFORM else ""
        for step in steps_for(cells, grading)[:: 2 if quick else 1]:
            of_step = [fenicsx_job("FEniCSx" + series, "quads, degree 2", path, cells, step, []),
                       fenicsx_job("FEniCSx" + series, "triangles, degree 2", path, cells, step, ["--triangles"]),
                       free_fem_job("FreeFEM" + series, path, cells, step, 2)]
            if grading != UNIFORM and cells <= LARGEST_OF_DEGREE_3:
                of_step += [fenicsx_job("FEniCSx", "quads, degree 3", path, cells, step, ["--degree", "3"]),
                            free_fem_job("FreeFEM", path, cells, step, 3)]
            for job in of_step:
                job.family += f", grading {grading}"
                job.label += f", grading {grading}"
            found += of_step
        if cells == 1 and grading == GRADED:
            found += [fenicsx_job("FEniCSx, solvers", f"quads, {solver}", path, cells, 5e-3, ["--solver", solver])
                      for solver in SOLVERS]
    return found


def adapted_jobs(path, all_adapted, quick):
    """Runs on FreeFEM's own meshes, which it makes in the run; the smaller their error, the smaller the steps."""
    mesh, found = path.with_name(path.name + ".msh"), []
    for adapt in all_adapted:
        for step in steps_for(1, GRADED if adapt[0] > 0.002 else STEEP)[:: 2 if quick else 1]:
            label = f"err {adapt[0]:g}, hmax {adapt[1]:g}, {1e3 * step:g} ms"
            found.append(PeerJob("FreeFEM, adaptmesh", "FreeFEM, adaptmesh, degree 2", label,
                                 lambda repeats, adapt=adapt, step=step: run.free_fem(mesh, 2, step, repeats, adapt)))
    return found


def free_fem_job(series, path, cells, step, degree):
    mesh = path.with_name(path.name + ".msh")
    return PeerJob(series, f"{series}, degree {degree}", f"degree {degree}, cells {cells:g}, {1e3 * step:g} ms",
                   lambda repeats: run.free_fem(mesh, degree, step, repeats))


def fenicsx_job(series, kind, path, cells, step, options):
    mesh = path.with_name(path.name + ".npz")
    return PeerJob(series, f"{series}, {kind}", f"{kind}, cells {cells:g}, {1e3 * step:g} ms",
                   lambda repeats: run.fenicsx(mesh, [*options, "--step", str(step)], repeats))


def warm_up(folder):
    """Lets FEniCSx compile its forms into a separate cache; returns the seconds of the first and of a later run.

    The names of the forms vary a little from run to run, so a few runs are needed until all forms are compiled.
    """
    run.ENVIRONMENT["XDG_CACHE_HOME"] = str(pathlib.Path(folder) / "cache")
    path = sorted(pathlib.Path(folder).glob("*.npz"))[0]
    times = {}
    for options in ([], ["--triangles"], ["--degree", "3"]):
        walls = [run.fenicsx(path, [*options, "--step", "0.1"], 1).wall for _ in range(7)]
        times[" ".join(options) or "quads"] = {"first": walls[0], "later": min(walls)}
    return times


def floors(program, lean=None):
    """Seconds of processes that do nothing (the solver's version, imports, an empty script): no run is faster."""
    solver = program.with_name("upbead-solver")  # upbead becomes this program for a command that solves
    do_nothing = {"upbead": [solver, "--version"],
                  "FEniCSx": [sys.executable, run.PEERS / "fenicsx.py", "--help"],
                  "FreeFEM": ["FreeFem++", "-nw", "-v", "0", run.PEERS / "empty.edp"]}
    if lean is not None:
        do_nothing[compare.LEAN] = [lean.with_name("upbead-solver"), "--version"]
    return {name: run.timed(command, 5)[0] for name, command in do_nothing.items()}
