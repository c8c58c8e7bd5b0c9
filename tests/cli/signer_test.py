#!/usr/bin/python3
"""Numbers that may not hold do not reach the person who signs without a word: keys that turn a verdict while nobody looks
are told, limits that nothing judges stand as not checked, and what lifts the caisson counts wherever it comes from.

usage: signer_test.py PROGRAM CASES_FOLDER
"""

import json
import pathlib
import sys

from program import ProgramTest, main, upbead

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
from section_scene import scene  # noqa: E402

SECTION = scene(("cells = 0.5, seabed_front = 60, seabed_back = 60", "cells = 0.3, grading = 4"))
SLIDING = '[sliding]\nfriction = 0.6\nsubmerged_weight = 4.3e6\n'
SEA = "mesh.parameters={ cells = 0.3, grading = 4, water_depth = 15, sea_front = 2, sea_back = 2 }"

# a setting, and the warning that tells of it; none: it is sound
DOUBTS = (
    ("regions.caisson.centre_of_gravity=[0, 14]", None),
    ("regions.caisson.centre_of_gravity=[0, 14000]", "implausible"),
    ("regions.caisson.centre_of_gravity=[0, 3]", "implausible"),
    ("regions.caisson.moment_of_inertia=2.9e7", None),
    ("regions.caisson.moment_of_inertia=2.9e4", "implausible"),
    ("loads.impulse.shape=[[6, 0.8], [15, 1], [22, 0.33]]", None),
    ("loads.impulse.shape=[[0, 0.8], [9, 1], [16, 0.33]]", "implausible"),
    ("regions.seabed.damping={ ratio = 0.05, frequencies = [0.5, 20] }", None),
    ("regions.seabed.damping={ ratio = 0.05, frequencies = [0.001, 0.01] }", "implausible"),
    ("regions.seabed.damping={ ratio = 0.05, frequencies = [100, 1000] }", "implausible"),
    ("loads.impulse.factor=1500", "implausible"),
    ("loads.impulse.factor=0.001", None),
    ("sliding.uplift={ kind = \"prescribed\", peak = 8e5, lag = 0.01 }", None),
    ("sliding.uplift={ kind = \"prescribed\", peak = 8e5, lag = 5 }", "load_zero"),
)
STRAIN = "regions.seabed.strain={ reference_strain = 1e-3%s }"
CURVES = ((", effective = 0.65", None), (", effective = 65", "implausible"))


class Signer(ProgramTest):
    def ask(self, command, *settings, text=SECTION + SLIDING):
        file = self.folder / "scene.toml"
        file.write_text(text)
        out = [] if command == "explain" else ["--out", self.folder / "out"]
        done = upbead(command, file, "--json", *out, *[part for setting in settings for part in ("--set", setting)])
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def names(self, *settings, **options):
        return {warning["name"] for warning in self.ask("explain", *settings, **options)["warnings"]}

    def test_keys_that_turn_a_verdict_are_told(self):
        before = self.names()
        for setting, name in DOUBTS + tuple((STRAIN % more, name) for more, name in CURVES):
            with self.subTest(setting):
                self.assertEqual(self.names(setting) - before, {name} - {None})

    def test_dashpots_are_told_beyond_critical_damping(self):
        text = """[mesh]
geometry = "caisson"
parameters = { caisson_width = 10, caisson_height = 12 }
[regions.caisson]
kind = "rigid"
mass = 2e5
moment_of_inertia = 6e6
springs = { horizontal = 2e8, vertical = 3.5e8, rotation = 5e9 }
dashpots = { horizontal = 2e6, vertical = 3e6, rotation = 4e7 }
[loads.push]
boundary = "front"
kind = "force"
pulse = { shape = "triangle", peak = 4e5, duration = 0.1 }
[boundaries]
front = {}
back = {}
top = {}
bottom = {}
[time]
end = 0.8
"""
        self.assertNotIn("implausible", self.names(text=text))
        for key, value in (("horizontal", 2e9), ("vertical", 3e3), ("rotation", 4e10)):
            self.assertIn("implausible", self.names(f"regions.caisson.dashpots.{key}={value}", text=text), key)

    def test_levels_that_are_not_those_of_the_mesh_void_the_verdict(self):
        base = SECTION + SLIDING + "[regions.sea_front]\nkind = \"water\"\n[regions.sea_back]\nkind = \"water\"\n"
        sides = [f"boundaries.{name}={value}" for name, value in (("sea_surface", '{ pressure = "open" }'),
                 ("sea_left", '{ pressure = "sealed" }'), ("sea_right", '{ pressure = "sealed" }'))]
        self.assertNotIn("harbour_level", self.names(SEA, *sides, text=base))
        for levels in ("{ water_level = 15, harbour_level = 10 }", "{ water_level = 13 }"):
            told = self.ask("explain", SEA, *sides, f"initial={levels}", text=base)["warnings"]
            self.assertIn("harbour_level", {warning["name"] for warning in told}, levels)

    def test_limits_that_nothing_judges_are_not_checked(self):
        found = self.ask("run", "limits={ sliding_factor = 1.2, lives_beyond = 0.1 }")
        self.assertEqual(found["verdict"]["unjudged"], 2)
        self.assertEqual({check["limit"] for check in found["checks"] if check["why_not"]} & {"sliding_factor", "lives_beyond"},
                         {"sliding_factor", "lives_beyond"})

    def test_a_load_that_lifts_takes_off_the_friction(self):
        lift = 'region = "caisson", at = [0, 6], kind = "force", direction = [0, 1], '
        pulse = 'pulse = { shape = "step", peak = 1e6, rise = 0.1 }'
        plain = self.ask("run")["checks"]
        lifted = self.ask("run", f"loads.uplift={{ {lift}{pulse} }}")["checks"]
        demand = [next(check["demand"] for check in checks if check["name"] == "force against friction") for checks in (plain, lifted)]
        self.assertGreater(demand[1] - demand[0], 0.9 * 0.6 * 1e6)

    def test_circles_of_a_march_do_not_hold_by_still_water(self):
        """The march keeps no pore pressure of its times: what holds without it is not checked, what fails fails."""
        strength = [f"regions.{name}.strength={{ friction_angle = {angle}, cohesion = 5e3 }}" for name, angle in (("seabed", 35), ("mound", 40))]
        for limit, why in ((0.05, True), (50.0, False)):
            found = self.ask("run", "time.scheme=\"sdirk4\"", f"limits.circles={limit}", "initial.water_level=15", *strength)
            check = next(check for check in found["checks"] if check["name"] == "slip circles")
            self.assertEqual(bool(check["why_not"]), why, check)


if __name__ == "__main__":
    main()
