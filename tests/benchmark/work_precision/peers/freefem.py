#!/usr/bin/python3
"""Prints the numbers that freefem.edp reads, and gives the command that runs it.

usage: freefem.py [STEP [RHO]]

Debian's FreeFem++ 4.11 looks for its plugins in the wrong place: set FF_LOADPATH=/usr/lib/freefem++.
"""

import pathlib
import sys

import scene as scenes

FOLDER = pathlib.Path(__file__).resolve().parent


def numbers(scene, rho, step, adapt=(0.0, 0.0)):
    """The input of freefem.edp. adapt: err and hmax (m) of adaptmesh; err 0: the given mesh."""
    soils = list(scene.soils.values())
    af, am = (rho / (1 + rho), (2 * rho - 1) / (1 + rho)) if rho < 1 else (0.0, 0.0)
    rows = [[s.G, s.lame, s.rho, s.storage, s.mobility] for s in soils]
    rows += [[soils[0].mass_damping, soils[0].stiffness_damping, *scene.centre, scene.mass, scene.inertia, scene.peak,
              scene.duration, scene.end, step, af, am, *adapt]]
    return "\n".join(" ".join(map(str, row)) for row in rows) + "\n"


def command(mesh, degree, numbers_file, output):
    """degree: 2 or 3, of the displacement."""
    script = FOLDER / f"freefem_p{degree}.edp"
    return ["FreeFem++", "-nw", "-v", "0", *map(str, (script, mesh, numbers_file, output))]


if __name__ == "__main__":
    step, rho, *_ = [float(text) for text in sys.argv[1:]] + [0.002, 1.0][len(sys.argv) - 1 :]
    print(numbers(scenes.read(), rho, step), end="")
