#!/usr/bin/python3
"""`upbead waves` as a user runs it.

usage: waves_test.py PROGRAM CASES_FOLDER
"""

import json
import math
import pathlib
import re
import sys

from program import AT_LENGTH, CASES, ProgramTest, main, upbead

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
from thinned_waves import thinned  # noqa: E402

# The section of the regression table, which is declared, not published (tests/waves/regression_test.cc).
DESIGN = """title = "regression"
[section]
water_depth = 15.0
foundation_depth = 10.5
berm_depth = 8.5
crest = 6.0
width = 12.0
berm_width = 8.0
bed_slope = 0.01
weight = 4273236.0
submerged_weight = 3000096.2
[waves.a_high]
height = 12.0
period = 12.0
[waves.b_low]
height = 8.0
period = 12.0
"""

KEYS = ["height", "significant_height", "period", "angle", "direction", "wavelength", "alpha_1", "alpha_2", "alpha_3", "alpha_I",
        "alpha_star", "lambda_1", "lambda_2", "lambda_3", "eta_star", "overtopped", "p1", "p3", "p4", "pu", "force",
        "uplift", "force_moment", "uplift_moment", "without_alpha_I", "safety_sliding", "safety_overturning",
        "heel_pressure", "toe_pressure", "tau_0F", "k", "tau_0", "shear_force", "shear_force_from", "sliding_force", "ratio",
        "sliding_paper", "sliding_paper_parts", "sliding_exact", "sliding_combined", "elastic", "standing",
        "why_no_standing", "trough_bound", "impact", "warnings"]

# Goda (2000), p. 140; B_M, and with it alpha_I, are added here. W and W' by 2.1 and 2.4 t/m3 below and above still
# water.
GODA = """[section]
water_depth = 10.1
foundation_depth = 7.1
berm_depth = 5.6
crest = 3.4
width = 15.0
berm_width = 8.0
bed_slope = 0.01
weight = 3394750.5
submerged_weight = 2318643.0
[waves.book]
deep_water_height = 6.3
period = 11.4
angle = 15.0
"""


class Waves(ProgramTest):
    def write(self, text, name="design.toml"):
        (self.folder / name).write_text(text)

    def waves(self, *arguments):
        return upbead("waves", *arguments, cwd=self.folder)

    def summary(self, *arguments):
        done = self.waves(*arguments, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_json_has_every_number_of_the_chain(self):
        self.write(DESIGN)
        summary = self.summary("design.toml")
        self.assertEqual(list(summary), ["title", "program", "verdict", "checks", "warnings", "gravity", "fluid", "section", "duration", "waves",
                                         "versions"])
        self.assertEqual(list(summary["waves"]), ["a_high", "b_low"])
        wave = summary["waves"]["a_high"]
        self.assertEqual(list(wave), KEYS)
        for key, value, digits in (("alpha_2", 0.2961, 4), ("alpha_I", 0.2157, 4), ("alpha_star", 0.2961, 4),
                                   ("tau_0F", 4.8, 3), ("k", 0.3484, 4), ("tau_0", 1.6725, 4),
                                   ("wavelength", 135.3522, 4), ("safety_sliding", 0.7048, 4), ("sliding_paper", 0.07562, 5),
                                   ("sliding_exact", 0.12542, 5)):
            self.assertAlmostEqual(wave[key], value, delta=0.51 * 10**-digits, msg=key)
        self.assertAlmostEqual(wave["force"] / 2090.2e3, 1, delta=3e-5)
        self.assertAlmostEqual(wave["uplift"] / 544.8e3, 1, delta=1e-4)
        self.assertAlmostEqual(sum(wave["sliding_paper_parts"]), wave["sliding_paper"], places=14)
        self.assertAlmostEqual(wave["sliding_force"], wave["force"] + 0.6 * wave["uplift"], places=6)
        self.assertAlmostEqual(wave["ratio"], wave["sliding_force"] / (0.6 * 3000096.2), places=12)
        self.assertGreater(abs(wave["ratio"] * wave["safety_sliding"] - 1), 0.05, "r is not 1/S.F.")
        self.assertEqual([w["name"] for w in wave["warnings"]], ["impulsive_breaking", "breaking_limit", "overturns"])
        self.assertEqual(summary["waves"]["b_low"]["sliding_exact"], 0)

    def test_goda_example_from_deep_water(self):
        self.write(GODA)
        wave = self.summary("design.toml")["waves"]["book"]
        self.assertAlmostEqual(wave["significant_height"], 5.796, delta=5e-4)
        self.assertAlmostEqual(wave["height"], 8.050, delta=5e-4)
        self.assertAlmostEqual(wave["without_alpha_I"]["force"] / 937281, 1, delta=2e-4)
        self.assertAlmostEqual(wave["force"] / 940684, 1, delta=2e-4)
        self.assertAlmostEqual(wave["pu"] / 65739.31, 1, delta=2e-4)
        self.assertEqual(wave["uplift"], wave["without_alpha_I"]["uplift"])
        self.assertAlmostEqual(wave["safety_overturning"], 2.569, delta=2e-3)

    def test_files_come_all_and_run_again(self):
        self.write(DESIGN)
        done = self.waves("design.toml", "--set", "waves.a_high.height=11")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.left_behind(), ["design.toml", "results", "results/design", "results/design/case.toml",
                                              "results/design/summary.json"])
        first = (self.folder / "results/design/summary.json").read_text()
        again = self.waves("results/design/case.toml", "--out", "again", "--json")
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual(again.stdout, first)
        self.assertEqual((self.folder / "again/case.toml").read_text(),
                         (self.folder / "results/design/case.toml").read_text())

    def test_tables_for_people_and_warnings_on_stderr(self):
        self.write(DESIGN)
        done = self.waves("design.toml")
        self.assertEqual(done.returncode, 0, done.stderr)
        for part in ("regression\nsection     h 15 m", "S.F. sliding", "S exact", "--details prints all else",
                     "written     results/design/{summary.json, case.toml}"):
            self.assertIn(part, done.stdout)
        self.assertRegex(done.stdout, r"a_high +12 m +0\.2961 +2\.09 MN/m +544\.8 kN/m +0\.7048 ")
        self.assertRegex(done.stderr, r"^warning: impulsive_breaking: compare .*\n         wave a_high: waves may break on the wall .*\n"
                                      r"warning: breaking_limit: give a height .*\n         wave a_high: H = 12 m .*\n"
                                      r"warning: overturns: widen .*\n         wave a_high: the safety factor .* 0\.809: .*\n"
                                      r"warning: impulsive_breaking: compare .*\n         wave b_low: .*\n$")

    def test_details_have_every_number_with_its_unit(self):
        self.write(DESIGN)
        done = self.waves("design.toml", "--details", "--set", "levels.low=-1")
        told = {line.split()[0] for line in done.stdout.splitlines() if line.strip()}
        summary = json.loads((self.folder / "results/design/summary.json").read_text())
        wave = summary["waves"]["a_high"]
        self.assertEqual({key for key, value in wave.items() if value not in (None, "", [])} - told, set())
        for line in (r"\n  a_high\n    height +12 m +H\n", r"\n    tau_0F +4\.8 s +eq\. \(11\)\n", r"\n      low\n        rise +-1 m "):
            self.assertRegex(done.stdout, line)

    def test_a_measured_force_is_reduced_but_never_that_with_alpha_I(self):
        self.write(DESIGN)
        measured = ["--set", "waves.a_high.force=5e6", "--set", "waves.a_high.uplift=3e5"]
        ratio = ["--set", "waves.a_high.shear_to_force_ratio=0.4"]
        wave = self.summary("design.toml", *measured, *ratio)["waves"]["a_high"]
        self.assertAlmostEqual(wave["sliding_force"], 0.4 * 5e6 + 0.6 * 3e5, places=6)
        self.assertEqual(wave["shear_force_from"], "measured")
        goda = self.summary("design.toml")["waves"]["a_high"]
        self.assertEqual(wave["tau_0"], goda["tau_0"])
        self.assertEqual(wave["safety_sliding"], goda["safety_sliding"])
        whole = self.summary("design.toml", *measured)["waves"]["a_high"]
        self.assertEqual(whole["shear_force"], 5e6, "without a ratio all of P reaches the bottom")
        done = self.waves("design.toml", *ratio, "--out", "refused")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("alpha_I was fitted to sliding tests", done.stderr)
        self.assertNotIn("refused", self.left_behind())

    def test_a_caisson_on_a_swaying_ground_swings_and_slips(self):
        self.write(DESIGN)
        ground = ["--set", "ground={stiffness=6e8}", "--set", "waves.a_high.pulse_duration=0.05",
                  "--set", "waves.a_high.uplift=0"]
        force = lambda value: ["--set", f"waves.a_high.force={value}"]
        self.assertIsNone(self.summary("design.toml")["waves"]["a_high"]["elastic"])
        weak = self.summary("design.toml", *ground, *force(1e5))["waves"]["a_high"]["elastic"]
        mass = 4273200 / 9.81
        period = 2 * math.pi * math.sqrt(mass / 6e8)
        # an undamped oscillator after a short symmetric triangle: F_T swings by 2 sin^2(w td/4) / (w td/4) P
        phase = 2 * math.pi / period * 0.05 / 4
        self.assertAlmostEqual(weak["peak_shear"], 1e5 * 4 * math.sin(phase) ** 2 / (2 * phase), delta=2e2)
        self.assertEqual(weak["sliding"], 0)
        strong = self.summary("design.toml", *ground, *force(8e6))["waves"]["a_high"]
        self.assertAlmostEqual(strong["elastic"]["peak_shear"], 0.6 * 3000096.2, delta=1)
        self.assertGreater(strong["elastic"]["sliding"], 1e-3)

    def test_what_is_unsettled_of_the_combined_model_is_an_input(self):
        self.write(DESIGN)
        standard = self.summary("design.toml")["waves"]["a_high"]["sliding_combined"]
        heavier = self.summary("design.toml", "--set", "combined.added_mass_factor=2")["waves"]["a_high"]
        sinusoidal = self.summary("design.toml", "--set", "combined.uplift=sinusoidal")["waves"]["a_high"]
        self.assertLess(heavier["sliding_combined"], 0.99 * standard)
        self.assertNotAlmostEqual(sinusoidal["sliding_combined"] / standard, 1, places=2)

    def test_committees_may_calibrate_k(self):
        self.write(DESIGN)
        wave = self.summary("design.toml", "--set", "duration.a=1", "--set", "duration.b=1")["waves"]["a_high"]
        self.assertAlmostEqual(wave["k"], 1 / (1 + wave["alpha_star"]), places=14)

    def test_standing_waves_are_told_where_there_are_any(self):
        self.write(DESIGN.replace("height = 8.0", "height = 4.0"))
        waves = self.summary("design.toml")["waves"]
        self.assertIsNone(waves["a_high"]["standing"])
        self.assertIn("no standing wave of H = 12 m and T = 12 s is found in 15 m", waves["a_high"]["why_no_standing"])
        low, mu, W = waves["b_low"]["standing"], 0.6, 3000096.2
        self.assertEqual(waves["b_low"]["why_no_standing"], "")
        self.assertAlmostEqual(low["crest"] - low["trough"], 8.0, places=9)
        self.assertAlmostEqual(low["safety_sliding"], mu * (W - low["uplift"]) / low["force"], places=9)
        self.assertAlmostEqual(low["uplift"], low["pu"] * 12.0 / 2, places=3)
        # seaward, about the toe, without the suction
        self.assertAlmostEqual(low["trough_safety_sliding"], -mu * W / low["trough_force"], places=9)
        self.assertAlmostEqual(low["trough_safety_overturning"], -W * 6.0 / low["trough_moment"], places=9)
        arm = (W * 6.0 + low["trough_moment"]) / W
        self.assertGreater(arm, 4.0)  # a trapezoid
        # with suction, a triangle under the base: a trapezoid's edge has all of the pressure at the edge more
        suction = low["toe_pressure"] - 2 * W / 12.0 * (2 - 3 * arm / 12.0)
        k = 2 * math.pi / low["wavelength"]
        of_a_low_wave = 1030 * 9.81 * 4.0 * math.cosh(k * (15 - 10.5)) / math.cosh(15 * k)
        self.assertLess(abs(suction / of_a_low_wave - 1), 0.25)
        out = self.waves("design.toml").stdout
        self.assertIn("sliding by formulas, standing wave, wave b_low: ", out)
        self.assertRegex(self.waves("design.toml", "--details").stdout, r"why_no_standing +no standing wave of H = 12 m")
        for key, value, why in (("angle", 10.0, "does not come straight"), ("blocks", "true", "dissipating blocks")):
            place = f"section.{key}" if key == "blocks" else f"waves.b_low.{key}"
            told = self.summary("design.toml", f"--set={place}={value}")["waves"]["b_low"]
            self.assertIsNone(told["standing"])
            self.assertIn(why, told["why_no_standing"])
            bound = told["trough_bound"]
            self.assertGreater(bound["force"], -low["trough_force"], "the bound is above the trough of the wave that stands")
            self.assertAlmostEqual(bound["safety_sliding"], mu * W / bound["force"], places=9)
        self.assertIsNone(waves["b_low"]["trough_bound"])

    def close(self, found, wanted, path=""):
        """Asserts that two JSON values differ by round-off at most; numbers within texts have four digits."""
        if isinstance(wanted, dict):
            self.assertEqual(list(found), list(wanted), path)
            for key in wanted:
                self.close(found[key], wanted[key], f"{path}/{key}")
        elif isinstance(wanted, list):
            self.assertEqual(len(found), len(wanted), path)
            for i, (one, other) in enumerate(zip(found, wanted)):
                self.close(one, other, f"{path}/{i}")
        elif isinstance(wanted, float):
            self.assertAlmostEqual(found, wanted, delta=1e-13 * max(abs(wanted), 1), msg=path)
        else:
            self.assertEqual(found, wanted, path)

    def test_a_water_level_is_the_section_shifted_by_hand(self):
        measured = "force = 1.9e6\nuplift = 3e5\n"
        second = DESIGN.replace("height = 8.0", "height = 4.0").replace("period = 12.0\n[", f"period = 12.0\n{measured}[")
        for text, rises in ((GODA, (0.75, -1.5, 3.0)), (second, (1.25, -3.0))):
            levels = {f"level {i}": rise for i, rise in enumerate(rises)}
            self.write(text + "[levels]\n" + "".join(f'"{name}" = {rise}\n' for name, rise in levels.items()))
            together = self.summary("design.toml")
            own = together["section"]
            self.write(text)
            alone = self.summary("design.toml")
            for name, rise in {**levels, "section": 0.0}.items():
                shifted = {key: own[key] + sign * rise for key, sign in (("water_depth", 1), ("foundation_depth", 1),
                                                                         ("berm_depth", 1), ("crest", -1))}
                shifted["submerged_weight"] = own["submerged_weight"] - 1030 * 9.81 * own["width"] * rise
                by_hand = self.summary("design.toml", *(f"--set=section.{key}={value!r}" for key, value in shifted.items()))
                for wave in alone["waves"]:
                    level = dict(together["waves"][wave]["levels"][name])
                    self.assertEqual(level.pop("rise"), rise)
                    self.close(level.pop("section"), by_hand["section"])
                    self.close(level, by_hand["waves"][wave], f"{wave} at {name}")
            for wave, numbers in alone["waves"].items():
                again = together["waves"][wave]
                self.assertEqual(list(again), KEYS + ["levels", "governing"])
                self.assertEqual({key: again[key] for key in KEYS}, numbers, "the section's own level stays as it was")
                heights = [level["rise"] for level in again["levels"].values()]
                self.assertEqual(heights, sorted([*rises, 0.0], reverse=True), "the highest first")
        depths = [level["height"] for level in self.levels_of_goda().values()]
        self.assertEqual(depths, sorted(depths, reverse=True))
        self.assertGreater(depths[0] - depths[-1], 0.5, "random breaking lets higher waves through where it is deeper")

    def levels_of_goda(self):
        self.write(GODA + "[levels]\nhigh = 1.0\nlow = -1.0\n", "goda.toml")
        return self.summary("goda.toml")["waves"]["book"]["levels"]

    def test_different_levels_govern_different_checks(self):
        # On a high mound alpha_I is large at low water, P grows with the depth, W' falls with it.
        levels = "[levels]\nhigh = 1.5\nlow = -2.0\n"
        high_mound = {"berm_depth = 8.5": "berm_depth = 4.5", "height = 8.0": "height = 5.0"}
        scenes = (({}, "b_low", ["high", "high", "low", "high"], "height = 8.0", "height = 6.0"),
                  (high_mound, "b_low", ["low", "section", "low", "high"], "", ""))
        for changes, name, wanted, old, new in scenes:
            text = DESIGN
            for before, after in {**changes, old: new}.items():
                text = text.replace(before, after) if before else text
            self.write(text + levels)
            wave = self.summary("design.toml")["waves"][name]
            checks = ("safety_sliding", "safety_overturning", "heel_pressure", "trough_safety_sliding")
            governing = wave["governing"]
            self.assertEqual([governing[check]["level"] for check in checks], wanted)
            for check, worst in zip(checks, (min, min, max, min)):
                found = {level: (numbers["standing"] if check[0] == "t" else numbers)[check]
                         for level, numbers in wave["levels"].items()}
                self.assertEqual(governing[check]["value"], worst(found.values()))
                self.assertEqual(governing[check]["value"], found[governing[check]["level"]])
        out = self.waves("design.toml").stdout
        self.assertRegex(out, r"\nb_low at +rise +H .*\nhigh +1\.5 m +5 m .*\nsection +0 m .*\nlow +-2 m +5 m .* 1\.156 .* 804\.6 kPa ")
        self.assertIn("\n  sliding by formulas, wave b_low at low: 1.156 against", out)
        self.assertIn("\n  heel pressure p_e, wave b_low at low: 804.6 kPa", out)

    def test_where_it_overturns_no_heel_pressure_is_worse(self):
        self.write(DESIGN.replace("height = 12.0", "height = 10.0").replace("period = 12.0\n[", "period = 15.0\n[")
                   + "[levels]\nhigh = 1.5\nlow = -2.0\n")
        wave = self.summary("design.toml")["waves"]["a_high"]
        pressures = {name: level["heel_pressure"] for name, level in wave["levels"].items()}
        self.assertIsNone(pressures["high"])
        self.assertGreater(pressures["low"], 1e6)
        self.assertEqual(wave["governing"]["heel_pressure"], {"level": "high", "value": pressures["high"]})
        # no standing wave at any level: the bound of the trough
        least = min(level["trough_bound"]["safety_sliding"] for level in wave["levels"].values())
        self.assertEqual(wave["governing"]["trough_safety_sliding"]["value"], least)

    def test_waves_too_high_for_a_level_are_told_with_it(self):
        self.write(DESIGN.split("[waves.a_high]")[0] + "[waves.one]\nheight = 8.0\nperiod = 7.0\n")
        self.assertNotIn("breaking_limit", self.waves("design.toml").stderr)
        done = self.waves("design.toml", "--set", "levels.ebb=-4")
        self.assertRegex(done.stderr, r"warning: breaking_limit: .*\n +wave one at ebb: H = 8 m is above Miche's limit ")
        wave = self.summary("design.toml", "--set", "levels.ebb=-4")["waves"]["one"]
        names = lambda told: [warning["name"] for warning in told["warnings"]]
        self.assertIn("breaking_limit", names(wave["levels"]["ebb"]))
        self.assertNotIn("breaking_limit", names(wave))

    def test_limits_tell_what_does_not_hold(self):
        self.write(DESIGN.replace("height = 8.0", "height = 6.0"))
        wave = self.summary("design.toml")["waves"]["b_low"]
        p_e, p_toe, safety = wave["heel_pressure"], wave["standing"]["toe_pressure"], wave["safety_overturning"]
        failing = lambda done, wave: re.findall(rf"\n  (.*?), wave {wave}.*: DOES NOT HOLD", done.stdout)
        self.assertEqual(failing(self.waves("design.toml"), "b_low"), [])
        bearable = self.waves("design.toml", f"--set=limits.base_pressure={1.001 * p_e}",
                              f"--set=limits.overturning={0.999 * safety}")
        self.assertEqual(failing(bearable, "b_low"), [])
        self.assertIn("overturning by formulas", failing(bearable, "a_high"))
        limits = (f"--set=limits.base_pressure={0.999 * p_toe}", f"--set=limits.overturning={1.001 * safety}")
        beyond = self.waves("design.toml", *limits, "--set=levels.low=-1")
        self.assertEqual(failing(beyond, "b_low"), ["overturning by formulas", "heel pressure p_e", "heel pressure p_e, standing wave",
                                                    "toe pressure p_e"])
        told = {warning["name"]: warning["text"] for warning in self.summary("design.toml", *limits)["waves"]["b_low"]["warnings"]}
        self.assertIn("the pressure under the heel is ", told["base_pressure"])
        self.assertIn(", below limits.overturning = ", told["overturning_limit"])
        self.assertRegex(beyond.stderr, r"warning: base_pressure: widen .*\n +wave b_low")

    def test_the_governing_level_makes_the_verdict(self):
        """Each check is that of the level at which it is worst; all that fails and all warnings are told."""
        scenes = ((DESIGN.replace("height = 8.0", "height = 6.0"), {"high": 1.5, "low": -2.0}), (GODA, {"high": 1.0, "low": -1.0}))
        for text, levels in scenes:
            table = "[levels]\n" + "".join(f"{name} = {rise}\n" for name, rise in levels.items())
            self.write(text + table + "[limits]\nbase_pressure = 250e3\noverturning = 1.2\nsliding = 0.01\n")
            done = self.waves("design.toml")
            found = self.summary("design.toml")
            told = " ".join((done.stdout + done.stderr).split())
            self.assertEqual(found["verdict"]["failing"], sum(check["holds"] is False for check in found["checks"]))
            self.assertGreater(found["verdict"]["failing"], 0)
            for check in found["checks"]:
                if check["holds"] is False:
                    self.assertIn(" ".join(check["text"].split()), told)
                levels_of = found["waves"][check["wave"]]["levels"]
                if check["name"] in ("sliding by formulas", "overturning by formulas"):
                    key = "safety_sliding" if "sliding" in check["name"] else "safety_overturning"
                    self.assertEqual(check["demand"], min(level[key] for level in levels_of.values()))
                    self.assertEqual(check["demand"], levels_of[check["level"]][key])
            for warning in found["warnings"]:
                what, cure = warning["text"].removesuffix(f"; {warning['cure']}"), warning["cure"]
                self.assertIn(f"warning: {warning['name']}: {cure} {what}", told)
            of_waves = {w["text"] for wave in found["waves"].values() for level in wave["levels"].values() for w in level["warnings"]}
            self.assertTrue(all(any(warning["text"].endswith(text) for warning in found["warnings"]) for text in of_waves))
            self.assertIn("verdict     " + found["verdict"]["text"], done.stdout)
            worst = min((check for check in found["checks"] if check["holds"] is False), key=lambda check: check["margin"] or 0)
            self.assertEqual((found["verdict"]["check"], found["verdict"]["level"]), (worst["name"], worst["level"]))

    def test_wrong_designs_write_nothing(self):
        self.write(DESIGN)
        for change, message in (("section.berm_depth=0", "berm_depth = 0 is outside"),
                                ("waves.a_high.deep_water_height=5", "keep one of them"),
                                ("section.colour=3", "unknown key 'colour'")):
            done = self.waves("design.toml", "--set", change)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertIn(message, done.stderr)
            self.assertEqual(self.left_behind(), ["design.toml"])
        self.write(DESIGN.split("[waves.a_high]")[0], "calm.toml")
        done = self.waves("calm.toml")
        self.assertEqual(done.returncode, 1)
        self.assertIn("the design has no wave; add a table [waves.NAME]", done.stderr)
        self.assertEqual(self.waves("none.toml").returncode, 1)
        self.assertEqual(self.waves().returncode, 1)

    def test_reference_of_keys_is_current(self):
        text = (CASES.parent / "docs/reference/design.md").read_text()
        keys = self.waves("--keys").stdout.replace("](", "](../")
        self.assertTrue(text.endswith(keys), "run postprocess/reference.py build/upbead docs")

    def test_keys_and_help_teach(self):
        done = self.waves("--keys")
        self.assertEqual(done.returncode, 0, done.stderr)
        for part in ("`[section]`", "`[waves.NAME]`", "| `berm_depth` |", "`[duration]`"):
            self.assertIn(part, done.stdout)
        done = self.waves("--help")
        for part in ("submerged_weight = 3.0e6", "summary.json", "--set"):
            self.assertIn(part, done.stdout)


class Figure10(ProgramTest):
    """Fig. 10: at equal safety factor impulsive waves slide the caisson less far than standing waves."""

    def curve(self, name, friction):
        change = ["--set", f"section.friction={friction}"]
        case = thinned(CASES / "fig10" / name, self.folder, 1 if AT_LENGTH else 2)
        done = upbead("waves", case, *change, "--json", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        waves = json.loads(done.stdout)["waves"].values()
        points = sorted((wave["safety_sliding"], wave["sliding_paper"]) for wave in waves)
        self.assertLess(points[0][0], 0.6)
        self.assertGreater(points[-1][0], 1.0)
        self.assertEqual(points[-1][1], 0)
        return [point for point in points if point[0] < 1] + [(1.0, 0.0)]  # S.F. = 1 is where r = 1

    def compare(self, friction):
        impulsive = self.curve("impulsive.toml", friction)
        others = self.curve("non_breaking.toml", friction)
        for step in range(40):
            safety = 0.6 + 0.01 * step
            low, high = at(impulsive, safety), at(others, safety)
            self.assertGreater(low, 0)
            self.assertLess(low, high, f"mu {friction}, S.F. {safety}")

    def test_impulsive_waves_slide_less_far(self):
        self.compare(0.6)

    def test_impulsive_waves_slide_less_far_at_other_friction_at_length(self):
        for friction in (0.5, 0.7):
            self.compare(friction)


def at(curve, safety):
    """S at a safety factor: near the threshold S grows with the third power, so its cube root is interpolated
    linearly between the waves."""
    for (a, S_a), (b, S_b) in zip(curve, curve[1:]):
        if a <= safety <= b:
            return (S_a ** (1 / 3) + (S_b ** (1 / 3) - S_a ** (1 / 3)) * (safety - a) / (b - a)) ** 3
    raise ValueError(f"no waves around S.F. {safety}")


if __name__ == "__main__":
    main()
