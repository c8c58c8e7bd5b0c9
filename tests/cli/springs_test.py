#!/usr/bin/python3
"""A caisson on springs and dashpots in place of ground: a lumped model of three degrees of freedom.

usage: springs_test.py PROGRAM CASES_FOLDER

The answers come from the matrix exponential of the three equations of motion, written here once more, between the
kinks of the load; slip from the explicit steps of postprocess/measured/lumped_slip.py.
"""

import json
import re
import sys

import h5py
import numpy as np
import scipy.linalg

from program import CASES, ProgramTest, main, upbead, with_keys

sys.path.insert(0, str(CASES.parent / "postprocess"))

MASS, INERTIA, CENTRE = 2.0e5, 6.0e6, (0.4, 5.0)  # kg/m, kg m2/m, m
WIDTH, HEIGHT = 10.0, 12.0
SPRINGS, DASHPOTS = (2.0e8, 3.5e8, 5.0e9), (2.0e6, 3.0e6, 4.0e7)
AT, DIRECTION, PEAK, RISE, FALL, END = (0.0, 8.0), (1.0, 0.3), 1.0e6, 0.05, 0.15, 0.8

CASE = f"""
gravity = 9.81
[mesh]
geometry = "caisson"
parameters = {{ caisson_width = {WIDTH}, caisson_height = {HEIGHT} }}
[regions.caisson]
kind = "rigid"
mass = {MASS}
moment_of_inertia = {INERTIA}
centre_of_gravity = [{CENTRE[0]}, {CENTRE[1]}]
springs = {{ horizontal = {SPRINGS[0]}, vertical = {SPRINGS[1]}, rotation = {SPRINGS[2]} }}
dashpots = {{ horizontal = {DASHPOTS[0]}, vertical = {DASHPOTS[1]}, rotation = {DASHPOTS[2]} }}
[boundaries]
front = {{}}
back = {{}}
top = {{}}
bottom = {{}}
[loads.push]
region = "caisson"
at = [{AT[0]}, {AT[1]}]
direction = [{DIRECTION[0]}, {DIRECTION[1]}]
history = "push.csv"
[time]
end = {END}
[accuracy]
tolerance = 1e-5
"""
PUSH = f"time,force\n0,0\n{RISE},{PEAK}\n{FALL},0\n{END},0\n"
MIDDLE = (0.0, 0.0)  # of the base


def base_motions():
    """Rows e of the base's motions over (x_G, y_G, phi), phi turning the top landward."""
    return np.array([[1, 0, MIDDLE[1] - CENTRE[1]], [0, 1, -(MIDDLE[0] - CENTRE[0])], [0, 0, 1]])


def matrices():
    e = base_motions()
    return np.diag([MASS, MASS, INERTIA]), e.T @ np.diag(DASHPOTS) @ e, e.T @ np.diag(SPRINGS) @ e


def load_vector():
    turning = DIRECTION[0] * (AT[1] - CENTRE[1]) - DIRECTION[1] * (AT[0] - CENTRE[0])
    return np.array([DIRECTION[0], DIRECTION[1], turning])


def exact(times):
    """Displacements and velocities at these times: of x' = A x + b f with f straight between kinks, by an exponential."""
    M, C, K = matrices()
    A = np.zeros((8, 8))  # x, x', f, f'
    A[:3, 3:6] = np.eye(3)
    A[3:6, :3], A[3:6, 3:6] = -np.linalg.solve(M, K), -np.linalg.solve(M, C)
    A[3:6, 6] = np.linalg.solve(M, load_vector())
    A[6, 7] = 1.0
    kinks, slopes = [0.0, RISE, FALL, np.inf], [PEAK / RISE, -PEAK / (FALL - RISE), 0.0]
    found, state = [], np.zeros(8)
    starts = []
    for i, slope in enumerate(slopes):
        state[7] = slope
        starts.append(state.copy())
        if np.isfinite(kinks[i + 1]):
            state = scipy.linalg.expm(A * (kinks[i + 1] - kinks[i])) @ state
    for t in times:
        i = int(np.searchsorted(kinks, t, side="right")) - 1
        found.append(scipy.linalg.expm(A * (t - kinks[i])) @ starts[i])
    return np.array(found)


class Springs(ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "case.toml").write_text(CASE)
        (self.folder / "push.csv").write_text(PUSH)

    def told(self, command, *keys, case="case.toml"):
        return self.json_of(command, case, *keys)

    def refused(self, *keys, case="case.toml", command="run"):
        done = upbead(command, case, *with_keys(keys), cwd=self.folder)
        self.assertEqual(done.returncode, 1, done.stdout)
        return " ".join(done.stderr.split())

    def histories(self):
        with h5py.File(self.folder / "out/results.h5") as file:
            return {name: file["history"][name][:] for name in ("time", "shear_force", "normal_force", "base_moment", "shear_force_by_inertia")} | {
                name: file["history/caisson"][name][:] for name in ("displacement_x", "displacement_y", "rotation", "velocity_x")
            }

    def assert_near(self, found, wanted, what, tolerance=1e-6):
        self.assertLess(np.abs(found - wanted).max(), tolerance * np.abs(wanted).max(), what)

    def compare(self, tolerance=1e-6, marched=False):
        found = self.histories()
        x = exact(found["time"])
        e = base_motions()
        base, rate = x[:, :3] @ e.T, x[:, 3:6] @ e.T
        forces = base * SPRINGS + rate * DASHPOTS
        inexact = {"shear_force_by_inertia"} if marched else set()  # by the acceleration of the scheme
        for name, wanted in {"displacement_x": x[:, 0], "displacement_y": x[:, 1], "rotation": x[:, 2], "velocity_x": x[:, 3], "shear_force": forces[:, 0],
                             "shear_force_by_inertia": forces[:, 0], "normal_force": -forces[:, 1], "base_moment": forces[:, 2]}.items():  # fmt: skip
            self.assert_near(found[name], wanted, name, 1e-3 if name in inexact else tolerance)
        return forces

    def test_a_reduced_model_is_the_closed_form(self):
        summary = self.told("run")
        self.assertIsNotNone(summary["reduction"])
        forces = self.compare()
        self.assertAlmostEqual(summary["response"]["peak_shear"] / forces[:, 0].max(), 1, delta=1e-5)

    def test_marches_are_the_closed_form(self):
        for scheme, step, tolerance in (("sdirk4", 1e-3, 1e-6), ("generalised_alpha", 1e-4, 2e-5)):
            self.told("run", f"time.scheme={scheme}", f"time.step={step}")
            self.compare(tolerance, marched=True)

    def test_periods_are_eigenvalues(self):
        summary = self.told("run", 'time.scheme="reduced"')
        M, C, K = matrices()
        A = np.block([[np.zeros((3, 3)), np.eye(3)], [-np.linalg.solve(M, K), -np.linalg.solve(M, C)]])
        poles = [p for p in np.linalg.eigvals(A) if p.imag > 0]
        wanted = sorted((2 * np.pi / p.imag, -p.real / abs(p)) for p in poles)
        found = sorted((p["period"], p["damping_ratio"]) for p in summary["periods"])
        self.assertGreaterEqual(len(found), 2)
        for period, damping in found:
            nearest = min(wanted, key=lambda pair: abs(pair[0] - period))
            self.assertAlmostEqual(period / nearest[0], 1, delta=1e-6)
            self.assertAlmostEqual(damping / nearest[1], 1, delta=1e-6)

    def test_water_beside_it_adds_its_mass(self):
        """One degree of freedom: sway beside two seas, 0.5428 rho h^2 each (rigid wall, incompressible water: Westergaard's problem)."""
        stiff = {"horizontal": SPRINGS[0], "vertical": 1e15, "rotation": 1e17}
        depth, density = 8.0, 1030.0
        extra = "\n[fluid]\nbulk_modulus = inf\n"
        for side in ("front", "back"):
            extra += f"[regions.sea_{side}]\nkind = 'water'\n"
        extra += "[boundaries.bed]\npressure = 'sealed'\n[boundaries.sea_surface]\npressure = 'open'\n"
        extra += "[boundaries.sea_left]\npressure = 'sealed'\n[boundaries.sea_right]\npressure = 'sealed'\n"
        (self.folder / "wet.toml").write_text(CASE + extra)
        summary = self.told("run", f"mesh.parameters.water_depth={depth}", "mesh.parameters.sea_front=4", "mesh.parameters.sea_back=4",
                            *(f"regions.caisson.springs.{key}={value}" for key, value in stiff.items()), 'time.scheme="reduced"', case="wet.toml")  # fmt: skip
        zeta_3 = 1.2020569031595942
        added = 2 * 16 * 7 * zeta_3 / 8 / np.pi**3 * density * depth**2
        undamped = 2 * np.pi * np.sqrt((MASS + added) / SPRINGS[0])
        first = max(summary["periods"], key=lambda p: p["share"])
        self.assertAlmostEqual(first["period"] * np.sqrt(1 - first["damping_ratio"] ** 2) / undamped, 1, delta=2e-3)

    def stiff_but_in_sway(self):
        return ["regions.caisson.springs.vertical=1e15", "regions.caisson.springs.rotation=1e17", 'time.scheme="reduced"']

    def undamped_first(self, summary):
        first = max(summary["periods"], key=lambda p: p["share"])
        return first["period"] * np.sqrt(1 - first["damping_ratio"] ** 2)

    def test_added_mass_in_sway_is_westergaards(self):
        """7/12 rho h^2 on each side, and within the 4 % of the period by which it differs from 0.5428 rho h^2 of water that is meshed."""
        depth, density = 8.0, 1030.0
        walls = [f"regions.caisson.added_mass={{seaward={depth}, landward={depth}}}"]
        found = self.undamped_first(self.told("run", *walls, *self.stiff_but_in_sway()))
        self.assertAlmostEqual(found / (2 * np.pi * np.sqrt((MASS + 2 * 7 / 12 * density * depth**2) / SPRINGS[0])), 1, delta=1e-6)

        def period(factor):
            return np.sqrt(MASS + 2 * factor * density * depth**2)

        wet = CASE + "\n[fluid]\nbulk_modulus = inf\n[regions.sea_front]\nkind = 'water'\n[regions.sea_back]\nkind = 'water'\n[boundaries.bed]\npressure = 'sealed'\n"
        wet += "[boundaries.sea_surface]\npressure = 'open'\n[boundaries.sea_left]\npressure = 'sealed'\n[boundaries.sea_right]\npressure = 'sealed'\n"
        (self.folder / "wet.toml").write_text(wet)
        meshed = self.undamped_first(self.told("run", f"mesh.parameters.water_depth={depth}", "mesh.parameters.sea_front=4", "mesh.parameters.sea_back=4",
                                               *self.stiff_but_in_sway(), case="wet.toml"))  # fmt: skip
        self.assertAlmostEqual(found / meshed, period(7 / 12) / period(0.542755), delta=2e-3)
        self.assertAlmostEqual(found / meshed, 1, delta=0.04)

    def test_added_mass_is_that_of_a_heavier_caisson(self):
        """The mass, its first and second moment about the base, 7/12 rho h^2, 7/30 rho h^3, 2/15 rho h^4, in the caisson itself: the same motion of the base,
        the same forces on it and the same slip under a horizontal load, as nothing then moves vertically."""
        seaward, landward, density, centre = 8.0, 6.5, 1030.0, 5.0
        mass, first, second = (sum(c * density * h**power for h in (seaward, landward)) for c, power in ((7 / 12, 2), (7 / 30, 3), (2 / 15, 4)))
        whole, moment = MASS + mass, MASS * centre + first
        inertia = INERTIA + MASS * centre**2 + second - moment**2 / whole
        level = ["loads.push.direction=[1.0, 0.0]", "loads.push.factor=1.6", "time.step=5e-4"]
        slides = ["sliding.friction=0.6", f"sliding.submerged_weight={0.6 * 9.81 * MASS}"]
        light = [f"regions.caisson.centre_of_gravity=[0.0, {centre}]", f"regions.caisson.added_mass={{seaward={seaward}, landward={landward}}}"]
        heavy = [f"regions.caisson.{key}={value!r}" for key, value in (("mass", whole), ("moment_of_inertia", inertia), ("centre_of_gravity", [0.0, moment / whole]))]
        for way, tolerance in (("reduced", 1e-8), ("sdirk4", 1e-8)):
            with self.subTest(way):
                keys = [*level, f'time.scheme="{way}"', "output.periods=true"]
                wanted, exact = self.told("run", *keys, *heavy), self.histories()
                told, found = self.told("run", *keys, *light), self.histories()
                steps = np.arange(0, END, 5e-4)  # between these each has times of its own, those of extremes
                here, there = (np.searchsorted(of["time"], steps - 1e-9) for of in (found, exact))
                self.assertLess(np.abs(found["time"][here] - exact["time"][there]).max(), 1e-9)
                for name in ("shear_force", "base_moment", "shear_force_by_inertia"):
                    self.assert_near(found[name][here], exact[name][there], name, tolerance if name != "shear_force_by_inertia" or way == "reduced" else 1e-3)
                self.assertEqual(len(told["periods"]), len(wanted["periods"]))
                for one, other in zip(told["periods"], wanted["periods"], strict=True):
                    self.assertAlmostEqual(one["period"] / other["period"], 1, delta=1e-8)
        one, other = (self.told("run", *level, *slides, *which)["sliding"]["sliding_coupled"] for which in (light, heavy))
        self.assertGreater(other, 1e-3)
        self.assertAlmostEqual(one / other, 1, delta=1e-6)

    def test_on_ground_it_stands_for_the_sea(self):
        """Fig. 2b, 9 m of water beside the caisson: the first period and F_T/P within 2 % of those with meshed seas, from 4 and 9 % without them."""
        case = CASES / "fig2b-prototype.toml"
        dry = ["mesh.parameters.sea_front=0", "mesh.parameters.sea_back=0"]
        water = "regions.caisson.added_mass={seaward=9, landward=9}"
        meshed, none, mass = (self.told("run", "mesh.parameters.cells=0.5", 'time.scheme="reduced"', *keys, case=case) for keys in ([], dry, [*dry, water]))

        def of(summary):
            return np.array([summary["periods"][0]["period"], summary["response"]["shear_to_force_ratio"]])

        self.assertLess(np.abs(of(mass) / of(meshed) - 1).max(), 0.02)
        self.assertGreater(np.abs(of(none) / of(meshed) - 1).min(), 0.04)

    def test_the_force_of_added_water_is_told(self):
        """P + P_water - m x'' = F_T with the caisson's own m: P_water is what the water's mass takes, of its front its part."""
        walls = ["regions.caisson.added_mass.seaward=8.0", "regions.caisson.added_mass.landward=8.0", "regions.caisson.centre_of_gravity=[0.0, 5.0]", "loads.push.direction=[1.0, 0.0]"]
        self.told("run", *walls, 'time.scheme="reduced"')
        with h5py.File(self.folder / "out/results.h5") as file:
            history = {name: file["history"][name][:] for name in ("force", "shear_force", "water_force", "water_force_front", "inertia_force")}
        largest = np.abs(history["force"]).max()
        self.assert_near(history["inertia_force"], history["force"] + history["water_force"] - history["shear_force"], "balance", 1e-9)
        self.assert_near(2 * history["water_force_front"], history["water_force"], "front", 1e-9)
        self.assertGreater(np.abs(history["water_force"]).max(), 0.05 * largest)

    def test_added_mass_that_cannot_be_is_refused(self):
        for key, told in {
            "regions.caisson.added_mass.seaward=13": "higher than the caisson's walls, 12 m",
            "regions.caisson.added_mass.seaward=-1": "outside",
        }.items():
            self.assertIn(told, self.refused(key))
        wet = CASE.replace("[boundaries]", "[regions.sea_front]\nkind = 'water'\n[boundaries]")
        wet += "[boundaries.bed]\npressure = 'sealed'\n[boundaries.sea_surface]\npressure = 'open'\n[boundaries.sea_left]\npressure = 'sealed'\n"
        (self.folder / "wet.toml").write_text(wet)
        keys = ["mesh.parameters.water_depth=8", "mesh.parameters.sea_front=4", "regions.caisson.added_mass.landward=5"]
        self.told("run", *keys, case="wet.toml")  # the harbour's water alone is not meshed
        refused = self.refused(*keys, "regions.caisson.added_mass.seaward=8", case="wet.toml")
        self.assertIn("'sea_front' on that side is meshed: its mass would count twice", refused)
        self.assertIn("write seaward = 0", refused)

    def test_steps_of_a_march_have_the_added_mass(self):
        """The apparent period, by which a march chooses its steps: in sway alone, without dashpots, that of (m + 7/12 rho h^2)/k."""
        keys = [*self.stiff_but_in_sway()[:2], "regions.caisson.dashpots.horizontal=0", 'time.scheme="sdirk4"', "loads.push.direction=[1.0, 0.0]"]
        for depth in (0.0, 11.0):
            why = self.told("run", *keys, f"regions.caisson.added_mass.seaward={depth}")["discretisation"]["why_step"]
            wanted = 2 * np.pi * np.sqrt((MASS + 7 / 12 * 1030.0 * depth**2) / SPRINGS[0])
            self.assertAlmostEqual(float(re.search("apparent period ([0-9.]+) s", why)[1]) / wanted, 1, delta=1e-3)

    def test_the_end_of_a_run_has_the_added_mass(self):
        """Three periods by Dunkerley's rule after the load, J about the base with Westergaard's 2/15 rho h^4."""
        (self.folder / "open.toml").write_text(CASE.replace(f"end = {END}", ""))
        depth, density = 11.0, 1030.0
        for water in (0.0, depth):
            done = upbead("run", "open.toml", "--details", *with_keys([f"regions.caisson.added_mass={{seaward={water}, landward={water}}}"]), cwd=self.folder)
            period = float(re.search("three times the section's own period is ([0-9.]+) s", " ".join(done.stdout.split()))[1]) / 3
            mass = MASS + 2 * 7 / 12 * density * water**2
            inertia = MASS * (HEIGHT**2 + (WIDTH / 2) ** 2) / 3 + 2 * 2 / 15 * density * water**4
            self.assertAlmostEqual(period / (2 * np.pi * np.sqrt(mass / SPRINGS[0] + inertia / SPRINGS[2])), 1, delta=5e-3)

    def test_slip_as_a_whole_is_friction_in_series(self):
        from measured.lumped_slip import Caisson, slip

        centred = ["regions.caisson.centre_of_gravity=[0.0, 5.0]", "loads.push.direction=[1.0, 0.0]", "loads.push.factor=1.6"]
        weight = 0.6 * 9.81 * MASS
        sliding = ["sliding.friction=0.6", f"sliding.submerged_weight={weight}"]
        summary = self.told("run", *centred, *sliding)
        time = np.array([0, RISE, FALL, END])
        model = Caisson(MASS, INERTIA + MASS * 25.0, 5.0, weight, 0.6, SPRINGS, DASHPOTS)
        _, slips = slip(model, time, 1.6 * PEAK * np.array([0, 1, 0, 0]), AT[1], np.zeros(4), np.zeros(4))
        self.assertGreater(slips[-1], 1e-3)
        self.assertAlmostEqual(summary["sliding"]["sliding_coupled"] / slips[-1], 1, delta=5e-3)

    def test_a_model_file_answers_waves_as_a_run_does(self):
        done = upbead("reduce", "case.toml", "--out", "model", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        (self.folder / "wave.csv").write_text(PUSH.replace("force", "push"))
        done = upbead("respond", "model/reduced.h5", "wave.csv", "--json", "--out", "answer", cwd=self.folder)
        self.assertIn(done.returncode, (0, 3), done.stderr)
        answer = json.loads(done.stdout)["waves"][0]
        self.assertAlmostEqual(answer["peak_shear"] / self.told("run")["response"]["peak_shear"], 1, delta=1e-4)
        self.assertIn("no soil is under it", self.refused_command("reduce", "case.toml", "--soils", "box.toml", "--out", "soils"))

    def refused_command(self, *arguments):
        (self.folder / "box.toml").write_text('[vary."regions.caisson.springs.horizontal"]\ndistribution = "uniform"\nlow = 1e8\nhigh = 3e8\n')
        done = upbead(*arguments, cwd=self.folder)
        self.assertEqual(done.returncode, 1, done.stdout)
        return " ".join(done.stderr.split())

    def test_what_asks_for_ground_is_refused(self):
        for key, told in {
            'regions.caisson.interface={kind="friction"}': "springs at its middle do not lift from its edges",
            "output.base=true": "the stress along the base is that of the ground's nodes",
            "limits.circles=1.0": "slip circles pass through ground",
            "limits.liquefaction=1.0": "it is the ground that liquefies",
            "time.inertia=false": "F_T = P",
            'mesh.refine="auto"': "there is no ground whose cells it could split",
            "regions.caisson.springs.rotation=0": "outside",
        }.items():
            with self.subTest(key):
                self.assertIn(told, self.refused(key))
        self.assertIn("dashpots are given without springs", self.refused_text(CASE.replace("springs = {", "# springs = {")))
        ground = (CASES / "fig2b-prototype.toml").read_text().replace("[regions.caisson]", "[regions.caisson]\nsprings = { horizontal = 1e8, vertical = 1e8, rotation = 1e10 }")
        for csv in CASES.glob("fig2b-prototype*.csv"):
            (self.folder / csv.name).write_bytes(csv.read_bytes())
        self.assertIn("the caisson stands on 'mound' and on springs", self.refused_text(ground))
        self.assertIn("only the caisson may stand on springs", self.refused_text(CASE.replace("[regions.caisson]", "[regions.block]").replace('"caisson"\nat', '"block"\nat')))

    def refused_text(self, text):
        (self.folder / "other.toml").write_text(text)
        return self.refused(case="other.toml")

    def test_a_unit_that_was_mistaken_is_told(self):
        summary = self.told("run", "regions.caisson.springs.rotation=5e6")
        told = [w["text"] + w["cure"] for w in summary["warnings"] if w["name"] == "implausible"]
        self.assertTrue(any("regions.caisson.springs.rotation" in text and "kN" in text for text in told), told)

    def test_a_scaled_case_is_not_warned_of_numbers_that_it_does_not_use(self):
        upbead("scale", "case.toml", "--factor", "0.05", "--out", "small", cwd=self.folder)
        done = upbead("explain", "small/case.toml", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        for key in ("fluid.viscosity", "fluid.atmospheric_pressure"):
            self.assertNotIn(key, done.stderr)

    def test_scaled_by_froude_it_swings_alike(self):
        done = upbead("scale", "case.toml", "--factor", "0.05", "--out", "model", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        large, small = self.told("run"), self.told("run", case="model/case.toml")
        self.assertAlmostEqual(small["periods"][0]["period"] / large["periods"][0]["period"] / np.sqrt(0.05), 1, delta=1e-6)
        self.assertAlmostEqual(small["response"]["shear_to_force_ratio"] / large["response"]["shear_to_force_ratio"], 1, delta=1e-6)


if __name__ == "__main__":
    main()
