"""Draws the figures of `upbead waves` from the program's output.

usage: test_waves.py FOLDER_OF_THE_SCRIPTS PROGRAM CASES_FOLDER
"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from scripts import call

SCRIPTS, PROGRAM, CASES = (Path(argument).resolve() for argument in sys.argv[1:4])
sys.path.insert(0, str(Path(__file__).parents[1] / "support"))
from thinned_waves import thinned  # noqa: E402


def figure(script, *arguments):
    return call(SCRIPTS / script, *arguments)


class WaveFigures(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def waves(self, case, *arguments):
        out = self.folder / Path(case).stem
        subprocess.run([PROGRAM, "waves", CASES / case, "--out", out, *arguments], check=True, capture_output=True)
        return out

    def check_png(self, done, name):
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual((self.folder / name).read_bytes()[:4], b"\x89PNG")

    def check_refused(self, done, message):
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn(message, done.stderr)
        self.assertNotIn("Traceback", done.stderr)

    def test_sliding_against_safety(self):
        curves = [self.waves(thinned(CASES / f"fig10/{name}.toml", self.folder, 4)) for name in ("impulsive", "non_breaking")]
        for formula in ("paper", "exact", "combined"):
            done = figure("sliding_safety.py", *curves, "--formula", formula, "-o", self.folder / "s.png")
            self.check_png(done, "s.png")
        self.check_refused(figure("sliding_safety.py", *curves, "--range", 1.2, 1.4), "slides the caisson")
        self.check_refused(figure("sliding_safety.py", *curves, "--range", 1.0, 0.6), "must be the smaller one")
        self.check_refused(figure("sliding_safety.py", self.folder / "none"), "cannot read")

    def test_pressure_over_height(self):
        one = self.waves("fig7-9/impulsive.toml")
        two = self.waves("fig7-9/non_breaking.toml")
        gauges = self.folder / "gauges.csv"
        gauges.write_text("height,pressure\n-8,80e3\n2,90e3\n")
        self.check_png(figure("wave_pressure.py", one, two, "-o", self.folder / "p.png"), "p.png")
        done = figure("wave_pressure.py", one / "summary.json", "--measured", gauges, "-o", self.folder / "m.png")
        self.check_png(done, "m.png")
        self.check_refused(figure("wave_pressure.py", one, two, "--measured", gauges), "give as many")
        self.check_refused(figure("wave_pressure.py", one, "--wave", "other"), "there is no wave 'other'")
        gauges.write_text("height,pressure\n-8,eighty\n")
        self.check_refused(figure("wave_pressure.py", one, "--measured", gauges), "expected a header line")
        self.check_refused(figure("wave_pressure.py", self.waves(thinned(CASES / "fig10/impulsive.toml", self.folder, 4))), "choose one with --wave")
        (self.folder / "other.json").write_text("{}")
        self.check_refused(figure("wave_pressure.py", self.folder / "other.json"), "holds no waves")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
