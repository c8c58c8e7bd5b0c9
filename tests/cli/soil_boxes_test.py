#!/usr/bin/python3
"""One model for a box of soils, as a user makes it.

usage: soil_boxes_test.py PROGRAM CASES_FOLDER
"""

import json
import sys
import unittest

import h5py
import numpy as np

from program import CASES, ProgramTest, upbead

CASE = CASES / "fig2b-prototype.toml"
COARSE = ["--set", "mesh.parameters.cells=0.5"]
BOX = """\
[vary."regions.seabed.shear_modulus"]
distribution = "log_uniform"
low = 20e6
high = 300e6
[vary."regions.mound.shear_modulus"]
distribution = "log_uniform"
low = 20e6
high = 600e6
[vary."regions.seabed.hydraulic_conductivity"]
distribution = "log_uniform"
low = 2e-5
high = 1e-3
"""


CALIBRATION = """\
[section]
water_depth = 15.0
foundation_depth = 9.0
berm_depth = 9.0
crest = 7.0
width = 18.0
berm_width = 7.0
bed_slope = 0.01
weight = 5.933e6
submerged_weight = 4.296e6
friction = 0.6
[impact]
peak_gain = 0.5
[calibration]
relative_height = [0.5, 0.7]
period = [10.0, 13.6]
relative_berm_depth = [0.4, 0.6]
relative_berm_width = [0.06]
ratios = [1.2]
[calibration.models.soft]
model = "model/soils.h5"
load = "impulse"
soil = { "regions.seabed.shear_modulus" = 25e6 }
[calibration.models.stiff]
model = "model/soils.h5"
load = "impulse"
soil = { "regions.seabed.shear_modulus" = 250e6 }
[calibration.models.many]
model = "model/soils.h5"
load = "impulse"
soils = 3
"""


class SoilBoxes(ProgramTest):
    def reduce(self, box, *arguments, case=CASE):
        (self.folder / "box.toml").write_text(box)
        return upbead("reduce", case, *COARSE, "--soils", "box.toml", *arguments, cwd=self.folder)

    def refusal(self, box, *arguments):
        done = self.reduce(box, *arguments, "--out", "model")
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertEqual(self.left_behind(), ["box.toml"])
        return done.stderr

    def test_reduce_writes_one_model_for_a_box(self):
        done = self.reduce(BOX, "--out", "model", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        told = json.loads(done.stdout)
        self.assertEqual([axis["key"] for axis in told["box"]][:1], ["regions.seabed.shear_modulus"])
        self.assertEqual(told["unseen"]["soils"], 16)
        self.assertLess(told["unseen"]["largest_estimate"], 2 * told["tolerance"])
        with h5py.File(self.folder / "model/soils.h5") as file:
            self.assertEqual(file.attrs["kind"].decode(), "upbead soil model")
            points, low, high = file["box/points"][:], file["box/low"][:], file["box/high"][:]
            self.assertEqual(points.shape, (told["points"], 3))
            self.assertTrue(np.all((points >= low) & (points <= high)))

    def test_a_calibration_is_of_one_soil_or_of_many(self):
        self.assertEqual(self.reduce(BOX, "--out", "model").returncode, 0)
        (self.folder / "k.toml").write_text(CALIBRATION)
        done = upbead("calibrate", "k.toml", "--json", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        models = json.loads(done.stdout)["models"]
        self.assertEqual([len(models[name]["soils"]) for name in ("many", "soft", "stiff")], [3, 0, 0])
        key = "regions.seabed.shear_modulus"
        for soil in models["many"]["soils"]:
            self.assertTrue(20e6 <= soil["soil"][key] <= 300e6, soil)
            self.assertLess(soil["error"], 1e-2)
        points = {name: models[name]["fits"][0]["points"] for name in models}
        self.assertGreater(points["many"], 2 * points["stiff"])
        self.assertNotEqual(models["soft"]["fits"], models["stiff"]["fits"])
        (self.folder / "k.toml").write_text(CALIBRATION.replace("= 25e6 }", "= 5e6, nothing = 1 }"))
        done = upbead("calibrate", "k.toml", cwd=self.folder)
        self.assertEqual(done.returncode, 1, done.stdout)
        for words in ("lies outside the box of the model", "'nothing' is no key that the model varies"):
            self.assertIn(words, done.stderr)

    def test_a_box_tells_all_its_mistakes(self):
        told = self.refusal(BOX + """\
[vary."loads.impulse.factor"]
distribution = "uniform"
low = 1
high = 2
[vary."regions.mound.flow"]
values = ["darcy", "inertial"]
[set]
"time.end" = 1
""")
        self.assertIn("'loads.impulse.factor' is no number of a soil", told)
        self.assertIn("'regions.mound.flow' has values that are no numbers", told)
        self.assertIn("a box of soils has no [set]", told)

    def test_the_case_lies_in_the_box_and_has_its_keys(self):
        self.assertIn("lies outside the box of soils", self.refusal(BOX.replace("high = 300e6", "high = 25e6")))
        self.assertIn("the case has no number at 'regions.clay.shear_modulus'",
                      self.refusal(BOX.replace("regions.mound.shear", "regions.clay.shear")))
        self.assertIn("does not go with --soils", self.refusal(BOX, "--check"))

    def test_a_box_with_two_kinds_of_soil_is_refused(self):
        told = self.refusal(BOX.replace("low = 2e-5\nhigh = 1e-3", "low = 1e-7\nhigh = 1.0"))
        self.assertIn("the box holds soils of more than one kind: with regions.seabed.", told)
        self.assertIn("decide otherwise about its flow", told)

    def test_a_scene_that_is_no_sum_is_refused_at_its_key(self):
        done = self.reduce(BOX, "--set", "time.scheme=sdirk4", "--out", "model")
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertIn("time.scheme", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
