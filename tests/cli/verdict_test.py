#!/usr/bin/python3
"""What a designer signs: a verdict holds nothing that does not stand, and no warning accuses what is right.

usage: verdict_test.py PROGRAM CASES_FOLDER
"""

import re

from program import CASES, ProgramTest, main, upbead, with_keys

WIDTH, WEIGHT, FRICTION = 18.0, 4.296e6, 0.6  # m, W' (N/m)
SPRINGS = "regions.caisson.springs={{ horizontal = {}, vertical = {}, rotation = {} }}"
LUMPED = """
[mesh]
geometry = "caisson"
parameters = { caisson_width = 18, caisson_height = 16 }
[regions.caisson]
kind = "rigid"
density = 2100.0
springs = { horizontal = 2e8, vertical = 4e8, rotation = 3e10 }
dashpots = { horizontal = 4e6, vertical = 8e6, rotation = 1e9 }
[boundaries]
front = {}
back = {}
top = {}
bottom = {}
[initial]
water_level = 9.0
[loads.push]
boundary = "front"
kind = "force"
direction = [1.0, 0.0]
pulse = { shape = "triangle", peak = 3e6, duration = 0.3 }
[time]
end = 2
[sliding]
friction = 0.6
submerged_weight = 4.296e6
[limits]
sliding = 5.0
"""
STEP = 'loads.push.pulse={ shape = "step", peak = 3e6, rise = 0.05 }'
COARSE = ("mesh.parameters.cells=0.3", "mesh.parameters.sea_front=1.5", "mesh.parameters.sea_back=1.5",
          "mesh.parameters.seabed_front=60", "mesh.parameters.seabed_back=60")


def check_of(summary, name):
    return next(check for check in summary["checks"] if check["name"] == name)


def names(summary):
    return [warning["name"] for warning in summary["warnings"]]


class OfALumpedModel(ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "case.toml").write_text(LUMPED)

    def told(self, *keys, command="run"):
        return self.json_of(command, "case.toml", *keys)

    def test_a_caisson_that_comes_to_rest_has_a_distance(self):
        summary = self.told()
        self.assertTrue(summary["sliding"]["design"]["rests"])
        self.assertGreater(check_of(summary, "sliding distance")["demand"], 0)
        self.assertNotIn("slides_on", names(summary))

    def test_loads_that_stay_above_friction_slide_it_without_bound(self):
        held = 'sliding.uplift={ kind = "prescribed", peak = %g, shape = "held", distribution = "uniform" }'
        distances = []
        for keys in ((STEP,), (STEP, "time.end=4"), (held % (1.02 * WEIGHT),)):
            summary = self.told(*keys)
            check = check_of(summary, "sliding distance")
            self.assertFalse(summary["sliding"]["design"]["rests"])
            self.assertEqual((check["demand"], check["holds"]), (None, False), check["text"])
            self.assertIn("slides_on", names(summary))
            self.assertNotIn("no_coupled_slip", names(summary))
            distances.append(summary["sliding"]["design"]["value"])
        self.assertGreater(distances[1], 2 * distances[0])

    def test_loads_that_stay_below_friction_leave_a_distance(self):
        step = STEP.replace("3e6", f"{0.9 * FRICTION * WEIGHT}")
        summary = self.told(step)
        self.assertNotEqual(summary["sliding"]["design"]["value"], 0)
        self.assertTrue(summary["sliding"]["design"]["rests"])

    def test_what_fails_by_little_does_not_look_like_its_limit(self):
        S = self.told()["sliding"]["design"]["value"]
        for factor in (1 - 1e-7, 1 - 1e-4, 1 + 1e-7):
            text = check_of(self.told(f"limits.sliding={S * factor!r}"), "sliding distance")["text"]
            demand, limit, margin = re.search(r": (\S+) mm against (\S+) mm: .*margin (\S+)", text).groups()
            self.assertEqual(float(demand) > float(limit), factor < 1, text)
            self.assertEqual(float(margin) < 1, factor < 1, text)

    def test_a_run_whose_loads_are_all_switched_off_is_told(self):
        self.assertIn("load_zero", names(self.told("loads.push.factor=0")))
        self.assertNotIn("load_zero", names(self.told()))

    def test_springs_in_kilonewtons_are_told_at_any_scale(self):
        def accused(*keys):
            return [warning["text"].split(" =")[0] for warning in self.told(*keys, command="explain")["warnings"]
                    if warning["name"] == "implausible"]

        springs = [f"regions.caisson.springs.{way}" for way in ("horizontal", "vertical", "rotation")]
        self.assertEqual(accused(), [])
        self.assertEqual(accused(SPRINGS.format(2e5, 4e5, 3e7)), springs)
        self.assertEqual(accused(SPRINGS.format(2e5, 4e8, 3e10)), springs[:1])
        self.assertEqual(accused(SPRINGS.format(2e8, 4e5, 3e10)), springs[1:2])
        self.assertEqual(accused(SPRINGS.format(2e11, 4e11, 3e13)), springs)


class OfASection(ProgramTest):
    def told(self, *keys, command="run", case="design-wave/composite.toml"):
        return self.json_of(command, CASES / case, *COARSE, *keys)

    def test_a_wave_cannot_pull_by_a_factor(self):
        done = upbead("explain", CASES / "design-wave/composite.toml", *with_keys(["loads.storm.factor=-1"]))
        self.assertEqual(done.returncode, 1)
        self.assertIn("a wave pushes landward", done.stderr)

    def test_a_centroid_that_is_not_the_mesh_s_is_told(self):
        self.assertNotIn("centroid_differs", names(self.told(command="explain")))
        for key in ("section.centroid=14", "regions.caisson.centre_of_gravity=[-3, 14]"):
            self.assertIn("centroid_differs", names(self.told(key, command="explain")), key)
        # W acts 3 m seaward, buoyancy in the middle: W' acts 3 W/W' seaward
        t = 0.5 * WIDTH + 3 * 5.933088e6 / WEIGHT
        both = ("regions.caisson.centre_of_gravity=[-3, 14]", f"section.centroid={t}")
        self.assertNotIn("centroid_differs", names(self.told(*both, command="explain")))

    def test_soil_without_any_strength_fails_and_is_told(self):
        summary = self.told("regions.seabed.strength={ friction_angle = 0 }", "limits.circles=1")
        self.assertEqual(check_of(summary, "slip circles")["holds"], False)
        self.assertIsNone(summary["circles"]["dynamic_load_factor"])

    def test_a_caisson_that_tips_node_by_node_does_not_hold(self):
        push = 'loads.storm={ boundary = "front", kind = "force", pulse = { shape = "triangle", peak = 2.5e6, duration = 0.3 } }'
        text = (CASES / "design-wave/composite.toml").read_text()
        head, rest = text.split("\n[section]", 1)
        rest = rest[rest.index("[regions.seabed]"):]
        (self.folder / "tip.toml").write_text(head + rest)
        summary = self.json_of(
            "run", "tip.toml", *COARSE, push, "time.end=2", "regions.caisson.interface.kind='friction'",
            "sliding={ friction = 0.6, submerged_weight = 4.296e6 }",
            'sliding.uplift={ kind = "prescribed", peak = 5e6, shape = "held", distribution = "triangle" }',
            "limits={ overturning = 1.0, dynamic_base_pressure = 1e9 }")
        self.assertIsNone(summary["base"]["peak_heel_pressure"])
        self.assertLess(summary["base"]["least_overturning_margin"], 1)
        for name in ("heel pressure in motion", "margin against overturning"):
            self.assertEqual(check_of(summary, name)["holds"], False, name)
        self.assertIn("rocks_on_edge", names(summary))
        self.assertFalse(summary["sliding"]["design"]["rests"], "U stays above W'")


class OfADesign(ProgramTest):
    def told(self, *keys):
        return self.json_of("waves", CASES / "designer/design.toml", *keys)

    def accused(self, *keys):
        return [warning["text"] for warning in self.told(*keys)["warnings"] if warning["name"] == "implausible"]

    def test_a_force_in_kilonewtons_is_told(self):
        wave = "waves.design={{ height = 8, period = 12, force = {}, uplift = {} }}"
        self.assertEqual(self.accused(wave.format(2e6, 1e6)), [])
        told = self.accused(wave.format(2e3, 1e3))
        self.assertEqual(len(told), 2, told)
        for text, key in zip(told, ("force", "uplift")):
            self.assertIn(f"waves.design.{key} = ", text)
            self.assertIn("kN/m", text)

    def test_a_harbour_far_below_its_bed_is_told(self):
        self.assertEqual(self.accused("section.harbour_level=-4"), [])
        self.assertIn("section.harbour_level", self.accused("section.harbour_level=-400")[0])

    def test_a_limit_of_lives_without_lives_is_not_checked(self):
        def expected(*keys):
            return self.json_of("expected", CASES / "designer/design.toml", "limits.lives_beyond=0.05", *keys)

        lives = ("life={ years = 50, simulated_lives = 20 }", "limits.sliding=0.3")
        for keys, why in ((lives[:1], "limits.sliding"), (lives[1:], "[life]"), ((), "limits.sliding")):
            summary = expected(*keys)
            check = check_of(summary, "share of lives that slide farther than a limit")
            self.assertIn(why, check["why_not"])
            self.assertEqual(summary["verdict"]["unjudged"], 1)
        self.assertEqual(expected(*lives)["verdict"]["unjudged"], 0)

    def test_a_wave_that_no_sea_has_is_told(self):
        few = [w["name"] for w in self.told("waves.design.significant_height=1.5")["warnings"]]
        usual = [w["name"] for w in self.told("waves.design.significant_height=4")["warnings"]]
        self.assertIn("significant_height", few)
        self.assertNotIn("significant_height", usual)


if __name__ == "__main__":
    main()
