#!/usr/bin/python3
"""Loads from CFD: the breakwater under the forces and under the sampled patch of one flow, and messages about missing
keys.

usage: flow_test.py PROGRAM CASES_FOLDER
"""

import json
import unittest

from program import CASES, ProgramTest, upbead, with_keys

BORE = CASES / "cfd/bore.toml"
AXES = ["--set", "landward=x", "--set", "up=z", "--set", "origin=[-3.2, 0.0]", "--set", "still_time=[0.0, 0.3]"]


class Flow(ProgramTest):
    def ask(self, *arguments, code=0):
        done = upbead(*arguments)
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stdout if code == 0 else done.stderr

    def solve(self, *settings):
        words = with_keys(["mesh.parameters.cells=0.3", *settings])
        return json.loads(self.ask("run", BORE, "--json", "--out", self.folder / "out", *words))

    def test_forces_and_patch_of_one_flow_give_the_same_shear_force(self):
        """The patch has fewer times, so the two are compared at the time of the largest force, which both have."""
        forces = self.solve()
        patch = self.solve("loads.forces.factor=0.0", "loads.patch.factor=1.0")
        for key in ("peak_force", "peak_shear"):
            self.assertAlmostEqual(forces["response"][key] / patch["response"][key], 1.0, delta=0.01, msg=key)
        self.assertAlmostEqual(forces["flows"]["forces"]["peak_force"], 866.93, delta=0.02)
        self.assertLess(forces["flows"]["patch"]["difference"], 1e-4)

    def test_explain_tells_what_was_understood(self):
        text = self.ask("explain", BORE)
        self.assertIn("99.09 N over a thickness of 0.1 m along y: 990.9 N/m", text)
        self.assertIn("the run from 0.8 s goes on", text)

    def test_asks_for_what_the_files_do_not_tell(self):
        text = BORE.read_text().replace("thickness = 0.1\nstill_time = [0.0, 0.3]\n", "")
        text = text.replace('"bore/', f'"{CASES}/cfd/bore/')
        (self.folder / "scene.toml").write_text(text)
        said = self.ask("explain", self.folder / "scene.toml", code=1)
        self.assertIn("'thickness' is missing", said)
        self.assertIn("'still_time' is missing", said)
        said = self.ask("explain", BORE, "--set", "loads.patch.origin=[4.8, 0.0]", code=1)
        self.assertIn("8 m from the boundary 'front'", said)

    def explained(self, up, height, *settings):
        """Warnings of the bore's case under forces of 90 N landward at `height` (m), and `up` N 0.4 m behind the wall."""
        centre, rows = (3.4, 0.1), []  # at the heel: up acts there, without a moment about it
        for t, f in ((0.05, 0), (0.5, 0), (0.6, 90), (0.7, 0), (0.8, 0)):
            share = f / 90
            rows.append(f"{t} (({f} 0 {up * share}) (0 0 0)) ((0 {f * (height - centre[1])} 0) (0 0 0))")
        (self.folder / "forces.dat").write_text(
            "# Forces\n# CofR : (3.4 0.05 0.1)\n# Time forces(pressure viscous) moment(pressure viscous)\n" + "\n".join(rows) + "\n")
        words = [f"loads.forces.from={self.folder}/forces.dat", "mesh.parameters.cells=0.3", "time.end=1", *settings]
        told = json.loads(self.ask("explain", BORE, "--json", *[w for s in words for w in ("--set", s)]))
        return {w["name"]: w for w in told["warnings"] if w["name"].startswith("flow_")}

    def test_moment_that_is_not_of_the_landward_force_is_warned_of(self):
        self.assertEqual(self.explained(0, 0.3), {})
        found = self.explained(45, 0.3, 'loads.forces.vertical="leave_out"')
        self.assertEqual(list(found), ["flow_vertical_moment"])
        self.assertAlmostEqual(found["flow_vertical_moment"]["value"], 0.5)
        self.assertIn("wrong by 0.5 m for each metre", found["flow_vertical_moment"]["text"])
        for height, limit in ((0.9, 0.5), (0.02, 0.1)):  # the wall reaches from 0.1 to 0.5 m
            found = self.explained(0, height)
            self.assertEqual(list(found), ["flow_arm_outside"])
            self.assertAlmostEqual(found["flow_arm_outside"]["value"], height)
            self.assertAlmostEqual(found["flow_arm_outside"]["limit"], limit)

    def test_read_writes_a_table_that_is_a_record(self):
        out = self.folder / "force.csv"
        told = json.loads(self.ask("read", CASES / "cfd/bore/forces", "--json", "--out", out, *AXES, "--set", "thickness=0.1"))
        self.assertAlmostEqual(told["load"]["peak_force"], 866.93, delta=0.02)
        self.assertEqual(out.read_text().splitlines()[0], "time (s),force (N/m),moment (N m/m)")
        self.assertEqual(len(out.read_text().splitlines()), 41)


if __name__ == "__main__":
    unittest.main(argv=["flow_test.py"])
