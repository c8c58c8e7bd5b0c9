#!/usr/bin/python3
"""Air in the pores by the absolute pressure at each cell's own depth: air_by_depth = true.

usage: air_test.py PROGRAM CASES_FOLDER

A column under a pressure that rises and falls as a sine, without inertia: with total stress p_0 at every depth, uniaxial strain (p - p_0)/M, the mass of
water is (S(y) + 1/M) i w p - i w p_0/M = k/(rho g) p'', S(y) = n (S_r/K_w + (1 - S_r)/(p_a + rho g (level - y))). It is solved here by differences.
"""

import h5py
import numpy as np
import scipy.linalg

from program import ProgramTest, main, upbead

HEIGHT, LEVEL, PERIOD, CYCLES = 10.0, 10.5, 9.0, 40
G, NU, POROSITY, CONDUCTIVITY, SATURATION, WATER, ATMOSPHERE = 12.7e6, 0.3, 0.4, 1e-3, 0.98, 2.2e9, 101325.0
HEIGHTS = {"z05": 9.5, "z1": 9.0, "z2": 8.0, "z4": 6.0, "z6": 4.0, "z10": 0.0}
PROBES = "".join(f"[probes.{name}]\nat = [0.05, {y}]\n" for name, y in HEIGHTS.items())
CASE = f"""
gravity = 9.81
[fluid]
density = 1000.0
bulk_modulus = {WATER}
[mesh]
geometry = "column"
parameters = {{ height = {HEIGHT}, width = 0.1, cells = 60, grading = 8 }}
[regions.soil]
kind = "porous"
shear_modulus = {G}
poissons_ratio = {NU}
porosity = {POROSITY}
grain_density = 2650.0
hydraulic_conductivity = {CONDUCTIVITY}
saturation = {SATURATION}
[initial]
water_level = {LEVEL}
[boundaries]
base = {{ displacement = "fixed", pressure = "sealed" }}
left = {{ displacement = "roller", pressure = "sealed" }}
right = {{ displacement = "roller", pressure = "sealed" }}
top = {{ displacement = "free", pressure = "open" }}
[loads.wave]
boundary = "top"
kind = "pressure"
pulse = {{ shape = "harmonic", peak = 1.0, frequency = {1 / PERIOD} }}
{PROBES}
[time]
inertia = false
end = {CYCLES * PERIOD}
step = {PERIOD / 100}
"""


def solution(points=20000):
    """p/p_0 at all heights, by central differences; symmetric about the base, where no water leaves."""
    w, h = 2 * np.pi / PERIOD, HEIGHT / points
    y = np.linspace(0, HEIGHT, points + 1)
    compressibility = (1 - 2 * NU) / (2 * G * (1 - NU))
    absolute = ATMOSPHERE + 1000 * 9.81 * (LEVEL - y)
    storage = POROSITY * (SATURATION / WATER + (1 - SATURATION) / absolute)
    c = CONDUCTIVITY / (1000 * 9.81) / h**2
    bands = np.zeros((3, points + 1), complex)
    bands[0, 1:], bands[2, :-1] = -c, -c
    bands[0, 1] = -2 * c
    bands[1] = 2 * c + 1j * w * (storage + compressibility)
    right = np.full(points + 1, 1j * w * compressibility)
    bands[1, -1], bands[2, -2], right[-1] = 1, 0, 1
    return y, scipy.linalg.solve_banded((1, 1), bands, right)


def wanted():
    y, p = solution()
    return {name: p[round(at / HEIGHT * (len(y) - 1))] for name, at in HEIGHTS.items()}


class Air(ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "case.toml").write_text(CASE)

    def told(self, *keys):
        return self.json_of("run", "case.toml", *keys)

    def amplitudes(self, *keys):
        """Complex, of p_0 sin(w t), from the last five periods."""
        self.told(*keys)
        with h5py.File(self.folder / "out/results.h5") as file:
            time = file["history/time"][:]
            last = time > time[-1] - 5 * PERIOD
            angle = 2 * np.pi / PERIOD * time[last]
            basis = np.column_stack([np.sin(angle), np.cos(angle), np.ones(last.sum())])
            found = {}
            for name in HEIGHTS:
                sine, cosine, _ = np.linalg.lstsq(basis, file[f"history/probes/{name}/pressure"][:][last], rcond=None)[0]
                found[name] = sine + 1j * cosine
            return found

    def difference(self, found):
        return max(abs(found[name] - exact) for name, exact in wanted().items())

    def test_a_column_is_that_of_its_equation(self):
        self.assertLess(self.difference(self.amplitudes("regions.soil.air_by_depth=true")), 1e-3)

    def test_air_of_the_middle_alone_is_another_column(self):
        self.assertGreater(self.difference(self.amplitudes()), 1e-2)

    def test_what_was_decided_is_told(self):
        done = upbead("explain", "case.toml", "--set", "regions.soil.air_by_depth=true", cwd=self.folder)
        self.assertIn("in each cell at its own depth", " ".join(done.stdout.split()))

    def test_without_air_it_is_a_mistake(self):
        done = upbead("run", "case.toml", "--set", "regions.soil.saturation=1", "--set", "regions.soil.air_by_depth=true", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("saturation is 1", done.stderr)


if __name__ == "__main__":
    main()
