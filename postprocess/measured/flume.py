"""Case W: how far a caisson in a flume slides under five waves, by the program, by formulas and by a published lumped model."""

from pathlib import Path

import h5py
import numpy as np

from .lumped_slip import Caisson, slip
from .runs import CASES, design, interval, run, side_by_side

CASE, ON_SPRINGS, AS_MASS = (CASES / f"flume/{name}.toml" for name in ("flume", "springs", "mass"))
SPREADS = {
    "factor": (0.75, 1.15, "linear"),  # of P and U
    "friction": (0.47, 0.53, "linear"),
    "modulus": (0.15e6, 20e6, "log"),  # from the given springs to rubble at small strain
    "course": (0.0, 1.0, "linear"),  # below 0.6 a triangle, else a church roof
    "uplift": (0.0, 1.0, "linear"),  # below 0.5 held, else in phase
    "height": (0.95, 1.05, "linear"),
}
POINTS = 32
SPRINGS, DASHPOTS = (541.6e3, 582.6e3, 16.25e3), (1694.0, 1757.0, 69.6)  # per metre: given
COARSE = {"mesh.parameters.cells": 0.5}


def keys_of(point):
    return {
        "loads.waves.wave.course": "triangle" if point["course"] < 0.6 else "church_roof",
        "loads.waves.wave.height": 0.167 * point["height"],
        "loads.waves.wave.significant_height": 0.167 * point["height"],
        "loads.waves.factor": point["factor"],
        "section.friction": point["friction"],
        "regions.mound.shear_modulus": point["modulus"],
        "sliding.uplift.shape": "held" if point["uplift"] < 0.5 else "in_phase",
    }


def as_a_whole(program, keys, folder):
    return run(program, CASE, COARSE | keys | {"regions.caisson.interface.kind": "bonded"}, folder)


def held(force, peak):
    """U in proportion to P up to the largest P of each wave, then at its peak as long as there is P."""
    course, highest = np.zeros_like(force), 0.0
    for i, p in enumerate(force):
        highest = max(highest, p) if p > 0 else 0.0
        course[i] = highest
    return peak * course / force.max()


def lumped_caisson(friction=0.5):
    height, width, mass = 0.385, 0.30, 162.0
    water = 1.0855 * 1000 * 0.15**2  # of rigid walls in water on both sides (exact, Westergaard's problem)
    return Caisson(mass, mass * (height**2 / 3 + width**2 / 12), height / 2, 1147.8, friction, SPRINGS, DASHPOTS, water, 0.4 * 0.15)


def lumped(folder, wave, friction=0.5, turns=True):
    """The lumped model under P and U of a run of the program in `folder`; whether U turns the caisson, too."""
    with h5py.File(Path(folder) / "results.h5") as file:
        time, force = file["history/time"][:], file["history/force"][:]
    uplift = held(force, wave["peak_uplift"])
    moment = turns * uplift * 0.30 / 6  # of a triangle, about the middle: it lifts the seaward edge
    caisson = lumped_caisson(friction)
    _, slips = slip(caisson, time, force, wave["force_moment"] / wave["force"], uplift, moment)
    return float(slips[-1])


def ways(program, folder):
    """Slip after five waves by each way (m); formulas have no memory, so five times that of one wave."""
    summary = as_a_whole(program, {}, folder / "whole")
    wave = summary["wave_loads"]["waves"]
    found = {
        "node by node, triangle": run(program, CASE, {}, folder / "nodes")["contact"]["solved"]["slip"],
        "as a whole, triangle": summary["sliding"]["sliding_coupled"],
        "formula, triangle, exact": 5 * summary["sliding"]["sliding_exact"],
        "formula, triangle, eq. (7)": 5 * summary["sliding"]["sliding_paper"],
        "lumped, springs given, triangle": lumped(folder / "whole", wave),
    }
    church = as_a_whole(program, {"loads.waves.wave.course": "church_roof"}, folder / "church")
    found["as a whole, church roof"] = church["sliding"]["sliding_coupled"]
    found["lumped, springs given, church roof"] = lumped(folder / "church", wave)
    found["lumped, springs given, triangle, U on friction alone"] = lumped(folder / "whole", wave, turns=False)
    found |= on_springs(program, folder)
    no_impact = as_a_whole(program, {"loads.waves.wave.course": "sine", "loads.waves.factor": standing_share(wave)}, folder / "sine")
    found["as a whole, sine, Goda's P without alpha_I"] = no_impact["sliding"]["sliding_coupled"]
    return found


def on_springs(program, folder):
    """The same published model as a case of the program: water as finite elements, slip with the caisson's own reduced model."""
    found = {}
    for course in ("triangle", "church roof"):
        summary = run(program, ON_SPRINGS, {"loads.waves.wave.course": course.replace(" ", "_")}, folder / f"springs, {course}")
        found[f"as a case, springs given, {course}"] = summary["sliding"]["sliding_coupled"]
    summary = run(program, AS_MASS, {}, folder / "springs, mass")
    found["as a case, springs given, triangle, the water as a mass"] = summary["sliding"]["sliding_coupled"]
    return found


def standing_share(wave):
    """Goda's P with alpha_2 over that with alpha*: every pressure goes with alpha_1 + alpha*."""
    return (wave["alpha_1"] + wave["alpha_2"]) / (wave["alpha_1"] + wave["alpha_star"])


def predict(program, folder):
    found = ways(program, folder)
    points = design(SPREADS, POINTS)
    slips = side_by_side(lambda number, point: as_a_whole(program, keys_of(point), folder / str(number))["sliding"]["sliding_coupled"], points)
    return {"slip": found["node by node, triangle"], "interval": interval(slips), "ways": found, "points": [[*point.values(), s] for point, s in zip(points, slips, strict=True)]}
