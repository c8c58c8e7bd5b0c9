"""Studies of upbead, each a list of jobs on one scene with one reference."""

import json
import pathlib
from dataclasses import dataclass

import run

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
REFERENCES = ROOT / "tests/reference"
PROTOTYPE = ROOT / "cases/fig2b-prototype.toml"
DESIGNER = ROOT / "cases/designer/church-roof.toml"
TRAIN = HERE / "train.csv"  # ten waves in 100 s, church roofs of 0.1 s rise and 4 s plateau
PEER_SCENE = HERE / "peer_scene.toml"
PULSE = 0.15  # s, of the prototype's impulse
UNDAMPED = {"regions.seabed.damping.ratio": 0.0, "regions.mound.damping.ratio": 0.0}
DARCY = {"regions.mound.flow": "darcy"}
SDIRK = {"time.scheme": "sdirk4"}
ALPHA = {"time.scheme": "generalised_alpha"}
TOLERANCES = (0.02, 0.01, 0.005, 0.002, 0.001)


@dataclass
class Job:
    series: str  # a line of the figures
    label: str
    settings: dict
    family: str = ""  # runs of one family differ only in cells and steps


@dataclass
class Study:
    name: str
    title: str
    case: pathlib.Path
    jobs: list
    reference: object  # settings of a far finer run, or an exact History
    reading: str = "shear_force"


def mesh(degree=2, cells=1, grading=12):
    return {"mesh.refine": 0, "mesh.degree": degree, "mesh.parameters.cells": cells, "mesh.parameters.grading": grading}


def meshes(series, kinds, extra=None):
    """Jobs for (degree, cells, grading)."""
    extra = extra or {}
    step = f", {1e3 * extra['time.step']:g} ms" if "time.step" in extra else ""
    return [Job(series, f"degree {degree}, cells {cells:g}, grading {grading:g}{step}",
                {**mesh(degree, cells, grading), **extra}, f"{series}, degree {degree}, grading {grading}")
            for degree, cells, grading in kinds]


def by_tolerance(series, extra):
    """The program chooses mesh, scheme and step."""
    made_for = {**extra, "mesh.refine": "auto", "mesh.degree": 3}
    return [Job(series, f"tolerance {tolerance:g}", {**made_for, "accuracy.tolerance": tolerance}, series)
            for tolerance in TOLERANCES]


def schemes(name, title, extra):
    """Time schemes and steps on one mesh, against small steps on the same mesh."""
    extra = {**mesh(), **extra}
    jobs = [Job("default", "auto", extra)]
    for series, scheme, parts in (("sdirk4", SDIRK, (4, 8, 16, 32)),
                                  ("generalised_alpha", ALPHA, (16, 32, 64, 128))):
        jobs += [Job(series, f"td/{part}", {**extra, **scheme, "time.step": PULSE / part}) for part in parts]
    jobs += [Job("reduced", f"tolerance {tolerance:g}",
                 {**extra, "time.scheme": "reduced", "accuracy.tolerance": tolerance}) for tolerance in (0.05, 0.005)]
    return Study(name, title, PROTOTYPE, jobs, {**extra, **SDIRK, "time.step": PULSE / 128})


def prototype_meshes(name, title, extra):
    graded = [0.35, 0.5, 0.7, 1, 1.5]  # the last two only for degree 2, as the reference has degree 3
    jobs = [Job("default", "auto", extra)] + by_tolerance("mesh by tolerance", extra)
    jobs += meshes("degree 2, graded", [(2, cells, 12) for cells in graded], extra)
    jobs += meshes("degree 3, graded", [(3, cells, 12) for cells in graded[:-2]], extra)
    jobs += meshes("degree 2, uniform", [(2, cells, 1) for cells in (0.5, 1, 2)], extra)
    jobs += meshes("degree 3, uniform", [(3, cells, 1) for cells in (0.5, 1, 2)], extra)
    return Study(name, title, PROTOTYPE, jobs, {**extra, **mesh(3, 1, 30), **SDIRK, "time.step": PULSE / 24})


def strip():
    exact = run.table(REFERENCES / "ref2d_poro_strip.json", lambda case: (
        case["case"] == "rubble5m_k0.1_on_sand15m_k1e-4" and case["model"] == "full" and case.get("td") == 0.1),
        "full", "FT")
    jobs = [job for degree in (2, 3) for job in meshes(
        f"degree {degree}", [(degree, cells, 60) for cells in (0.25, 0.35, 0.5, 0.7)], {"time.step": 1.25e-3})]
    jobs += meshes("degree 3, sdirk4", [(3, cells, 60) for cells in (0.25, 0.5)], {**SDIRK, "time.step": 6.25e-3})
    jobs += meshes("degree 3, generalised_alpha", [(3, cells, 60) for cells in (0.25, 0.5)],
                   {**ALPHA, "time.step": 1.5625e-3})
    return Study("strip", "strip of ref2d, against the exact solution", HERE / "strip.toml", jobs, exact)


def column():
    exact = run.table(REFERENCES / "ref2b_column.json", lambda case: (
        case["name"] == "rubble_L5_k0.1" and case["load"].get("td") == 0.1), "full", "u_top", sign=-1)
    jobs = [Job("default", "auto", {})]
    for degree in (2, 3):
        for scheme, settings, factor in (("sdirk4", SDIRK, 1), ("generalised_alpha", ALPHA, 0.25)):
            jobs += [Job(f"degree {degree}, {scheme}", f"{cells} cells, {1e3 * factor * step:g} ms",
                         {"mesh.refine": 0, "mesh.degree": degree, "mesh.parameters.cells": cells, **settings,
                          "time.step": factor * step})
                     for cells, step in ((5, 12.5e-3), (10, 6.25e-3), (20, 3.125e-3), (80, 0.78125e-3))]
    return Study("column", "column of ref2b, against the exact solution", HERE / "column.toml", jobs, exact,
                 "probes/top/displacement_y")


def designer():
    """A section on an unstructured mesh by gmsh that is not graded for it: 58,644 unknowns as shipped."""
    jobs = [Job("default", "auto", {}), Job("degree 3", "as shipped", {"mesh.degree": 3}),
            Job("cells halved", "degree 2", {"mesh.refine": 1}),
            Job("sdirk4", "its own step", SDIRK), Job("generalised_alpha", "its own step", ALPHA)]
    made_for = {"mesh.refine": "auto", "mesh.degree": 3}
    jobs += [Job("mesh by tolerance", f"tolerance {tolerance:g}", {**made_for, "accuracy.tolerance": tolerance})
             for tolerance in TOLERANCES[:3]]
    return Study("designer", "designer's section, 6 s", DESIGNER, jobs,
                 # all cells halved at degree 3 take 9 GB and more than 8 minutes; F_T does not depend on friction, and
                 # a caisson that does not slip takes no second reduced model
                 {**made_for, "accuracy.tolerance": 1e-3, "sliding.friction": 0.95})


def train():
    """The cost of a march grows with the time; modes found for one wave serve ten waves as well. All runs have one
    coarse mesh, as only schemes in time are compared: the reference takes 16,000 steps."""
    extra = {**mesh(cells=0.5), "time.end": 100, "loads.impulse.history": json.dumps(str(TRAIN))}
    jobs = [Job("default", "auto", extra)]
    for series, scheme, steps in (("sdirk4", SDIRK, (0.1, 0.05, 0.025)),
                                  ("generalised_alpha", ALPHA, (0.025, 0.0125, 0.00625))):
        jobs += [Job(series, f"{1e3 * step:g} ms", {**extra, **scheme, "time.step": step}) for step in steps]
    jobs += [Job("reduced", f"tolerance {tolerance:g}",
                 {**extra, "time.scheme": "reduced", "accuracy.tolerance": tolerance}) for tolerance in (0.05, 0.0005)]
    return Study("train", "fig2b prototype, ten waves in 100 s", PROTOTYPE, jobs, {**extra, **SDIRK, "time.step": 0.00625})


def upbead_alone():
    return [schemes("damped", "fig2b prototype, schemes, 5 % damping", {}),
            schemes("undamped", "fig2b prototype, schemes, undamped", UNDAMPED),
            prototype_meshes("inertial", "fig2b prototype, meshes, inertial mound", {}),
            prototype_meshes("darcy", "fig2b prototype, meshes, darcy mound", DARCY), strip(), column(), designer(), train()]


def beside_peers(name="upbead"):
    """upbead on the peers' scene: reduced as by default, and marched. `name`: what its series begin with."""
    cells = (0.25, 0.35, 0.5, 0.7, 1, 1.5)
    jobs = [Job(f"{name}, reduced", "default", {}, "default")] + by_tolerance(f"{name}, by tolerance", {})
    for grading in (12, 30):
        jobs += meshes(f"{name}, reduced", [(2, c, grading) for c in cells])
        jobs += meshes(f"{name}, reduced", [(3, c, grading) for c in cells[:-1]])
    for part in (4, 8):
        step = {**SDIRK, "time.step": PULSE / part}
        jobs += meshes(f"{name}, sdirk4", [(2, c, 12) for c in cells[:-1]] + [(3, c, 12) for c in cells[:-2]], step)
    for part in (16, 32):
        step = {**ALPHA, "time.step": PULSE / part}
        jobs += meshes(f"{name}, generalised_alpha",
                       [(2, c, 12) for c in cells[1:-1]] + [(3, c, 12) for c in cells[:-3]], step)
    jobs += meshes(f"{name}, reduced, uniform", [(degree, c, 1) for degree in (2, 3) for c in (0.5, 1, 2)])
    return Study("peers", "peers, darcy flow without sea", PEER_SCENE, jobs,
                 {**mesh(3, 1.5, 60), "accuracy.tolerance": 1e-5, "time.step": 1e-3})
