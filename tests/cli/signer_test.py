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
    ("loads.impulse.shape=[[21, 0.8], [30, 1], [37, 0.33]]", "implausible"),
    ("loads.impulse.shape=[[6, 0.8], [15, 1], [25, 0]]", None),
    ("regions.seabed.damping={ ratio = 0.05, frequencies = [0.5, 20] }", None),
    ("regions.seabed.damping={ ratio = 0.05, frequencies = [0.001, 0.01] }", "implausible"),
    ("regions.seabed.damping={ ratio = 0.05, frequencies = [100, 1000] }", "implausible"),
    ("boundaries.base.displacement=free", "base_free"),
    ("boundaries.base={ displacement = \"free\", pressure = \"sealed\", spring = [1e8, 1e8] }", None),
    ("boundaries.base={ displacement = \"free\", pressure = \"sealed\", spring = [1, 1] }", "base_free implausible"),
    ("boundaries.base={ displacement = \"free\", pressure = \"sealed\", dashpot = [1, 1] }", "base_free implausible"),
    ("boundaries.base={ displacement = \"free\", pressure = \"sealed\", spring = [1e8, 1e2] }", "implausible"),
    ("boundaries.left={ displacement = \"free\", pressure = \"sealed\", dashpot = [5e5, 2e5], spring = [1e6, 1e6] }", None),
    ("boundaries.left={ displacement = \"free\", pressure = \"sealed\", dashpot = [500, 200], spring = [1e6, 1e6] }", "implausible"),
    ("boundaries.mound_surface.displacement=fixed", "ground_held"),
    ("time.end=0.16", "answer_cut"),
    ("loads.impulse.pulse={ shape = \"triangle\", peak = 1e6, duration = 0.15, start = 0.44 }", "answer_cut"),
    ("loads.trifle={ boundary = \"front\", kind = \"force\", pulse = { shape = \"triangle\", peak = 10, duration = 0.15, "
     "start = 0.44 } }", None),
    ("loads.impulse.boundary=base", "load_zero"),
    ("limits={ settlement = 0.05, tilt = 0.01, overturning = 1.2, circles = 1 }", None),
    ("limits.settlement=5", "implausible"),
    ("limits.tilt=0.2", "implausible"),
    ("limits.overturning=0.12", "implausible"),
    ("loads.impulse.factor=1500", "implausible"),
    ("loads.impulse.factor=0.001", None),
    ("sliding.uplift={ kind = \"prescribed\", peak = 8e5, lag = 0.01 }", None),
    ("sliding.uplift={ kind = \"prescribed\", peak = 8e5, lag = 5 }", "load_zero"),
)
STRAIN = "regions.seabed.strain={ reference_strain = 1e-3%s }"
CURVES = ((", effective = 0.65", None), (", effective = 65", "implausible"),
          (", modulus = [[1e-6, 1], [1e-4, 0.8], [1e-3, 0.4]]", None), (", modulus = [[1e-6, 1], [1e-4, 0.4], [1e-3, 0.8]]", "implausible"),
          (", damping = [[1e-6, 0.01], [1e-4, 0.05], [1e-3, 0.2]]", None), (", damping = [[1e-6, 0.01], [1e-4, 0.2], [1e-3, 0.05]]", "implausible"))
TRAIN = 'loads.swell={ boundary = "bed", kind = "train", train = { amplitude = %g, period = 1, length = 40, course = "stands" } }'


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
                self.assertEqual(self.names(setting) - before, set((name or "").split()))

    def test_a_curve_that_no_soil_has_voids_the_verdict(self):
        for more, name in CURVES[2:]:
            with self.subTest(more):
                verdict = self.ask("run", STRAIN % more, "limits.sliding=1")["verdict"]
                self.assertEqual("implausible" in (verdict["why_void"] or ""), name is not None, verdict)

    def test_a_pulse_of_an_acceleration_may_be_in_g(self):
        base = SECTION.split("[loads.impulse]")[0].replace('displacement = "roller"', 'displacement = "level"') + "[time]\nend = 1.5\n" + SLIDING
        for peak, factor, told in ((0.3, 1, True), (-0.3, 1, True), (0.3, 9.81, False), (3, 1, False), (3, 0.1, False), (0.1, 1, False)):
            quake = (f'loads.quake={{ boundary = "base", kind = "acceleration", factor = {factor}, '
                     f'pulse = {{ shape = "half_sine", peak = {peak}, duration = 0.5 }} }}')
            with self.subTest(peak=peak, factor=factor):
                self.assertEqual("implausible" in self.names(quake, text=base), told)

    def test_an_acceleration_without_a_unit_may_be_in_g(self):
        base = SECTION.split("[loads.impulse]")[0].replace('displacement = "roller"', 'displacement = "level"') + "[time]\nend = 1.5\n" + SLIDING
        for header, peak, factor, told in (("acc", 0.2, 1, True), ("acc", 0.2, 9.81, False), ("acc", 2, 1, False), ("acc", 2, 0.1, False),
                                           ("acc (g)", 0.2, 1, False), ("acc (m/s2)", 0.2, 1, False), ("a_g", 0.2, 1, False)):
            (self.folder / "quake.csv").write_text(f"time (s),{header}\n0,0\n0.2,{peak}\n0.6,{-peak}\n0.8,0\n")
            quake = f'loads.quake={{ boundary = "base", kind = "acceleration", history = "quake.csv", factor = {factor} }}'
            with self.subTest(header=header, peak=peak, factor=factor):
                self.assertEqual("implausible" in self.names(quake, text=base), told)

    def test_a_storm_of_minutes_or_of_less_than_a_wave_is_told(self):
        sand = "regions.seabed.cyclic={ relative_density = 0.6 }"
        for storm, told in (("significant_height = [3], run_height = 5, period = [10], duration = [7200]", False),
                            ("significant_height = [3], run_height = 5, period = [10], duration = [2]", True),
                            ("significant_height = [3], run_height = 5, period = [10], duration = [120]", True),
                            ("number = [300], period = [10]", False), ("number = [0.3], period = [10]", True)):
            with self.subTest(storm):
                names = self.names(sand, f"cycles={{ {storm} }}", "initial.water_level=15")
                self.assertEqual("implausible" in names, told)

    def test_slip_node_by_node_is_judged_without_the_table_of_sliding(self):
        """As with it, where it has the weight that the nodes bear."""
        keys = ['regions.caisson.interface={ kind = "friction" }', "initial.water_level=15", "loads.impulse.pulse.peak=9e6", "limits.sliding=0.01"]
        plain = self.ask("run", *keys, text=SECTION)
        weight = plain["contact"]["weight"]
        with_table = self.ask("run", *keys, text=SECTION + f"[sliding]\nfriction = 0.6\nsubmerged_weight = {weight!r}\n")
        of = [next(check for check in found["checks"] if check["name"] == "sliding distance") for found in (plain, with_table)]
        for key in ("holds", "capacity", "why_not"):
            self.assertEqual(of[0][key], of[1][key], key)
        self.assertAlmostEqual(of[0]["demand"] / of[1]["demand"], 1, 6)
        self.assertIs(plain["verdict"]["holds"], False)
        cut = self.ask("run", *keys, "time.end=0.16", "limits.sliding=1", text=SECTION)
        self.assertIsNone(next(check for check in cut["checks"] if check["name"] == "sliding distance")["holds"], "it still slides")

    def test_a_shear_force_above_friction_that_nothing_judges_holds_nothing(self):
        keys = ["initial.water_level=15", "limits.overturning=1"]
        for peak, void in ((5e5, False), (6e6, True)):
            found = self.ask("run", *keys, f"loads.impulse.pulse.peak={peak}", text=SECTION)
            self.assertEqual("sliding_not_judged" in (found["verdict"]["why_void"] or ""), void)

    def test_cycles_of_a_frictional_contact_that_bears_are_those_of_a_bonded_one(self):
        keys = ["regions.seabed.cyclic={ relative_density = 0.6 }", "cycles={ number = [300], period = [10] }", "initial.water_level=15",
                'time.scheme="sdirk4"', "loads.impulse.pulse.peak=5e5", "regions.seabed.strength={ friction_angle = 35, cohesion = 5e3 }"]
        found = [self.ask("run", *keys, f'regions.caisson.interface={{ kind = "{kind}" }}') for kind in ("bonded", "friction")]
        self.assertIsNone(found[1]["contact"]["solved"])
        for part, key in (("cycles", "largest_ratio"), ("strength", "largest")):
            values = [summary[part][0][key] if isinstance(summary[part], list) else summary[part][key] for summary in found]
            self.assertAlmostEqual(values[1] / values[0], 1, 6)
    def test_a_threshold_in_percent_is_told(self):
        yields = ["regions.seabed.law=mohr_coulomb", "regions.seabed.strength={ friction_angle = 35, cohesion = 5e3 }", "initial.water_level=15"]
        for threshold, told in ((1e-4, False), (0.01, True)):
            names = self.names(*yields, f"regions.seabed.densification={{ relative_density = 0.5, threshold = {threshold} }}")
            self.assertEqual("implausible" in names, told)

    def test_a_train_in_kilopascals_is_told(self):
        for amplitude, told in ((2e4, 0), (20, 1)):
            found = [w for w in self.ask("explain", TRAIN % amplitude)["warnings"] if w["name"] == "implausible" and "loads.swell" in w["text"]]
            self.assertEqual(len(found), told, found)

    def test_a_drag_that_the_distance_does_not_have_is_told(self):
        for drag, told in ((0, False), (1e5, True)):
            found = self.ask("run", f"sliding.drag={drag}", "loads.impulse.factor=6")
            self.assertGreater(found["sliding"]["design"]["value"], 0)
            self.assertEqual("drag_left_out" in {warning["name"] for warning in found["warnings"]}, told)

    def test_loads_that_only_lift_have_no_rebound(self):
        lift = 'region = "caisson", at = [0, 6], kind = "force", direction = [0, 1], pulse = { shape = "step", peak = 1e6, rise = 0.1 }'
        checks = self.ask("run", "loads.impulse.factor=0", f"loads.lift={{ {lift} }}")["checks"]
        for check in checks:
            if "force against friction" in check["name"]:
                self.assertIsNone(check["why_not"])
                self.assertGreaterEqual(check["demand"], 0.99 * 0.6 * 1e6)

    def test_strength_reduction_tells_what_cannot_fail_and_how_much_coarse_cells_add(self):
        strong = ["initial.water_level=15", "regions.mound.strength={ friction_angle = 40, cohesion = 5e3 }"]
        factor = self.ask("run", *strong, "limits.safety=1.01")["safety"]["lower"]
        for limit, more, told in ((factor / 1.5, [], {"strength_missing"}), (factor / 1.1, [], {"strength_missing", "coarse_factor"}),
                                  (2 * factor, [], set()),
                                  (1.01, ["regions.seabed.strength={ friction_angle = 35, cohesion = 5e3 }"], set())):
            names = {warning["name"] for warning in self.ask("run", *strong, *more, f"limits.safety={limit}")["warnings"]}
            self.assertEqual(names & {"strength_missing", "coarse_factor"}, told)

    def test_a_lid_on_the_sea_bed_is_told(self):
        sealed = "boundaries.bed.pressure=sealed"
        for more, told in ((("initial.water_level=15",), True), ((), False)):
            self.assertEqual("ground_sealed" in self.names(sealed, *more), told)

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
        self.assertNotIn("sea_sealed", self.names(SEA, *sides, text=base))
        self.assertIn("sea_sealed", self.names(SEA, *sides, 'boundaries.sea_surface.pressure="sealed"', text=base))

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

    def test_a_caisson_that_came_back_was_farther_away(self):
        """Pushed landward, then as far back: S is about nothing, and the limit is held to what it was on the way, too."""
        back = 'boundary = "front", kind = "force", direction = [-1, 0]'
        push = 'shape = "triangle", peak = %g, duration = 0.5%s'
        loads = [f"loads.impulse.pulse={{ {push % (8e6, '')} }}", f"loads.back={{ {back}, pulse = {{ {push % (8e6, ', start = 1.5')} }} }}",
                 "time.end=4", "limits.sliding=0.1"]
        found = self.ask("run", *loads, text=SECTION + SLIDING)
        design, checks = found["sliding"]["design"], {check["name"]: check for check in found["checks"]}
        self.assertLess(abs(design["value"]), 0.5 * abs(design["largest"]))
        self.assertTrue(checks["sliding distance"]["holds"])
        self.assertEqual(checks["sliding distance on the way"]["demand"], abs(design["largest"]))
        self.assertFalse(checks["sliding distance on the way"]["holds"])
        self.assertNotIn("sliding distance on the way", {check["name"] for check in self.ask("run", "limits.sliding=0.01")["checks"]})

    def test_what_grows_until_the_end_is_not_judged(self):
        """A harmonic load near the section's own frequency; a pulse cut before its peak."""
        swing = 'loads.impulse.pulse={ shape = "harmonic", peak = 3e5, frequency = 1 }'
        for settings, name in (([swing, "time.end=1.5"], "still_grows"), (["time.end=0.06"], "load_cut")):
            found = self.ask("run", *settings, "limits.overturning=1.2")
            self.assertIn(name, {warning["name"] for warning in found["warnings"]})
            self.assertIsNone(found["verdict"]["holds"])

    def test_a_ground_that_shakes_vertically_takes_friction_away(self):
        """Twice: N' is less by the weight's acceleration, so that the force which it must bear is more."""
        base = SECTION.split("[loads.impulse]")[0].replace('displacement = "roller"', 'displacement = "level"') + "[time]\nend = 1.5\n" + SLIDING
        shake = 'boundary = "base", kind = "acceleration", pulse = { shape = "half_sine", peak = %g, duration = 0.4 }'
        across = f"loads.across={{ {shake % 1.0}, direction = [1, 0] }}"
        demand = []
        for more in ([], [f"loads.down={{ {shake % -3.0}, direction = [0, 1] }}"]):
            sliding = self.ask("run", across, *more, text=base)["sliding"]
            demand.append(max(sliding["peak_force_on_normal"], sliding["peak_force_seaward_on_normal"]))
            plain = max(sliding["peak_sliding_force"], sliding["peak_sliding_force_seaward"])
        self.assertGreater(demand[1], 1.1 * max(demand[0], plain))

    def test_soil_that_still_moves_is_not_judged(self):
        law = [part for name, angle in (("seabed", 35), ("mound", 40)) for part in (
            f"regions.{name}.law=mohr_coulomb", f"regions.{name}.strength={{ friction_angle = {angle}, cohesion = 2e4 }}")]
        found = self.ask("run", *law, "initial.water_level=15", "loads.impulse.pulse.peak=3e6", "time.end=0.3")
        residual = found["residual"]
        width, share = 18, 0.1
        moves = [residual[moved] > max(share * abs(residual[end]), least)
                 for moved, end, least in (("moved_x", "displacement_x", 1e-5 * width), ("moved_y", "displacement_y", 1e-5 * width),
                                           ("moved_rotation", "rotation", 1e-5))]
        self.assertTrue(any(moves))
        self.assertIn("still_moves", {warning["name"] for warning in found["warnings"]})

    def test_nodes_that_slip_on_under_loads_that_go_on_are_not_judged(self):
        nodes = ("regions.caisson.interface={ kind = \"friction\" }", "initial.water_level=15", "limits.sliding=0.1",
                 "loads.held={ boundary = \"front\", kind = \"force\", pulse = { shape = \"step\", peak = 0.6e6 } }",
                 "loads.impulse.pulse={ shape = \"harmonic\", peak = 1.5e6, frequency = 0.5 }", "time.end=6")
        found = self.ask("run", *nodes)
        self.assertNotEqual(found["contact"]["solved"]["slip"], 0)
        self.assertIn("still slipped", found["sliding"]["design"]["why_not_all"])

    def test_a_rebound_is_no_check_of_the_landward_direction(self):
        for way, why in (("[1, 0]", False), ("[-1, 0]", True)):
            checks = self.ask("run", f"loads.impulse.direction={way}")["checks"]
            check = next(check for check in checks if check["name"] == "force against friction")
            self.assertEqual(bool(check["why_not"]), why, check)

    def test_loads_that_come_through_the_ground_are_judged_in_motion(self):
        """A load on the bed is no load on the caisson: its uplift, its p_e without motion and its seaward side are unknown."""
        bed = 'loads.impulse={ boundary = "bed", kind = "pressure", over_x = true, shape = [[-60, 1], [-12, 1], [-11, 0]], ' \
              'pulse = { shape = "half_sine", peak = 1e5, duration = 0.3 } }'
        found = self.ask("run", bed, "sliding.uplift={ kind = \"prescribed\", peak = 8e5 }", "limits.base_pressure=4e5")
        self.assertIn("uplift_left_out", {warning["name"] for warning in found["warnings"]})
        checks = {check["name"]: check for check in found["checks"]}
        self.assertIsNotNone(checks["heel pressure p_e of the loads"]["why_not"])
        self.assertIsNone(checks["force against friction, seaward"]["why_not"])

    def test_circles_of_a_march_do_not_hold_by_still_water(self):
        """The march keeps no pore pressure of its times: what holds without it is not checked, what fails fails."""
        strength = [f"regions.{name}.strength={{ friction_angle = {angle}, cohesion = 5e3 }}" for name, angle in (("seabed", 35), ("mound", 40))]
        for limit, why in ((0.05, True), (50.0, False)):
            found = self.ask("run", "time.scheme=\"sdirk4\"", f"limits.circles={limit}", "initial.water_level=15", *strength)
            check = next(check for check in found["checks"] if check["name"] == "slip circles")
            self.assertEqual(bool(check["why_not"]), why, check)


if __name__ == "__main__":
    main()
