#!/usr/bin/python3
"""Drag of pore water that grows with its velocity: forchheimer, i = w/k + b |w| w.

usage: drag_test.py PROGRAM CASES_FOLDER

Water that flows through a column of stiff stones, from a pressure on its top to its open base: one velocity everywhere. Steady flow has a root of a
quadratic equation; where it swings, a w' + rho g (1/k + b 8/(3 pi) W) w = p_0/L for the amplitude W, by Lorentz's equal energy; the equation with |w| w
itself is integrated in steps.
"""

import h5py
import numpy as np

from program import CASES, ProgramTest, main, upbead, with_keys

LENGTH, POROSITY, K, B, PEAK, FREQUENCY, CYCLES = 2.0, 0.4, 0.2, 40.0, 1.0e4, 0.5, 6
RHO, G = 1000.0, 9.81
CASE = f"""
gravity = {G}
[fluid]
density = {RHO}
bulk_modulus = 2.2e12
[mesh]
geometry = "column"
parameters = {{ height = {LENGTH}, width = 0.5, cells = 8 }}
[regions.soil]
kind = "porous"
shear_modulus = 1e12
poissons_ratio = 0.3
porosity = {POROSITY}
grain_density = 2650.0
hydraulic_conductivity = {K}
forchheimer = {B}
[boundaries]
base = {{ displacement = "fixed", pressure = "open" }}
left = {{ displacement = "roller", pressure = "sealed" }}
right = {{ displacement = "roller", pressure = "sealed" }}
top = {{ displacement = "free", pressure = "open" }}
"""
SWINGS = f"""
[loads.wave]
boundary = "top"
kind = "pressure"
pulse = {{ shape = "harmonic", peak = {PEAK}, frequency = {FREQUENCY} }}
[probes.middle]
at = [0.25, {LENGTH / 2}]
[time]
end = {CYCLES / FREQUENCY}
step = {1 / FREQUENCY / 80}
scheme = "sdirk4"
"""
STEADY = """
[loads.head]
boundary = "top"
kind = "pressure"
history = "head.csv"
[time]
inertia = false
end = 10
"""


def lorentz(b):
    """The amplitude of w with the drag b |w| w made linear."""
    omega, W = 2 * np.pi * FREQUENCY, 0.1
    for _ in range(200):
        W = 0.5 * W + 0.5 * PEAK / LENGTH / abs(RHO * G * (1 / K + b * 8 / (3 * np.pi) * W) + 1j * omega * RHO / POROSITY)
    return W


def integrated(b, steps=20000):
    """The largest w of the last swing, by the equation with |w| w (Runge and Kutta's steps)."""
    h, w, last = CYCLES / FREQUENCY / steps, 0.0, []

    def rate(t, w):
        return (PEAK / LENGTH * np.sin(2 * np.pi * FREQUENCY * t) - RHO * G * (w / K + b * abs(w) * w)) * POROSITY / RHO

    for n in range(steps):
        t = n * h
        k1 = rate(t, w)
        k2 = rate(t + h / 2, w + h / 2 * k1)
        k3 = rate(t + h / 2, w + h / 2 * k2)
        k4 = rate(t + h, w + h * k3)
        w += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        if t > (CYCLES - 1) / FREQUENCY:
            last.append(w)
    return max(last)


class Drag(ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "swings.toml").write_text(CASE + SWINGS)
        (self.folder / "weighs.toml").write_text(CASE + '[loads.weight]\nkind = "gravity"\nhistory = "head.csv"\n[time]\nend = 1\n')
        (self.folder / "steady.toml").write_text(CASE + STEADY)
        (self.folder / "head.csv").write_text(f"time,pressure\n0,0\n0.02,{PEAK}\n10,{PEAK}\n")

    def test_steady_flow_is_a_root(self):
        """i = w/k + b w^2, and the conductivity at it."""
        i = PEAK / (RHO * G * LENGTH)
        for b in (4.0, B, 400.0):
            w = (np.sqrt(1 / K**2 + 4 * b * i) - 1 / K) / (2 * b)
            soil = self.json_of("run", "steady.toml", f"regions.soil.forchheimer={b}")["soil"]
            self.assertTrue(soil["converged"])
            self.assertAlmostEqual(soil["largest_velocity"] / w, 1, delta=1e-2)
            self.assertAlmostEqual(soil["least_conductivity_ratio"] * (1 + b * K * w), 1, delta=1e-2)

    def test_flow_that_swings_is_lorentz(self):
        for b in (4.0, B, 400.0):
            told = self.json_of("run", "swings.toml", f"regions.soil.forchheimer={b}")
            with h5py.File(self.folder / "out/results.h5") as file:
                time, w = file["history/time"][:], file["history/probes/middle/darcy_velocity_y"][:]
            amplitude = np.abs(w[time > (CYCLES - 1) / FREQUENCY]).max()
            self.assertTrue(told["soil"]["converged"])
            self.assertAlmostEqual(amplitude / lorentz(b), 1, delta=1e-2)
            self.assertAlmostEqual(told["soil"]["largest_velocity"] / (8 / (3 * np.pi) * amplitude), 1, delta=1e-2)
            self.assertAlmostEqual(amplitude / integrated(b), 1, delta=0.1)  # what it costs to be linear
        self.assertLess(lorentz(B) / lorentz(0), 0.8)

    def test_without_it_nothing_changes(self):
        told = self.json_of("run", "swings.toml", "regions.soil.forchheimer=1e-9")
        with h5py.File(self.folder / "out/results.h5") as file:
            with_it = file["history/probes/middle/darcy_velocity_y"][:]
        self.assertLess(abs(told["soil"]["least_conductivity_ratio"] - 1), 1e-8)
        (self.folder / "plain.toml").write_text((CASE + SWINGS).replace(f"forchheimer = {B}\n", ""))
        self.assertIsNone(self.json_of("run", "plain.toml")["soil"])
        with h5py.File(self.folder / "out/results.h5") as file:
            without = file["history/probes/middle/darcy_velocity_y"][:]
        self.assertLess(np.abs(with_it - without).max(), 1e-8 * np.abs(without).max())

    def test_soil_that_yields_beside_it_is_not_softened_by_its_strain(self):
        keys = ["mesh.parameters.cells=0.25", "time.end=0.15", "regions.mound.forchheimer=2", "regions.seabed.law='hysteretic'",
                "regions.seabed.strain={reference_strain=5e-4}"]
        soil = self.json_of("run", CASES / "fig2b-prototype.toml", *keys)["soil"]
        self.assertEqual((soil["least_modulus_ratio"], soil["largest_strain"], soil["largest_damping"]), (1, 0, 0))
        self.assertLess(soil["least_conductivity_ratio"], 1)

    def test_what_cannot_have_it_is_refused(self):
        for command, case, keys, told in (
            ("run", "swings.toml", ["regions.soil.flow='drained'"], "leaves out the pore water"),
            ("run", "swings.toml", ["regions.soil.forchheimer=-1"], "outside"),
            ("run", "swings.toml", ["regions.soil.conductivity_ratio=0.5"], "alike in all directions"),
            ("run", "weighs.toml", [], "leaves out the weight of its water"),
            ("reduce", CASES / "fig2b-prototype.toml", ["regions.mound.forchheimer=2"], "every wave has a drag of its own"),
            ("run", CASES / "fig2b-prototype.toml", ["regions.caisson.forchheimer=2"], "in porous regions"),
        ):
            with self.subTest(told):
                done = upbead(command, case, *with_keys(keys), cwd=self.folder)
                self.assertEqual(done.returncode, 1, done.stdout)
                self.assertIn(told, " ".join(done.stderr.split()))


if __name__ == "__main__":
    main()
