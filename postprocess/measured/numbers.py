"""Everything that docs/validation.md says, computed anew; what was predicted is not changed by it."""

import json
import subprocess

from . import beach, column, deep, flume, more, paper, parapet, peers, tornado, tornado_more
from .runs import CASES, run

STIFFER = 1.06  # rubble that a parapet's weight presses together: G goes with the root of 1.12 times the stress


def of_column(program, folder):
    found = {}
    for saturation in column.SATURATIONS:
        keys = column.keys_of(saturation, {})
        here, exact, slow = column.computed(program, keys, folder / "column"), column.theory(keys), column.theory(keys, column.quasi_static)
        error = max(abs(here[name][0] / exact[name][0] - 1) for name in exact)
        found[str(saturation)] = {"computed": {name: list(pair) for name, pair in here.items()}, "theory": {name: list(pair) for name, pair in exact.items()},
                                  "error": error, "inertia": max(abs(exact[name][0] / slow[name][0] - 1) for name in exact)}  # fmt: skip
    return found


def of_air(program, folder):
    """The largest change of |p|/p_0 over the depth where the column's air has the pressure at its own depth, by saturation."""
    found = {}
    for saturation in column.SATURATIONS[:-1]:
        keys = column.keys_of(saturation, {})
        middle, own = (column.computed(program, keys | {"regions.soil.air_by_depth": by_depth}, folder / "air") for by_depth in (False, True))
        found[str(saturation)] = max(abs(own[name][0] - middle[name][0]) for name in middle)
    return found


def of_parapet(program, folder):
    frequency, change = parapet.change(program, parapet.CENTRAL, folder)
    stiffer = parapet.frequency(program, parapet.keys_of(parapet.CENTRAL | {"rubble_modulus": STIFFER * parapet.CENTRAL["rubble_modulus"]}, True), folder / "stiffer")
    wide = parapet.change(program, parapet.CENTRAL | {"width": 20.0, "slenderness": 0.65}, folder / "wide")
    part = parapet.frequency(program, parapet.as_part(parapet.CENTRAL), folder / "part")
    return {"frequency": frequency, "change": change, "change, as a part": 100 * (part / frequency - 1), "change, rubble stiffer by the weight": 100 * (stiffer / frequency - 1), "change, 20 m wide and 13 m high": wide[1]}


def of_drag(program, folder):
    """What drag that grows with velocity does to Fig. 2b's prototype: beta (1 - n)/(n^3 g d_50) of stones of 0.5 m."""
    case, b = CASES.parent / "fig2b-prototype.toml", 1.1 * 0.6 / (0.4**3 * 9.81 * 0.5)
    without, with_it = (run(program, case, keys, folder / "drag") for keys in ({}, {"regions.mound.forchheimer": b}))
    peak, plain = (summary["response"]["peak_shear"] for summary in (with_it, without))
    return {"b": b, "change": abs(peak / plain - 1), "velocity": with_it["soil"]["largest_velocity"]}


def of_beach(program, folder):
    return beach.fitted(program, folder / "beach") | {f"{state}, their S and k": value for state, value in beach.published(program, folder / "beach").items()}


def of_wall(program, folder):
    done = subprocess.run([program, "waves", CASES / "wall/wall.toml", "--out", folder / "wall", "--json"], capture_output=True, text=True, check=False)
    wave = json.loads(done.stdout)["waves"]["impact"]
    return {"p_1 over rho g h_s": wave["p1"] / (1030 * 9.81 * 0.135)}


def all_of(program, folder, only=None):
    """All, or one part by its name."""
    steps = {
        "column": of_column,
        "air": of_air,
        "parapet": of_parapet,
        "drag": of_drag,
        "flume": flume.ways,
        "deep": lambda program, folder: deep.frequencies(program, {}, folder / "deep"),
        "beach": of_beach,
        "wall": of_wall,
        "paper": paper.numbers,
        "peers": peers.compared,
        "tornado": tornado.predict,
        "more tornados": tornado_more.all_of,
    } | more.STEPS
    found = {}
    for name, step in steps.items():
        if only in (None, name):
            print(name, flush=True)
            found[name] = step(program, folder)
    return found



