"""Draws the figures of a caisson that slips from artificial results. Usage: test_slip.py FOLDER_OF_THE_SCRIPTS"""

import csv
import json
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np
from scripts import call

SCRIPTS = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parents[2] / "postprocess"
sys.path.insert(0, str(SCRIPTS))
from upbead.errors import UserError  # noqa: E402
from upbead.slip_result import SlipResult  # noqa: E402

TIME, PLACE = np.linspace(0.0, 1.0, 101), np.linspace(-9.0, 9.0, 7)
MEASURES = ["sliding.equal_impulse.sliding_paper", "sliding.equal_impulse.sliding_exact", "sliding.sliding_history",
            "sliding.sliding_coupled", "contact.solved.slip", "contact.solved.least_slip"]


def write_run(folder, slips):
    """All nodes slip from 0.2 s to 0.4 s; the seaward one is open from 0.3 s to 0.5 s."""
    folder.mkdir()
    slip = np.clip(TIME - 0.2, 0, 0.2)[:, None] * np.linspace(0.1, 0.2, PLACE.size)
    opening = np.zeros_like(slip)
    opening[:, 0] = np.clip(0.01 - 0.1 * abs(TIME - 0.4), 0, None)
    with h5py.File(folder / "results.h5", "w") as file:
        wave = 2e6 * np.sin(3 * TIME)
        for name in ("time", "force", "shear_force", "uplift", "base_moment", "caisson/displacement_x",
                     "interface/slip"):
            file[f"history/{name}"] = TIME if name == "time" else slip.mean(axis=1) if "slip" in name else wave
        if slips:
            for name in ("time", "shear_force", "displacement_x", "slip"):
                file[f"coupled/{name}"] = TIME
            file["interface/position"], file["interface/length"] = PLACE, np.r_[1.5, np.full(5, 3.0), 1.5]
            file["interface/slip"], file["interface/opening"] = slip, opening
            file["interface/normal_force"] = np.where(opening > 0, 0.0, 6e5)
            file["interface/shear_force"] = np.full_like(slip, 1e5)
    summary = {"title": "Made-up", "sliding": {"resistance": 2.5e6, "sliding_history": 0.03},
               "contact": {"solved": {"first_slip": 0.2}}}
    summary["sliding"] |= {"equal_impulse": {"sliding_paper": 0.01}, "coupled": {"slips": [{"start": 0.21}]}}
    (folder / "summary.json").write_text(json.dumps(summary), encoding="utf-8")
    return folder


def write_study(folder, names):
    folder.mkdir()
    with open(folder / "study.csv", "w", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(["run", "sliding.ratio", *names, "status", "message"])
        rows.writerow([0, 1.0, *[0.0 for _ in names], "done", ""])
        rows.writerow([1, 1.25, *[0.01 for _ in names], "done", ""])
    return folder


class SlipFigures(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def figure(self, name, *arguments):
        path = self.folder / "figure.svg"
        done = call(SCRIPTS / name, *arguments, "-o", path)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return path.read_text(encoding="utf-8")

    def refused(self, message, name, *arguments):
        done = call(SCRIPTS / name, *arguments)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn(message, done.stderr)
        self.assertNotIn("Traceback", done.stderr)

    def test_states_of_the_nodes(self):
        result = SlipResult(write_run(self.folder / "slides", True))
        slips, is_open = result.slips(), result.is_open()
        self.assertFalse(slips[:21].any() or slips[41:].any())
        self.assertTrue(slips[21:41, 1:].all())
        np.testing.assert_array_equal(is_open[:, 0], (TIME > 0.3005) & (TIME < 0.4995))
        self.assertFalse(is_open[:, 1:].any() or (slips & is_open).any())
        np.testing.assert_allclose(result.contact()[[25, 40]], [1.0, 16.5 / 18])
        self.assertEqual(result.number("sliding.resistance"), 2.5e6)
        with self.assertRaisesRegex(UserError, "has no number sliding.tau_0"):
            result.number("sliding.tau_0")

    def test_histories_and_bottom(self):
        slides, bonded = write_run(self.folder / "slides", True), write_run(self.folder / "bonded", False)
        self.assertIn("Made-up", self.figure("slip_histories.py", slides, bonded, "--until", 0.8))
        self.assertIn("least", self.figure("slip_bottom.py", slides, "--until", 0.8))
        self.refused('interface.kind = "friction"', "slip_bottom.py", bonded)
        self.refused("there is no folder", "slip_histories.py", slides, self.folder / "none")

    def test_a_slip_as_a_whole_that_is_not_told_is_not_drawn(self):
        slides, bonded = write_run(self.folder / "slides", True), write_run(self.folder / "bonded", False)
        with h5py.File(slides / "results.h5", "r+") as file:
            del file["coupled"]
        summary = json.loads((slides / "summary.json").read_text())
        summary["sliding"] |= {"sliding_coupled": None, "coupled": None, "why_not_coupled": "it parts"}
        (slides / "summary.json").write_text(json.dumps(summary), encoding="utf-8")
        self.assertIn("Made-up", self.figure("slip_histories.py", slides, bonded))
        study = write_study(self.folder / "some", MEASURES)
        text = (study / "study.csv").read_text().replace("0.01,0.01,0.01,0.01", "0.01,0.01,0.01,")
        self.assertIn(",,", text)
        (study / "study.csv").write_text(text)
        self.assertIn("some", self.figure("slip_safety.py", study))

    def test_safety(self):
        full = write_study(self.folder / "full", MEASURES)
        self.assertIn("full", self.figure("slip_safety.py", full, full, "--scale", 1, 20))
        self.refused("--scale has 1 numbers for 2 folders", "slip_safety.py", full, full, "--scale", 1)
        self.refused("has no column contact.solved.least_slip", "slip_safety.py",
                     write_study(self.folder / "short", MEASURES[:-1]))
        self.refused("holds no results", "slip_safety.py", self.folder / "none")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
