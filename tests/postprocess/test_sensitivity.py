"""Indices of Sobol: those of a function with known ones, of soils without answers, and of a model of soils by the program,
whose script writes what the function gives.

usage: test_sensitivity.py FOLDER_OF_THE_SCRIPTS PROGRAM PROGRAM_THAT_WRITES_A_MODEL
"""

import csv
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

SCRIPTS, PROGRAM, WRITER = (Path(argument).resolve() for argument in sys.argv[1:4])
sys.path.insert(0, str(SCRIPTS))
import upbead  # noqa: E402
from upbead.soil_answer import SoilAnswer, WaveAnswer  # noqa: E402
from upbead.soil_model import Axis  # noqa: E402

G, K = "regions.sand.shear_modulus", "regions.sand.hydraulic_conductivity"


class Known:
    """y = a + 2 ln b + a (c - 2.5): of the variance 4/9, a brings 3/16 alone, b 3/4, c 3/64, and a with c 1/64."""

    box = {"a": Axis(0.0, 1.0, False), "b": Axis(1.0, np.e, True), "c": Axis(2.0, 3.0, False)}
    first, total = {"a": 3 / 16, "b": 3 / 4, "c": 3 / 64}, {"a": 13 / 64, "b": 3 / 4, "c": 4 / 64}

    def __init__(self, beyond=1.0, void_from=9.0):
        self.beyond, self.void_from = beyond, void_from  # soils with a larger a have no answer, or a void one

    def respond(self, wave, soil):
        x = {"a": 0.5, "b": np.sqrt(np.e), "c": 2.5, **soil}
        if x["a"] > self.beyond:
            raise upbead.SoilError("beyond", soil)
        numbers = {"ratio": x["a"] + 2 * np.log(x["b"]) + x["a"] * (x["c"] - 2.5), "sliding": 0.0}
        return SoilAnswer(x, 1e-4, [WaveAnswer("wave", numbers)], [], "no_rest" if x["a"] > self.void_from else None)

    def respond_all(self, wave, soils):
        found = []
        for soil in soils:
            try:
                found.append(self.respond(wave, soil))
            except upbead.SoilError as error:
                found.append(error)
        return found


class Indices(unittest.TestCase):
    def test_are_those_of_a_known_function_within_their_intervals(self):
        inside = []
        for seed in range(10):
            (of,) = upbead.sensitivity(Known(), None, ["ratio"], samples=2000, seed=seed)
            for share in of.keys:
                self.assertAlmostEqual(share.total, Known.total[share.key], delta=0.06)
                inside += [low <= exact <= high for (low, high), exact in (
                    (share.first_interval, Known.first[share.key]), (share.total_interval, Known.total[share.key]))]
        self.assertGreater(np.mean(inside), 0.85)  # of 60 intervals of 95 %, of which those of a seed hang together
        self.assertAlmostEqual(of.deviation, 2 / 3, delta=0.03)
        self.assertEqual([(round(share.at_low, 12), round(share.at_high, 12)) for share in of.keys], [(1.0, 2.0), (0.5, 2.5), (1.25, 1.75)])

    def test_what_does_not_vary_has_none(self):
        (of,) = upbead.sensitivity(Known(), None, ["sliding"], samples=50)
        self.assertEqual((of.deviation, [share.total for share in of.keys]), (0.0, [None] * 3))

    def test_rows_without_an_answer_are_left_out_and_told(self):
        (of,) = upbead.sensitivity(Known(beyond=0.99), None, ["ratio"], samples=400)
        self.assertTrue(0 < of.left_out < 100)
        self.assertEqual(of.why_left_out, "beyond")
        with self.assertRaisesRegex(upbead.UserError, "'ratio' has no value for .* of 400 rows of soils: beyond"):
            upbead.sensitivity(Known(beyond=0.8), None, ["ratio"], samples=400)

    def test_void_answers_are_told_and_drawn_so(self):
        (of,) = upbead.sensitivity(Known(void_from=0.7), None, ["ratio"], samples=50)
        self.assertRegex(of.warnings["void_soils"], "^no verdict may be drawn of [0-9]+ of 257 answers, .*: no_rest$")
        self.assertEqual(of.summary()["why_void"], "no_rest")
        words = [text.get_text() for text in upbead.figures.sensitivity([of]).texts]
        self.assertIn("VOID", words)
        (sound,) = upbead.sensitivity(Known(), None, ["ratio"], samples=50)
        self.assertEqual((sound.why_void, "void_soils" in sound.warnings), (None, False))

    def test_a_name_that_no_answer_has_is_refused_with_a_near_one(self):
        with self.assertRaisesRegex(upbead.UserError, "no number 'slidin'; did you mean 'sliding'\\? it has ratio, sliding"):
            upbead.sensitivity(Known(), None, ["slidin"], samples=50)

    def test_too_few_samples_are_refused(self):
        with self.assertRaisesRegex(upbead.UserError, "16 or more"):
            upbead.sensitivity(Known(), None, ["ratio"], samples=15)


class OfAModel(unittest.TestCase):
    def test_the_script_writes_what_the_function_gives(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            subprocess.run([WRITER, folder / "soils.h5"], check=True)
            (folder / "wave.csv").write_text("time,impact\n0,0\n0.075,1.6e6\n0.15,0\n1,0\n")
            with upbead.SoilModel(folder / "soils.h5", program=PROGRAM) as model:
                ratio, shear = upbead.sensitivity(model, folder / "wave.csv", ["ratio", lambda answer: answer.peak_shear], samples=40)
            self.assertEqual([share.key for share in ratio.keys], list(model.box))
            for a, b in zip(ratio.keys, shear.keys):  # of one wave F_T/P and F_T have the same shares
                self.assertAlmostEqual(a.total, b.total, delta=1e-9)
            done = subprocess.run(["/usr/bin/python3", "-B", SCRIPTS / "sensitivity.py", "soils.h5", "wave.csv", "--samples", "40", "--out", "found"],
                                  cwd=folder, capture_output=True, text=True, env={"UPBEAD": str(PROGRAM), "PATH": f"{PROGRAM.parent}:/usr/bin:/bin"})
            self.assertEqual(done.returncode, 0, done.stderr)
            (written,) = json.loads((folder / "found/sensitivity.json").read_text())
            self.assertEqual([written["soils"], written["left_out"]], [40 * (2 + len(ratio.keys)), 0])
            for told, share in zip(written["keys"], ratio.keys):  # the order in which soils are answered moves last digits
                for name in ("first", "total", "at_low", "at_high"):
                    self.assertAlmostEqual(told[name], getattr(share, name), delta=1e-9)
            with open(folder / "found/sensitivity.csv") as file:
                rows = list(csv.DictReader(file))
            self.assertEqual([float(row["total"]) for row in rows], [told["total"] for told in written["keys"]])
            self.assertTrue((folder / "found/sensitivity.png").stat().st_size > 10000)
            self.assertIn(G, done.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
