#!/usr/bin/python3
"""Units that were mistaken are told, with the unit that was meant, by every command that reads a number; scenes in SI,
models and centrifuges pass in silence.

usage: units_test.py PROGRAM CASES_FOLDER [at_length]
"""

import json
import pathlib
import re
import sys

from program import CASES, ProgramTest, main, upbead

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
from section_scene import scene  # noqa: E402

PULSE = 'pulse = { shape = "triangle", peak = 1e6, duration = 0.15 }'
SLIDING = '\n[sliding]\nfriction = 0.6\nsubmerged_weight = 4.3e6\n[initial]\nwater_level = 15.0\n'
SIZES = {"seabed_depth": 15, "seabed_front": 60, "seabed_back": 60, "mound_height": 6, "mound_crest_front": 16,
         "mound_crest_back": 16, "caisson_width": 18, "caisson_height": 16}

CASE = (("regions.seabed.shear_modulus", 4e4, "in kPa, write 4e+07"),
        ("regions.seabed.shear_modulus", 2e5, "in kPa, write 2e+08"),
        ("regions.seabed.shear_modulus", 40, "in MPa, write 4e+07"),
        ("regions.mound.porosity", 0.95, "in void ratio, write 0.4872"),
        ("regions.mound.porosity", 0.01, "sand has 0.3 to 0.5"),
        ("regions.mound.damping.ratio", 0.5, "5 percent are 0.05"),
        ("regions.mound.grain_density", 2.65, "in t/m3, write 2650"),
        ("regions.mound.hydraulic_conductivity", 8.64, "in m/day, write 0.0001"),
        ("gravity", 981, "in cm/s2, write 9.81"),
        ("fluid.bulk_modulus", 2.2, "in GPa, write 2.2e+09"),
        ("fluid.viscosity", 1.07, "in mPa s"),
        ("sliding.friction", 31, "in degrees, write 0.6009"),
        ("loads.impulse.pulse.duration", 150, "in ms, write 0.15"),
        ("initial.water_level", 1500, "in cm, write 15"),
        ("limits.base_pressure", 600, "in kPa, write 6e+05"),
        ("limits.sliding", 30, "in cm, write 0.3"))
PEAKS = ((1600, "in kN/m, write 1.6e+06"), (1.6, "in MN/m, write 1.6e+06"))
DESIGN = (("waves.storm.height=1100", "in cm, write 11"),
          ("waves.storm.period=12000", "in ms, write 12"),
          ("waves.storm.angle=0.26", "in radians, write 14.9"),
          ("section.water_depth=1500", "in cm, write 15"),
          ("section.weight=5933", "in kN/m, write 5.933e+06"),
          ("section.bed_slope=1", "in percent, write 0.01"),
          ("section.submerged_weight=438", "in t/m, write 4.297e+06"),
          ("fluid.density=1.03", "in t/m3, write 1030"),
          ("levels={ high = 150 }", "in cm, write 1.5"),
          ("limits.base_pressure=600", "in kPa, write 6e+05"),
          ("section.berm_width=700", "in cm, write 7"),
          ("section.harbour_level=-80", "in cm, write -0.8"))
GIVEN = (("waves.storm.force=2e3", "in kN/m, write 2e+06"), ("waves.storm.uplift=1e3", "in kN/m, write 1e+06"),
         ("ground.mass=300", "in t/m, write 3e+05"))


def sized(factor):
    sizes = ", ".join(f"{key} = {value * factor}" for key, value in SIZES.items())
    return scene(("cells = 0.5, seabed_front = 60, seabed_back = 60", f"cells = 0.5, {sizes}"))


class Units(ProgramTest):
    def told(self, text, *settings, command="explain"):
        """The texts of the warnings `implausible`, by their key."""
        file = self.folder / "scene.toml"
        file.write_text(text)
        out = [] if command == "explain" else ["--out", self.folder / "out"]
        done = upbead(command, file, *out, *[part for setting in settings for part in ("--set", setting)])
        self.assertEqual(done.returncode, 0, done.stderr)
        found = re.findall(r"^warning: implausible: (.*\n +(\S+?),? .*)$", done.stderr, re.M)
        return {key: lines for lines, key in found}

    def expect(self, text, setting, meant, key=None):
        with self.subTest(setting=setting):
            found = self.told(text, setting)
            key = key or setting.split("=")[0]
            self.assertIn(key, found, found)
            self.assertIn(meant, found[key])

    def test_of_a_case(self):
        text = scene() + SLIDING
        self.assertEqual(self.told(text), {})
        for key, value, meant in CASE[::4]:
            self.expect(text, f"{key}={value}", meant, key)

    def test_of_a_case_at_length(self):
        for key, value, meant in CASE:
            self.expect(scene() + SLIDING, f"{key}={value}", meant, key)
        for value, meant in PEAKS:
            self.expect(scene(), f"loads.impulse.pulse.peak={value}", meant, "loads.impulse")
        mass = scene(("density = 2100.0", "mass = 604.8\nmoment_of_inertia = 29e3"))
        self.assertIn("in t/m, write 6.048e+05", self.told(mass)["regions.caisson.mass"])
        self.assertIn("in t/m3, write 2100", self.told(scene(("density = 2100.0", "density = 2.1")))["regions.caisson.density"])
        soil = ("kind = \"porous\"", "kind = \"porous\"\nstrength = { friction_angle = %s, cohesion = %s }")
        self.assertIn("in radians, write 34.95",
                      self.told(scene((soil[0], soil[1] % (0.61, 0))))["regions.seabed.strength.friction_angle"])
        self.assertIn("in kPa, write 2e+04",
                      self.told(scene((soil[0], soil[1] % (30, 20))))["regions.seabed.strength.cohesion"])
        self.assertEqual(self.told(scene((soil[0], soil[1] % (0.001, 20e3)))), {}, "undrained strength")
        for strength, key in (("friction_angle = 0, cohesion = 60", "cohesion"), ("cohesion = 60e9", "cohesion"),
                              ("dilatancy_angle = 0.2", "dilatancy_angle"), ("tension = 10", "tension")):
            text = scene((soil[0], 'kind = "porous"\nlaw = "mohr_coulomb"\nstrength = { %s }' % strength))
            self.assertIn(f"regions.seabed.strength.{key}", self.told(text))
        uplift = scene() + SLIDING + '[sliding.uplift]\nkind = "prescribed"\npeak = 800\n'
        self.assertIn("in kN/m, write 8e+05", self.told(uplift)["sliding.uplift.peak"])
        self.assertIn("in kN/m", next(w["text"] for w in self.all_told(scene() + SLIDING, "sliding.submerged_weight=4300")
                                      if w["name"] == "submerged_weight"))

    def all_told(self, text, setting):
        (self.folder / "scene.toml").write_text(text)
        return json.loads(upbead("explain", self.folder / "scene.toml", "--json", "--set", setting).stdout)["warnings"]

    def test_of_a_mesh(self):
        for factor, meant in ((1000, "in mm"),):
            found = self.told(sized(factor))
            self.assertIn(meant, found["mesh"])
        slow = "loads.impulse.pulse.duration=60"
        self.assertIn("loads.impulse.pulse.duration", self.told(scene(), slow))
        self.assertEqual(self.told(scene(), slow, "time.inertia=false", "time.end=100"), {}, "a tide, or a fill")

    def test_models_and_centrifuges_pass(self):
        for n in (20, 100):
            small = sized(1 / n)
            model = [f"loads.impulse.pulse.peak={1.2e6 / n ** 2}", f"regions.seabed.shear_modulus={3e7 / n}",
                     f"regions.mound.shear_modulus={5e7 / n}"]
            self.assertEqual(self.told(small, *model), {})
            self.assertEqual(self.told(small, f"gravity={9.81 * n}", f"loads.impulse.pulse.peak={1.2e6 / n}",
                                       f"loads.impulse.pulse.duration={0.15 / n}", "fluid.viscosity=0.1"), {})

    def test_of_a_wave(self):
        wave = scene(('kind = "force"', 'kind = "wave"'), (PULSE, 'wave = { height = 800, period = 12.0, course = "sine" }'))
        wave += ("[section]\nwater_depth = 15.0\nfoundation_depth = 9.0\nberm_depth = 7.5\ncrest = 7.0\nwidth = 18.0\n"
                 "berm_width = 7.0\nbed_slope = 0.01\nweight = 5.933088e6\nsubmerged_weight = 4.296e6\n")
        self.assertIn("in cm, write 8", self.told(wave)["loads.impulse.wave.height"])
        self.assertEqual(self.told(wave, "loads.impulse.wave.height=8"), {})

    def test_of_a_design(self):
        text = (CASES / "design-wave/section.toml").read_text()
        self.assertEqual(self.told(text, command="waves"), {})
        for setting, meant in DESIGN[::3]:
            self.check_design(text, setting, meant)

    def test_of_a_design_at_length(self):
        for setting, meant in DESIGN:
            self.check_design((CASES / "design-wave/section.toml").read_text(), setting, meant)

    def test_of_what_scatters(self):
        text = (CASES / "designer/design.toml").read_text() + "\n[life]\nyears = 50\nsimulated_lives = 20\n"
        (self.folder / "storms.csv").write_text((CASES / "designer/storms.csv").read_text())
        self.assertEqual(self.told(text, "scatter.friction={ mean = 1.06, cov = 0.16, low = 0.2 }",
                                   "scatter.force={ kind = 'uniform', low = 0.7, high = 1.1 }", "sea.highest=1.8", command="expected"), {})
        for setting, key, meant in (("scatter.friction={ mean = 106, cov = 0.16, low = 1 }", "scatter.friction.mean", "in percent, write 1.06"),
                                    ("scatter.force={ mean = 0.091, cov = 0.17, low = 0.02 }", "scatter.force.mean", "it is a factor"),
                                    ("scatter.weight={ kind = 'uniform', low = 90, high = 110 }", "the", "in percent, write 1"),
                                    ("sea.highest=1", "sea.highest", "the highest of a hundred waves")):
            with self.subTest(setting=setting):
                found = self.told(text, setting, command="expected")
                self.assertIn(meant, found[key])

    def test_of_given_forces(self):
        for setting, meant in GIVEN:
            text = (CASES / "design-wave/section.toml").read_text() + "force = 2e6\n[ground]\nstiffness = 1e8\n"
            self.check_design(text, setting, meant)

    def check_design(self, text, setting, meant):
        key = "levels.high" if "levels" in setting else setting.split("=")[0]
        with self.subTest(setting=setting):
            (self.folder / "scene.toml").write_text(text)
            done = upbead("waves", self.folder / "scene.toml", "--out", self.folder / "out", "--set", setting)
            if done.returncode == 0:
                cures = re.findall(rf"^warning: implausible: (.*)\n +{re.escape(key)} = ", done.stderr, re.M)
                self.assertIn(meant, " ".join(cures), done.stderr)
            else:
                self.assertEqual(done.returncode, 1, "refused with a cure")
                self.assertIn("; ", done.stderr)

    def check_silent(self, files):
        for file in files:
            text = file.read_text()
            with self.subTest(case=str(file)):
                if "[mesh]" in text:
                    done = upbead("explain", file)
                elif "[waves" in text:
                    done = upbead("waves", file, "--out", self.folder / "out")
                else:
                    continue
                self.assertEqual(done.returncode, 0, done.stderr)
                for name in ("implausible", "load_cut", "load_zero"):
                    self.assertNotIn(name, done.stderr)

    def test_shipped_cases_pass(self):
        self.check_silent(CASES / file for file in ("fig2b-model.toml", "fig2b-prototype.toml", "designer/design.toml",
                                                    "fig10/impulsive.toml"))

    def test_all_shipped_cases_pass_at_length(self):
        self.check_silent(sorted(CASES.rglob("*.toml")))


if __name__ == "__main__":
    main()
