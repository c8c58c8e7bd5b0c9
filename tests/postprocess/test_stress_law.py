"""Laws of stress in Python: the same answers as the program's own laws, and mistakes of a function.

usage: test_stress_law.py FOLDER_OF_THE_SCRIPTS PROGRAM
"""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

SCRIPTS, PROGRAM = (Path(argument).resolve() for argument in sys.argv[1:3])
os.environ["UPBEAD"] = str(PROGRAM)
sys.path.insert(0, str(SCRIPTS))

import upbead  # noqa: E402

COHESION = 6e3


def column(load=2e4, **soil):
    """A column that a traction along its top shears, with weight."""
    scene = upbead.Scene("A sheared column", geometry="column", parameters={"height": 10.0, "width": 0.5, "cells": 8})
    scene.region("soil", "porous", shear_modulus=2e7, poissons_ratio=0.3, porosity=0.4, grain_density=2650.0, hydraulic_conductivity=1e-3, **soil)
    scene.boundary("base", displacement="fixed", pressure="sealed")
    scene.boundary("left", displacement="roller", pressure="sealed").boundary("right", displacement="roller", pressure="sealed")
    scene.boundary("top", displacement="free", pressure="open")
    scene.load("press", kind="traction", boundary="top", direction=[0.3, -1.0], factor=load, history=([0, 0.05, 0.1, 0.15, 0.2], [0, 1, 0, -1, 0]))
    return scene.put(initial={"water_level": 12.0, "start": "k0", "k0": 1.0}, fluid={"density": 1000.0, "bulk_modulus": 2.2e9}, time={"end": 0.2, "step": 0.005}).probe("top", at=(0.25, 9.0)).probe("middle", at=(0.25, 5.0))


def deviator(s):
    mean = (s[:, 0] + s[:, 1] + s[:, 3]) / 3
    return np.column_stack([s[:, 0] - mean, s[:, 1] - mean, s[:, 2], s[:, 3] - mean])


def elastic(strain, memory, soil):
    return soil.elastic(strain), memory, np.zeros(len(strain))


def sliding(strain, slid, soil):
    """One element of the overlay of the hysteretic law: its deviator is at most sqrt(2) times the shear strength (von Mises)."""
    G2 = 2 * soil.shear_modulus[:, None]
    volume = np.column_stack([strain[:, 0] + strain[:, 1]] * 2)
    e = np.column_stack([strain[:, :2] - volume / 3, strain[:, 2], -volume[:, 0] / 3])
    rest = deviator(soil.at_rest)
    tried = rest + G2 * (e - slid)
    length = np.sqrt(tried[:, 0] ** 2 + tried[:, 1] ** 2 + tried[:, 3] ** 2 + 2 * tried[:, 2] ** 2)
    most = np.sqrt(2) * COHESION
    slid = slid + (np.maximum(1 - most / np.maximum(length, 1e-300), 0)[:, None] * tried) / G2
    bulk = (soil.lame + 2 / 3 * soil.shear_modulus) * volume[:, 0]
    change = G2 * (e - slid) + bulk[:, None] * np.array([1.0, 1.0, 0.0, 1.0])
    return change, slid, np.minimum(length / most, 1.0)


class Laws(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def run_with(self, name, **soil):
        return upbead.run(column(**soil), out=self.folder / name)

    def assert_alike(self, one, other, tolerance):
        for name in ("probes/top/displacement_x", "probes/top/displacement_y", "probes/middle/pressure"):
            np.testing.assert_allclose(one[name], other[name], rtol=0, atol=tolerance * np.abs(other[name]).max(), err_msg=name)

    def test_soil_that_never_yields_is_elastic(self):
        self.assert_alike(self.run_with("python", law=elastic), self.run_with("own", law="hysteretic", strength={"friction_angle": 0.0, "cohesion": 1e9}, strain={"modulus": [[1e-6, 1.0], [0.1, 1.0]]}), 1e-9)

    def test_an_element_that_slides_is_that_of_the_program(self):
        own = self.run_with("own", load=1.2e5, law="hysteretic", strength={"friction_angle": 0.0, "cohesion": COHESION}, strain={"modulus": [[1e-6, 1.0], [0.1, 1.0]]})
        python = self.run_with("python", load=1.2e5, law=upbead.StressLaw(sliding, memory=4))
        self.assert_alike(python, own, 1e-6)
        self.assertGreater(own.summary["nonlinear"]["regions"][0]["largest"], 0.99)
        for table, key, tolerance in (("nonlinear", "share_yielded", 0), ("nonlinear", "peak_strain", 1e-6), ("nonlinear", "peak_strain_over_neighbours", 1e-6),
                                      ("energy", "strain", 1e-6), ("energy", "plastic", 1e-6)):
            found, expected = (run.summary[table][key] for run in (python, own))
            self.assertGreater(expected, 0, msg=key)
            self.assertAlmostEqual(found / expected, 1, delta=tolerance, msg=key)

    def test_a_study_of_another_function_starts_anew(self):
        def study(share):
            case = column(law=lambda strain, memory, soil: (share * soil.elastic(strain), memory, 0 * strain[:, 0]))
            return upbead.study({"case": case, "vary": {"loads.press.factor": {"values": [1e4, 2e4]}}, "read": ["energy.strain"]}, out=self.folder / "study", jobs=2)

        stiff, soft = study(1.0)["energy.strain"], study(0.5)["energy.strain"]
        self.assertTrue((soft > 1.2 * stiff).all(), (stiff, soft))

    def test_a_run_whose_function_fails_is_told_with_its_reason(self):
        def far(strain, memory, soil):
            if np.abs(strain).max() > 2e-4:
                raise ValueError("too far")
            return elastic(strain, memory, soil)

        with self.assertWarns(UserWarning):
            table = upbead.study({"case": column(law=far), "vary": {"loads.press.factor": {"values": [1e3, 2e5]}}, "read": ["energy.strain"]}, out=self.folder / "study", jobs=1)
        self.assertEqual((len(table), len(table.failed)), (1, 1))
        self.assertIn("ValueError: too far", str(table.failed))


class Mistakes(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def refused(self, law, error, text):
        with self.assertRaises(error) as caught:
            upbead.run(column(law=law), out=self.folder / "results")
        self.assertIn(text, str(caught.exception))
        self.assertFalse((self.folder / "results/summary.json").exists())

    def test_an_error_of_the_function_is_raised_as_it_is(self):
        self.refused(lambda strain, memory, soil: 1 / 0, ZeroDivisionError, "division by zero")

    def test_what_it_returns_is_looked_at(self):
        self.refused(lambda strain, memory, soil: soil.elastic(strain), upbead.UserError, "regions.soil.law: give stress, memory and the share")
        self.refused(lambda strain, memory, soil: (strain, memory, strain[:, 0]), upbead.UserError, "its stress has the shape")
        self.refused(lambda strain, memory, soil: (soil.at_rest, memory, strain[:, 0]), upbead.UserError, "without strain the stress changes")
        self.refused(lambda strain, memory, soil: (soil.elastic(strain) * np.nan, memory, strain[:, 0]), upbead.UserError, "no finite numbers")

    def test_a_case_that_asks_python_is_refused_without_it(self):
        path = column(law=elastic).save(self.folder / "case.toml")
        done = subprocess.run([PROGRAM, "run", path, "--out", self.folder / "out"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn('[regions.soil]: "python" asks a function of Python', done.stderr)
        self.assertFalse((self.folder / "out").exists())

    def test_cases_of_a_study_share_a_function(self):
        with self.assertRaisesRegex(upbead.UserError, "other functions"):
            upbead.study({"cases": [column(law=elastic), column(law=upbead.StressLaw(sliding, 4))], "vary": {"time.end": [0.1, 0.2]}}, out=self.folder / "study")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
