#!/usr/bin/python3
"""A caisson of parts with densities of their own, and a parapet with its wall.

usage: body_parts_test.py PROGRAM CASES_FOLDER

Masses, centres and moments of inertia are written here once more, from rectangles.
"""

import h5py
import numpy as np

from program import CASES, ProgramTest, main, upbead, with_keys

FIG_2B = CASES / "fig2b-prototype.toml"
COARSE = ["mesh.parameters.cells=0.5", "mesh.parameters.caisson_height=16"]
MARCH = ['time.scheme="sdirk4"', "time.step=0.0125", "time.end=0.6"]
BASE, WIDTH, HEIGHT = 6.0, 18.0, 16.0  # y of the caisson's bottom, its size (m)

SPRINGS = """
[mesh]
geometry = "caisson"
parameters = {{ caisson_width = 10, caisson_height = 12, parapet_width = {width}, parapet_height = 3 }}
[regions.caisson]
kind = "rigid"
density = 2000
springs = {{ horizontal = {spring}, vertical = 1e15, rotation = 1e17 }}
[boundaries]
front = {{}}
back = {{}}
top = {{}}
bottom = {{}}
[loads.push]
boundary = "front"
kind = "normal"
pulse = {{ shape = "triangle", peak = 1e4, duration = 0.2 }}
[time]
end = 1
scheme = "reduced"
"""


def part(name, x, y, density):
    return f"regions.caisson.parts.{name}={{x=[{x[0]}, {x[1]}], y=[{y[0]}, {y[1]}], density={density}}}"


def body(*blocks):
    """Mass, centre and moment of inertia of (x, y, density) beside each other."""
    area = [(x[1] - x[0]) * (y[1] - y[0]) for x, y, _ in blocks]
    mass = [a * density for a, (_, _, density) in zip(area, blocks, strict=True)]
    at = np.array([[sum(x) / 2, sum(y) / 2] for x, y, _ in blocks])
    centre = np.average(at, axis=0, weights=mass)
    own = [((x[1] - x[0]) ** 2 + (y[1] - y[0]) ** 2) / 12 for x, y, _ in blocks]
    return sum(mass), centre, sum(m * (i + d @ d) for m, i, d in zip(mass, own, at - centre, strict=True))


def as_one(*blocks):
    mass, centre, inertia = body(*blocks)
    return f"regions.caisson={{kind='rigid', mass={mass!r}, centre_of_gravity=[{centre[0]!r}, {centre[1]!r}], moment_of_inertia={inertia!r}}}"


class BodyParts(ProgramTest):
    def solved(self, *keys, case=FIG_2B):
        """Summary and histories of the march, at the ends of 48 steps: between them each has times of its own, those of extremes."""
        summary = self.json_of("run", case, *COARSE, *keys)
        with h5py.File(self.folder / "out/results.h5") as file:
            whole = {name: file["history"][name][:] for name in ("time", "shear_force", "normal_force", "base_moment")}
        at = [int(np.abs(whole["time"] - time).argmin()) for time in np.arange(0, 0.6, 0.0125)]
        return summary, {name: values[at] for name, values in whole.items()}

    def assert_same(self, found, wanted, tolerance=1e-12, sign=None):
        np.testing.assert_allclose(found["time"], wanted["time"], atol=1e-9)
        for name in ("shear_force", "normal_force", "base_moment"):
            factor = (sign or {}).get(name, 1)
            scale = np.abs(wanted[name]).max() or 1
            self.assertLess(np.abs(found[name] - factor * wanted[name]).max(), tolerance * max(scale, np.abs(wanted["shear_force"]).max()), name)

    def test_a_caisson_in_two_parts_is_the_whole(self):
        """F_T, S and periods of a caisson, of the same one whose upper quarter is a parapet as wide as it, and of one whose densities are those of two parts."""
        parapet = ["mesh.parameters.caisson_height=12", "mesh.parameters.parapet_height=4", f"mesh.parameters.parapet_width={WIDTH}"]
        halves = ["regions.caisson.density=1500", part("low", (-9, 9), (6, 15), 2100), part("high", (-9, 9), (15, 22), 2100)]
        slides = ["loads.impulse.factor=5"]
        summary, whole = self.solved(*MARCH, *slides)
        self.assertGreater(summary["sliding"]["sliding_coupled"], 1e-3)
        reduced = self.json_of("run", FIG_2B, *COARSE, 'time.scheme="reduced"')["periods"]
        for keys in (parapet, halves):
            with self.subTest(keys):
                told, found = self.solved(*MARCH, *slides, *keys)
                self.assert_same(found, whole)
                self.assertAlmostEqual(told["sliding"]["sliding_coupled"] / summary["sliding"]["sliding_coupled"], 1, delta=1e-9)
                self.assertAlmostEqual(told["sliding"]["design"]["value"] / summary["sliding"]["design"]["value"], 1, delta=1e-9)
                other = self.json_of("run", FIG_2B, *COARSE, 'time.scheme="reduced"', *keys)["periods"]
                self.assertEqual(len(other), len(reduced))
                for one, period in zip(other, reduced, strict=True):
                    self.assertAlmostEqual(one["period"] / period["period"], 1, delta=1e-9)

    def test_a_parapet_is_its_mass_centre_and_inertia(self):
        """By densities of parts, and by numbers for the whole, on the same mesh; the wave presses on the parapet's wall, too."""
        mesh = ["mesh.parameters.parapet_height=4", "mesh.parameters.parapet_width=5"]
        blocks = [((-9, 9), (6, 22), 2100.0), ((-9, -4), (22, 26), 2300.0)]
        summary, found = self.solved(*MARCH, *mesh, part("parapet", (-9, -4), (22, 26), 2300))
        told, wanted = self.solved(*MARCH, *mesh, as_one(*blocks))
        self.assert_same(found, wanted)
        _, without = self.solved(*MARCH)
        self.assertGreater(np.abs(found["base_moment"]).max() / np.abs(without["base_moment"]).max(), 1.1)
        for one in (summary, told):
            self.assertAlmostEqual(one["loads"]["impulse"]["arm"], (HEIGHT + 4) / 2, delta=1e-9)  # uniform over the whole wall

    def test_weights_act_at_their_centre(self):
        """At rest, dry, on a level base: W' acts at the parts' centre, in the base's own numbers and in the stages of construction."""
        heavy = ((-9, -5), (6, 22), 4000.0)
        blocks = [heavy, ((-5, 9), (6, 22), 2100.0)]
        mass, centre, _ = body(*blocks)
        keys = ["initial.water_level=-20", "mesh.parameters.sea_front=0", "mesh.parameters.sea_back=0", f"sliding.submerged_weight={mass * 9.81!r}",
                "construction.all={order=1, regions=['seabed', 'mound', 'caisson']}"]  # fmt: skip
        heel = mass * 9.81 / WIDTH * (1 + 6 * centre[0] / WIDTH)
        for given in (part("heavy", *heavy), as_one(*blocks)):
            with self.subTest(given):
                told = self.json_of("run", FIG_2B, *COARSE, *keys, given)
                self.assertAlmostEqual(told["base"]["eccentricity_at_rest"] / centre[0], 1, delta=1e-9)
                self.assertAlmostEqual(told["base"]["heel_pressure_at_rest"] / heel, 1, delta=1e-9)
                self.assertAlmostEqual(told["construction"]["stages"][0]["heel_pressure"] / heel, 1, delta=1e-6)

    def test_mirrored_it_answers_mirrored(self):
        to_front = [part("fill", (-9, -5), (6, 22), 3000)]
        to_back = [part("fill", (5, 9), (6, 22), 3000), "loads.impulse.boundary='back'", "loads.impulse.direction=[-1, 0]"]
        _, one = self.solved(*MARCH, *to_front)
        _, other = self.solved(*MARCH, *to_back)
        self.assert_same(other, one, 1e-10, {"shear_force": -1, "base_moment": -1})

    def test_scaled_it_answers_scaled(self):
        self.json_of("run", FIG_2B, *COARSE, *MARCH, part("fill", (-9, -5), (6, 22), 3000))
        with h5py.File(self.folder / "out/results.h5") as file:
            whole = file["history/shear_force"][:]
        done = upbead("scale", self.folder / "out/case.toml", "--factor", "0.05", "--out", "model", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        (model,) = (self.folder / "model").glob("*.toml")
        self.assertIn("x = [-0.45, -0.25]", model.read_text())
        self.json_of("run", model)
        with h5py.File(self.folder / "out/results.h5") as file:
            small = file["history/shear_force"][:]
        self.assertLess(np.abs(small * 400 - whole).max(), 1e-8 * np.abs(whole).max())

    def test_nonsense_is_refused(self):
        fill = part("fill", (-9, -5), (6, 22), 3000)
        for keys, told in {
            (part("parapet", (-9, -4), (22, 26), 2300),): "it lies outside of 'caisson' as meshed",
            (part("parapet", (-9, -4), (20, 26), 2300),): "66.7 % of it lies outside of 'caisson' as meshed",
            (fill, part("other", (-6, 0), (10, 12), 3000)): "it overlaps with 'fill'",
            (part("fill", (-5, -9), (6, 22), 3000),): "its sides do not ascend",
            (part("fill", (-9, -5), (6, 22), 0),): "outside",
            (fill, "regions.caisson.centre_of_gravity=[0, 14]"): "those of the whole",
            (fill.replace("caisson", "mound"),): "in rigid regions",
            ("mesh.parameters.parapet_width=5",): "give both, or none",
            ("mesh.parameters.parapet_width=19", "mesh.parameters.parapet_height=4"): "hangs in the air",
        }.items():
            with self.subTest(told):
                done = upbead("run", FIG_2B, *with_keys([*COARSE, *keys]), cwd=self.folder)
                self.assertEqual(done.returncode, 1, done.stdout)
                self.assertIn(told, " ".join(done.stderr.split()))

    def test_on_springs_too(self):
        """geometry = "caisson": sway on a stiff base has the mass, and a pressure over the wall the arm, of a parapet on a part of the width and on all of it."""
        spring = 2e8
        for width in (4.0, 10.0):
            with self.subTest(width):
                (self.folder / "springs.toml").write_text(SPRINGS.format(width=width, spring=spring))
                told = self.json_of("run", "springs.toml", part("parapet", (-5, width - 5), (12, 15), 2500))
                mass = 2000 * 10 * 12 + 2500 * width * 3
                first = max(told["periods"], key=lambda period: period["share"])
                self.assertAlmostEqual(first["period"] / (2 * np.pi * np.sqrt(mass / spring)), 1, delta=1e-6)
                self.assertAlmostEqual(told["loads"]["push"]["moment"] / (15 * 7.5), 1, delta=1e-12)
                self.assertAlmostEqual(told["loads"]["push"]["arm"] / 7.5, 1, delta=1e-12)


if __name__ == "__main__":
    main()
