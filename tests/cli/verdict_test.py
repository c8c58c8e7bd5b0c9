#!/usr/bin/python3
"""What a designer signs: a verdict holds nothing that does not stand, and no warning accuses what is right.

usage: verdict_test.py PROGRAM CASES_FOLDER
"""

import math
import re

import h5py

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

    def test_what_cannot_be_and_what_never_acts_holds_nothing(self):
        """A force in kN, a friction in degrees, W' in air and a load after the end make every check hold."""
        self.assertIs(self.told("limits.sliding=0.01")["verdict"]["holds"], False)
        late = 'loads.late={ boundary = "front", kind = "force", pulse = { shape = "triangle", peak = 9e6, duration = 0.3, start = 3 } }'
        uplift = 'sliding.uplift={ kind = "prescribed", peak = %s }'
        for key, name in (("loads.push.pulse.peak=3000", "implausible"), ("sliding.friction=31", "implausible"),
                          (uplift % "800", "implausible"), ("limits.sliding=30", "implausible"),
                          ("regions.caisson.moment_of_inertia=1e12", "implausible"),
                          ("sliding.submerged_weight=5.9e6", "submerged_weight"), ("loads.push.factor=0", "load_zero"),
                          (late, "load_zero"), (uplift % "8e5, lag = 5", "load_zero"), (uplift % "8e5, lag = 1.9", "load_cut")):
            with self.subTest(key):
                verdict = self.told("limits.sliding=0.01", key)["verdict"]
                self.assertIsNone(verdict["holds"], verdict["text"])
                self.assertIn(name, verdict["why_void"])

    def test_a_weight_above_the_caisson_s_is_told_before_one_below_it(self):
        for weight, told in ((4.2e6, False), (WEIGHT, False), (4.45e6, True), (3.8e6, True)):
            found = self.told(f"sliding.submerged_weight={weight}")
            self.assertEqual("submerged_weight" in names(found), told, weight)
            self.assertEqual(found["verdict"]["holds"] is None, abs(weight / WEIGHT - 1) > 0.1)

    def test_a_run_that_stops_while_it_swings_holds_nothing(self):
        for share, void in ((0.9, True), (0.001, False)):
            told = self.told(f"time.stop_at_energy={share}", "loads.push.pulse.duration=0.05", "time.end=20")
            self.assertEqual("answer_cut" in names(told), void)
            self.assertEqual(told["verdict"]["holds"] is None, void, told["verdict"]["text"])

    def test_a_step_that_is_too_long_holds_nothing_where_a_reduced_model_was_to_answer(self):
        for step, void in ((0.3, True), (0.01, False)):
            told = self.told(f"time.step={step}")
            self.assertEqual("step_too_coarse" in names(told), void)
            self.assertEqual(told["verdict"]["holds"] is None, void, told["verdict"]["text"])

    def test_a_load_that_drops_at_once_counts_until_then(self):
        """Its static pressures, margin and arm are those of the same peak that falls more slowly."""
        pulse = 'loads.push.pulse={ shape = "triangle", peak = 1.5e6, duration = 0.4, rise = %s }'
        saw, slow = (self.told(pulse % rise) for rise in (0.4, 0.2))
        self.assertAlmostEqual(saw["response"]["arm"], slow["response"]["arm"], 9)
        for key in ("static_heel_pressure", "static_overturning_margin"):
            self.assertAlmostEqual(saw["base"][key] / slow["base"][key], 1, 6, key)

    def test_a_record_that_ends_at_its_peak_holds_nothing(self):
        rows = [(0.002 * i, 1e6 * math.sin(math.pi * max(0, 0.002 * i - 0.1) / 0.4)) for i in range(251)]
        record = 'loads.push={ boundary = "front", kind = "force", direction = [1, 0], history = "record.csv" }'
        cut = ["load_drops", "record_cut"]
        for kept, names_told, void in ((251, [], False), (151, ["record_cut"], True), (140, ["record_cut"], True), (205, ["record_cut"], True)):
            (self.folder / "record.csv").write_text("time (s),force (N/m)\n" + "".join(f"{t},{f}\n" for t, f in rows[:kept]))
            text = LUMPED[:LUMPED.index("[loads.push]")] + LUMPED[LUMPED.index("[time]"):]
            (self.folder / "case.toml").write_text(text)
            told = self.told(record)
            self.assertEqual([name for name in names(told) if name in cut], names_told, "one of them, and once")
            self.assertEqual(told["verdict"]["holds"] is None, void, told["verdict"]["text"])
        (self.folder / "record.csv").write_text("time (s),F1,F2\n0,0,0\n0.1,4e5,4e6\n0.2,0,0\n")
        self.assertIn("column_chosen", names(self.told(record)))
        self.assertIsNone(self.told(record)["verdict"]["holds"])
        self.assertNotIn("column_chosen", names(self.told(record[:-1] + ', column = "F2" }')))
        (self.folder / "record.csv").write_text("time (s),eta (m),F (kN/m)\n0,0,0\n0.1,2,400\n0.2,0,0\n")
        told = self.told(record)
        self.assertNotIn("column_chosen", names(told), "one column alone has a unit of the load")
        self.assertAlmostEqual(told["response"]["peak_force"], 4e5, 3)
        (self.folder / "record.csv").write_text("time (s),force (N/m)\n0,0\n0.1,4e5\n0.2,4e5\n")
        told = self.told(record)
        self.assertEqual([name for name in names(told) if name in cut], ["load_drops"], "corners are no record that is cut")
        self.assertIsNone(told["verdict"]["holds"])
        (self.folder / "record.csv").write_text("time (s),force (N/m)\n0,0\n0.1,4e5\n2,4e5\n")
        self.assertNotIn("load_drops", names(self.told(record)), "it goes on until the end")

    def test_peaks_of_a_summary_are_those_of_its_own_histories(self):
        told = self.told("time.step=0.05", "loads.push.pulse.duration=0.4", command="run")
        with h5py.File(self.folder / "out/results.h5") as file:
            for key, history in (("rotation", "history/caisson/rotation"), ("base_moment", "history/base_moment")):
                values = file[history][:]
                self.assertGreaterEqual(told["response"]["peak_" + key], values.max())
                self.assertGreaterEqual(abs(told["response"]["largest_" + key]), abs(values).max())

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

    def test_a_run_says_that_it_passes_over_levels(self):
        for keys, told in (((), False), (("levels={ high = 1 }",), True)):
            found = self.told(*keys)
            self.assertEqual("levels_not_used" in names(found), told)
            self.assertEqual({check["level"] for check in found["checks"] if check["by"] == "formulas"}, {"section" if told else None})

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
