#!/usr/bin/python3
"""Sliding as a user asks for it: [sliding] in a case, by the run and by its reduced model.

usage: sliding_test.py PROGRAM CASES_FOLDER
"""

import json
import unittest

import h5py
import numpy

from program import CASES, ProgramTest, upbead

COARSE = ["--set", "mesh.parameters.cells=0.5"]
STRONG = ["--set", "loads.impulse.factor=3"]
MASS = 2100 * 0.9 * 0.8  # kg/m
RESISTANCE = 0.6 * 10740.0  # N/m


def block(time, force, resistance, parts=200):
    """Final position of a block of mass MASS: small steps of eq. (4), landward and seaward."""
    fine = numpy.interp(numpy.arange((len(time) - 1) * parts + 1) / parts, numpy.arange(len(time)), time)
    F, R = numpy.interp(fine, time, force), numpy.interp(fine, time, numpy.broadcast_to(resistance, len(time)))
    x = v = 0.0
    for i in range(len(fine) - 1):
        if v == 0.0 and abs(F[i]) <= R[i]:
            continue
        sign = numpy.sign(v) if v else numpy.sign(F[i])
        new = v + (fine[i + 1] - fine[i]) * (F[i] - sign * R[i]) / MASS
        v = 0.0 if new * sign < 0 else new
        x += (fine[i + 1] - fine[i]) * v
    return x


class Sliding(ProgramTest):
    def run_model(self, *arguments, case=CASES / "fig2b-model.toml", out="out", status=0):
        done = upbead("run", case, *COARSE, *arguments, "--out", out, cwd=self.folder)
        self.assertEqual(done.returncode, status, done.stderr)
        return json.loads((self.folder / out / "summary.json").read_text())["sliding"] if status == 0 else done

    def test_distance_is_that_of_a_block_under_the_history(self):
        found = self.run_model(*STRONG)
        with h5py.File(self.folder / "out/results.h5") as file:
            time, force = file["history/time"][:], file["history/shear_force"][:]
        self.assertGreater(found["ratio"], 1)
        self.assertAlmostEqual(found["resistance"], RESISTANCE, places=6)
        self.assertAlmostEqual(found["peak_sliding_force"], force.max(), delta=1e-3 * force.max())
        S = block(time, force, RESISTANCE)
        self.assertGreater(S, 1e-4)
        self.assertAlmostEqual(found["sliding_history"], S, delta=0.02 * S)
        self.assertAlmostEqual(found["sliding_history"], sum(slip["distance"] for slip in found["slips"]), delta=1e-12)
        self.assertIsNone(found["tau_0"])

    def test_marched_and_reduced_and_answered_agree(self):
        reduced = self.run_model(*STRONG)
        marched = self.run_model(*STRONG, "--set", "time.scheme=sdirk4", out="marched")
        S = reduced["sliding_history"]
        self.assertAlmostEqual(marched["sliding_history"], S, delta=0.01 * S)
        self.assertEqual(upbead("reduce", CASES / "fig2b-model.toml", *COARSE, "--out", "m", cwd=self.folder).returncode, 0)
        wave = (CASES / "fig2b-model-impulse.csv").read_text().splitlines()
        rows = [line.split(",") for line in wave[1:]]
        text = "\n".join([wave[0].replace(wave[0].split(",")[1], "impulse")] +
                         [f"{time},{3 * float(value)}" for time, value in rows])
        (self.folder / "wave.csv").write_text(text + "\n")
        done = upbead("respond", "m/reduced.h5", "wave.csv", "--json", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        answered = json.loads(done.stdout)["waves"][0]["sliding"]
        self.assertAlmostEqual(answered, S, delta=0.01 * S)

    def test_uplift_relieves(self):
        without = self.run_model(*STRONG)
        uplift = "sliding.uplift={kind='prescribed',peak=2000.0}"
        in_phase = self.run_model(*STRONG, "--set", uplift, "--set", "sliding.uplift.shape=in_phase")
        held = self.run_model(*STRONG, "--set", uplift)  # the default, on the safe side
        for found in (in_phase, held):
            self.assertEqual(found["uplift_courses"], {"held": held["sliding_history"],
                                                       "in_phase": in_phase["sliding_history"]})
        self.assertIsNone(without["uplift_courses"])
        # with a vertical part; otherwise the pore pressure is antisymmetric and U = 0
        pressed = ["--set", "loads.impulse.direction=[1.0, -0.5]"]
        computed = self.run_model(*STRONG, *pressed, "--set", "sliding.uplift={kind='computed'}")
        self.assertGreater(in_phase["sliding_history"], 1.02 * without["sliding_history"])
        self.assertGreater(held["sliding_history"], 1.1 * in_phase["sliding_history"])
        self.assertEqual((without["uplift"], held["uplift"], computed["uplift"]), ("none", "prescribed", "computed"))
        self.assertAlmostEqual(held["least_normal_force"], 10740.0 - 2000.0, delta=1)
        with h5py.File(self.folder / "out/results.h5") as file:
            history = file["history"]
            time, force, U = history["time"][:], history["shear_force"][:], history["uplift"][:]
        S = block(time, force, 0.6 * (10740.0 - U))
        self.assertGreater(U.max(), 200)
        self.assertGreater(abs(S / block(time, force, RESISTANCE) - 1), 0.05)
        self.assertAlmostEqual(computed["sliding_history"], S, delta=0.02 * S)

    def test_the_papers_distance_is_told_with_its_parts(self):
        found = self.run_model(*STRONG, "--set", "sliding.wave={height=0.4,depth=0.75,period=3.04,alpha_star=0.5}")
        tau_0F = (0.5 - 0.4 / 0.75 / 8) * 3.04
        self.assertAlmostEqual(found["tau_0F"], tau_0F, places=12)
        self.assertAlmostEqual(found["tau_0"], tau_0F / (0.5**0.3 + 1) ** 2, places=12)
        F, R, tau_0 = found["peak_sliding_force"], found["resistance"], found["tau_0"]
        S = tau_0**2 * (F - R) ** 3 * (F + R) / (8 * R * MASS * F * F)
        self.assertAlmostEqual(found["sliding_paper"], S, delta=1e-9 * S)
        self.assertAlmostEqual(sum(found["sliding_paper_parts"]), S, delta=1e-9 * S)
        self.assertGreater(found["sliding_exact"], S)

    def test_below_the_threshold_nothing_slides(self):
        found = self.run_model()
        self.assertEqual((found["sliding_history"], found["slips"]), (0, []))
        self.assertLess(found["ratio"], 1)
        self.assertIsNone(found["duration"]["by_exact"])

    def test_a_case_without_the_table_is_not_asked(self):
        text = (CASES / "fig2b-model.toml").read_text()
        for name in ("fig2b-model-impulse.csv", "fig2b-model-slow.csv"):
            (self.folder / name).write_text((CASES / name).read_text())
        (self.folder / "case.toml").write_text(text[:text.index("[sliding]")])
        self.assertIsNone(self.run_model(case="case.toml"))

    def test_what_does_not_fit_the_caisson_is_told_before_anything_is_solved(self):
        for key, value, message in (
                ("sliding.weight", 16000.0, "weight = 16000 N/m is not mass x g of the caisson, 14833 N/m"),
                ("sliding.submerged_weight", 15000.0, "is above the weight in air, 14833 N/m")):
            done = self.run_model("--set", f"{key}={value}", status=1)
            self.assertIn(message, done.stderr)
            self.assertIn(f"--set {key}", done.stderr)
        done = self.run_model("--set", "sliding.uplift={kind='computed'}", "--set", "regions.mound.flow=drained",
                              status=1)
        self.assertIn("no pore pressure acts on the caisson's bottom", done.stderr)
        self.assertEqual(self.left_behind(), [])


if __name__ == "__main__":
    unittest.main(argv=["sliding_test.py"])
