#!/usr/bin/python3
"""Claims: a case whose regions have strengths goes through `respond` as one file, as the model and as the wave, and has the
same answer as by `reduce`; the circles of a wave are those of a run within what `reduce` says, and 1 %; without strengths
there are none; lives tell every way to fail, with the share beyond each limit.

usage: reduced_circles_test.py PROGRAM CASES_FOLDER
"""

import json
import pathlib

from program import ProgramTest, main, upbead

SECTION = pathlib.Path(__file__).parents[1] / "support/section.toml"
SEABED, MOUND = "strength = { friction_angle = 35, cohesion = 0 }", "strength = { friction_angle = 40, cohesion = 20e3 }"
LIFE = """
[section]
water_depth = 13.0
foundation_depth = 8.0
berm_depth = 8.0
crest = 6.0
width = {width}
berm_width = 8.0
bed_slope = 0.01
weight = {weight}
submerged_weight = {submerged}

[storms]
distribution = "weibull"
location = 2.0
scale = 1.5
shape = 1.2
steepness = 0.035

[life]
years = 20
simulated_lives = 20

[dynamics]
model = "model/reduced.h5"

[limits]
circles = 1.0
"""


class ReducedCircles(ProgramTest):
    def case(self, strong=True):
        text = SECTION.read_text().replace('[boundaries]', '[initial]\nwater_level = 6\n[boundaries]')
        text = text.replace("peak = 1e6", "peak = 2e5")
        if strong:
            text = text.replace("[regions.seabed]\n", f"[regions.seabed]\n{SEABED}\n")
            text = text.replace("[regions.mound]\n", f"[regions.mound]\n{MOUND}\n")
        path = self.folder / ("strong.toml" if strong else "plain.toml")
        path.write_text(text)
        return path

    def answer(self, command, *arguments):
        done = upbead(command, *arguments, "--json", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_one_file_is_model_and_wave(self):
        case = self.case()
        reduced = self.answer("reduce", case, "--out", "model")
        self.assertIn("reduced.h5", [path.name for path in (self.folder / "model").iterdir()])
        whole = self.answer("respond", case, "--out", "whole")["waves"]
        parts = self.answer("respond", "model/reduced.h5", case, "--out", "parts")["waves"]
        self.assertEqual(whole[0]["name"], "strong")
        self.assertEqual(whole, parts)
        run = self.answer("run", case, "--out", "run", "--set", "time.scheme=reduced")
        circle, wave = run["circles"], whole[0]
        self.assertAlmostEqual(wave["peak_shear"] / run["response"]["peak_shear"], 1, delta=1e-3)
        least = wave["circle"]["factor"] / circle["factor"] - 1
        self.assertGreater(least, -0.01)
        self.assertLess(least, reduced["circles"]["gap"] + 0.01)

    def test_there_are_none_without_strength(self):
        case = self.case(strong=False)
        self.assertNotIn("circles", self.answer("reduce", case, "--out", "model"))
        self.assertIsNone(self.answer("respond", "model/reduced.h5", case)["waves"][0]["circle"])

    def test_a_wave_of_another_case_needs_a_load_of_the_model(self):
        case = self.case()
        self.answer("reduce", case, "--out", "model")
        other = self.folder / "other.toml"
        other.write_text(case.read_text().replace("[loads.impulse]", "[loads.blow]"))
        done = upbead("respond", "model/reduced.h5", other, cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("no load of the model: impulse", done.stderr)
        done = upbead("respond", "model/reduced.h5", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("there is no wave to answer", done.stderr)

    def test_lives_tell_every_way_to_fail(self):
        import h5py
        self.answer("reduce", self.case(), "--out", "model")
        with h5py.File(self.folder / "model/reduced.h5") as file:
            mass, width = file["case"].attrs["caisson_mass"], file["circles/base"][1] - file["circles/base"][0]
        weight = mass * 9.81
        (self.folder / "life.toml").write_text(LIFE.format(width=width, weight=weight, submerged=0.55 * weight))
        lives = self.answer("expected", "life.toml")
        ways = lives["monte_carlo"]["ways"]
        self.assertEqual(ways["waves"], 20 * 20, "one storm a year")
        for key in ("circles", "sliding_factor", "overturning_margin"):
            quantiles = ways[key]["quantiles"]
            self.assertLessEqual(quantiles["0.05"], quantiles["0.5"])
        self.assertEqual(ways["circles"]["limit"], 1.0)
        names = [check["name"] for check in lives["checks"]]
        self.assertIn("slip circles, of the median life", names)
        self.assertLess(ways["lower_worse"], 0.5)
        worst = lives["monte_carlo"]["base"]["largest_eccentricity"]
        self.assertIsNotNone(worst)
        self.assertLessEqual(ways["overturning_margin"]["mean"],
                             lives["monte_carlo"]["base"]["least_overturning_margin"]["mean"] + 1e-9)
        for k in (1, 2):
            self.answer("expected", "life.toml", "--out", "parts", "--part", f"{k}/2")
        self.assertEqual(self.answer("expected", "life.toml", "--out", "parts", "--merge")["monte_carlo"],
                         lives["monte_carlo"])


if __name__ == "__main__":
    main()
