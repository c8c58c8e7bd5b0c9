#!/usr/bin/python3
"""Claims: reliability prints and writes each way to fail, the fault tree, and the demands of codes; the same file has the same numbers
again; one file may be a case and a design; mistakes of its tables are told at once, with place and cure, and nothing is written. Limit states by F_T of
a model of soils: sliding as often as an integral over the soil says, S of the design point as `respond` has it.

usage: reliability_test.py PROGRAM CASES_FOLDER; UPBEAD_SAMPLE_SOILS in the environment names the program that writes a model
"""

import json
import math
import os
import statistics
import subprocess

from program import CASES, PROGRAM, ProgramTest, main, upbead

DESIGN = CASES / "designer/reliability.toml"
QUICK = ["--set", "reliability.samples=2000"]


class Reliability(ProgramTest):
    def summary(self, *options, design=DESIGN, out="out"):
        done = upbead("reliability", design, *options, "--out", out, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((self.folder / out / "summary.json").read_text()), done

    def test_each_way_to_fail_and_the_tree_have_a_row(self):
        found, done = self.summary(*QUICK)
        modes = found["modes"]
        for name, mode in modes.items():
            self.assertIn(name, done.stdout)
            indices = [method["index"] for method in mode["methods"].values() if method["index"] is not None]
            if indices:  # the worse governs
                self.assertEqual(mode["occasion"]["index"], min(indices))
                self.assertEqual(mode["methods"][mode["governing"]]["index"], min(indices))
            else:
                self.assertTrue(mode["why_not"])
            if mode["life"]["probability"] is not None:
                p = mode["occasion"]["probability"]
                self.assertAlmostEqual(mode["life"]["probability"], 1 - (1 - p) ** 50, delta=1e-9)
            if mode["design_point"]:
                self.assertAlmostEqual(sum(v["importance"] for v in mode["design_point"].values()), 1, delta=1e-6)
        self.assertEqual(found["system"], "unusable")
        self.assertEqual({row["code"] for row in found["codes"]}, {"Japan", "PIANC WG 28", "Eurocode"})
        self.assertIn("assumed", done.stdout)

    def test_the_same_file_gives_the_same_numbers(self):
        again = [self.summary(*QUICK)[0]["modes"] for _ in range(2)]
        self.assertEqual(*again)

    def test_a_wider_caisson_fails_less(self):
        narrow, wide = (self.summary(*QUICK, "--set", f"section.submerged_weight={W}")[0]["modes"]["sliding"]["life"]["index"]
                        for W in (5.2e6, 5.9e6))
        self.assertGreater(wide, narrow)

    def test_a_mean_in_another_unit_than_the_design_is_told(self):
        done = self.summary(*QUICK, "--set", "reliability.variables.friction.mean=63.6")[1]
        self.assertIn("if it was meant in percent, write 0.636\n", done.stderr)
        self.assertIn("reliability.variables.friction.mean = 63.6 is more than is ever found", done.stderr)
        self.assertNotIn("implausible", self.summary(*QUICK)[1].stderr)

    def test_distributions_in_another_unit_are_told(self):
        for setting, words in (
            ("reliability.variables.friction.mean=6.36", "friction.mean = 6.36 is more than is ever found"),
            ("reliability.variables.goda.mean=0.091", "goda.mean = 0.091 is less than is ever found (0.4; it is a factor"),
            ("reliability.variables.goda.cov=17", "if it was meant in percent, write 0.17"),
            ("reliability.variables.height.high=5", "height.high = 5 is below the mean, 6.5: more than half"),
        ):
            done = self.summary(*QUICK, "--set", setting, "--set", "reliability.methods=['form']")[1]
            self.assertIn("warning: implausible", done.stderr)
            self.assertIn(words, " ".join(done.stderr.split()))

    def test_a_mean_of_the_water_above_the_crest_is_refused(self):
        rise = "reliability.variables.rise={ acts_on = 'water_level', mean = 12, deviation = 0.5 }"
        done = upbead("reliability", DESIGN, *QUICK, "--set", rise, cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("above the crest", done.stderr)

    def test_a_way_that_fails_for_certain_fails_the_system(self):
        form = ["--set", "reliability.methods=['form']", "--set", "limits.base_pressure=100e3"]
        for more in ("reliability.system={ all_of = { any = ['sliding', 'heel_pressure'] } }",
                     "reliability.system={ one = { any = ['heel_pressure', 'two'] }, two = { all = ['sliding', 'sliding_seaward'] } }"):
            done = upbead("reliability", DESIGN, *form, "--set", more, "--out", "out", cwd=self.folder)
            found = json.loads((self.folder / "out/summary.json").read_text())
            self.assertEqual(found["modes"][found["system"]]["life"]["probability"], 1)
            self.assertEqual(found["verdict"]["holds"], False)
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_what_it_writes_runs_again(self):
        first = self.summary(*QUICK)[0]["modes"]
        self.assertEqual(first, self.summary(design=self.folder / "out/case.toml", out="again")[0]["modes"])

    def test_one_file_may_be_case_and_design(self):
        case = self.folder / "both.toml"
        case.write_text((CASES / "designer/section.toml").read_text() + """
[reliability]
wave = "design"
[reliability.variables.friction]
acts_on = "section.friction"
cov = 0.16
[reliability.variables.goda]
acts_on = "force"
cov = 0.17
""")
        (self.folder / "storms.csv").write_text((CASES / "designer/storms.csv").read_text())
        found = self.summary(*QUICK, design=case)[0]
        self.assertEqual(found["system"], "system")
        self.assertEqual(upbead("waves", case, "--out", "waves", cwd=self.folder).returncode, 0)

    def test_mistakes_are_told_at_once_and_nothing_is_written(self):
        bad = self.folder / "bad.toml"
        bad.write_text(DESIGN.read_text().replace('acts_on = "section.friction"', 'acts_on = "section.frction"')
                       .replace('second = "uplift"', 'second = "uplfit"').replace('"overturning", ', '"overturnign", ')
                       .replace("mean = 6.5\ncov = 0.12", "mean = 6.5"))
        done = upbead("reliability", bad, "--set", 'reliability.methods=["forn"]', "--out", "bad", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        for line in ("section.frction", "did you mean 'uplift'?", "did you mean 'overturning'?", "neither 'cov' nor 'deviation'",
                     "there is no method 'forn'"):
            self.assertIn(line, done.stderr)
        self.assertFalse((self.folder / "bad").exists())

    def test_two_trees_beside_each_other_are_refused(self):
        text = DESIGN.read_text()
        two = self.folder / "two.toml"
        two.write_text(text + '[reliability.system.another]\nany = ["sliding"]\n')
        done = upbead("reliability", two, *QUICK, "--out", "two", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("[reliability.system.unusable]: gates another, unusable are each part of no other", done.stderr)
        self.assertFalse((self.folder / "two").exists())

    def test_a_system_names_what_it_leaves_out(self):
        text = DESIGN.read_text()
        bare = self.folder / "bare.toml"
        (self.folder / "storms.csv").write_text((DESIGN.parent / "storms.csv").read_text())
        bare.write_text(text[: text.index("[reliability.system.unusable]")].replace("base_pressure = 600e3\n", "") + "[levels]\nhigh = 1.0\n")
        found, done = self.summary(*QUICK, "--set", 'reliability.methods=["form"]', design=bare)
        self.assertIsNone(found["modes"]["heel_pressure"]["occasion"]["probability"])
        out = "without heel_pressure, sliding_seaward"
        for told in (found["modes"]["system"]["meaning"], found["checks"][0]["assumption"],
                     *(row["what"] for row in found["codes"] if row["code"] in ("PIANC WG 28", "Eurocode"))):
            self.assertIn(out, told)
        names = [warning["name"] for warning in found["warnings"]]
        self.assertIn("system_incomplete", names)
        self.assertIn("levels_not_used", names)

    def test_a_life_that_fails_for_certain_misses_its_target(self):
        found, done = self.summary(*QUICK, "--set", "reliability.variables.goda.mean=6", "--set", 'reliability.methods=["form"]')
        self.assertEqual(found["modes"]["unusable"]["life"], {"probability": 1, "index": None})
        check = found["checks"][0]
        self.assertEqual((check["holds"], check["demand"], check["probability"]), (False, None, 1))
        self.assertIn("implausible", found["verdict"]["why_void"], "no wave has six times Goda's force")
        self.assertIn("not found (probability 1) against at least 2.38: DOES NOT HOLD", done.stdout)

    def test_only_targets_of_the_file_are_judged(self):
        assumed = self.summary(*QUICK)[0]
        self.assertEqual(sum(row["holds"] is not None for row in assumed["checks"]), 1, "the target alone")
        given = self.summary(*QUICK, "--set", "reliability.targets.eurocode_year=6", "--set", "reliability.targets.exceed_0_1=0.3")[0]
        rows = {row["name"]: row["holds"] for row in given["checks"] if row["name"].startswith("reliability, ")}
        self.assertEqual(rows, {"reliability, Eurocode: beta of the system unusable in a year": False,
                                "reliability, Japan: S of all waves of a life above 0.1 m": True})
        self.assertEqual({row["source"] for row in given["codes"] if row["target"] in (6, 0.3) and row["source"].startswith("given")},
                         {"given by the file"})
        self.assertEqual(given["verdict"]["failing"], 1)

    def test_what_is_doubtful_in_lives_and_section_is_told(self):
        quick = [*QUICK, "--set", 'reliability.methods=["form"]']

        def names(*changes):
            keys = [word for key in ("life.simulated_lives=5", *changes) for word in ("--set", key)]
            return {one["name"] for one in self.summary(*quick, *keys)[0]["warnings"]}

        plain = names()
        self.assertIn("few_lives", plain)
        self.assertFalse(plain & {"years_differ", "buoyancy", "berm_below_bed", "foundation_below_bed"})
        self.assertIn("years_differ", names("life.years=5"))
        self.assertIn("buoyancy", names("section.submerged_weight=5.2e6"))

    def test_a_system_fails_as_often_as_each_of_its_parts(self):
        text = DESIGN.read_text()
        bare = self.folder / "bare.toml"
        (self.folder / "storms.csv").write_text((DESIGN.parent / "storms.csv").read_text())
        bare.write_text(text[: text.index("[reliability.system.unusable]")])
        modes = self.summary("--set", 'reliability.methods=["form"]', design=bare)[0]["modes"]
        parts = [mode["occasion"]["probability"] for name, mode in modes.items() if name in ("sliding", "overturning", "sliding_distance", "heel_pressure")]
        self.assertGreaterEqual(modes["system"]["occasion"]["probability"], max(parts))
        self.assertLessEqual(modes["system"]["occasion"]["probability"], sum(parts))

    def test_only_its_program_loads_the_library(self):
        for name, loads in (("upbead", False), ("upbead-solver", False), ("upbead-reliability", True)):
            libraries = subprocess.run(["ldd", PROGRAM.with_name(name)], capture_output=True, text=True, check=True).stdout
            self.assertEqual("libOT" in libraries, loads, name)


G = "regions.sand.shear_modulus"
ON_SAND = """
[section]
water_depth = 12.0
foundation_depth = 7.0
berm_depth = 7.0
crest = 10.0
width = 20.0
berm_width = 8.0
bed_slope = 0.02
weight = 5.933e6
submerged_weight = 3.7e6
friction = 0.6
[waves.design]
height = 8.0
period = 12.0
[limits]
sliding = 0.05
[dynamics]
model = "soils.h5"
[reliability]
methods = ["form", "importance"]
dynamics = true
samples = 5000
[reliability.variables.friction]
acts_on = "section.friction"
distribution = "lognormal"
cov = 0.16
[reliability.variables.goda]
acts_on = "force"
distribution = "lognormal"
cov = 0.1
"""
RANDOM_G = f"""
[reliability.variables.G]
acts_on = "{G}"
distribution = "lognormal"
cov = 0.5
low = 1e7
high = 1e8
"""


def impact(wave, force=1.0, n=4001):
    """(time, P(t)) of a wave of `upbead waves`, as docs/expected.md has it: half a sine of P_1 whose impulse stays, or a triangle."""
    standing = wave["force"] * wave["alpha_1"] / (wave["alpha_1"] + wave["alpha_star"])
    peak, T = max(wave["force"], standing), wave["period"]
    rise = 0.769 * math.sqrt(7.0 / 9.81) * 1030 * 9.81 * wave["height"] ** 2 / peak
    duration = min(rise * (2 + 8 * math.exp(-18 * rise / T)), T / 2)
    rise = min(rise, duration / 2)
    time = sorted({T / 2 * i / (n - 1) for i in range(n)} | {rise, duration})

    def course(gamma):
        def at(t):
            triangle = peak * min(t / rise, max((duration - t) / (duration - rise), 0))
            return max(gamma * standing * math.sin(2 * math.pi * t / T), triangle, 0)
        return [at(t) for t in time]

    def impulse(values):
        return sum(0.5 * (b - a) * (x + y) for a, b, x, y in zip(time, time[1:], values, values[1:]))

    low, high = 0.0, 1.0
    for _ in range(40):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if impulse(course(middle)) < standing * T / math.pi else (low, middle)
    return time, [force * P for P in course(low)]


class OnRandomSoil(ProgramTest):
    def setUp(self):
        super().setUp()
        subprocess.run([os.environ["UPBEAD_SAMPLE_SOILS"], self.folder / "soils.h5"], check=True)

    def modes(self, text, *options):
        (self.folder / "case.toml").write_text(text)
        done = upbead("reliability", "case.toml", *options, "--json", "--out", "out", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)["modes"]

    def wave(self, force=1.0):
        """Writes wave.csv and returns the wave of Goda's formulas."""
        done = upbead("waves", "case.toml", "--json", "--out", "waves", cwd=self.folder)
        wave = json.loads(done.stdout)["waves"]["design"]
        (self.folder / "wave.csv").write_text("time,impact\n" + "".join(f"{t!r},{P!r}\n" for t, P in zip(*impact(wave, force))))
        return wave

    def test_sliding_is_as_probable_as_an_integral_over_the_soil_says(self):
        """Of ln F_T(G) + ln(factor of P) - ln mu, normal for each G: P(failure) is the mean over G of Phi."""
        sliding = self.modes(ON_SAND + RANDOM_G)["sliding_dynamic"]
        wave = self.wave()
        # G of the case is 3e7; of its distribution between its ends 200 values of equal probability
        of_G = statistics.NormalDist(math.log(3e7) - 0.5 * math.log(1 + 0.5**2), math.sqrt(math.log(1 + 0.5**2)))
        low, high = of_G.cdf(math.log(1e7)), of_G.cdf(math.log(1e8))
        soils = [math.exp(of_G.inv_cdf(low + (high - low) * (i + 0.5) / 200)) for i in range(200)]
        done = upbead("respond", "soils.h5", "wave.csv", "--soil", "-", cwd=self.folder, input="".join(f"{G}={value}\n" for value in soils))
        peaks = [json.loads(line)["waves"][0]["peak_shear"] for line in done.stdout.splitlines()]
        self.assertGreater(max(peaks), 1.2 * min(peaks), "the soil matters")
        of_friction, of_force = math.log(1 + 0.16**2), math.log(1 + 0.1**2)
        median = math.log(0.6) - 0.5 * of_friction + 0.5 * of_force
        normal = statistics.NormalDist(0, math.sqrt(of_friction + of_force))
        exact = statistics.mean(normal.cdf(math.log(peak / (3.7e6 - wave["uplift"])) - median) for peak in peaks)
        sampled = sliding["methods"]["importance"]
        self.assertAlmostEqual(sampled["probability"], exact, delta=3 * sampled["variation"] * exact)
        self.assertLess(sampled["variation"], 0.03)
        self.assertAlmostEqual(sliding["methods"]["form"]["index"], -statistics.NormalDist().inv_cdf(exact), delta=0.1)
        self.assertEqual(sliding["design_point"]["G"]["unit"], "Pa")
        self.assertGreater(sliding["design_point"]["G"]["importance"], 0.01)

    def test_s_of_the_design_point_is_the_limit(self):
        point = self.modes(ON_SAND + RANDOM_G, "--set", 'reliability.methods=["form"]')["sliding_distance_dynamic"]["design_point"]
        wave = self.wave(point["goda"]["value"])
        done = upbead("respond", "soils.h5", "wave.csv", "--soil", f"{G}={point['G']['value']}", "--friction", point["friction"]["value"],
                      "--buoyant-weight", 3.7e6 - wave["uplift"], "--json", cwd=self.folder)
        self.assertAlmostEqual(json.loads(done.stdout)["waves"][0]["sliding"], 0.05, delta=2e-4)

    def test_the_density_of_the_water_reaches_f_t(self):
        density = '[reliability.variables.rho]\nacts_on = "fluid.density"\ndistribution = "normal"\ncov = 0.05\n'
        modes = self.modes(ON_SAND + density, "--set", 'reliability.methods=["form"]')
        formulas, dynamic = (modes[name]["design_point"]["rho"]["importance"] for name in ("sliding", "sliding_dynamic"))
        self.assertGreater(formulas, 0.05)
        self.assertGreater(dynamic, 0.05)

    def test_friction_below_zero_ends_nothing(self):
        wide = ON_SAND.replace('"lognormal"\ncov = 0.16', '"normal"\ncov = 0.3')
        modes = self.modes(wide, "--set", 'reliability.methods=["plain"]', "--set", "reliability.plain_samples=4000")
        sliding = modes["sliding_dynamic"]["methods"]["plain"]
        self.assertGreater(sliding["probability"], 0.0)

    def test_a_soil_without_spread_is_a_certain_soil(self):
        form = ["--set", 'reliability.methods=["form"]']
        certain = self.modes(ON_SAND.replace('"soils.h5"', f'"soils.h5"\nsoil = {{ "{G}" = 4e7 }}'), *form)
        narrow = RANDOM_G.replace('lognormal"\ncov = 0.5', 'uniform"').replace("1e7", "3.9999999e7").replace("1e8", "4.0000001e7")
        known = self.modes(ON_SAND + narrow, *form)
        formulas = self.modes(ON_SAND.replace("dynamics = true\n", ""), *form)
        for name in ("sliding_dynamic", "sliding_distance_dynamic"):
            self.assertAlmostEqual(known[name]["methods"]["form"]["index"], certain[name]["methods"]["form"]["index"], delta=1e-6)
            self.assertNotIn(name, formulas)
        for name in ("sliding", "overturning", "sliding_distance"):
            self.assertEqual(formulas[name], certain[name], "the ground changes no other limit state")
            index = formulas[name]["methods"]["form"]["index"]
            if index is not None:
                self.assertAlmostEqual(known[name]["methods"]["form"]["index"], index, delta=1e-6)

    def test_the_sheet_has_their_rows(self):
        (self.folder / "case.toml").write_text((ON_SAND + RANDOM_G).replace('["form", "importance"]', '["form"]'))
        done = upbead("sheet", "case.toml", "--json", "--out", "sheet", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        sheet = json.loads(done.stdout)
        [row] = [row for row in sheet["checks"] if row["name"].endswith("life, sliding_dynamic")]
        self.assertEqual(row["demand"], sheet["reliability"]["modes"]["sliding_dynamic"]["life"]["index"])

    def test_mistakes_of_soils_are_told(self):
        for text, options, told in (
                (ON_SAND + RANDOM_G.replace("1e8", "2e8"), [], "beyond the box of the model has no answer"),
                (ON_SAND + RANDOM_G.replace("shear_modulus", "porosity"), [], "nor a key of the soils of [dynamics] model"),
                (ON_SAND.replace('[dynamics]\nmodel = "soils.h5"\n', ""), [], "there is no ground whose soil could be random"),
                (ON_SAND.replace("5.933e6", "5e6"), [], "the caisson of the model weighs"),
                (ON_SAND.replace("dynamics = true", "") + '[reliability.system.slides]\nany = ["sliding_dynamic"]\n', [], "sliding_dynamic")):
            (self.folder / "bad.toml").write_text(text)
            done = upbead("reliability", "bad.toml", *options, "--out", "bad", cwd=self.folder)
            self.assertEqual(done.returncode, 1, told)
            self.assertIn(told, done.stderr)
            self.assertFalse((self.folder / "bad").exists())


if __name__ == "__main__":
    main()
