#!/usr/bin/python3
"""Natural periods where a scene is marched: output.periods = true. They are those of the reduced run of the same linear ground.

usage: periods_test.py PROGRAM CASES_FOLDER
"""

import shutil

from program import CASES, ProgramTest, main

COARSE = ["mesh.parameters.cells=0.4"]
MARCHED = ['time.scheme="sdirk4"', "output.periods=true"]


class Periods(ProgramTest):
    def setUp(self):
        super().setUp()
        for path in CASES.glob("fig2b-*"):
            shutil.copy(path, self.folder)

    def compare(self, found, wanted, tolerance=1e-6):
        """All of them, in their order."""
        self.assertIsNone(found["reduction"])
        self.assertIsNone(found["no_periods"])
        self.assertGreater(len(wanted["periods"]), 2)
        self.assertEqual(len(found["periods"]), len(wanted["periods"]))
        for one, other in zip(found["periods"], wanted["periods"], strict=True):
            for key in ("period", "damping_ratio", "share"):
                self.assertAlmostEqual(one[key] / other[key], 1, delta=tolerance)

    def test_marches_have_the_periods_of_the_reduced_run(self):
        for case in ("fig2b-prototype.toml", "fig2b-model.toml"):
            with self.subTest(case):
                self.compare(self.json_of("run", case, *COARSE, *MARCHED), self.json_of("run", case, *COARSE, 'time.scheme="reduced"'))

    def test_soil_that_yields_has_those_of_the_ground_before(self):
        short = [*COARSE, "time.end=0.4"]
        wanted = self.json_of("run", "fig2b-prototype.toml", *short, 'time.scheme="reduced"')
        yields = ['regions.seabed.law="hysteretic"', "regions.seabed.strain={reference_strain=5e-4}", "output.periods=true"]
        self.compare(self.json_of("run", "fig2b-prototype.toml", *short, *yields), wanted)

    def test_without_the_key_a_march_tells_how(self):
        summary = self.json_of("run", "fig2b-prototype.toml", *COARSE, MARCHED[0])
        self.assertEqual(summary["periods"], [])
        self.assertIn("output.periods = true", summary["no_periods"])

    def test_with_the_key_in_vain_it_is_not_advised(self):
        still = [*COARSE, "time.inertia=false", "mesh.parameters.sea_front=0", "mesh.parameters.sea_back=0", "output.periods=true"]
        summary = self.json_of("run", "fig2b-prototype.toml", *still)
        self.assertEqual(summary["periods"], [])
        self.assertIn("nothing swings", summary["no_periods"])
        self.assertNotIn("output.periods = true", summary["no_periods"])


if __name__ == "__main__":
    main()
