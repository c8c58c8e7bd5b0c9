#!/usr/bin/python3
"""`upbead expected` as a person meets it: section 4 of the paper, lives, the caisson's own dynamics.

usage: expected_test.py PROGRAM CASES_FOLDER
"""

import json
import os
import pathlib
import pty
import signal
import subprocess
import sys
import unittest

import h5py
import numpy as np

from program import CASES, PROGRAM, ProgramTest, upbead, wait_until_it_catches

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
from hand_made_model import write_oscillator  # noqa: E402

HD12, HD10 = CASES / "section4/hd12.toml", CASES / "section4/hd10.toml"
PROTOTYPE = CASES / "expected/prototype.toml"
LIFE = ["--set", "life.simulated_lives=300", "--set", "scatter.force.cov=0.1", "--set", "scatter.friction.cov=0.1"]


class Expected(ProgramTest):
    def expected(self, design, *arguments, **options):
        done = upbead("expected", design, *arguments, "--json", cwd=self.folder, **options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_section_4_of_the_paper(self):
        """Published: 3.7 and 36.3 waves, 0.6 cm for H_D = 12.1 m and 45 cm for H_D = 10.5 m."""
        high, low = self.expected(HD12), self.expected(HD10)
        for found in (high, low):
            self.assertAlmostEqual(found["exceedance"]["HD_12"]["waves"], 3.7, delta=0.02 * 3.7)
            self.assertAlmostEqual(found["exceedance"]["HD_10"]["waves"], 36.3, delta=0.02 * 36.3)
            self.assertAlmostEqual(found["expected"]["waves"], 32.7e6, delta=1)
        self.assertAlmostEqual(low["expected"]["distance_paper"], 0.45, delta=0.15 * 0.45)
        self.assertTrue(0.006 / 5 < high["expected"]["distance_paper"] < 0.006 * 5)
        self.assertAlmostEqual(high["expected"]["threshold_height"]["paper"], 12.1, delta=1e-4)
        self.assertAlmostEqual(low["expected"]["threshold_height"]["paper"], 10.5, delta=1e-4)

    def test_section_4_slides_72_cm_in_the_highest_wave(self):
        done = upbead("waves", HD12, "--json", cwd=self.folder)
        self.assertAlmostEqual(json.loads(done.stdout)["waves"]["highest"]["sliding_paper"], 0.72, delta=1e-4)

    def test_low_seas_bring_nothing(self):
        states = self.expected(HD10)["expected"]["states"]
        self.assertLess(states[1]["distance"]["exact"], 1e-40)
        self.assertGreater(states[0]["distance"]["exact"], 0)

    def test_without_a_model_nothing_is_dynamic(self):
        found = self.expected(HD10)
        self.assertIsNone(found["expected"]["distance_dynamic"])
        self.assertIsNone(found["model"])
        self.assertIsNone(found["monte_carlo"])

    def test_lives_have_the_mean_of_quadrature(self):
        found = self.expected(HD10, "--set", "life.years=9", "--set", "life.simulated_lives=2000")
        life = found["monte_carlo"]
        self.assertEqual(life["law"], "exact")
        self.assertAlmostEqual(life["without_scatter"], found["expected"]["distance_exact"])
        self.assertLess(abs(life["mean"] - life["without_scatter"]), 3 * life["standard_error"])
        low, high = life["confidence_interval"]
        self.assertTrue(low < life["mean"] < high)

    def test_the_same_seed_gives_the_same_answer_on_any_number_of_threads(self):
        one = self.expected(HD10, *LIFE, preexec_fn=lambda: os.sched_setaffinity(0, [min(os.sched_getaffinity(0))]))
        all_cores = self.expected(HD10, *LIFE)
        self.assertEqual(one["monte_carlo"], all_cores["monte_carlo"])
        self.assertEqual(one["expected"], all_cores["expected"])
        other = self.expected(HD10, *LIFE, "--set", "life.seed=2")
        self.assertNotEqual(one["monte_carlo"]["mean"], other["monte_carlo"]["mean"])

    def test_files_are_written_whole_and_run_again(self):
        first = self.expected(HD10, *LIFE, "--out", "first")
        self.assertEqual(sorted(os.listdir(self.folder / "first")), ["case.toml", "results.h5", "summary.json"])
        again = self.expected(self.folder / "first/case.toml", "--out", "second")
        self.assertEqual(again["monte_carlo"], first["monte_carlo"])
        with h5py.File(self.folder / "first/results.h5") as file:
            lives = file["lives/sliding"][:]
            self.assertAlmostEqual(lives.mean(), first["monte_carlo"]["mean"])
            height = file["heights/height"][:]
            share = np.trapz(file["heights/contribution/exact"][:], height)
            self.assertAlmostEqual(share / first["expected"]["states"][0]["distance"]["exact"], 1, delta=0.01)
            self.assertEqual(file["lives/sliding"].attrs["unit"], b"m")

    def test_few_lives_that_slide_are_doubted(self):
        done = upbead("expected", HD12, "--set", "life.simulated_lives=5", cwd=self.folder)
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stderr, r"^warning: only \d of 5 lives slide: ")

    def test_own_dynamics_are_the_default_where_a_model_is_given(self):
        write_oscillator(self.folder / "model.h5", mass=5.933088e6 / 9.81)
        model = ["--set", f"dynamics.model={self.folder / 'model.h5'}", "--set", "dynamics.load=impact"]
        found = self.expected(PROTOTYPE, *model, "--set", "life.simulated_lives=20", "--set", "life.years=1")
        self.assertEqual(found["monte_carlo"]["law"], "dynamic")
        self.assertGreater(found["expected"]["distance_dynamic"], 0)
        self.assertEqual(found["model"]["load"], "impact")

    def test_goda_with_alpha_I_does_not_go_through_the_dynamics(self):
        write_oscillator(self.folder / "model.h5", mass=5.933088e6 / 9.81)
        done = upbead("expected", PROTOTYPE, "--set", f"dynamics.model={self.folder / 'model.h5'}", "--set",
                      "dynamics.load=impact", "--set", "impact.force=goda_with_alpha_I", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("would count twice", done.stderr)
        self.assertEqual(self.left_behind(), ["model.h5"])

    def test_shipped_prototype_runs_with_its_model(self):
        done = upbead("reduce", CASES / "fig2b-prototype.toml", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        model = self.folder / "results/fig2b-prototype/reduced.h5"
        found = self.expected(PROTOTYPE, "--set", f"dynamics.model={model}")
        self.assertGreater(found["expected"]["distance_dynamic"], found["expected"]["distance_paper"])

    def test_mistakes_leave_nothing(self):
        done = upbead("expected", HD10, "--set", "sea.years=0", "--set", "life.simulated_lives=1", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("years", done.stderr)
        self.assertIn("lives", done.stderr)
        self.assertEqual(self.left_behind(), [])

    def test_interrupted_lives_leave_nothing(self):
        long = ["--set", "life.simulated_lives=10000000", "--set", "scatter.period.cov=0.1"]
        process = subprocess.Popen([PROGRAM, "expected", HD10, *long],
                                   cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        wait_until_it_catches(signal.SIGINT, process)
        with self.assertRaises(subprocess.TimeoutExpired):
            process.wait(1)
        process.send_signal(signal.SIGINT)
        errors = process.communicate()[1]
        self.assertEqual(process.returncode, 130, errors)
        self.assertEqual(self.left_behind(), [])

    def test_progress_is_shown_on_a_terminal(self):
        leader, follower = pty.openpty()
        process = subprocess.Popen([PROGRAM, "expected", HD10, *LIFE, "--set", "life.simulated_lives=50000"], cwd=self.folder,
                                   stdout=subprocess.DEVNULL, stderr=follower)
        os.close(follower)
        text = b""
        try:
            while chunk := os.read(leader, 4096):
                text += chunk
        except OSError:  # the terminal closes when the program ends
            pass
        self.assertEqual(process.wait(), 0)
        self.assertIn(b"simulating lives", text)

    def test_storms_are_drawn_without_a_record(self):
        text = HD10.read_text()
        (self.folder / "storms.toml").write_text(
            text[:text.index("[sea]")] + "[storms]\nlocation = 3\nscale = 1.5\nshape = 1.4\nsteepness = 0.03\n"
            "tide_high = 1\n[life]\nlives = 300\nyears = 50\n")
        found = self.expected("storms.toml")
        self.assertIsNone(found["expected"])
        self.assertIsNone(found["monte_carlo"]["without_scatter"])
        self.assertGreater(found["monte_carlo"]["mean"], 0)
        higher = self.expected("storms.toml", "--set", "storms.location=4")
        self.assertGreater(higher["monte_carlo"]["mean"], found["monte_carlo"]["mean"])

    def test_results_are_drawn(self):
        script = CASES.parent / "postprocess/expected_sliding.py"
        draw = lambda *arguments: subprocess.run([sys.executable, "-B", script, *arguments], cwd=self.folder,
                                                 capture_output=True, text=True)
        self.expected(HD10, "--out", "low")
        self.expected(HD12, "--out", "high")
        done = draw("low", "high", "--law", "paper", "-o", "figure.png")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertGreater((self.folder / "figure.png").stat().st_size, 10000)
        done = draw("nothing")
        self.assertEqual(done.returncode, 1)
        self.assertIn("holds no results of 'upbead expected'", done.stderr)

    def test_help_teaches_by_example(self):
        done = upbead("expected", "--help")
        self.assertEqual(done.returncode, 0)
        self.assertIn("upbead expected cases/section4/", done.stdout)
        self.assertIn("[scatter", upbead("expected", "--keys").stdout)
        self.assertEqual(upbead("expected").returncode, 1)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
