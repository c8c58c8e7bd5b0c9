#!/usr/bin/python3
"""Claims: a run with strengths tells its slip circles, their course and slices in results.h5, and warns of a factor below 1 and of
limits that it cannot check; strength at the peak of the wave and momentary liquefaction are computed where their limits ask for
them, become checks of run and sheet, and change no other number; mistakes have their places.

usage: circles_test.py PROGRAM CASES_FOLDER
"""

import json
import pathlib
import sys

import h5py
import numpy

from program import ProgramTest, main, upbead

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
from section_scene import SCENE  # noqa: E402

STRONG = ["--set", "initial.water_level=6", "--set", "regions.seabed.strength={ friction_angle = 35 }",
          "--set", "regions.mound.strength={ friction_angle = 40, cohesion = 20e3 }", "--set", "time.scheme='reduced'"]
WEAK = [word.replace("35", "5").replace("40, cohesion = 20e3", "10") for word in STRONG]
ASKED = ["--set", "limits.peak_safety=1", "--set", "limits.liquefaction=1"]


class Circles(ProgramTest):
    def ask(self, *arguments, command="run", out="out"):
        """(summary, stderr) of the section."""
        (self.folder / "scene.toml").write_text(SCENE)
        done = upbead(command, self.folder / "scene.toml", *arguments, "--out", self.folder / out)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((self.folder / out / "summary.json").read_text()), done.stderr

    def refused(self, *arguments):
        (self.folder / "scene.toml").write_text(SCENE)
        done = upbead("run", self.folder / "scene.toml", *arguments, "--out", self.folder / "refused")
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertFalse((self.folder / "refused").exists())
        return done.stderr

    def check(self, summary, name):
        found = [check for check in summary["checks"] if check["name"] == name]
        self.assertEqual(len(found), 1, name)
        return found[0]

    def test_course_and_slices_are_in_the_results(self):
        summary, err = self.ask(*STRONG)
        self.assertNotIn("warning: slip_circle", err)
        circles = summary["circles"]
        governs = circles[circles["by"]]
        with h5py.File(self.folder / "out/results.h5") as file:
            time, factor = file["circle/time"][:], file["circle/factor"][:]
            x, width, base, surface, pressure = (file[f"circle/{name}"][:] for name in ("x", "width", "base", "surface", "pressure"))
        at = numpy.abs(time - (governs["time"] or 0.0)).argmin()
        self.assertAlmostEqual(factor[at] / circles["factor"], 1, 9)
        self.assertAlmostEqual(numpy.nanmin(factor) / circles["factor"], 1, 2)
        self.assertAlmostEqual(width.sum() / (governs["to"] - governs["from"]), 1, 9)
        self.assertTrue((surface > base).all())
        centre = governs["centre"]
        self.assertLess(numpy.abs(numpy.hypot(x - centre[0], base - centre[1]) / governs["radius"] - 1).max(), 1e-9)
        self.assertEqual(numpy.abs(pressure).max() > 0, circles["by"] == "computed")
        self.assertGreater(circles["dynamic_load_factor"], 0)
        self.assertGreater(circles["static_design"]["factor"], 0)
        balance = self.check(summary, "slip circles")["balance"]
        self.assertAlmostEqual(balance["resisting"] / balance["acting"] / circles["factor"], 1, 9)

    def test_warnings(self):
        summary, err = self.ask(*WEAK)
        self.assertLess(summary["circles"]["factor"], 1)
        self.assertIn("warning: slip_circle: ", err)
        for limit, name in (("circles", "circles_open"),):
            summary, err = self.ask("--set", f"limits.{limit}=1", *STRONG[:2])
            self.assertIn(f"warning: {name}: ", err)
            self.assertIn(f"limits.{limit} is not checked: no region has a table strength", err)
            self.assertIsNone(self.check(summary, "slip circles")["holds"])

    def test_limits_ask_for_what_else_is_not_computed(self):
        plain, _ = self.ask(*STRONG)
        asked, err = self.ask(*STRONG, *ASKED)
        for key in ("peak_safety", "liquefaction"):
            self.assertIsNone(plain[key])
            self.assertIsNotNone(asked[key], asked[f"why_no_{key}"])
        for key in ("response", "base", "circles", "strength", "energy"):
            self.assertEqual(plain[key], asked[key], key)
        peak = asked["peak_safety"]
        self.assertLessEqual(peak["upper"] / peak["lower"], 1.006)
        self.assertEqual(self.check(asked, "strength at the peak")["holds"], peak["lower"] >= 1)
        lifted = self.check(asked, "momentary liquefaction")
        self.assertAlmostEqual(lifted["balance"]["resisting"] / lifted["balance"]["acting"] / asked["liquefaction"]["factor"], 1, 9)
        differs = peak["circle"] is not None and abs(peak["lower"] / peak["circle"] - 1) > 0.1
        self.assertEqual("warning: circles_differ: " in err, differs)
        sheet, _ = self.ask(*STRONG, *ASKED, command="sheet", out="sheet")
        modes = {row["name"]: row["mode"] for row in sheet["checks"]}
        self.assertEqual(modes["strength at the peak"], "strength of the ground")
        self.assertEqual(modes["momentary liquefaction"], "momentary liquefaction of the ground")

    def test_mistakes_have_their_places(self):
        self.assertIn("limits.peak_safety", self.refused("--set", "limits.peak_safety=1", *STRONG[:2]))
        self.assertIn("initial", self.refused("--set", "limits.liquefaction=1"))
        self.assertIn("limits.peak_safety", self.refused(*STRONG, "--set", "limits.peak_safety=-1"))


main()
