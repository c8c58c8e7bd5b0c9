#!/usr/bin/python3
"""A section in the coordinates of a survey: the whole summary is that of the same section at the origin, to the digits
that large coordinates leave of the cells, and fields have their cells.

usage: survey_test.py PROGRAM CASES_FOLDER
"""

import json
import pathlib
import sys

import numpy as np

from program import CASES, ProgramTest, main, upbead

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "postprocess"))
from report import vtu  # noqa: E402

EAST, NORTH = 441871.6, 6329700.7
#: Round-off of a coordinate, 1e-9 m, over a cell of 1 m, grows in derived numbers; where it counts cells it is larger.
CLOSE, LOOSE = 1e-6, 1e-3
SCENE = """title = "section"
[mesh]
file = "{mesh}"
[initial]
water_level = {level!r}
[regions.seabed]
kind = "porous"
law = "hysteretic"
strength = {{ friction_angle = 35, cohesion = 5e3 }}
shear_modulus = 30e6
poissons_ratio = 0.33
porosity = 0.4
grain_density = 2650.0
hydraulic_conductivity = 1e-4
damping = {{ ratio = 0.05, frequencies = [1, 10] }}
[regions.mound]
kind = "porous"
shear_modulus = 50e6
poissons_ratio = 0.3
porosity = 0.4
grain_density = 2650.0
hydraulic_conductivity = 0.15
damping = {{ ratio = 0.05, frequencies = [1, 10] }}
[regions.caisson]
kind = "rigid"
density = 2100.0
[boundaries]
base = {{ displacement = "fixed", pressure = "sealed" }}
left = {{ displacement = "roller", pressure = "sealed" }}
right = {{ displacement = "roller", pressure = "sealed" }}
bed = {{ pressure = "open" }}
mound_surface = {{ pressure = "open" }}
front = {{}}
back = {{}}
top = {{}}
[loads.impulse]
boundary = "front"
kind = "force"
shape = [[{low!r}, 1.0], [{middle!r}, 2.0], [{high!r}, 0.5]]
pulse = {{ shape = "triangle", peak = 1e6, duration = 0.15 }}
[sliding]
friction = 0.6
submerged_weight = 4.3e6
[time]
end = 0.2
[probes.sand]
at = [{probe_x!r}, {probe_y!r}]
[output.fields]
every = 0.1
"""


def numbers(value, path=""):
    if isinstance(value, dict):
        for key, part in value.items():
            yield from numbers(part, f"{path}.{key}" if path else key)
    elif isinstance(value, list):
        for index, part in enumerate(value):
            yield from numbers(part, f"{path}[{index}]")
    else:
        yield path, value


class Survey(ProgramTest):
    def solve(self, name, x, y):
        text = (CASES.parent / "meshes" / "composite.geo").read_text()
        for plain, coarse in (("cells = 1,", "cells = 0.3,"), ("seabed_front = 120", "seabed_front = 40"), ("seabed_back = 120", "seabed_back = 40")):
            self.assertIn(plain, text)
            text = text.replace(plain, coarse)
        moved = f"\nTranslate {{{x!r}, {y!r}, 0}} {{ Surface{{:}}; }}\n" if x else ""
        (self.folder / f"{name}.geo").write_text(text + moved)
        case = SCENE.format(mesh=f"{name}.geo", level=15.0 + y, low=6.0 + y, middle=15.0 + y, high=22.0 + y, probe_x=3.0 + x, probe_y=y - 2.0)
        (self.folder / f"{name}.toml").write_text(case)
        done = upbead("run", self.folder / f"{name}.toml", "--out", self.folder / name)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((self.folder / name / "summary.json").read_text())

    def test_the_summary_is_that_at_the_origin(self):
        here, there = (dict(numbers(self.solve(*of))) for of in (("here", 0.0, 0.0), ("there", EAST, NORTH)))
        self.assertEqual(list(here), list(there))
        for key, value in here.items():
            other = there[key]
            if key.startswith(("timing", "versions")) or key.endswith(("mismatch", "text")) or isinstance(value, str):
                continue
            if key.endswith("_at[0]") or key.endswith(".at[0]") or key.endswith("pressure_at"):
                other = other - EAST if other else other  # 0: no such place
            elif key.endswith("_at[1]") or key.endswith(".at[1]"):
                other = other - NORTH if other else other
            elif key.startswith("circles.") and key.endswith(("centre[0]", "from", "to")) or key.startswith("circles.block.x"):
                other = other - EAST
            elif key.startswith("circles.") and key.endswith("centre[1]") or key.startswith("circles.block.y"):
                other = other - NORTH
            if value is None or isinstance(value, bool):
                self.assertEqual(other, value, key)
                continue
            if "at[0]" in key or key.endswith("residual.pore_pressure"):  # of two places alike, left and right of the middle, either
                value, other = abs(value), abs(other)
            close = LOOSE if "share" in key or key.endswith("_time") else CLOSE
            self.assertLessEqual(abs(other - value), close * max(abs(value), 1e-3), f"{key}: {value} {other}")

    def test_fields_have_their_cells(self):
        self.solve("there", EAST, NORTH)
        self.solve("here", 0.0, 0.0)
        areas = []
        for name in ("here", "there"):
            found = vtu.arrays(self.folder / name / "fields" / "fields_0001.vtu", ("points", "types"))
            self.assertEqual(found["points"].dtype, np.float64)
            points = found["points"][vtu.corners(len(found["points"]), len(found["types"]))][:, :, :2]
            across, along = points[:, 2] - points[:, 0], points[:, 3] - points[:, 1]
            areas.append(np.abs(across[:, 0] * along[:, 1] - across[:, 1] * along[:, 0]) / 2)
        np.testing.assert_allclose(areas[1], areas[0], rtol=1e-6)


if __name__ == "__main__":
    main()
