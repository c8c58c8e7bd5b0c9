#!/usr/bin/python3
"""Slip and lift node by node of waves, answered by a reduced model: what a run of the case with that wave on a reduced
ground finds.

usage: respond_contact_test.py PROGRAM CASES_FOLDER
"""

import json
import re
import unittest

import h5py

from program import CASES, ProgramTest, main, upbead, with_keys

END = 1.0  # s
UPLIFT = 0.6e6  # N/m, in wave a


def triangle(peak, rise, duration):
    return ((0, 0), (rise, peak), (duration, 0))


STRONG = {"a": triangle(8e6, 0.1, 0.25), "b": triangle(7e6, 0.09, 0.22), "weak": triangle(1e6, 0.1, 0.25)}
HUGE = triangle(35e6, 0.1, 0.25)
WEAKER = {"a": triangle(2e6, 0.1, 0.25), "b": triangle(2e6, 0.11, 0.4)}


def section(wave, uplift=0.0, damped=True, tolerance=0.005):
    """The prototype of Fig. 2b on coarse cells, with one load."""
    text = (CASES / "fig2b-prototype.toml").read_text()
    text = re.sub(r"\[probes\..*?(?=\[sliding\])|\[loads\.slow\].*?(?=\[time\])", "", text, flags=re.S)
    text = text.replace("end = 1\n", f"end = {END}\n").replace("[mesh.parameters]  # m", "[mesh.parameters]\ncells = 0.5")
    text = text.replace('history = "fig2b-prototype-impulse.csv"', f'history = "{wave}.csv"')
    text = text.replace('kind = "rigid"', 'kind = "rigid"\ninterface = { kind = "friction" }')
    if not damped:
        text = re.sub(r"damping = .*", "", text)
    text += f"\n[accuracy]\ntolerance = {tolerance}\n"
    if uplift:
        text += f'\n[sliding.uplift]\nkind = "prescribed"\npeak = {uplift}\nshape = "in_phase"\n'
    return text


class RespondContact(ProgramTest):
    def write(self, waves):
        self.peak = {name: rows[1][1] for name, rows in waves.items()}
        for name, rows in waves.items():
            lines = [f"{time},{force}" for time, force in rows]
            (self.folder / f"{name}.csv").write_text("\n".join(["time,impulse", *lines]) + "\n")

    def told(self, *arguments):
        done = upbead(*arguments, "--json", cwd=self.folder)
        self.assertIn(done.returncode, (0, 3), done.stderr)
        return json.loads(done.stdout)

    def answers(self, waves, **scene):
        """The waves by `respond`, by name."""
        self.write(waves)
        (self.folder / "case.toml").write_text(section("a", **scene))
        self.told("reduce", "case.toml", "--out", "model")
        found = self.told("respond", "model/reduced.h5", *[f"{name}.csv" for name in waves], "--end", END, "--out", "answers")
        self.told_of = {warning["name"]: warning for warning in found["warnings"]}
        self.assertNotIn("no_contact", self.told_of)
        return {wave["name"]: wave for wave in found["waves"]}

    def run_of(self, wave, **scene):
        if scene.get("uplift"):
            scene["uplift"] *= self.peak[wave] / self.peak["a"]
        (self.folder / f"{wave}.toml").write_text(section(wave, **scene))
        return self.told("run", f"{wave}.toml", *with_keys(['time.scheme="reduced"']), "--out", f"run_{wave}")

    def expect_same(self, wave, run, places):
        """Every number of `contact` and the peaks of F_T, where the run was on a reduced ground."""
        mine, its = wave["contact"], run["contact"]
        self.assertIsNotNone(its["solved"]["ground"], run["ladder"])
        self.assertAlmostEqual(mine["weight"] / its["weight"], 1, places)
        for key, value in its["solved"].items():
            if key == "ground":
                for part in ("slip", "peak_shear", "history"):
                    self.assertAlmostEqual(mine["solved"]["ground"][part], value[part], delta=1e-6 * value[part])
            elif value is None:
                self.assertIsNone(mine["solved"][key], key)
            else:
                self.assertAlmostEqual(mine["solved"][key], value, delta=10.**-places * abs(value), msg=key)
        for key in ("peak_shear", "peak_shear_time", "peak_shear_seaward"):
            expected = run["response"][key]
            self.assertAlmostEqual(wave["response"][key], expected, delta=10.**-places * abs(expected), msg=key)

    def expect_within_what_is_told(self, wave, case):
        marched = self.told("run", case, "--out", "marched")
        self.assertIsNone(marched["contact"]["solved"]["ground"])
        ground, solved = wave["contact"]["solved"]["ground"], marched["contact"]["solved"]
        self.assertNotEqual(wave["contact"]["solved"]["slip"], solved["slip"], "it would be the same march")
        self.assertLess(abs(wave["contact"]["solved"]["slip"] - solved["slip"]), ground["slip"])
        peak = marched["response"]["peak_shear"]
        self.assertLess(abs(wave["response"]["peak_shear"] - peak), ground["peak_shear"] * peak)

    def test_a_base_that_lifts_under_uplift(self):
        waves = self.answers(STRONG, uplift=UPLIFT)
        self.assertIn("no_settlement", self.told_of)
        self.assertFalse({"still_slides", "rocks_on_edge"} & set(self.told_of), self.told_of)
        self.write({**STRONG, "huge": HUGE})  # it throws the caisson off its mound
        found = self.told("respond", "model/reduced.h5", "huge.csv", "--end", END, "--out", "thrown")
        self.assertLess({"still_slides", "rocks_on_edge", "no_settlement"}, {warning["name"] for warning in found["warnings"]} | {"more"})
        self.assertIn("still_slides", found["why_void"])
        self.assertIn("rocks_on_edge", found["why_void"], "S of a caisson that was thrown is not known")
        for name in ("a", "b"):
            self.expect_same(waves[name], self.run_of(name, uplift=UPLIFT), 8)
        self.assertLess(waves["a"]["contact"]["solved"]["least_contact"], 0.8)
        self.assertGreater(waves["a"]["contact"]["solved"]["slip"], 1e-3)
        self.expect_within_what_is_told(waves["b"], "b.toml")
        with h5py.File(self.folder / "answers/responses.h5") as file:
            self.assertEqual(file["a/contact_solved_slip"][0], waves["a"]["contact"]["solved"]["slip"])
            self.assertEqual(file["a/response_peak_shear"][0], waves["a"]["response"]["peak_shear"])

    def test_a_wave_that_moves_nothing_is_the_bonded_one(self):
        wave = self.answers(STRONG, uplift=UPLIFT)["weak"]
        self.assertFalse(wave["contact"]["glued"]["reached"])
        self.assertIsNone(wave["contact"]["solved"])
        self.assertEqual(wave["response"]["peak_shear"], wave["peak_shear"])
        run = self.run_of("weak", uplift=UPLIFT)
        self.assertIsNone(run["contact"]["solved"])
        self.assertAlmostEqual(wave["contact"]["glued"]["slip"] / run["contact"]["glued"]["slip"], 1, delta=5e-3)
        self.assertAlmostEqual(wave["response"]["peak_shear"] / run["response"]["peak_shear"], 1, delta=5e-3)

    def test_what_a_run_says_of_a_wave_is_said(self):
        """Steps of the case that are too long for a wave, and an --end that cuts it or its answer."""
        self.write(STRONG)
        (self.folder / "case.toml").write_text(section("a", uplift=UPLIFT))
        self.told("reduce", "case.toml", *with_keys(["time.step=0.06"]), "--out", "model")
        self.told("respond", "model/reduced.h5", "b.csv", "--end", END, "--out", "answers")
        for end, name in ((0.2, "load_cut"), (0.25, "answer_cut")):
            found = self.told("respond", "model/reduced.h5", "b.csv", "--end", end, "--out", "cut")
            self.assertIn(name, {warning["name"] for warning in found["warnings"]})
        self.assertEqual(found["why_void"], "answer_cut")

    def test_ground_without_damping(self):
        waves = self.answers(WEAKER, damped=False)
        for name in ("a", "b"):
            self.expect_same(waves[name], self.run_of(name, damped=False), 8)
        self.expect_within_what_is_told(waves["a"], "a.toml")

    def test_friction_and_weight_of_the_command_line(self):
        self.answers(STRONG, tolerance=0.03)
        asked = self.told("respond", "model/reduced.h5", "b.csv", "--end", END, "--friction", 0.5, "--buoyant-weight", 4e6,
                          "--out", "other")["waves"][0]
        (self.folder / "b.toml").write_text(section("b", tolerance=0.03))
        run = self.told("run", "b.toml", *with_keys(['time.scheme="reduced"', "sliding.friction=0.5",
                                                    "sliding.submerged_weight=4e6"]), "--out", "run_b")
        self.expect_same(asked, run, 8)

    def test_a_ground_that_is_incomplete_is_refused(self):
        self.write(STRONG)
        (self.folder / "case.toml").write_text(section("a"))
        told = self.told("reduce", "case.toml", "--out", "model")
        self.assertEqual((told["skipped"], len(told["contact"]["coordinates"])), ([], 3))
        with h5py.File(self.folder / "model/reduced.h5", "r+") as file:
            del file["contact/level_1/C"]
        done = upbead("respond", "model/reduced.h5", "a.csv", cwd=self.folder)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("/contact/level_1/C is missing, or cannot be read as numbers; make it again", done.stderr)

    def test_the_sea_in_gaps_is_left_to_runs(self):
        self.write(STRONG)
        text = section("a").replace('kind = "friction"', 'kind = "friction", gap = "sea"')
        (self.folder / "case.toml").write_text(text)
        told = self.told("reduce", "case.toml", "--out", "model")
        self.assertEqual([part["what"] for part in told["skipped"]], ["contact node by node"])
        self.assertIn("the sea enters gaps", told["skipped"][0]["why"])
        self.assertNotIn("contact", self.told("respond", "model/reduced.h5", "a.csv", "--out", "answers")["waves"][0])


if __name__ == "__main__":
    main()
