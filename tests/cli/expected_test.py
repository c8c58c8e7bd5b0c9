#!/usr/bin/python3
"""`upbead expected` as a user runs it: section 4 of the paper, lives, the law dynamic.

usage: expected_test.py PROGRAM CASES_FOLDER
"""

import json
import os
import pathlib
import signal
import subprocess
import sys
import unittest

import h5py
import numpy as np

from program import CASES, PROGRAM, ProgramTest, on_a_terminal, upbead, wait_until_it_catches

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
from hand_made_model import write_oscillator  # noqa: E402

HD12, HD10 = CASES / "section4/hd12.toml", CASES / "section4/hd10.toml"
PROTOTYPE = CASES / "expected/prototype.toml"
LIFE = ["--set", "life.simulated_lives=300", "--set", "scatter.force.cov=0.1", "--set", "scatter.friction.cov=0.1"]


class Expected(ProgramTest):
    def expected(self, design, *arguments, **options):
        done = upbead("expected", design, *arguments, "--json", cwd=self.folder, **options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_section_4_of_the_paper(self):
        """Published: 3.7 and 36.3 waves, 0.6 cm for H_D = 12.1 m and 45 cm for H_D = 10.5 m."""
        high, low = self.expected(HD12), self.expected(HD10)
        for found in (high, low):
            self.assertAlmostEqual(found["exceedance"]["HD_12"]["waves"], 3.7, delta=0.02 * 3.7)
            self.assertAlmostEqual(found["exceedance"]["HD_10"]["waves"], 36.3, delta=0.02 * 36.3)
            self.assertAlmostEqual(found["expected"]["waves"], 32.7e6, delta=1)
        self.assertAlmostEqual(low["expected"]["distance_paper"], 0.45, delta=0.15 * 0.45)
        self.assertTrue(0.006 / 5 < high["expected"]["distance_paper"] < 0.006 * 5)
        self.assertAlmostEqual(high["expected"]["threshold_height"]["paper"], 12.1, delta=1e-4)
        self.assertAlmostEqual(low["expected"]["threshold_height"]["paper"], 10.5, delta=1e-4)

    def test_section_4_slides_72_cm_in_the_highest_wave(self):
        done = upbead("waves", HD12, "--json", cwd=self.folder)
        self.assertAlmostEqual(json.loads(done.stdout)["waves"]["highest"]["sliding_paper"], 0.72, delta=1e-4)

    def test_a_margin_of_equilibrium_alone_is_told(self):
        for weight, told in ((4.8e6, True), (5.4e6, False)):
            own = ["--set", f"section.submerged_weight={weight}", "--set", f"section.weight={weight + 3.5e6}"]
            for limit, by_practice in (([], False), (["--set", "limits.overturning=1.05"], True)):
                found = self.expected(HD10, *own, *limit)
                margin = next(check for check in found["checks"] if check["name"] == "overturning, highest wave")
                self.assertTrue(margin["holds"])
                below = [w["value"] for w in found["warnings"] if w["name"] == "factor_below_practice"]
                self.assertEqual(below, [margin["demand"]] if told and not by_practice else [], (weight, limit))

    def test_low_seas_bring_nothing(self):
        states = self.expected(HD10)["expected"]["states"]
        self.assertLess(states[1]["distance"]["exact"], 1e-40)
        self.assertGreater(states[0]["distance"]["exact"], 0)

    def test_a_significant_height_above_the_depth_is_told(self):
        text = HD10.read_text()
        name = text.split('states = "')[1].split('"')[0]
        (self.folder / "sea.toml").write_text(text.replace(name, "states.csv"))
        for height, told in ((23.0, True), (21.0, False)):  # in 22 m of water
            (self.folder / "states.csv").write_text(f"significant_height (m),period (s),waves\n1,8,10\n{height},20,6\n")
            done = upbead("expected", self.folder / "sea.toml", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            warning = "height_above_depth: look at significant_height and water_depth\n         1 of 2 sea states have an H_1/3 above the depth, the first, row 2, 23 m in 22 m"
            self.assertEqual(warning in done.stderr, told, done.stderr)
            found = self.expected(self.folder / "sea.toml", "--set", "limits.sliding=1e3")["verdict"]
            self.assertEqual("height_above_depth" in (found["why_void"] or ""), told, found)

    def test_soil_of_another_wave_voids_the_verdict(self):
        """Lives have waves of all sizes, and the model the stiffness that one has left."""
        model = self.folder / "model.h5"
        own = ["--set", f"dynamics.model={model}", "--set", "dynamics.load=impact", "--set", "life.simulated_lives=5", "--set", "limits.sliding=1e3"]
        for table, void in (("", False), ("[regions.seabed.strain]\n", True)):
            write_oscillator(model, mass=5.933088e6 / 9.81)
            with h5py.File(model, "r+") as file:
                attributes = dict(file["case"].attrs)
                del file["case"]
                file["case"] = 'title = "oscillator"\n' + table
                file["case"].attrs.update(attributes)
            verdict = self.expected(PROTOTYPE, *own)["verdict"]
            self.assertEqual("soil_of_other_wave" in (verdict["why_void"] or ""), void, verdict)
            if void:
                self.assertIsNone(verdict["holds"])

    def test_a_table_that_nothing_uses_is_told(self):
        for settings, told in (([], False), (["--set", 'impact.force="proverbs"'], True)):
            done = upbead("expected", HD10, *settings, "--json", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual("table_not_used" in [w["name"] for w in json.loads(done.stdout)["warnings"]], told)

    def test_a_model_of_another_section_voids_the_verdict(self):
        model = self.folder / "other.h5"
        own = ["--set", f"dynamics.model={model}", "--set", "dynamics.load=impact", "--set", "life.simulated_lives=5", "--set", "limits.sliding=1e3"]
        sea = '[mesh]\ngeometry = "composite"\nparameters = { mound_height = %s, sea_front = 6.0, water_depth = 15.0 }\n'
        for table, void in (("", False), ("[section]\nwater_depth = 15.0\nfoundation_depth = 9.0\n", False),
                            ("[section]\nwater_depth = 12.0\nfoundation_depth = 9.0\n", True), (sea % "6.0", False),
                            (sea % "5.0", True), ("[fluid]\ndensity = 1000.0\n", True)):
            write_oscillator(model, mass=5.933088e6 / 9.81)
            with h5py.File(model, "r+") as file:
                attributes = dict(file["case"].attrs)
                del file["case"]
                file["case"] = 'title = "oscillator"\n' + table
                file["case"].attrs.update(attributes)
            verdict = self.expected(PROTOTYPE, *own)["verdict"]
            self.assertEqual("model_of_other_section" in (verdict["why_void"] or ""), void, table)

    def test_without_a_model_nothing_is_dynamic(self):
        found = self.expected(HD10)
        self.assertIsNone(found["expected"]["distance_dynamic"])
        self.assertIsNone(found["model"])
        self.assertIsNone(found["monte_carlo"])

    def test_lives_have_the_mean_of_quadrature(self):
        found = self.expected(HD10, "--set", "life.years=9", "--set", "life.simulated_lives=2000")
        life = found["monte_carlo"]
        self.assertEqual(life["law"], "exact")
        self.assertAlmostEqual(life["without_scatter"], found["expected"]["distance_exact"])
        self.assertLess(abs(life["mean"] - life["without_scatter"]), 3 * life["standard_error"])
        low, high = life["confidence_interval"]
        self.assertTrue(low < life["mean"] < high)

    def test_the_same_seed_gives_the_same_answer_on_any_number_of_threads(self):
        one = self.expected(HD10, *LIFE, preexec_fn=lambda: os.sched_setaffinity(0, [min(os.sched_getaffinity(0))]))
        all_cores = self.expected(HD10, *LIFE)
        self.assertEqual(one["monte_carlo"], all_cores["monte_carlo"])
        self.assertEqual(one["expected"], all_cores["expected"])
        other = self.expected(HD10, *LIFE, "--set", "life.seed=2")
        self.assertNotEqual(one["monte_carlo"]["mean"], other["monte_carlo"]["mean"])

    def test_files_are_written_whole_and_run_again(self):
        first = self.expected(HD10, *LIFE, "--out", "first")
        self.assertEqual(sorted(os.listdir(self.folder / "first")), ["case.toml", "results.h5", "summary.json"])
        again = self.expected(self.folder / "first/case.toml", "--out", "second")
        self.assertEqual(again["monte_carlo"], first["monte_carlo"])
        with h5py.File(self.folder / "first/results.h5") as file:
            lives = file["lives/sliding"][:]
            self.assertAlmostEqual(lives.mean(), first["monte_carlo"]["mean"])
            height = file["heights/height"][:]
            share = np.trapz(file["heights/contribution/exact"][:], height)
            self.assertAlmostEqual(share / first["expected"]["states"][0]["distance"]["exact"], 1, delta=0.01)
            self.assertEqual(file["lives/sliding"].attrs["unit"], b"m")

    def test_few_lives_that_slide_are_doubted(self):
        done = upbead("expected", HD12, "--set", "life.simulated_lives=5", cwd=self.folder)
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stderr, r"warning: few_lives: simulate more .*\n +only \d of 5 lives slide by the law exact: ")

    def test_a_doubtful_section_is_told_as_by_waves(self):
        for change, name in ((None, None), ("section.submerged_weight=7.2e6", "buoyancy"), ("section.berm_depth=30", "berm_below_bed")):
            done = upbead("expected", HD12, "--set", "life.simulated_lives=5", *(["--set", change] if change else []), cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            told = [one for one in ("buoyancy", "berm_below_bed", "bed_slope") if f"warning: {one}: " in done.stderr]
            self.assertEqual(told, [name] if name else [])

    def test_own_dynamics_are_the_default_where_a_model_is_given(self):
        write_oscillator(self.folder / "model.h5", mass=5.933088e6 / 9.81)
        model = ["--set", f"dynamics.model={self.folder / 'model.h5'}", "--set", "dynamics.load=impact"]
        found = self.expected(PROTOTYPE, *model, "--set", "life.simulated_lives=20", "--set", "life.years=1")
        self.assertEqual(found["monte_carlo"]["law"], "dynamic")
        self.assertGreater(found["expected"]["distance_dynamic"], 0)
        self.assertEqual(found["model"]["load"], "impact")
        self.assert_headlines(found)
        # where own dynamics bring less, the formulas are the headline: one of the two alone was told
        mild = self.expected(PROTOTYPE, *model, "--set", "life.simulated_lives=20", "--set", "impact.peak_gain=0")
        self.assertLess(mild["expected"]["distance_dynamic"], mild["expected"]["distance_exact"])
        self.assert_headlines(mild)
        self.assertNotEqual(mild["expected"]["headline"]["law"], "dynamic")
        self.assertIn("impact_below_goda", [warning["name"] for warning in mild["warnings"]])
        self.assertNotIn("impact_below_goda", [warning["name"] for warning in found["warnings"]])
        self.assertIsNone(found["monte_carlo"]["base"])
        self.assertIn("no readings of the normal force", found["monte_carlo"]["why_no_base"])
        self.assertIn("no readings of the normal force", found["expected"]["base"]["why_not_dynamic"])

    def assert_headlines(self, found):
        """The larger of the routes, and the same lives by formulas beside those by own dynamics."""
        life, record = found["monte_carlo"], found["expected"]
        self.assertEqual(record["headline"]["value"], max(record[f"distance_{law}"] for law in ("paper", "exact", "combined", "dynamic")))
        self.assertEqual(life["by_formulas"]["law"], "exact")
        self.assertEqual(life["headline"]["value"], max(life["mean"], life["by_formulas"]["mean"]))
        self.assertEqual(life["by_formulas"]["waves"], life["waves"], "the same lives")

    def test_waves_of_own_dynamics_break(self):
        write_oscillator(self.folder / "model.h5", mass=5.933088e6 / 9.81)
        model = ["--set", f"dynamics.model={self.folder / 'model.h5'}", "--set", "dynamics.load=impact"]
        found = self.expected(PROTOTYPE, *model, "--set", "life.simulated_lives=100", "--set", "impact.peak_gain=2",
                              "--set", "sea.highest=breaking")
        life = found["monte_carlo"]
        self.assertEqual(life["law"], "dynamic")
        self.assertGreater(found["expected"]["distance_limited"]["dynamic"], 0)
        self.assertLess(abs(life["mean"] - life["without_scatter"]), 3 * life["standard_error"])
        highest = max(state["highest"] for state in found["expected"]["states"])
        self.assertAlmostEqual(life["highest"], highest, delta=1e-12)

    def test_goda_with_alpha_I_does_not_go_through_the_dynamics(self):
        write_oscillator(self.folder / "model.h5", mass=5.933088e6 / 9.81)
        done = upbead("expected", PROTOTYPE, "--set", f"dynamics.model={self.folder / 'model.h5'}", "--set",
                      "dynamics.load=impact", "--set", "impact.force=goda_with_alpha_I", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("would count twice", done.stderr)
        self.assertEqual(self.left_behind(), ["model.h5"])

    def test_shipped_prototype_runs_with_its_model(self):
        done = upbead("reduce", CASES / "fig2b-prototype.toml", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        model = self.folder / "results/fig2b-prototype/reduced.h5"
        found = self.expected(PROTOTYPE, "--set", f"dynamics.model={model}")
        self.assertGreater(found["expected"]["distance_dynamic"], found["expected"]["distance_paper"])
        base = found["expected"]["base"]
        self.assertGreater(base["dynamic"]["peak_heel_pressure"], base["goda"]["peak_heel_pressure"])

    def test_mistakes_leave_nothing(self):
        done = upbead("expected", HD10, "--set", "sea.years=0", "--set", "life.simulated_lives=1", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("years", done.stderr)
        self.assertIn("lives", done.stderr)
        self.assertEqual(self.left_behind(), [])

    def test_interrupted_lives_leave_nothing(self):
        long = ["--set", "life.simulated_lives=10000000", "--set", "scatter.period.cov=0.1"]
        process = subprocess.Popen([PROGRAM, "expected", HD10, *long],
                                   cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        wait_until_it_catches(signal.SIGINT, process)
        with self.assertRaises(subprocess.TimeoutExpired):
            process.wait(1)
        process.send_signal(signal.SIGINT)
        errors = process.communicate()[1]
        self.assertEqual(process.returncode, 130, errors)
        self.assertEqual(self.left_behind(), [])

    def test_progress_is_shown_on_a_terminal(self):
        code, text = on_a_terminal("expected", HD10, *LIFE, "--set", "life.simulated_lives=50000", cwd=self.folder)
        self.assertEqual(code, 0)
        self.assertIn(b"simulating lives", text)

    def test_storms_are_drawn_without_a_record(self):
        text = HD10.read_text()
        (self.folder / "storms.toml").write_text(
            text[:text.index("[sea]")] + "[storms]\nlocation = 3\nscale = 1.5\nshape = 1.4\nsteepness = 0.03\n"
            "tide_high = 1\n[life]\nlives = 300\nyears = 50\n")
        found = self.expected("storms.toml")
        self.assertIsNone(found["expected"])
        self.assertIsNone(found["monte_carlo"]["without_scatter"])
        self.assertGreater(found["monte_carlo"]["mean"], 0)
        higher = self.expected("storms.toml", "--set", "storms.location=4")
        self.assertGreater(higher["monte_carlo"]["mean"], found["monte_carlo"]["mean"])

    def write_surf_zone(self, states="7.95,12,3000\n5,10,20000"):
        """A caisson in 12 m of water, where the record's waves of 7.95 m break."""
        section = {"water_depth": 12, "foundation_depth": 7, "berm_depth": 6.5, "crest": 6, "width": 20, "berm_width": 8,
                   "bed_slope": 0.02, "weight": 5.0e6, "submerged_weight": 3.585e6}
        (self.folder / "surf.toml").write_text(
            'title = "surf zone"\n[section]\n' + "".join(f"{key} = {value}\n" for key, value in section.items()) +
            '[sea]\nstates = "states.csv"\nyears = 50\n[life]\nsimulated_lives = 2000\nyears = 50\n')
        (self.folder / "states.csv").write_text("significant_height,period,waves\n" + states + "\n")

    def test_drawn_waves_break_where_waves_breaks_them(self):
        self.write_surf_zone()
        found = self.expected("surf.toml")
        high, low = found["expected"]["states"]
        self.assertAlmostEqual(high["highest"], 10.9, delta=0.05)
        for state in (high, low):
            (self.folder / "wave.toml").write_text(
                (self.folder / "surf.toml").read_text().split("[sea]")[0] +
                f"[waves.same]\ndeep_water_height = {state['deep_water_height']!r}\nperiod = {state['period']!r}\n")
            done = upbead("waves", "wave.toml", "--json", cwd=self.folder)
            wave = json.loads(done.stdout)["waves"]["same"]
            self.assertAlmostEqual(wave["significant_height"], state["significant_height"], delta=1e-12)
            if state is high:
                self.assertAlmostEqual(wave["height"], state["highest"], delta=1e-12)
                self.assertAlmostEqual(wave["height"], found["monte_carlo"]["highest"], delta=1e-12)
                self.assertAlmostEqual(wave["height"], found["expected"]["highest"], delta=1e-12)
        share = np.exp(-2 * (high["highest"] / 7.95) ** 2)
        self.assertAlmostEqual(high["share_limited"], share, delta=1e-12)
        limited = 3000 * share + 20000 * np.exp(-2 * (low["highest"] / 5) ** 2)
        self.assertAlmostEqual(found["expected"]["waves_limited"], limited, delta=1e-9)
        self.assertAlmostEqual(found["monte_carlo"]["waves_limited"] / 2000, limited, delta=0.01 * limited)
        life = found["monte_carlo"]
        self.assertLess(abs(life["mean"] - life["without_scatter"]), 3 * life["standard_error"])
        self.assertEqual([found["expected"]["limit"], life["limit"]], ["breaking", "breaking"])
        told = upbead("expected", "surf.toml", cwd=self.folder)
        self.assertRegex(told.stdout, r"  highest +10\.86 m +the height that one wave exceeds, or the limit\n  limit +breaking\n  share_limited +0\.00\d+ ")
        told = upbead("expected", "surf.toml", "--details", cwd=self.folder)
        self.assertRegex(told.stdout, r"  waves_limited +85\.14 ")
        self.assertRegex(told.stdout, r",\s+highest 9\.568 m")

    def test_waves_that_all_break_press_as_the_breaker_does(self):
        """1,000 waves of H_1/3 = 50 m that all break to one height: every life has the heel pressure of that
        height."""
        self.write_surf_zone("50,12,1000")
        limits = ["--set", "limits.base_pressure=300e3", "--set", "limits.overturning=1.2", "--set", "limits.sliding=2.5"]
        found = self.expected("surf.toml", *limits, "--set", "life.simulated_lives=20", "--out", "out")
        height = found["expected"]["states"][0]["highest"]
        done = upbead("waves", "surf.toml", "--set", f"waves.same.height={height!r}", "--set", "waves.same.period=12.0",
                      "--set", "waves.same.significant_height=50.0", "--json", cwd=self.folder)
        wave = json.loads(done.stdout)["waves"]["same"]
        self.assertGreater(wave["heel_pressure"], 300e3)
        heel = found["monte_carlo"]["base"]["peak_heel_pressure"]
        for value in (heel["mean"], *heel["quantiles"].values(), found["expected"]["base"]["goda"]["peak_heel_pressure"]):
            self.assertAlmostEqual(value / wave["heel_pressure"], 1, delta=1e-9)
        self.assertEqual([heel["limit"], heel["probability"], heel["confidence_interval"][1]], [300e3, 1, 1])
        margin = found["monte_carlo"]["base"]["least_overturning_margin"]
        self.assertAlmostEqual(margin["quantiles"]["0.5"] / wave["safety_overturning"], 1, delta=1e-9)
        self.assertEqual(margin["probability"], float(wave["safety_overturning"] < 1.2))
        self.assertEqual(list(found["monte_carlo"]["probability"]), ["0.1", "0.3", "1", "2.5"])
        with h5py.File(self.folder / "out/results.h5") as file:
            np.testing.assert_allclose(file["lives/heel_pressure"][:], wave["heel_pressure"], rtol=1e-9)
            self.assertTrue((np.diff(file["heights/heel_pressure"][:]) >= 0).all())
        told = upbead("expected", "surf.toml", *limits, cwd=self.folder).stdout
        self.assertRegex(told, r"peak_heel_pressure\n +mean +\d+\.?\d* kPa .*\n +quantiles\n(.*\n)+ +limit +300 kPa .*\n +probability +1 ")
        checks = {check["name"]: check for check in found["checks"]}
        for name in ("heel pressure p_e, highest wave", "heel pressure p_e, of the median life"):
            self.assertEqual((checks[name]["holds"], checks[name]["by"]), (False, "formulas"))
            self.assertIn(checks[name]["text"], told)
        self.assertFalse(found["verdict"]["holds"])
        self.assertIn("100 % of the lives have a heel pressure above 300 kPa",
                      " ".join(warning["text"] for warning in found["warnings"] if warning["name"] == "lives_beyond_limit"))

    def test_the_figure_says_that_nothing_slides(self):
        sys.path.insert(0, str(CASES.parent / "postprocess"))
        from upbead import expected_result, figures
        self.expected(CASES / "designer/design.toml", "--out", "calm")
        self.expected(HD10, "--out", "moving")
        for folder, words in (("calm", ["Nothing slides: no wave is high enough."]), ("moving", [])):
            axes = figures.expected([expected_result.ExpectedResult(self.folder / folder)]).axes
            self.assertEqual([text.get_text() for text in axes[1].texts if "slides" in text.get_text()], words)
            self.assertEqual(len(axes), 2 if words else 3)
            self.assertTrue(all(panel.lines or panel.patches for panel in axes), "no empty panel")

    def test_a_resultant_beside_the_base_is_told(self):
        self.write_surf_zone("50,12,1000")
        light = ["--set", "section.weight=2.6e6", "--set", "section.submerged_weight=1.19e6"]
        found = self.expected("surf.toml", *light, "--set", "life.simulated_lives=20")
        for base in (found["expected"]["base"]["goda"], found["monte_carlo"]["base"]):
            heel = base["peak_heel_pressure"]
            self.assertIsNone(heel["mean"] if isinstance(heel, dict) else heel)
        self.assertIn("none where the resultant leaves the base", upbead("expected", "surf.toml", *light, cwd=self.folder).stdout)

    def test_limits_by_hand_and_none(self):
        """Without breaking, the numbers are those of the version before breaking was added."""
        self.write_surf_zone()
        for limit, exact in (("1.8", 4.091082806070966), ("1.4", 0.02936711990564604), ("none", 6.8122584857918485)):
            done = upbead("expected", "surf.toml", "--set", f"sea.highest={limit}", "--json", cwd=self.folder)
            found = json.loads(done.stdout)
            self.assertAlmostEqual(found["expected"]["distance_exact"] / exact, 1, delta=1e-9)
            self.assertEqual(found["expected"]["limit"], "none" if limit == "none" else "cut")
            self.assertRegex(done.stderr, r"warning: waves_unbroken: write sea.*\n +[\d.]+ of \S+ waves .* higher than Goda's highest breaker")
        self.assertEqual(found["expected"]["waves_limited"], 0)
        self.assertIsNone(found["expected"]["states"][0]["highest"])

    def test_seas_that_cannot_be_are_told(self):
        self.write_surf_zone("9,12,3000\n5,10,20000")
        done = upbead("expected", "surf.toml", "--json", cwd=self.folder)
        self.assertRegex(done.stderr, r"warning: sea_impossible: check .*\n +1 of 2 sea states have an H_1/3 that no sea brings to that depth, the "
                                      r"first 9 m at T = 12 s, where the steepest sea has 8\.166 m and breaks at 11\.27 m")
        states = json.loads(done.stdout)["expected"]["states"]
        self.assertEqual([s["significant_height_possible"] for s in states], [False, True])
        self.assertAlmostEqual(states[0]["highest"], 11.274, delta=1e-3)

    def test_shares_of_the_time_are_no_numbers_of_waves(self):
        self.write_surf_zone("7,12,0.5\n5,10,99.5")
        done = upbead("expected", "surf.toml", cwd=self.folder)
        self.assertRegex(done.stderr, r"warning: few_waves: give how many .*\n +all sea states together have 100 waves in [\d.]+ years?")
        states = self.folder / "states.csv"
        states.write_text("significant_height,period,waves (%)\n7,12,0.5\n5,10,99.5\n")
        done = upbead("expected", "surf.toml", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("the unit '%' of column 'waves' is no number of waves; give how many waves each row stands for", done.stderr)

    def test_waves_that_last_longer_than_their_record_are_told(self):
        year = 365.25 * 86400
        for share, told in ((1.3, True), (1.2, False)):
            self.write_surf_zone(f"5,10,{share * year / 10}")
            done = upbead("expected", "surf.toml", "--set", "sea.years=1", cwd=self.folder)
            self.assertEqual("too_many_waves" in done.stderr, told, done.stderr)

    def test_water_levels_move_the_limit(self):
        self.write_surf_zone()
        (self.folder / "states.csv").write_text("significant_height,period,waves,water_level\n7.5,12,3000,0\n"
                                                "7.5,12,3000,2\n")
        low, high = self.expected("surf.toml")["expected"]["states"]
        self.assertGreater(high["highest"], low["highest"] + 0.8)

    def test_levels_that_no_sea_has_are_told(self):
        self.write_surf_zone()
        (self.folder / "states.csv").write_text("significant_height,period,waves,water_level\n7.5,12,3000,0\n7.5,12,3000,2\n")
        for levels, told in (("{ high = 1.5 }", []), ("{ high = 2.5, low = -0.5 }", ["levels_not_used"])):
            found = self.expected("surf.toml", "--set", f"levels={levels}")["warnings"]
            self.assertEqual([w["name"] for w in found if w["name"] == "levels_not_used"], told)

    def test_loads_that_no_wave_has_are_told(self):
        write_oscillator(self.folder / "model.h5", loads=("impact", "weight"), mass=5.933088e6 / 9.81)
        found = self.expected(PROTOTYPE, "--set", f"dynamics.model={self.folder / 'model.h5'}", "--set", "dynamics.load=impact",
                              "--set", "life.simulated_lives=2", "--set", "life.years=1")
        self.assertIn("weight", next(w["text"] for w in found["warnings"] if w["name"] == "load_left_out"))

    def test_waves_of_storms_break(self):
        self.write_surf_zone()
        text = (self.folder / "surf.toml").read_text()
        (self.folder / "surf.toml").write_text(text[:text.index("[sea]")] + (
            "[storms]\nlocation = 5\nscale = 2\nshape = 1.4\nsteepness = 0.035\n[life]\nsimulated_lives = 500\n"))
        found, free = (self.expected("surf.toml", "--set", f"storms.highest={word}")["monte_carlo"]
                       for word in ("breaking", "none"))
        self.assertEqual(self.expected("surf.toml")["monte_carlo"], found)
        self.assertLess(found["mean"], free["mean"])
        self.assertGreater(found["mean"], 0)
        self.assertGreater(found["waves_limited"], 0)
        self.assertEqual(free["waves_limited"], 0)
        self.assertGreater(free["highest"], 1.2 * found["highest"])

    def test_results_are_drawn(self):
        script = CASES.parent / "postprocess/expected_sliding.py"
        draw = lambda *arguments: subprocess.run([sys.executable, "-B", script, *arguments], cwd=self.folder,
                                                 capture_output=True, text=True)
        self.expected(HD10, "--out", "low")
        self.expected(HD12, "--out", "high")
        done = draw("low", "high", "--law", "paper", "-o", "figure.png")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertGreater((self.folder / "figure.png").stat().st_size, 10000)
        done = draw("nothing")
        self.assertEqual(done.returncode, 1)
        self.assertIn("holds no results of 'upbead expected'", done.stderr)

    def test_help_teaches_by_example(self):
        done = upbead("expected", "--help")
        self.assertEqual(done.returncode, 0)
        self.assertIn("upbead expected cases/section4/", done.stdout)
        self.assertIn("[scatter", upbead("expected", "--keys").stdout)
        self.assertEqual(upbead("expected").returncode, 1)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
