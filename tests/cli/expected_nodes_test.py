#!/usr/bin/python3
"""Expected sliding with slip and lift node by node: S of all waves from a few of them.

usage: expected_nodes_test.py PROGRAM CASES_FOLDER
"""

import json
import re

from program import CASES, ProgramTest, main, upbead, with_keys
from respond_contact_test import section

ALL = 1000  # more waves than these lives have


def stiff_section():
    """On ground so stiff, and pushed so low, that nothing but the bottom moves, and without a sea that moves with it: a
    rigid block."""
    text = section("a")
    text = re.sub(r"shear_modulus = (\S+)", lambda found: f"shear_modulus = {1000 * float(found[1])}", text)
    text = re.sub(r"measured_on_wall.*|\[regions\.sea_.*\nkind.*|sea_(surface|left|right) = .*", "", text)
    text = re.sub(r"(sea_front|sea_back) = 6", r"\1 = 0", text)
    return re.sub(r'boundary = "front"(?=\nkind = "force")', 'region = "caisson"\nat = [0.0, 6.0]', text)


class ExpectedNodes(ProgramTest):
    def told(self, *arguments):
        done = upbead(*arguments, "--json", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def model(self, text):
        (self.folder / "a.csv").write_text("time,impulse\n0,0\n0.1,2e6\n0.25,0\n")
        (self.folder / "case.toml").write_text(text)
        self.told("reduce", "case.toml", "--out", "model")

    def lives(self, *keys, waves=250, height=8):
        """Two short lives of one sea."""
        (self.folder / "sea.csv").write_text(f"significant_height,period,waves\n{height},14,{waves}\n")
        text = (CASES / "expected/prototype.toml").read_text().replace('"storms.csv"', '"sea.csv"')
        (self.folder / "lives.toml").write_text(text)
        life = ['dynamics.model="model/reduced.h5"', "life.years=50", "life.simulated_lives=2"]
        return self.told("expected", "lives.toml", *with_keys([*life, *keys]), "--out", "lives")

    def names(self, found):
        return [warning["name"] for warning in found["warnings"]]

    def test_a_draw_of_waves_has_the_sum_of_all(self):
        self.model(section("a"))
        everything = self.lives(f"dynamics.node_waves={ALL}")
        whole, life = everything["nodes"], everything["monte_carlo"]
        self.assertTrue(whole["all_waves"])
        self.assertEqual(whole["unanswered"], 0)
        self.assertGreater(whole["waves"], 40)
        self.assertGreater(whole["mean"], 10 * whole["ground_error"])
        self.assertEqual(whole["block"], life["mean"])
        self.assertAlmostEqual(whole["ratio"], whole["mean"] / whole["block"])
        self.assertLess(whole["ratio"], 1)
        self.assertEqual(life["headline"]["value"], life["mean"], "the larger governs")
        drawn = self.lives("dynamics.node_waves=40")
        few = drawn["nodes"]
        self.assertFalse(few["all_waves"])
        self.assertLess(few["waves"], 41)
        self.assertEqual(few["block"], whole["block"])
        self.assertEqual(whole["draw_error"], 0)
        self.assertNotEqual(few["mean"], whole["mean"])
        self.assertLess(abs(few["mean"] - whole["mean"]), 2.03 * few["draw_error"])  # 95 %, Student's t of 36 degrees
        self.assertLess(few["draw_error"], 0.1 * few["mean"])
        self.assertEqual(drawn["monte_carlo"], life | {"headline": drawn["monte_carlo"]["headline"]}, "the block's numbers stay")
        self.assertEqual(self.lives("dynamics.node_waves=40")["nodes"], few, "the same seed, the same waves")
        self.assertIsNone(self.lives("dynamics.node_waves=0")["nodes"])
        record = self.told("expected", "lives.toml", *with_keys(['dynamics.model="model/reduced.h5"', "dynamics.node_waves=40"]), "--out", "record")
        self.assertEqual(record["nodes"]["of"], "record")
        self.assertEqual(record["nodes"]["block"], record["expected"]["distance_dynamic"])
        self.assertTrue(0.2 < record["nodes"]["ratio"] / whole["ratio"] < 5)

    def test_on_stiff_ground_nodes_slide_as_the_block(self):
        """Whatever scatters; with an uplift that comes with P for both."""
        self.model(stiff_section())
        uncertain = ["scatter.weight.cov=0.08", "scatter.friction.cov=0.1", "scatter.uplift.cov=0.3", "scatter.uplift.low=0.1"]
        for keys in ([], uncertain):
            found = self.lives('impact.uplift="in_phase"', "dynamics.node_waves=40", *keys, waves=600)
            self.assertGreater(found["nodes"]["block"], 1e-2)
            self.assertAlmostEqual(found["nodes"]["ratio"], 1, delta=2e-3)
            self.assertNotIn("nodes_slide_farther", self.names(found))


if __name__ == "__main__":
    main()
