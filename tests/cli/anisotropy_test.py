#!/usr/bin/python3
"""Soil that lets water through more easily along its layers than across them: conductivity_ratio = k_y/k_x.

usage: anisotropy_test.py PROGRAM CASES_FOLDER

Each answer is had in two ways: flow along one axis is that of isotropic soil with the k of that axis; flow in the plane, where the
skeleton takes no part, is isotropic on a section whose heights are divided by the root of the ratio.
"""

import json

import h5py
import numpy as np

from program import CASES, ProgramTest, main, upbead, with_keys

COLUMN = """
gravity = 10.0
[fluid]
density = 1000.0
[mesh]
geometry = "column"
parameters = { height = 4.0, width = 2.0, cells = 12, cells_across = 6 }
[regions.soil]
kind = "porous"
shear_modulus = 1.0e7
poissons_ratio = 0.25
porosity = 0.4
grain_density = 2650.0
hydraulic_conductivity = 1.0e-4
[boundaries]
base = { displacement = "roller", pressure = "sealed" }
left = { displacement = "roller", pressure = "sealed" }
right = { displacement = "roller", pressure = "sealed" }
top = { pressure = "open" }
[loads.weight]
boundary = "top"
kind = "normal"
pulse = { shape = "triangle", peak = 1.0e4, duration = 0.2 }
[probes]
low = { at = [0.5, 0.5] }
high = { at = [1.5, 3.6] }
[time]
end = 1.0
"""
SIDEWAYS = {"boundaries.right": '{ pressure = "open" }', "boundaries.top": '{ displacement = "roller", pressure = "sealed" }', "loads.weight.boundary": '"right"'}
# water that a source puts into soil whose skeleton takes no part (biot = 0): storage p' = div(k grad p)/(rho g) + s
PLANE = COLUMN.replace("[regions.soil]", "[regions.soil]\nbiot = 0.0").replace('[loads.weight]\nboundary = "top"\nkind = "normal"', '[loads.water]\nregion = "soil"\nkind = "source"')


class Anisotropy(ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "column.toml").write_text(COLUMN)
        (self.folder / "plane.toml").write_text(PLANE)

    def run_of(self, case, keys, probe=None):
        words = [word for key, value in keys.items() for word in ("--set", f"{key}={value}")]
        done = upbead("run", case, *words, "--json", "--out", "out", cwd=self.folder)
        self.assertIn(done.returncode, (0, 3), done.stderr)
        with h5py.File(self.folder / "out/results.h5") as file:
            probes = file["history/probes"]
            time = file["history/time"][:]
            return json.loads(done.stdout), np.array([time, *(probes[name]["pressure"][:] for name in sorted(probes))])

    def assert_equal_histories(self, found, wanted, tolerance=1e-8):
        """Pressures at the times of the first, between whose rows those of the second are straight lines."""
        for one, other in zip(found[1:], wanted[1:], strict=True):
            self.assertLess(np.abs(one - np.interp(found[0], wanted[0], other)).max(), tolerance * np.abs(other).max())

    def test_flow_along_an_axis_has_the_conductivity_of_that_axis(self):
        for flow, schemes in (("darcy", ("sdirk4", "reduced")), ("inertial", ("sdirk4",))):
            for scheme in schemes:
                common = {"regions.soil.flow": f'"{flow}"', "time.scheme": f'"{scheme}"', "time.step": 0.01, "regions.soil.hydraulic_conductivity": 1e-3}
                for way, k in (({}, 2e-4), (SIDEWAYS, 1e-3)):
                    with self.subTest(flow=flow, scheme=scheme, k=k):
                        _, found = self.run_of("column.toml", common | way | {"regions.soil.conductivity_ratio": 0.2})
                        _, wanted = self.run_of("column.toml", common | way | {"regions.soil.hydraulic_conductivity": k})
                        self.assert_equal_histories(found, wanted, 1e-8 if scheme == "sdirk4" else 2e-2)

    def test_in_the_plane_heights_over_the_root_of_the_ratio_are_isotropic(self):
        ratio = 0.25
        sides = {"boundaries.right": '{ displacement = "roller", pressure = "open" }', "time.inertia": "false", "time.step": 0.02}
        sides["loads.water.pulse.peak"] = 1e-3
        _, found = self.run_of("plane.toml", sides | {"regions.soil.conductivity_ratio": ratio})
        stretched = {"mesh.parameters.height": 4 / ratio**0.5, "probes.low.at": "[0.5, 1.0]", "probes.high.at": "[1.5, 7.2]"}
        _, wanted = self.run_of("plane.toml", sides | stretched)
        self.assert_equal_histories(found, wanted)
        _, isotropic = self.run_of("plane.toml", sides)
        far = np.abs(found[1] - np.interp(found[0], isotropic[0], isotropic[1])).max()
        self.assertGreater(far, 0.05 * np.abs(wanted[1]).max(), "the ratio must matter")

    def test_weight_of_the_water_drives_flow_by_the_same_ratio(self):
        """In the plane as above; on the stretched section gravity is less by the root of the ratio."""
        ratio = 0.25
        (self.folder / "weight.toml").write_text(PLANE.replace('kind = "source"', 'kind = "gravity"'))
        sides = {"boundaries.right": '{ displacement = "roller", pressure = "open" }', "time.inertia": "false", "time.step": 0.02}
        _, found = self.run_of("weight.toml", sides | {"loads.water.pulse.peak": 10.0, "regions.soil.conductivity_ratio": ratio})
        stretched = {"mesh.parameters.height": 4 / ratio**0.5, "probes.low.at": "[0.5, 1.0]", "probes.high.at": "[1.5, 7.2]"}
        _, wanted = self.run_of("weight.toml", sides | stretched | {"loads.water.pulse.peak": 10 * ratio**0.5})
        self.assertGreater(np.abs(wanted[1:]).max(), 100.0)
        self.assert_equal_histories(found, wanted)

    def test_models_for_soils_keep_the_ratio_and_refuse_another(self):
        case, csv = CASES / "fig2b-prototype.toml", CASES / "fig2b-prototype-impulse.csv"
        keys = ["mesh.parameters.cells=0.5", "regions.seabed.conductivity_ratio=0.1", "time.end=1.0"]
        words = with_keys(keys)
        box = '[vary."regions.seabed.hydraulic_conductivity"]\ndistribution = "log_uniform"\nlow = 2e-5\nhigh = 1e-3\n'
        (self.folder / "box.toml").write_text(box)
        done = upbead("reduce", case, *words, "--soils", "box.toml", "--out", "model", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        soil = "regions.seabed.hydraulic_conductivity=3e-4"
        done = upbead("respond", "model/soils.h5", csv, "--soil", soil, "--json", "--out", "answer", cwd=self.folder)
        self.assertIn(done.returncode, (0, 3), done.stderr)
        wave = json.loads(done.stdout)["waves"][0]
        done = upbead("run", case, *words, "--set", soil, "--json", "--out", "own", cwd=self.folder)
        own = json.loads(done.stdout)
        self.assertAlmostEqual(wave["peak_shear"] / own["response"]["peak_shear"], 1, delta=2e-3)
        done = upbead("respond", "model/soils.h5", csv, "--soil", "regions.seabed.conductivity_ratio=0.5", "--out", "other", cwd=self.folder)
        self.assertNotEqual(done.returncode, 0)
        (self.folder / "box.toml").write_text(box.replace("hydraulic_conductivity", "conductivity_ratio").replace("2e-5", "0.1").replace("1e-3", "1.0"))
        done = upbead("reduce", case, *words, "--soils", "box.toml", "--out", "model", cwd=self.folder)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("its direction", " ".join(done.stderr.split()))

    def test_the_choice_of_flow_looks_at_the_larger_conductivity(self):
        def told(ratio):
            done = upbead("explain", "column.toml", "--json", "--set", f"regions.soil.conductivity_ratio={ratio}",
                          "--set", "regions.soil.hydraulic_conductivity=1e-3", cwd=self.folder)  # fmt: skip
            return json.loads(done.stdout)["regions"]["soil"]["flow"]

        self.assertEqual(told(0.01), told(1.0))
        self.assertEqual((told(1.0), told(300.0)), ("darcy", "inertial"))

    def test_it_belongs_to_pores_and_percent_are_told(self):
        done = upbead("run", "column.toml", "--set", "regions.soil.conductivity_ratio=0", cwd=self.folder)
        self.assertIn("conductivity_ratio", done.stderr)
        summary, _ = self.run_of("column.toml", {"regions.soil.conductivity_ratio": 50.0, "time.end": 0.3})
        self.assertTrue(any("percent" in w["cure"] for w in summary["warnings"] if w["name"] == "implausible"), summary["warnings"])


if __name__ == "__main__":
    main()
