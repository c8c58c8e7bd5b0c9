#!/usr/bin/python3
"""The ladder: if one way refuses a scene another solves it, and the summary lists the ways tried, with the reasons of
refusals.

usage: ladder_test.py PROGRAM CASES_FOLDER
"""

import json
import pathlib
import sys
import unittest

from program import ProgramTest, upbead

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
from section_scene import SCENE  # noqa: E402

ELASTIC = ["--set", 'regions.caisson={ kind = "solid", density = 2100.0, shear_modulus = 8e8, poissons_ratio = 0.2, '
           'deformation = "elastic" }']
COLUMN = """title = "pressure on incompressible water"
[fluid]
density = 1000.0
bulk_modulus = inf
[mesh]
geometry = "column"
parameters = { height = 10, width = 1, cells = 20, grading = 1 }
[regions.soil]
kind = "porous"
shear_modulus = 1e7
poissons_ratio = 0.3
porosity = 0.4
grain_density = 2650
hydraulic_conductivity = 1e6
flow = "inertial"
[boundaries]
base = { displacement = "fixed", pressure = "sealed" }
left = { displacement = "roller", pressure = "sealed" }
right = { displacement = "roller", pressure = "sealed" }
top = { displacement = "free", pressure = "open" }
[loads.a]
boundary = "top"
kind = "pressure"
[loads.a.pulse]
peak = 1e4
shape = "triangle"
duration = 0.1
rise = 0.05
[time]
end = 1
[probes.A]
at = [0.5, 5]
"""


class Ladder(ProgramTest):
    def ask(self, scene, *arguments):
        (self.folder / "scene.toml").write_text(scene)
        return upbead("run", self.folder / "scene.toml", "--json", *arguments, "--out", self.folder / "out")

    def summary(self, scene, *arguments):
        done = self.ask(scene, *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_the_first_way_is_taken_where_it_holds(self):
        summary = self.summary(SCENE, "--set", 'time.scheme="sdirk4"')
        self.assertEqual(summary["ladder"], [{"way": "sdirk4", "refused": None}])

    def test_a_reduced_model_balances_the_forces_on_an_elastic_caisson(self):
        """In an older version both routes to F_T differed by 3e-3, and the run was refused."""
        reduced = self.summary(SCENE, *ELASTIC, "--set", 'time.scheme="reduced"')
        self.assertLess(reduced["response"]["reaction_mismatch"], 1e-8)
        marched = self.summary(SCENE, *ELASTIC, "--set", 'time.scheme="sdirk4"')
        peaks = [summary["response"]["peak_shear"] for summary in (reduced, marched)]
        self.assertAlmostEqual(peaks[0] / peaks[1], 1, delta=5e-3)

    def test_refined_solutions_where_large_forces_cancel(self):
        """The work is only round-off here; work and the sum of all energies differed by 4e-5 of 1e-10 of the work
        that the loads could do."""
        for scheme in ("auto", "sdirk4", "generalised_alpha"):
            ladder = self.summary(COLUMN, "--set", f'time.scheme="{scheme}"')["ladder"]
            self.assertIsNone(ladder[-1]["refused"])
            for step in ladder[:-1]:
                self.assertIn("the work of the loads and the sum of all energies differ", step["refused"])

    def test_a_study_climbs_as_well(self):
        (self.folder / "scene.toml").write_text(COLUMN)
        (self.folder / "study.toml").write_text(
            'title = "k"\ncase = "scene.toml"\nsample = "grid"\nread = ["energy.mismatch"]\n'
            '[vary."regions.soil.hydraulic_conductivity"]\nvalues = [1.0, 1e6]\n')
        done = upbead("study", self.folder / "study.toml", "--out", self.folder / "study")
        self.assertEqual(done.returncode, 0, done.stderr + done.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
