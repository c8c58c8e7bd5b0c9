#!/usr/bin/python3
"""Reduced models as a user makes and uses them: run, reduce and respond.

usage: reduced_test.py PROGRAM CASES_FOLDER
"""

import json
import os
import pathlib
import sys
import unittest

import h5py
import numpy as np

from program import CASES, ProgramTest, upbead

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
from hand_made_model import write_oscillator  # noqa: E402

CASE = CASES / "fig2b-prototype.toml"
COARSE = ["--set", "mesh.parameters.cells=0.5"]
DRY = ["--set", "mesh.parameters.sea_front=0", "--set", "mesh.parameters.sea_back=0"]


LIFE = """
[storms]
distribution = "weibull"
location = 2.0
scale = 1.5
shape = 1.2
steepness = 0.035
[life]
years = 5
simulated_lives = 5
[dynamics]
model = "model/reduced.h5"
[limits]
sliding = 0.3
"""


def sorted_as(warnings, others):
    """The same warnings in the order of the others."""
    return sorted(warnings, key=others.index)


class Reduced(ProgramTest):
    def summary(self, command, *arguments, case=CASE):
        done = upbead(command, case, *COARSE, *arguments, "--json", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def shear(self, folder, time):
        with h5py.File(self.folder / folder / "results.h5") as file:
            return np.interp(time, file["history/time"], file["history/shear_force"])

    def test_run_reduces_by_itself_and_agrees_with_marching(self):
        reduced = self.summary("run", "--out", "reduced")
        marched = self.summary("run", "--out", "marched", "--set", "time.scheme=sdirk4", "--set", "time.step=2.5e-3")
        self.assertEqual(reduced["discretisation"]["scheme"], "reduced")
        self.assertLess(reduced["discretisation"]["solves"], 60)
        self.assertIsNone(reduced["energy"])
        self.assertIsNone(marched["reduction"])
        self.assertGreater(len(reduced["periods"]), 0)
        self.assertIsNone(reduced["no_periods"])
        self.assertEqual(marched["periods"], [])
        self.assertIn("this scene was marched", marched["no_periods"])
        self.assertLess(reduced["response"]["reaction_mismatch"], 1e-8)
        peak = marched["response"]["peak_shear"]
        self.assertAlmostEqual(reduced["response"]["peak_shear"] / peak, 1, delta=1e-3)
        time = np.linspace(0, 1, 401)
        self.assertLess(abs(self.shear("reduced", time) - self.shear("marched", time)).max(), 3e-3 * peak)

    def test_loads_that_act_up_or_down_count_with_the_weight_in_both(self):
        """A crown that is set on the caisson, beside its middle, and one that lifts: two ways, one margin."""
        for way in (-1.0, 1.0):
            load = f'[loads.crown]\nregion = "caisson"\nat = [4, 20]\nkind = "force"\ndirection = [0.0, {way}]\n' \
                   'pulse = { shape = "step", peak = 4e5, rise = 0.05 }\n'
            text = CASE.read_text().replace('history = "', f'history = "{CASES}/').replace("[mesh.parameters]", "[mesh.parameters]\ncells = 0.5\n")
            (self.folder / "crown.toml").write_text(text + load)
            run = json.loads(upbead("run", "crown.toml", "--json", cwd=self.folder).stdout)
            wave, = json.loads(upbead("respond", "crown.toml", "--json", cwd=self.folder).stdout)["waves"]
            margin = run["base"]["least_overturning_margin"]
            self.assertAlmostEqual(wave["least_overturning_margin"] / margin, 1, delta=5e-3)
            for key in ("peak_heel_pressure", "peak_toe_pressure"):
                self.assertAlmostEqual(wave[key] / run["base"][key], 1, delta=5e-3)

    def test_run_marches_where_a_reduced_model_does_not_do(self):
        for reason, key in (("stop early", "time.stop_at_energy=0.01"), ("given in the case", "time.scheme=sdirk4")):
            done = upbead("run", CASE, *COARSE, "--details", "--set", key, cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stdout, f"why_scheme +.*{reason}")
            self.assertRegex(done.stdout, "no_periods +they are the poles of a reduced model")

    def test_reduce_then_respond_gives_what_run_gives(self):
        told = self.summary("reduce", "--check", "--out", "model")
        self.assertEqual(self.left_behind(), ["model", "model/reduced.h5"])
        self.assertLess(told["reduction"]["error_march"], 3e-3)
        self.assertLessEqual(told["reduction"]["error"], 5e-3)
        done = upbead("respond", "model/reduced.h5", CASES / "fig2b-prototype-impulse.csv", "--out", "answer", "--json",
                      cwd=self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""), "no warning about the wave it was made from")
        wave = json.loads(done.stdout)["waves"][0]
        marched = self.summary("run", "--set", "time.scheme=sdirk4", "--set", "time.step=2.5e-3", "--out", "marched")
        self.assertAlmostEqual(wave["peak_shear"] / marched["response"]["peak_shear"], 1, delta=2e-3)

    def test_reduce_refuses_what_cannot_be_reduced(self):
        done = upbead("reduce", CASE, *DRY, "--set", "time.inertia=false", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("consolidation cannot be reduced", done.stderr)
        done = upbead("reduce", CASE, "--set", "mesh.parameters.cells=0.3", "--set", "accuracy.tolerance=1e-13",
                      cwd=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("has not converged after", done.stderr)
        self.assertEqual(self.left_behind(), [])

    def told(self, *arguments):
        done = upbead(*arguments, "--json", cwd=self.folder)
        self.assertIn(done.returncode, (0, 3), done.stderr)
        return json.loads(done.stdout)

    def test_what_a_run_warns_of_its_model_and_its_waves_tell_too(self):
        """A harbour two metres lower, which [initial] does not give, pushes the caisson: all numbers are void."""
        text = (CASES / "design-wave/composite.toml").read_text()
        text = text.replace("water_depth = 15\n", "water_depth = 15\nwater_depth_back = 13\n").replace("cells = 0.4", "cells = 0.6")
        (self.folder / "harbour.toml").write_text(text)
        told = self.told("explain", "harbour.toml")["warnings"]
        self.assertIn("harbour_level", [warning["name"] for warning in told])

        reduced = upbead("reduce", "harbour.toml", "--json", "--out", "model", cwd=self.folder)
        self.assertEqual(json.loads(reduced.stdout)["warnings"], sorted_as(told, json.loads(reduced.stdout)["warnings"]))
        for warning in told:
            self.assertIn(f"warning: {warning['name']}: ", reduced.stderr)
        own = self.told("respond", "harbour.toml", "--out", "own")
        self.assertEqual([w for w in told if w not in own["warnings"]], [])
        (self.folder / "wave.csv").write_text("time,P\n0,0\n0.5,1e6\n1,0\n")
        other = self.told("respond", "model/reduced.h5", "wave.csv", "--out", "other")
        names = {warning["name"] for warning in other["warnings"]}
        self.assertIn("harbour_level", names)
        self.assertNotIn("effective_force", names, "it is of the case's wave alone")
        for found in (own, other):
            self.assertEqual(found["why_void"], "harbour_level")
        plain = self.respond("model/reduced.h5", "wave.csv", "--out", "plain")
        self.assertIn("\nverdict     VOID, as the warnings say: harbour_level\n", plain.stdout)

        design = text[text.index("[section]"):text.index("[loads.storm]")] + LIFE
        (self.folder / "life.toml").write_text(design)
        life = self.told("expected", "life.toml", "--out", "life")
        self.assertEqual(life["verdict"]["why_void"], "harbour_level")
        self.assertIsNone(life["verdict"]["holds"])

    def test_a_base_that_would_lift_is_told_of_a_wave_as_of_a_run(self):
        sliding = ["--set", "sliding={ friction = 0.6, submerged_weight = 2.6e6 }", "--set", "loads.impulse.factor=3"]
        run = self.summary("run", "--out", "run", *sliding)["warnings"]
        self.summary("reduce", "--out", "lifts", *sliding)
        (self.folder / "three.csv").write_text("\n".join(
            line if not line[:1].isdigit() else ",".join([line.split(",")[0], str(3 * float(line.split(",")[1]))])
            for line in (CASES / "fig2b-prototype-impulse.csv").read_text().splitlines()))
        lifts = [next(w for w in found if w["name"] == "would_lift")
                 for found in (run, self.told("respond", "lifts/reduced.h5", "three.csv", "--out", "three")["warnings"])]
        self.assertAlmostEqual(lifts[1]["value"] / lifts[0]["value"], 1, delta=0.01)

    def scene(self, name, *changes):
        text = CASE.read_text().replace('"fig2b', f'"{CASES}/fig2b').replace("[mesh.parameters]  # m", "[mesh.parameters]\ncells = 0.5")
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new, 1)
        (self.folder / name).write_text(text)
        return name

    def test_another_weight_and_friction_move_all_numbers_as_in_a_run(self):
        own, other = self.scene("own.toml"), self.scene("other.toml", ("friction = 0.6", "friction = 0.5"), ("4.296e6", "3e6"))
        self.told("reduce", own, "--out", "model")
        asked = ["--friction", 0.5, "--buoyant-weight", 3e6, "--out", "answer"]
        wave, run = self.told("respond", "model/reduced.h5", own, *asked)["waves"][0], self.told("run", other, "--out", "run")
        for key in ("peak_heel_pressure", "least_overturning_margin"):
            self.assertAlmostEqual(wave[key] / run["base"][key], 1, delta=2e-3, msg=key)
        for option, value in (("--buoyant-weight", 3000), ("--buoyant-weight", 9e6), ("--friction", 6)):
            told = self.told("respond", "model/reduced.h5", own, option, value, "--out", "unit")["warnings"]
            self.assertEqual([w["name"] for w in told if option in w["text"]], ["implausible"], (option, value))
        for share, void in ((1.01, None), (1.05, False), (1.2, True)):
            answer = self.told("respond", "model/reduced.h5", own, "--buoyant-weight", share * 4.296e6, "--out", "heavy")
            told = [w for w in answer["warnings"] if w["name"] == "submerged_weight"]
            self.assertEqual(len(told), 0 if void is None else 1, share)
            self.assertEqual("submerged_weight" in (answer["why_void"] or ""), bool(void), share)

    def test_a_case_as_a_wave_is_of_the_scene_of_the_model(self):
        self.told("reduce", self.scene("own.toml"), "--out", "model")
        slower, otherwise = ("factor = 0.0", "factor = 1.0"), ("direction = [1.0, 0.0]", "direction = [-1.0, 0.0]")
        for table, *change in ((None,), ("loads.impulse", otherwise), ("regions.seabed", ("29.382e6", "20e6")),
                               ("sliding", ("friction = 0.6", "friction = 0.3"))):
            told = self.told("respond", "model/reduced.h5", self.scene("wave.toml", *change), "--out", "answer")["warnings"]
            texts = [w["text"] for w in told if w["name"] == "model_of_other_scene"]
            self.assertEqual([f"they differ in {table}" in text for text in texts], [True] if table else [])
        refused = self.respond("model/reduced.h5", self.scene("slow.toml", slower))
        self.assertEqual(refused.returncode, 1)
        self.assertIn("'slow' is no load of the model; its loads are impulse", refused.stderr)

    def respond(self, *arguments):
        return upbead("respond", *arguments, cwd=self.folder)

    def make_model_and_waves(self, **changes):
        write_oscillator(self.folder / "model.h5", **changes)
        (self.folder / "roof.csv").write_text("time,P\n0,0\n0.05,1.6e6\n0.1,4e5\n1.5,0\n")
        time = np.arange(401) * 1e-3
        with h5py.File(self.folder / "storm.h5", "w") as file:
            file["time"] = time
            file["impact"] = np.outer(np.linspace(1e5, 2e6, 30), np.interp(time, [0, 0.075, 0.15], [0, 1, 0]))

    def test_respond_answers_one_wave_and_many(self):
        self.make_model_and_waves()
        friction = ["--friction", 0.6, "--buoyant-weight", 1e6]
        done = self.respond("model.h5", "roof.csv", "storm.h5", *friction)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for part in ("oscillator, reduced to 2 modes", "of 31 ", "peak F_T", "  storm[29]  ", "not 0 in",
                     "written     results/model-respond/{responses.h5, summary.json}"):
            self.assertIn(part, done.stdout)
        result = self.folder / "results/model-respond"
        self.assertEqual(sorted(os.listdir(result)), ["responses.h5", "summary.json"])
        summary = json.loads((result / "summary.json").read_text())
        self.assertEqual([w["name"] for w in summary["waves"][:3]], ["roof", "storm[0]", "storm[1]"])
        with h5py.File(result / "responses.h5") as file:
            self.assertEqual(file["storm/shear_force"].shape, (30, len(file["storm/time"])))
            for name in ("time", "force", "shear_force", "peak_force", "peak_shear", "peak_shear_seaward",
                         "peak_shear_time", "ratio", "beyond_band", "sliding"):
                self.assertTrue(file["storm"][name].attrs["unit"] and file["storm"][name].attrs["description"], name)
            self.assertEqual([w["sliding"] for w in summary["waves"]], [*file["roof/sliding"], *file["storm/sliding"]])
            np.testing.assert_allclose(file["storm/ratio"], file["storm/ratio"][0], rtol=1e-12)
            self.assertAlmostEqual(file["storm/time"][-1], 4.0)
        again = self.respond("model.h5", "roof.csv", "storm.h5", *friction, "--out", "again")
        self.assertEqual(again.returncode, 0)
        self.assertEqual((result / "responses.h5").read_bytes(), (self.folder / "again/responses.h5").read_bytes())

    def test_respond_prints_a_table_or_json(self):
        self.make_model_and_waves()
        done = self.respond("model.h5", "roof.csv", "roof.csv", "--end", 1)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"wave +peak P +peak F_T +F_T / P +error of F_T\nroof +1.6 MN/m .* 0\nroof-2 +1.6 MN/m ")
        done = self.respond("model.h5", "roof.csv", "--json")
        summary = json.loads(done.stdout)
        self.assertEqual(summary["model"], {"title": "oscillator", "file": "model.h5", "error": 0.004,
                                            "tolerance": 0.01, "highest_frequency": 50.0})
        self.assertIsNone(summary["waves"][0]["sliding"])
        self.assertEqual((summary["waves"][0]["error_estimate"], summary["warnings"]), (0, []))
        self.assertEqual(list(summary["timing"]), ["read", "respond", "write", "total"])
        self.assertGreater(summary["histories_per_second"], 0)

    def test_respond_warns_of_waves_that_the_model_does_not_cover(self):
        self.make_model_and_waves(highest=3.0)
        done = self.respond("model.h5", "roof.csv")
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stderr, r"^warning: beyond_band: reduce again .* or march the wave with 'upbead run'\n +1 of 1 waves reach "
                                      r"beyond .* 3 Hz: worst roof, where .* % of F_T .*\(tolerance 1 %\)\n$")

    def test_respond_warns_of_waves_whose_error_may_be_too_large(self):
        self.make_model_and_waves(nested=(1.01, 1.02))  # 1.2 x 2 % + 1.5 x 1 %
        done = self.respond("model.h5", "roof.csv", "--json")
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stderr, r"^warning: reduced_model_error: reduce again with an 'end' .*\n +F_T of 1 of 1 waves may be "
                                      r"wrong .* worst roof, by up to 3.9 % of its largest F_T \(tolerance 1 %\)\n$")
        summary = json.loads(done.stdout)
        self.assertAlmostEqual(summary["waves"][0]["error_estimate"], 0.039, delta=1e-4)
        self.assertEqual([w["name"] for w in summary["warnings"]], ["reduced_model_error"])
        self.make_model_and_waves(nested=None)
        done = self.respond("model.h5", "roof.csv", "--json")
        self.assertRegex(done.stderr, r"^warning: no_error_estimate: make the model again with 'upbead reduce'\n +the model holds nothing .* is null\n$")
        self.assertIsNone(json.loads(done.stdout)["waves"][0]["error_estimate"])

    def test_respond_warns_of_forces_that_are_none_beside_the_weight(self):
        self.make_model_and_waves()
        for peak, told in ((2.5, True), (2.5e6, False)):
            (self.folder / "w.csv").write_text(f"time,P\n0,0\n0.1,{peak}\n0.2,0\n")
            done = self.respond("model.h5", "w.csv")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual("implausible: if it was meant in " in done.stderr, told, done.stderr)

    def test_respond_refuses_wrong_input_and_writes_nothing(self):
        self.make_model_and_waves(loads=("impact", "slow"))
        before = self.left_behind()
        for arguments, message in (
                (["model.h5", "roof.csv"], "column 'P' is no load of the model; the model's loads are: impact, slow"),
                (["roof.csv", "roof.csv"], "roof.csv: no HDF5 file; give a model made by 'upbead reduce'"),
                (["storm.h5", "roof.csv"], "storm.h5: an HDF5 file, but no reduced model"),
                (["model.h5", "none.csv"], "cannot read 'none.csv'"),
                (["model.h5", "storm.h5", "--friction", 0.6], "give --buoyant-weight too (N/m)"),
                (["model.h5", "storm.h5", "--buoyant-weight", 1e6], "give --friction too"),
                (["model.h5", "storm.h5", "--end", 0], "--end 0 is not above 0"),
                (["model.h5", "storm.h5", "--end", 1e9], "lower --end")):
            done = self.respond(*arguments)
            self.assertEqual((done.returncode, done.stdout), (1, ""), arguments)
            self.assertIn(message, done.stderr)
            self.assertEqual(self.left_behind(), before)
        write_oscillator(self.folder / "model.h5", mass=0.0)
        done = self.respond("model.h5", "storm.h5", "--friction", 0.6, "--buoyant-weight", 1e6)
        self.assertEqual(done.returncode, 1)
        self.assertIn("nothing can slide", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
