#!/usr/bin/python3
"""Slip and opening at the bottom as a user asks for them: a run whose caisson slips and lifts, a run in which it does
neither, mistakes.

usage: contact_test.py PROGRAM CASES_FOLDER
"""

import json
import pathlib
import sys
import unittest

import h5py
import numpy

from program import CASES, ProgramTest, upbead

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "postprocess"))
from report import vtu  # noqa: E402

COARSE = ["--set", "mesh.parameters.cells=0.35", "--set", "sliding.submerged_weight=10740.0"]
FRICTION = ["--set", 'regions.caisson.interface.kind="friction"']
WIDTH, HEIGHT = 0.9, 0.3  # width of the caisson, height of its bottom above the seabed (m)
STRONG = ["--set", "loads.impulse.factor=3"]


class Contact(ProgramTest):
    def run_model(self, *arguments, out="out", status=0):
        done = upbead("run", CASES / "fig2b-model.toml", *COARSE, *arguments, "--out", out, cwd=self.folder)
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def summary(self, out="out"):
        return json.loads((self.folder / out / "summary.json").read_text())

    def test_a_strong_wave_slides_and_lifts(self):
        done = self.run_model(*FRICTION, *STRONG)
        self.assertIn("S           ", done.stdout)
        self.assertIn("with friction node by node", done.stdout)
        found = self.summary()
        solved, energy = found["contact"]["solved"], found["energy"]
        self.assertEqual(found["discretisation"]["scheme"], "contact")
        self.assertTrue(found["contact"]["glued"]["reached"])
        self.assertAlmostEqual(solved["dissipated"], energy["friction"], delta=1e-9 * energy["friction"])
        self.assertGreater(found["sliding"]["sliding_coupled"], 1e-4)
        with h5py.File(self.folder / "out/results.h5") as file:
            time, nodes = file["history/time"].size, file["interface/position"].size
            self.assertEqual(nodes, found["contact"]["nodes"])
            tables = {name: file[f"interface/{name}"][:] for name in ("slip", "opening", "shear_force", "normal_force")}
            for table in tables.values():
                self.assertEqual(table.shape, (time, nodes))
            length = file["interface/length"][:]
            mean = tables["slip"] @ length / length.sum()
            self.assertTrue(numpy.allclose(mean, file["history/interface/slip"][:], rtol=0, atol=1e-12))
            self.assertAlmostEqual(mean[-1], solved["slip"], delta=1e-15)
            F_T = file["history/shear_force"][:]
            self.assertTrue(numpy.allclose(tables["shear_force"].sum(axis=1), F_T, rtol=0, atol=1e-9 * F_T.max()))
            self.assertEqual(file["coupled/slip"][-1], found["sliding"]["sliding_coupled"])
        self.assertGreaterEqual(tables["opening"].min(), 0)
        self.assertGreaterEqual(tables["normal_force"].min(), -1e-9 * 10740)
        excess = abs(tables["shear_force"]) - 0.6 * tables["normal_force"]
        self.assertLessEqual(excess.max(), 1e-9 * 10740)

    def test_a_weak_wave_needs_no_contact(self):
        weak = ["--set", "loads.impulse.factor=0.2"]
        self.run_model(*FRICTION, *weak)
        self.run_model(*weak, out="tied")
        free, tied = self.summary(), self.summary("tied")
        self.assertIsNone(free["contact"]["solved"])
        self.assertIn("contact node by node", [item["what"] for item in free["skipped"]])
        self.assertIsNone(tied["contact"])
        ratio = [each["response"]["shear_to_force_ratio"] for each in (free, tied)]
        self.assertAlmostEqual(ratio[0], ratio[1], delta=2e-3 * ratio[1])
        self.assertEqual(free["sliding"]["sliding_coupled"], 0)

    def test_fields_show_both_sides_of_the_gap(self):
        self.run_model(*FRICTION, *STRONG, "--set", "output.fields={ every = 0.1 }")
        self.assertTrue((self.folder / "out/fields.pvd").exists())
        tied = self.run_model(*STRONG, "--set", "output.fields={ every = 0.1 }", out="tied")
        self.assertEqual(tied.returncode, 0)
        self.assertLess(self.gap("tied"), 1e-6)
        with h5py.File(self.folder / "out/results.h5") as file:
            step = abs(file["history/time"][:] - vtu.times(self.folder / "out/fields.pvd")[-1][0]).argmin()
            slip = abs(file["interface/slip"][step, 1:-1]).max()
        self.assertAlmostEqual(self.gap("out") / slip, 1, 4)

    def gap(self, out):
        """Slip (m) in the last field, at points within the bottom: the distance between points of caisson and ground
        that coincided at rest."""
        found = vtu.arrays(vtu.times(self.folder / out / "fields.pvd")[-1][1], {"points", "displacement_(m)"})
        at = numpy.round(found["points"][:, :2].astype(float), 5)
        sway, widest = found["displacement_(m)"][:, 0], 0.0
        for x in numpy.unique(at[(abs(at[:, 1] - HEIGHT) < 1e-5) & (abs(at[:, 0]) < WIDTH / 2 - 1e-3), 0]):
            here = sway[(at == [x, HEIGHT]).all(axis=1)]
            widest = max(widest, float(here.max() - here.min()))
        return widest

    def test_the_effective_case_gives_the_same_answer(self):
        self.run_model(*FRICTION, *STRONG)
        done = upbead("run", "out/case.toml", "--out", "again", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.summary("again")["contact"], self.summary()["contact"])

    def test_what_cannot_be_meant_is_told_and_nothing_written(self):
        done = self.run_model(*FRICTION, "--set", "regions.caisson.interface.coefficient=0.5", "--set",
                              "sliding.friction=0.6", status=1)
        self.assertIn("friction = 0.6 is not the coefficient = 0.5", done.stderr)
        self.assertFalse((self.folder / "out").exists())

    def test_a_prescribed_uplift_acts_node_by_node(self):
        uplift = ["--set", 'sliding.uplift={ kind = "prescribed", peak = 2000.0 }']
        self.run_model(*FRICTION, *STRONG, out="without")
        self.run_model(*FRICTION, *STRONG, *uplift)
        without, found = self.summary("without"), self.summary()
        self.assertGreater(found["contact"]["solved"]["slip"], 1.05 * without["contact"]["solved"]["slip"])
        self.assertEqual(found["sliding"]["design"]["measure"], "contact.solved.slip")
        self.assertEqual(found["sliding"]["design"]["value"], found["contact"]["solved"]["slip"])
        self.assertGreater(found["base"]["peak_heel_pressure"], without["base"]["peak_heel_pressure"])


if __name__ == "__main__":
    unittest.main(argv=["contact_test.py"])
