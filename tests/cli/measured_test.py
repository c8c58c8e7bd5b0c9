#!/usr/bin/python3
"""Measured histories compared with computed ones, and stresses along the caisson's bottom.

usage: measured_test.py PROGRAM CASES_FOLDER
"""

import csv
import json
import sys
import unittest

import h5py
import numpy

from program import ProgramTest, upbead
from warnings_test import SCENE, WEIGHT, WIDTH, settings


class Measured(ProgramTest):
    def run_scene(self, *arguments, code=0, text=SCENE, name="out"):
        (self.folder / "scene.toml").write_text(text)
        done = upbead("run", self.folder / "scene.toml", "--json", "--out", self.folder / name, *arguments)
        self.assertEqual(done.returncode, code, done.stderr)
        return json.loads(done.stdout) if code == 0 else done.stderr

    def history(self, *names, file="out"):
        with h5py.File(self.folder / file / "results.h5") as results:
            return [results[name][:] for name in names]

    def test_a_run_against_itself_and_against_a_larger_later_one(self):
        self.run_scene(*WEIGHT)
        time, force, x = self.history("history/time", "history/shear_force", "history/caisson/displacement_x")
        rows = ["t (ms),F_T (kN/m),x_G (mm)"]
        rows += [f"{1e3 * (t + 2)!r},{f / 1e3!r},{1e3 * d!r}" for t, f, d in zip(time, force, x)]
        (self.folder / "lab.csv").write_text("\n".join(rows) + "\n")
        delay, factor = 0.02, 1.25
        rows = [f"{t + delay!r};{factor * f!r}".replace(".", ",") for t, f in zip(time, force)]
        (self.folder / "late.csv").write_text("t [s];F [N/m]\n" + "\n".join(rows) + "\n")
        summary = self.run_scene(text=SCENE + """
[measured.same]
file = "lab.csv"
reading = "shear_force"
record_start = 2.0
[measured.sway]
file = "lab.csv"
column = "x_G"
reading = "caisson/displacement_x"
record_start = 2.0
[measured.late]
file = "late.csv"
reading = "shear_force"
""")
        for name in ("same", "sway"):
            found = summary["measured"][name]
            self.assertAlmostEqual(found["peak_ratio"], 1, 9)
            self.assertLess(found["rms_relative"], 1e-9)
            self.assertAlmostEqual(found["phase"], 0, 9)
        found = summary["measured"]["late"]
        self.assertAlmostEqual(found["peak_ratio"], 1 / factor, 9)
        self.assertAlmostEqual(found["phase"], -delay, 3)
        self.assertGreater(found["rms_relative"], 0.2)
        with h5py.File(self.folder / "out/results.h5") as file:
            value = file["measured/sway/value"]
            self.assertEqual((value.attrs["unit"], value.attrs["reading"]), (b"m", b"caisson/displacement_x"))
            self.assertLess(abs(value[:] - x).max(), 1e-12 * abs(x).max())
            self.assertLess(abs(file["measured/sway/time"][:] - time).max(), 1e-12)
        again = upbead("run", self.folder / "out/case.toml", "--json", "--out", self.folder / "again")
        self.assertEqual(json.loads(again.stdout)["measured"], summary["measured"])

    def test_a_study_holds_its_runs_against_records(self):
        self.run_scene()
        time, force = self.history("history/time", "history/shear_force")
        rows = [f"{t!r},{f!r}" for t, f in zip(time, force)]
        (self.folder / "lab.csv").write_text("t (s),F (N/m)\n" + "\n".join(rows) + "\n")
        (self.folder / "scene.toml").write_text(SCENE + '[measured.lab]\nfile = "lab.csv"\nreading = "shear_force"\n')
        (self.folder / "study.toml").write_text(
            'case = "scene.toml"\nread = ["measured.lab.peak_ratio"]\n[vary."loads.impulse.factor"]\nvalues = [1, 2]\n')
        done = upbead("study", self.folder / "study.toml", "--out", self.folder / "study")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.folder / "study/study.csv", newline="") as file:
            ratios = [float(row["measured.lab.peak_ratio"]) for row in csv.DictReader(file)]
        self.assertAlmostEqual(ratios[0], 1, 9)
        self.assertAlmostEqual(ratios[1], 2, 6)

    def test_a_record_a_thousand_times_smaller_has_another_unit(self):
        self.run_scene()
        time, force = self.history("history/time", "history/shear_force")
        record = SCENE + '[measured.lab]\nfile = "lab.csv"\nreading = "shear_force"\n'
        for unit, told in (("", True), (" (kN/m)", False)):
            (self.folder / "lab.csv").write_text(f"t (s),F_T{unit}\n" + "".join(f"{t!r},{f / 1e3!r}\n" for t, f in zip(time, force)))
            warnings = [w["text"] for w in self.run_scene(text=record)["warnings"] if w["name"] == "implausible"]
            self.assertEqual(any("the peak of shear_force is 1000 times the measured one" in text for text in warnings), told, warnings)

    def test_mistakes_are_told_before_anything_is_solved(self):
        (self.folder / "lab.csv").write_text("t (s),F (m)\n0,1\n1,2\n")
        told = self.run_scene(code=1, text=SCENE + """
[measured.a]
file = "lab.csv"
reading = "sheer_force"
[measured.b]
file = "lab.csv"
reading = "shear_force"
[measured.c]
file = "lab.csv"
column = "G"
reading = "force"
[measured.d]
file = "none.csv"
reading = "force"
""")
        for text in ("no history 'sheer_force'; did you mean 'shear_force'?", "the unit 'm' of column 'F'",
                     "has no column 'G'", "cannot read"):
            self.assertIn(text, told)
        self.assertFalse((self.folder / "out").exists())
        (self.folder / "lab.csv").write_text("t (s),F (N/m)\n10,1\n11,2\n")
        told = self.run_scene(code=1, text=SCENE + '[measured.b]\nfile = "lab.csv"\nreading = "force"\n')
        self.assertIn("no time in common", told)

    def test_what_stands_on_the_ground(self):
        self.run_scene(*WEIGHT, *settings(loads__impulse__factor=3))
        names = ["effective_normal_force", "effective_base_moment", "eccentricity", "toe_pressure", "heel_pressure",
                 "normal_force", "uplift", "base_moment", "uplift_moment"]
        N, M, e, toe, heel, dN, U, dM, M_U = self.history(*(f"history/{name}" for name in names))
        self.assertLess(abs(N - (4.3e6 + dN - U)).max(), 1e-9 * 4.3e6)
        self.assertLess(abs(M - (dM + M_U)).max(), 1e-6 * abs(dM).max())
        self.assertLess(abs(e * N - M).max(), 1e-9 * abs(M).max())
        whole = abs(e) <= WIDTH / 6
        self.assertTrue(whole.any() and not whole.all())
        self.assertLess(abs(0.5 * (toe + heel) * WIDTH - N)[whole].max(), 1e-6 * 4.3e6)
        self.assertTrue((numpy.minimum(toe, heel)[~whole] == 0).all())
        self.run_scene()
        # without [sliding] and a water level no weight is known
        with h5py.File(self.folder / "out/results.h5") as file:
            self.assertNotIn("eccentricity", file["history"])

    def test_stress_along_the_bottom_adds_up_to_its_forces(self):
        """Consistent nodal forces: their sums are the forces and the moment on any cells; also with friction and
        opening at the bottom."""
        for more in ([], settings(regions__caisson__interface="{ kind = \"friction\", coefficient = 0.6 }", loads__impulse__factor=3)):
            summary = self.run_scene(*WEIGHT, *settings(time__scheme="sdirk4", time__step=0.01, output__base="true"), *more)
            x, length, shear, normal, pore, F_T, N, U, M = self.history(
                "base/position", "base/length", "base/shear_stress", "base/normal_stress", "base/pore_pressure",
                "history/shear_force", "history/normal_force", "history/uplift", "history/base_moment")
            self.assertEqual(shear.shape, (len(F_T), len(x)))
            self.assertTrue((numpy.diff(x) > 0).all())
            self.assertAlmostEqual(length.sum(), WIDTH, 9)
            for total, force in ((shear @ length, F_T), (pore @ length, U), ((normal + pore) @ length, N)):
                self.assertLess(abs(total - force).max(), 1e-10 * abs(F_T).max())
            self.assertLess(abs((normal + pore) @ (length * x) - M).max(), 1e-10 * abs(M).max())
            ux, rotation, uy = self.history("base/displacement_x", "history/caisson/rotation", "base/displacement_y")
            if not more:  # bonded: the ground moves with the caisson's bottom
                self.assertLess(abs(ux - ux[:, :1]).max(), 1e-9 * abs(ux).max())
                self.assertLess(abs(uy[:, 0] - uy[:, -1] - rotation * WIDTH).max(), 1e-9 * abs(uy).max())
            else:
                self.assertGreater(abs(ux - ux[:, :1]).max(), 0.01 * abs(ux).max())
                opened, = self.history("history/interface/opened_width")
                self.assertEqual(opened.shape, F_T.shape)
                self.assertAlmostEqual(opened.max(), (1 - summary["contact"]["solved"]["least_contact"]) * WIDTH, 9)

    def test_reduced_and_marched_stress_agree(self):
        self.run_scene("--set", "output.base=true", name="reduced")
        time, stress = self.history("history/time", "base/normal_stress", file="reduced")
        self.run_scene(*settings(time__scheme="sdirk4", time__step=0.003, output__base="true"), name="marched")
        fine, marched = self.history("history/time", "base/normal_stress", file="marched")
        place = stress.shape[1] // 4
        self.assertLess(abs(numpy.interp(time, fine, marched[:, place]) - stress[:, place]).max(),
                        0.02 * abs(marched[:, place]).max())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
