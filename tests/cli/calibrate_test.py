#!/usr/bin/python3
"""`upbead calibrate` as a user runs it: k(alpha*) of the caisson of Fig. 2b at two sizes.

usage: calibrate_test.py PROGRAM CASES_FOLDER
"""

import csv
import json
import os
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np

from program import CASES, ProgramTest, upbead

FIG2B = CASES / "calibration/fig2b.toml"
FEW = ["--set", "calibration.relative_height=[0.3, 0.5, 0.7]", "--set", "calibration.period=[10, 13]"]


class Calibrate(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.shared = tempfile.TemporaryDirectory()
        cls.models = []
        for name in ("model", "prototype"):
            done = upbead("reduce", CASES / f"fig2b-{name}.toml", cwd=cls.shared.name)
            assert done.returncode == 0, done.stderr
            reduced = f"{cls.shared.name}/results/fig2b-{name}/reduced.h5"
            cls.models += ["--set", f"calibration.models.{name}.model={reduced}"]

    @classmethod
    def tearDownClass(cls):
        cls.shared.cleanup()

    def calibrate(self, design, *arguments, **options):
        done = upbead("calibrate", design, *arguments, "--json", cwd=self.folder, **options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def fit(self, found, model, ratio, measure="exact"):
        return next(fit for fit in found["models"][model]["fits"]
                    if fit["ratio"] == ratio and fit["measure"] == measure)

    def test_shipped_family_at_two_sizes(self):
        found = self.calibrate(FIG2B, *self.models)
        waves = found["waves"]
        self.assertGreater(waves["taken"], 1000)
        self.assertEqual(waves["taken"] + sum(waves["left_out"].values()), waves["grid"])
        for model in ("model", "prototype"):
            for ratio in (1.05, 1.2, 1.5, 2.0):
                fit = self.fit(found, model, ratio)
                self.assertEqual(fit["points"], waves["taken"])
                self.assertFalse(fit["given_in_ellipse"], "a = 0.3, b = 2 is nowhere in the region")
                self.assertLess(fit["quality"]["deviation"], fit["given"]["deviation"])
            take, all_r = found["models"][model]["recommended"], self.fit(found, model, None)
            self.assertEqual((take["measure"], take["ratio"], take["a"], take["b"]),
                             ("exact", None, all_r["a"], all_r["b"]), "S itself, at all r")
        # The value in the table of docs/.
        self.assertAlmostEqual(self.fit(found, "prototype", 1.5)["a"], 0.395, delta=0.005)
        self.assertAlmostEqual(self.fit(found, "prototype", 1.5)["b"], 1.83, delta=0.01)
        self.assertAlmostEqual(self.fit(found, "model", 1.2)["a"], 0.367, delta=0.005)
        self.assertAlmostEqual(self.fit(found, "model", 1.2)["b"], 1.565, delta=0.01)

    def test_the_ellipse_is_that_of_the_covariance(self):
        fit = self.fit(self.calibrate(FIG2B, *self.models, *FEW), "prototype", 1.5)
        C = np.array(fit["covariance"])
        self.assertAlmostEqual(fit["standard_error"]["a"], np.sqrt(C[0, 0]))
        self.assertAlmostEqual(fit["correlation"], C[0, 1] / np.sqrt(C[0, 0] * C[1, 1]))
        values, vectors = np.linalg.eigh(C)
        ratio = fit["ellipse"]["long_axis"] / fit["ellipse"]["short_axis"]
        self.assertAlmostEqual(ratio / np.sqrt(values[1] / values[0]), 1, delta=1e-6)
        angle = fit["ellipse"]["angle"]
        self.assertAlmostEqual(abs(vectors[:, 1] @ [np.cos(angle), np.sin(angle)]), 1, delta=1e-9)

    def test_files_are_written_whole_agree_and_run_again(self):
        first = self.calibrate(FIG2B, *self.models, *FEW, "--out", "first")
        self.assertEqual(sorted(os.listdir(self.folder / "first")),
                         ["calibration.csv", "case.toml", "results.h5", "summary.json"])
        with open(self.folder / "first/calibration.csv") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 2 * 4 * first["waves"]["taken"])
        with h5py.File(self.folder / "first/results.h5") as file:
            self.assertEqual(set(file), set(rows[0]))
            for name in set(file) - {"model"}:
                np.testing.assert_array_equal(file[name][:], [float(row[name] or 0) for row in rows], name)
            self.assertEqual(file["tau_0_exact"].attrs["unit"], b"s")
            self.assertTrue(file["tau_0_exact"].attrs["description"])
            np.testing.assert_allclose(file["k_exact"][:], file["tau_0_exact"][:] / file["tau_0F"][:], rtol=1e-12)
        again = self.calibrate(self.folder / "first/case.toml", "--out", "second")
        self.assertEqual(again["models"], first["models"])

    def test_a_model_may_have_any_name(self):
        name = 'stiff, "dense" sand'
        text = FIG2B.read_text().split("[calibration.models")[0]
        text += f"[calibration.models.'{name}']\nmodel = '{self.shared.name}/results/fig2b-prototype/reduced.h5'\n"
        (self.folder / "named.toml").write_text(text)
        self.calibrate("named.toml", *FEW, "--out", "found")
        with open(self.folder / "found/calibration.csv") as file:
            self.assertEqual({row["model"] for row in csv.DictReader(file)}, {name})
        with h5py.File(self.folder / "found/results.h5") as file:
            self.assertEqual(set(file["model"][:]), {name.encode()})
        self.calibrate(self.folder / "found/case.toml", "--out", "again")

    def test_the_same_numbers_on_any_number_of_threads(self):
        one = self.calibrate(FIG2B, *self.models, *FEW,
                             preexec_fn=lambda: os.sched_setaffinity(0, [min(os.sched_getaffinity(0))]))
        self.assertEqual(one["models"], self.calibrate(FIG2B, *self.models, *FEW)["models"])

    def test_the_history_decides(self):
        few = self.calibrate(FIG2B, *self.models, *FEW)
        steep = self.calibrate(FIG2B, *self.models, *FEW, "--set", "impact.peak_gain=2")
        self.assertGreater(self.fit(steep, "model", 2.0)["b"], 1.5 * self.fit(few, "model", 2.0)["b"])

    def test_fits_that_tell_nothing_are_doubted(self):
        done = upbead("calibrate", FIG2B, *self.models, "--set", "calibration.relative_height=[0.3]", "--set",
                      "calibration.period=[10]", "--set", "calibration.relative_berm_depth=[0.4]", "--set",
                      "calibration.relative_berm_width=[0.06, 0.12]", "--json", cwd=self.folder)
        self.assertEqual(done.returncode, 0)
        fit = self.fit(json.loads(done.stdout), "model", 1.2)
        self.assertEqual((fit["doubt"], fit["a"], fit["points"]), ("too_few", None, 2))
        self.assertRegex(done.stderr, r"warning: not_identifiable: see .*\n +model prototype: \d+ of 16 fits do not tell a and b")

    def test_mistakes_leave_nothing(self):
        done = upbead("calibrate", FIG2B, *self.models, "--set", "calibration.ratios=[0.9]", "--set",
                      "calibration.models.model.scale=0", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("ratios = 0.9 is outside", done.stderr)
        self.assertIn("scale = 0 is outside", done.stderr)
        self.assertEqual(self.left_behind(), [])
        done = upbead("calibrate", CASES / "section4/hd10.toml", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("the table [calibration] is missing", done.stderr)

    def test_results_are_drawn(self):
        script = CASES.parent / "postprocess/calibration.py"
        draw = lambda *arguments: subprocess.run([sys.executable, "-B", script, *arguments], cwd=self.folder,
                                                 capture_output=True, text=True)
        self.calibrate(FIG2B, *self.models, *FEW, "--out", "found")
        for measure in ("--measure=paper", "--measure=exact", "--measure=excess", "--spectrum"):
            done = draw("found", measure, "-o", "figure.png")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertGreater((self.folder / "figure.png").stat().st_size, 10000)
        done = draw("nothing")
        self.assertEqual(done.returncode, 1)
        self.assertIn("holds no results of 'upbead calibrate'", done.stderr)

    def test_one_mass_on_a_spring_stands_for_the_ground(self):
        script = CASES.parent / "postprocess/lumped_model.py"
        reduced = f"{self.shared.name}/results/fig2b-prototype/reduced.h5"
        lump = lambda *arguments: subprocess.run([sys.executable, "-B", script, *arguments], cwd=self.folder,
                                                 capture_output=True, text=True)
        done = lump(reduced, "--load", "impulse")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"^lumped\.h5: 1\.2 Hz, 2\.\d+ % of critical damping")
        found = self.calibrate(FIG2B, *self.models, *FEW, "--out", "found", "--set",
                               f"calibration.models.lumped.model={self.folder / 'lumped.h5'}")
        self.assertIn("lumped", found["models"])
        with h5py.File(self.folder / "found/results.h5") as file:
            ratio = file["peak_shear"][:] / file["peak_force"][:]
            lumped = file["model"][:] == b"lumped"
        self.assertLess(ratio[lumped].max(), 2, "no spectrum of one mass exceeds 2 for a pulse")
        self.assertGreater(np.median(ratio[lumped]), np.median(ratio[~lumped]))
        done = lump(reduced, "--load", "wave")
        self.assertEqual(done.returncode, 1)
        self.assertIn("is no reduced model with a caisson and that load", done.stderr)

    def test_help_teaches_by_example(self):
        done = upbead("calibrate", "--help")
        self.assertEqual(done.returncode, 0)
        self.assertIn("upbead calibrate cases/calibration/fig2b.toml", done.stdout)
        self.assertIn("`[calibration.models.NAME]`", upbead("calibrate", "--keys").stdout)
        self.assertEqual(upbead("calibrate").returncode, 1)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
