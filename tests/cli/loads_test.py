#!/usr/bin/python3
"""Loads that a code accepts, as a user runs them: several waves in a row, sea and harbour at two levels, the direction
as on the chart, impacts by PROVERBS.

usage: loads_test.py PROGRAM CASES_FOLDER
"""

import json
import math
import shutil

from program import CASES, ProgramTest, main, upbead, with_keys

RHO_G = 1030.0 * 9.81
SECTION = CASES / "design-wave/section.toml"
LEVELS = CASES / "gallery/two-levels.toml"


class Loads(ProgramTest):
    def told(self, *arguments):
        done = upbead(*arguments, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def settings(self, *settings):
        return with_keys(settings)

    def waves(self, *settings):
        return self.told("waves", SECTION, "--json", *self.settings(*settings))


class Rows(Loads):
    def slid(self, load):
        """S by eq. (4) and coupled, of the prototype of Fig. 2b under a load."""
        text = (CASES / "fig2b-prototype.toml").read_text()
        for name in ("fig2b-prototype-impulse.csv", "fig2b-prototype-slow.csv"):
            shutil.copy(CASES / name, self.folder)
        text = text.replace('history = "fig2b-prototype-impulse.csv"', load)
        (self.folder / "case.toml").write_text(text)
        found = self.told("run", "case.toml", "--json", "--out", "out",
                          *self.settings("mesh.parameters.cells=0.5", "time.end=2"))
        return found["sliding"]["sliding_history"], found["sliding"]["sliding_coupled"]

    def test_waves_in_a_row_are_not_as_many_times_one_wave(self):
        pulse = 'pulse = { shape = "triangle", peak = 9e6, duration = 0.2%s }'
        one, row = self.slid(pulse % ""), self.slid(pulse % ", number = 3, period = 0.45")
        corners = [(k * 0.45 + t, force) for k in range(3) for t, force in ((0.0, 0.0), (0.1, 9e6), (0.2, 0.0))]
        (self.folder / "row.csv").write_text("time,force\n" + "".join(f"{t!r},{f!r}\n" for t, f in corners))
        by_hand = self.slid('history = "row.csv"')
        for S, S_by_hand, S_one in zip(row, by_hand, one):
            self.assertGreater(S_one, 1e-3)
            self.assertAlmostEqual(S / S_by_hand, 1, delta=1e-6, msg="written out by hand")
            self.assertGreater(abs(S / (3 * S_one) - 1), 0.02, "the ground still sways from the wave before")


class TwoLevels(Loads):
    COARSE = ("mesh.parameters.seabed_front=120", "mesh.parameters.seabed_back=120", "mesh.parameters.cells=0.4")
    GIVEN = ("initial.water_level=14", "initial.harbour_level=11", "loads.levels.factor=0")

    def run_with(self, *settings):
        return self.told("run", LEVELS, "--json", "--out", "out", *self.settings(*self.COARSE, *settings))

    def test_the_run_has_them_in_all_that_is_at_rest(self):
        found, by_load = self.run_with(*self.GIVEN), self.run_with()
        gained = RHO_G * 20 * 3 / 2
        push, moment = RHO_G * (100 - 49) / 2, RHO_G * (1000 - 343) / 6
        harbour = found["harbour"]
        self.assertTrue(harbour["counted"])
        self.assertAlmostEqual(harbour["push"], push, delta=1)
        self.assertAlmostEqual(harbour["weight_gained"], gained, delta=1)
        self.assertIsNone(found["verdict"]["why_void"])
        self.assertNotIn("harbour_level", [warning["name"] for warning in found["warnings"]])
        # N', M' at rest by hand: W' of the case, more of it B/6 landward of the middle, and the moment of the push
        own = 4571.5e3 * by_load["base"]["eccentricity_at_rest"]
        N, M = 4571.5e3 + gained, own + gained * 20 / 6 + moment
        self.assertAlmostEqual(found["base"]["eccentricity_at_rest"] / (M / N), 1, delta=1e-9)
        self.assertAlmostEqual(found["base"]["heel_pressure_at_rest"] / (N / 20 * (1 + 6 * M / N / 20)), 1, delta=1e-9)
        sliding, loaded = found["sliding"], by_load["sliding"]
        self.assertAlmostEqual(sliding["resistance"], 0.6 * N, delta=1)
        # as the load does that stands for them, once it has come to stay
        self.assertAlmostEqual(sliding["peak_sliding_force"] / loaded["peak_sliding_force"], 1, delta=3e-3)

    def test_a_caisson_that_still_water_pushes_away_is_a_mistake(self):
        lifted = ("initial.water_level=11", "initial.harbour_level=14", "loads.levels.factor=0", "sliding.submerged_weight=2e5")
        for settings in ((*self.GIVEN, "sliding.friction=0.05"), lifted):
            done = upbead("run", LEVELS, *self.settings(*self.COARSE, *settings), "--out", "away", cwd=self.folder)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn("it slides without a wave", done.stderr)
            self.assertFalse((self.folder / "away").exists())

    def test_slip_circles_have_the_push(self):
        strong = ("regions.seabed.strength={ friction_angle = 35 }", "regions.mound.strength={ friction_angle = 40, cohesion = 20e3 }")
        found = self.run_with(*self.GIVEN, *strong)["circles"]
        self.assertAlmostEqual(found["at_rest"]["shear"], RHO_G * (100 - 49) / 2, delta=1)
        level = self.run_with("initial.water_level=14", "initial.harbour_level=14", "loads.levels.factor=0", *strong)["circles"]
        self.assertEqual(level["at_rest"]["shear"], 0)
        self.assertLess(found["at_rest"]["factor"], level["at_rest"]["factor"])
        for way in ("still", "static_design"):  # F_T as it was, and the push
            self.assertGreater(found[way]["shear"], level[way]["shear"])

    def test_without_the_key_the_verdict_is_void_and_the_warning_names_it(self):
        found = self.run_with("loads.levels.factor=0")
        self.assertFalse(found["harbour"]["counted"])
        warning = next(warning for warning in found["warnings"] if warning["name"] == "harbour_level")
        self.assertIn("water_level = 14 and harbour_level = 11", warning["cure"])
        self.assertIsNotNone(found["verdict"]["why_void"])

    def test_what_begins_without_shear_is_refused(self):
        friction = 'regions.caisson.interface.kind="friction"'
        done = upbead("run", LEVELS, *self.settings(*self.GIVEN, friction), cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("begins without the shear of still water", done.stderr)

    def test_respond_gives_what_run_gives(self):
        strong = ("regions.seabed.strength={ friction_angle = 35 }", "regions.mound.strength={ friction_angle = 40, cohesion = 20e3 }")
        given = (*self.GIVEN, *strong, "sliding.friction=0.18")  # so that it slides
        run = self.run_with(*given)
        told = self.told("reduce", LEVELS, "--json", "--out", "model", *self.settings(*self.COARSE, *given))
        self.assertIn("slip as a whole begins without shear", json.dumps(told))
        times = [5 * i / 400 for i in range(401)]
        rows = "".join(f"{5 + t!r},{672.6e3 * math.sin(math.pi * t / 5)!r}\n" for t in times)
        (self.folder / "wave.csv").write_text("time,wave\n0,0\n" + rows)
        wave = self.told("respond", "model/reduced.h5", "wave.csv", "--json", "--out", "answer")["waves"][0]
        sliding, base = run["sliding"], run["base"]
        self.assertGreater(sliding["sliding_history"], 1e-3)
        self.assertAlmostEqual(wave["peak_shear"] / run["response"]["peak_shear"], 1, delta=2e-3)
        self.assertAlmostEqual(wave["sliding"] / sliding["sliding_history"], 1, delta=1e-2)
        for key in ("peak_heel_pressure", "least_overturning_margin"):
            self.assertAlmostEqual(wave[key] / base[key], 1, delta=2e-3, msg=key)
        for key in ("force", "shear", "moment"):  # of the moment that governs; pore pressures differ: the run has no computed one
            self.assertAlmostEqual(wave["circle"][key] / run["circles"]["still"][key], 1, delta=1e-3, msg=key)
        one = self.told("respond", "model/reduced.h5", "wave.csv", "--json", "--out", "other", "--friction", "0.18",
                        "--buoyant-weight", "4571.5e3")["waves"][0]
        self.assertEqual(one["sliding"], wave["sliding"])
        done = upbead("respond", "model/reduced.h5", "wave.csv", "--friction", "0.05", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("it slides without a wave", done.stderr)

    def test_a_life_has_them(self):
        text = (CASES / "designer/design.toml").read_text()
        shutil.copy(CASES / "designer/storms.csv", self.folder)
        (self.folder / "design.toml").write_text(text)
        base = self.settings("section.friction=0.4")
        one, two = (self.told("expected", "design.toml", "--json", *base, *self.settings(*more))["expected"]
                    for more in ((), ("section.harbour_level=-2.0",)))
        self.assertGreater(two["distance_exact"], one["distance_exact"])
        done = upbead("expected", "design.toml", *self.settings("scatter.friction.kind='lognormal'", "scatter.friction.cov=0.6", "section.harbour_level=-2.0"), cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("it slides without a wave", done.stderr)

    def test_formulas_have_them(self):
        friction = "section.friction=0.5"  # so that it slides
        one, two = self.waves(friction), self.waves(friction, "section.harbour_level=-1.0")
        s, wave = one["section"], next(iter(one["waves"]))
        a, b = one["waves"][wave], two["waves"][wave]
        h, B = s["foundation_depth"], s["width"]
        rho_g = one["fluid"]["density"] * one["gravity"]
        push, gained = rho_g * (h**2 - (h - 1) ** 2) / 2, rho_g * B / 2
        mu, W = s["friction"], s["submerged_weight"] + gained
        self.assertAlmostEqual(b["safety_sliding"], mu * (W - a["uplift"]) / (a["force"] + push), delta=1e-9)
        self.assertAlmostEqual(b["ratio"], (a["force"] + mu * a["uplift"]) / (mu * W - push), delta=1e-9)
        self.assertGreater(b["sliding_exact"], a["sliding_exact"])


class Directions(Loads):
    def test_the_chart_is_turned_and_printed(self):
        wave = next(iter(self.waves()["waves"]))
        chart = ("section.facing=350", f"waves.{wave}.direction=12")
        told = self.waves(*chart)["waves"][wave]
        self.assertAlmostEqual(told["angle"], 7, delta=1e-12)
        self.assertEqual(told["direction"], 12)
        self.assertEqual(told["force"], self.waves(f"waves.{wave}.angle=7")["waves"][wave]["force"])
        done = upbead("waves", SECTION, *self.settings(*chart), cwd=self.folder)
        self.assertIn("22 degrees to the normal, turned by 15 towards it (Goda 2000): beta = 7 degrees", done.stdout)
        done = upbead("waves", SECTION, *self.settings(chart[1]), cwd=self.folder)
        self.assertIn("add facing to [section]", done.stderr)


class Proverbs(Loads):
    def test_waves_tell_the_impact_and_its_source(self):
        self.assertIsNone(next(iter(self.waves()["waves"].values()))["impact"])
        told = self.waves('impact.force="proverbs"', "impact.proverbs.breaker=5.0", "impact.proverbs.quantile=0.5")
        impact = next(iter(told["waves"].values()))["impact"]
        F = 3.268 + 1.91 / -0.232 * (1 - math.log(2) ** -0.232)
        self.assertAlmostEqual(impact["relative_peak"], F, delta=1e-9)
        rho_g = told["fluid"]["density"] * told["gravity"]
        self.assertAlmostEqual(impact["peak"] / (F * rho_g * 25), 1, delta=1e-9)
        done = upbead("waves", SECTION, *self.settings('impact.force="proverbs"'), cwd=self.folder)
        self.assertIn("PROVERBS (Oumeraci et al. 2001), its numbers assumed", done.stdout)

    def test_settings_without_the_choice_are_refused(self):
        done = upbead("waves", SECTION, *self.settings("impact.proverbs.quantile=0.5"), cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn('write force = "proverbs"', done.stderr)


if __name__ == "__main__":
    main()
