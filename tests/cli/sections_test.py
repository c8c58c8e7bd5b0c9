"""The shipped sections of designers and textbooks have the numbers that their headers and pages state."""

import json
import tomllib
import unittest

from program import CASES, ProgramTest, upbead, with_keys

RHO_G = 1030.0 * 9.81
SECTIONS = ["designer/section.toml"] + sorted(
    str(path.relative_to(CASES))
    for path in (CASES / "gallery").glob("*.toml")
    if "mesh" in tomllib.loads(path.read_text())
)


class Sections(ProgramTest):
    def solve(self, command, case, *settings):
        done = upbead(command, CASES / case, "--out", "out", *with_keys(settings), cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((self.folder / "out/summary.json").read_text())

    def read(self, case):
        return tomllib.loads((CASES / case).read_text())

    def test_there_are_eight_and_each_declares_what_is_assumed(self):
        self.assertEqual(len(SECTIONS), 1 + 8)
        for case in SECTIONS:
            header = " ".join(line[1:].strip() for line in (CASES / case).read_text().split("\n\n")[0].splitlines())
            self.assertRegex(header, "are our own|Ours:|assumptions", case)

    def test_weights_are_those_of_section_and_levels(self):
        """W' = rho_c g B h_c less the weight of the water displaced at the higher level; U and alpha* are those of
        the named wave."""
        for case in SECTIONS:
            found, p = self.read(case), self.read(case)["mesh"]["parameters"]
            width, wet = p["caisson_width"], p["water_depth"] - p["mound_height"]
            W = found["regions"]["caisson"]["density"] * 9.81 * width * p["caisson_height"]
            given = found["sliding"]["submerged_weight"]
            self.assertAlmostEqual(given / (W - RHO_G * width * wet), 1, delta=2e-3, msg=case)

    def test_the_designers_wave_has_godas_uplift_and_breaks_at_10_9_m(self):
        section, waves = self.read("designer/section.toml"), self.solve("waves", "designer/design.toml")["waves"]
        self.assertAlmostEqual(waves["design"]["uplift"] / section["sliding"]["uplift"]["peak"], 1, delta=2e-3)
        self.assertAlmostEqual(waves["design"]["alpha_star"], section["sliding"]["wave"]["alpha_star"], delta=1e-4)
        self.assertAlmostEqual(waves["storm"]["significant_height"], 7.95, delta=0.01)
        self.assertAlmostEqual(waves["storm"]["height"], 10.9, delta=0.05)

    def test_fifty_years_hang_on_how_high_waves_are(self):
        for highest, S in (("breaking", 0.0), (1.8, 15.08e-3), ("none", 0.2016)):
            found = self.solve("expected", "designer/design.toml", f"sea.highest={json.dumps(highest)}")["expected"]
            self.assertAlmostEqual(found["distance_exact"], S, delta=1e-3 * S, msg=highest)

    def test_the_designers_section_is_judged(self):
        """Bonded and on coarse cells, S by eq. (4) with held uplift is within 5 % of that on fine cells."""
        found = self.solve("run", "designer/section.toml", "mesh.parameters.cells=0.5", "time.end=1.2",
                           'regions.caisson.interface.kind="bonded"')
        courses = found["sliding"]["uplift_courses"]
        self.assertAlmostEqual(courses["held"] / 32.44e-3, 1, delta=0.05)
        self.assertAlmostEqual(courses["in_phase"] / 17.15e-3, 1, delta=0.05)
        self.assertLess(found["response"]["reaction_mismatch"], 1e-9)
        holds = {check["name"]: check["holds"] for check in found["checks"]}
        self.assertTrue(holds["sliding distance"])
        self.assertFalse(holds["heel pressure p_e of the loads"])
        self.assertIsNone(holds["heel pressure in motion"], "the limit was made for p_e")

    def test_godas_example_presses_as_by_hand(self):
        wave = self.solve("waves", "gallery/goda-waves.toml")["waves"]["book"]
        self.assertAlmostEqual(wave["without_alpha_I"]["force"], 937.2e3, delta=50)
        self.assertAlmostEqual(wave["uplift"], 493.0e3, delta=50)
        base = self.solve("run", "gallery/goda.toml", "mesh.parameters.cells=0.5",
                          'regions.caisson.interface.kind="bonded"')["base"]
        self.assertAlmostEqual(base["peak_heel_pressure"] / wave["heel_pressure"], 1, delta=0.01)
        self.assertAlmostEqual(base["least_overturning_margin"] / wave["safety_overturning"], 1, delta=0.01)

    def test_forces_of_the_others_are_godas(self):
        """The integral of peak and shape of P is the force and the arm of Goda's formulas."""
        for case in SECTIONS:
            load = self.read(case)["loads"]["wave"]
            if load["pulse"]["shape"] != "half_sine":
                continue
            p, wave = self.read(case)["mesh"]["parameters"], self.read(case)["sliding"]["wave"]
            blocks = "wide-berm" in case
            design = f"""[section]
water_depth = {wave["depth"]}
foundation_depth = {wave["depth"] - p["mound_height"]}
berm_depth = {5.6 if "goda" in case else wave["depth"] - p["mound_height"]}
crest = {p["mound_height"] + p["caisson_height"] - wave["depth"]}
width = {p["caisson_width"]}
berm_width = {p["mound_crest_front"] - p["caisson_width"] / 2}
bed_slope = 0.01
weight = 1e8
submerged_weight = {self.read(case)["sliding"]["submerged_weight"]}
blocks = {str(blocks).lower()}
[waves.a]
height = {wave["height"]}
significant_height = {5.796 if "goda" in case else wave["height"] / 1.8}
period = {wave["period"]}
angle = {15 if "goda" in case else 0}
"""
            (self.folder / "design.toml").write_text(design)
            goda = self.solve("waves", self.folder / "design.toml")["waves"]["a"]
            self.assertAlmostEqual(load["pulse"]["peak"] / goda["force"], 1, delta=1e-3, msg=case)
            self.assertAlmostEqual(self.read(case)["sliding"]["uplift"]["peak"] / goda["uplift"], 1, delta=1e-3, msg=case)
            self.assertAlmostEqual(wave["alpha_star"], goda["alpha_star"], delta=1e-3, msg=case)
            force = moment = 0.0
            for (a, at_a), (b, at_b) in zip(load["shape"][:-1], load["shape"][1:]):
                force += (b - a) * (at_a + at_b) / 2
                moment += (b - a) * (at_a * (2 * a + b) + at_b * (a + 2 * b)) / 6
            arm = moment / force - p["mound_height"]
            self.assertAlmostEqual(arm / (goda["force_moment"] / goda["force"]), 1, delta=1e-3, msg=case)

    def test_the_difference_of_levels_pushes(self):
        """The force is rho g times 3 m over 7 m of wall, and half of that pressure over 3 m."""
        peak = self.read("gallery/two-levels.toml")["loads"]["levels"]["pulse"]["peak"]
        self.assertAlmostEqual(peak / (RHO_G * 3 * (7 + 3 / 2)), 1, delta=1e-3)

    def test_each_is_understood_without_a_warning(self):
        # its page states these warnings; the push of two-levels.toml is one of its loads
        expected = {"designer/section.toml": ["harbour_level", "walls_too_near"]}
        for case in SECTIONS:
            done = upbead("explain", CASES / case, cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            names = [line.split(": ")[1] for line in done.stderr.splitlines() if line.startswith("warning: ")]
            self.assertEqual(names, expected.get(case, []), case)


if __name__ == "__main__":
    unittest.main(argv=["sections_test.py"])
