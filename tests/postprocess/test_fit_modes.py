"""Fits to natural frequencies and damping: known parameters are recovered, intervals are right, and no mode is
exchanged without a message.

usage: test_fit_modes.py FOLDER_OF_THE_SCRIPTS PROGRAM
"""

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

SCRIPTS, PROGRAM = (Path(argument).resolve() for argument in sys.argv[1:3])
sys.path.insert(0, str(SCRIPTS))
sys.path.insert(0, str(Path(__file__).parents[1] / "support"))
os.environ["UPBEAD"] = str(PROGRAM)
import upbead  # noqa: E402
import section_scene  # noqa: E402
from upbead.fit import judge, solve  # noqa: E402
from upbead.fit_modes import SHORTEST, Paired, at_small_strain, surveyed  # noqa: E402
from upbead.fit_parameters import Parameters  # noqa: E402
from upbead.fit_runs import Runs  # noqa: E402
from upbead.fit_weights import Weights  # noqa: E402

SEABED, MOUND, DAMPING = "regions.seabed.shear_modulus", "regions.mound.shear_modulus", "regions.seabed.damping.ratio"
G, NORMAL = 27e6, 1.959964
TIE = {MOUND: f"1.6666667*{SEABED}"}
DRY = {f"regions.{name}.{key}": value for name in ("seabed", "mound") for key, value in (("flow", "drained"), ("damping.ratio", 0.0))}


class OfTheProgram(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)
        self.case = self.folder / "case.toml"
        self.case.write_text(section_scene.SCENE)

    def modes(self, **keys):
        with upbead.run(self.case, set={"time.scheme": "reduced", **keys}, out=self.folder / "truth") as result:
            return [(1 / mode["period"], mode["damping_ratio"]) for mode in result.summary["periods"]]

    def assert_near(self, found, truth, relative=1e-6):
        self.assertLess(abs(found / truth - 1), relative)


class Planted(OfTheProgram):
    def test_dry_undamped_ground_has_frequencies_by_the_root_of_G(self):
        (f, _), *_ = self.modes(**DRY, **{SEABED: G, MOUND: 1.6666667 * G})
        found = upbead.fit(self.case, frequencies=[(f, 0.02 * f)], parameters={SEABED: 2.2 * G}, ties=TIE, set=DRY)
        self.assert_near(found.values[SEABED], G)
        self.assertAlmostEqual(np.log(found.confidence[SEABED][1] / found.values[SEABED]), 2 * NORMAL * 0.02, delta=1e-6)
        (mode,) = found.modes
        self.assertEqual((mode["first guess"]["mode"], mode["fit"]["mode"]), (1, 1))
        self.assert_near(mode["first guess"]["frequency"], f * np.sqrt(2.2), 1e-4)
        self.assertIn(f"mode of {f:.4g} +- ", str(found))
        self.assertEqual((found.noise, found.time.size, len(upbead.figures.fit(found).axes)), (None, 0, 1))
        with self.assertRaisesRegex(upbead.UserError, "no damping where a measured"):
            upbead.fit(self.case, frequencies=[(f, 0.1)], dampings=[(0.03, 0.01)], parameters={SEABED: G}, ties=TIE, set=DRY)

    def test_damped_layers_with_pore_water_by_two_modes(self):
        truth = {SEABED: G, MOUND: 45e6, DAMPING: 0.06}
        sway, rocking, *_ = self.modes(**truth)
        found = upbead.fit(self.case, frequencies=[(sway[0], 0.01 * sway[0]), (rocking[0], 0.01 * rocking[0], 2)],
                           dampings=[(sway[1], 0.1 * sway[1])], parameters={SEABED: 1.4 * G, MOUND: 60e6, DAMPING: 0.08})
        for key, value in truth.items():
            self.assert_near(found.values[key], value)
        self.assertEqual([mode["fit"]["mode"] for mode in found.modes], [1, 2])
        self.assert_near(found.modes[0]["fit"]["damping_ratio"], sway[1])

    def test_beside_a_record_the_interval_is_narrower_than_by_either(self):
        with upbead.run(self.case, set={"time.scheme": "reduced", SEABED: G, MOUND: 1.6666667 * G}, out=self.folder / "truth") as run:
            time, f = np.arange(0.0, 0.6, 2e-3), 1 / run.summary["periods"][0]["period"]
            exact = np.interp(time, run.time, run["shear_force"])
        value = exact + 0.1 * exact.max() * np.random.default_rng(1).standard_normal(time.size)
        half = []
        for record, frequencies in (((time, value), None), (None, [(f, 0.004 * f)]), ((time, value), [(f, 0.004 * f)])):
            found = upbead.fit(self.case, record, frequencies=frequencies, parameters={SEABED: 1.2 * G}, ties=TIE)
            half.append(np.log(found.confidence[SEABED][1] / found.values[SEABED]))
            self.assert_near(found.values[SEABED], G, 1.5 * np.expm1(half[-1]))
        self.assertLess(half[2], min(half[:2]))
        self.assertAlmostEqual(half[2], (half[0] ** -2 + half[1] ** -2) ** -0.5, delta=0.03 * half[2])  # independent data
        self.assertEqual(len(upbead.figures.fit(found).axes), 3)

    def test_soil_that_follows_the_strain_is_taken_at_small_strain(self):
        curves = {"regions.seabed.strain.reference_strain": 1e-4, "regions.seabed.strain.smallest_damping": 0.05}
        linear, under_the_wave = self.modes()[0][0], self.modes(**curves)[0][0]
        self.assertLess(under_the_wave, 0.7 * linear)
        self.case.write_text(section_scene.SCENE + "[regions.seabed.strain]\nreference_strain = 1e-4\nsmallest_damping = 0.05\n")
        with upbead.run(self.case, set={"time.scheme": "reduced"}, out=self.folder / "run") as result:
            small = at_small_strain(result.case)
        for wants_history in (True, False):
            runs = Runs(self.case, "shear_force", {}, None, 2, None)
            runs.small, runs.wants_modes, runs.wants_history = small, True, wants_history
            ((time, _, modes),) = runs.answers([{}])
            self.assert_near(modes[0, 0], linear, 1e-4)
            self.assertEqual((time.size > 1, runs.n_runs), (wants_history, 2 if wants_history else 1))

    def test_command(self):
        (f, zeta), *_ = self.modes(**{SEABED: G, MOUND: 1.6666667 * G})
        command = [sys.executable, SCRIPTS / "fit.py", "case.toml", "--parameter", SEABED, "--tie", f"{MOUND}={TIE[MOUND]}",
                   "--out", "out"]
        done = subprocess.run([*command, "--frequency", f"{f}:0.03", "--damping", f"{zeta}:0.006"], cwd=self.folder,
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("it is mode 1 of the first guess", done.stdout)
        told = json.loads((self.folder / "out/fit.json").read_text())
        self.assert_near(told["values"][SEABED], G, 1e-6)
        self.assertEqual((told["noise"], told["samples"], len(told["modes"])), (None, 0, 1))
        self.assertFalse((self.folder / "out/fit.csv").exists())
        self.assertTrue((self.folder / "out/fit.png").is_file())
        done = subprocess.run([*command, "--frequency", "1.2"], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("'1.2' is no measured mode; write VALUE:STANDARD_DEVIATION", done.stderr)

    def test_mistakes_are_told_with_a_cure(self):
        for options, words in (
                ({}, "give a record, or frequencies"),
                ({"dampings": [(0.03, 0.01)]}, "give its frequency too"),
                ({"frequencies": [(1.2, 0.1)], "dampings": [(0.03, 0.01)] * 2}, "2 damping ratios of 1 frequencies"),
                ({"frequencies": [1.2]}, "not understood"),
                ({"frequencies": [(1.2, 0.0)]}, "not understood"),
                ({"frequencies": [(1.2, 0.1)], "dampings": [(3.1, 0.6)]}, "3.1 % is 0.031"),
                ({"frequencies": [(1.2, 0.1, 1), (2.0, 0.1, 1)]}, "each frequency another"),
                ({"frequencies": [(1.2, 0.1, 99)]}, "up to mode 99; by the first guess F_T has these modes: 1: 1.27"),
                ({"frequencies": [(1.2, 0.1)], "parameters": {"record.time_factor": 1.0}}, "none is given"),
                ({"frequencies": [(1.2, 0.1)], "set": {"time.scheme": "sdirk4"}}, 'solved by sdirk4.*set time.scheme to "reduced"')):
            with self.subTest(words), self.assertRaisesRegex(upbead.UserError, words):
                upbead.fit(self.case, **{"parameters": {SEABED: None}, **options})


class Modes:
    """Runs that take no time: modes f_i = f0_i prod theta^power_i, each with a damping ratio and a share."""

    failures = []

    def __init__(self, *modes, scale=1.0):
        self.list, self.n_runs, self.scale = modes, 0, scale

    def modes(self, points):
        found = []
        for point in points:
            self.n_runs += 1
            rows = [[f0 * np.prod(np.power(list(point.values()), power)), 0.03, share(point)] for f0, power, share in self.list]
            found.append(np.array(sorted(rows, key=lambda row: -row[2])))
        return found

    def finer(self, point):
        return self.modes([point])[0] * [self.scale, 1.0, 1.0] if self.scale else None


def constant(share):
    return lambda point: share


def parameters(**guess):
    return Parameters(guess, -2.3 * np.ones(len(guess)), 2.3 * np.ones(len(guess)), False)


def fitted(measured, runs, keys):
    paired = Paired(measured, runs, keys)
    weights = Weights(0, None, measured.uncertainty)
    solution = solve(lambda points: [paired.rows(x) for x in points], measured.values, keys, [], weights)
    return paired, solution, judge(keys, solution, measured.values, None, 0.25, weights)


class Pairing(unittest.TestCase):
    """Two modes whose shares, or frequencies, change their order as G grows."""

    def test_a_mode_is_followed_through_a_change_of_shares_and_that_is_told(self):
        grows = (1.0, [0.5], lambda point: 0.5 / point["G"])
        falls = (3.0, [0.5], lambda point: 0.1 * point["G"])
        for rank, cautions in ((None, 1), (1, 0)):
            measured = surveyed([(2.0, 0.02, rank)], None)
            paired, solution, _ = fitted(measured, Modes(grows, falls), parameters(G=1.0))
            self.assertAlmostEqual(np.exp(solution.x[0]), 4.0)  # not (2/3)^2
            told = paired.cautions(solution.x)
            self.assertEqual(len(told), cautions, told)
            self.assertEqual([row["fit"]["mode"] for row in paired.table(solution.x)], [2])
        paired = Paired(surveyed([(2.0, 0.02)], None), Modes(grows, falls), parameters(G=1.0))
        paired.at(np.log([4.0]))
        self.assertIn("changed places", paired.cautions(np.log([4.0]))[0])

    def test_modes_that_cross_are_doubted(self):
        runs = Modes((1.0, [1.0], constant(0.4)), (2.0, [0.0], constant(0.35)))
        paired = Paired(surveyed([(1.0, 0.01, 1), (2.0, 0.01, 2)], None), runs, parameters(G=1.0))
        np.testing.assert_allclose(paired.at(np.log([1.7]))[:, 0], [1.7, 2.0])
        self.assertEqual(paired.doubts, [])
        paired.at(np.log([2.05]))
        self.assertIn("comes close to another", paired.doubts[0])

    def test_a_mode_that_is_lost_answers_nan_and_is_told(self):
        runs = Modes((1.0, [0.5], lambda point: 0.3 if point["G"] < 2 else 1e-6), (5.0, [0.5], constant(0.2)))
        paired = Paired(surveyed([(1.0, 0.01)], None), runs, parameters(G=1.0))
        self.assertTrue(np.isnan(paired.at(np.log([2.5]))[0, 0]) or paired.doubts)
        self.assertTrue(paired.doubts)

    def test_short_ways_need_no_run_between(self):
        runs = Modes((1.0, [0.5], constant(0.5)), (3.0, [0.5], constant(0.2)))
        paired = Paired(surveyed([(1.0, 0.01)], None), runs, parameters(G=1.0))
        before = runs.n_runs
        paired.at(np.array([0.5 * SHORTEST]))
        paired.at(np.array([0.53]))
        self.assertLessEqual(runs.n_runs - before, 6)
        self.assertEqual(len(paired.index), 3)

    def test_of_several_the_order_of_frequencies_counts_and_a_narrow_choice_is_told(self):
        runs = Modes((1.0, [0.5], constant(0.2)), (3.0, [0.5], constant(0.5)), (6.0, [0.5], constant(0.15)))
        paired = Paired(surveyed([(2.9, 0.1), (1.1, 0.1)], None), runs, parameters(G=1.0))
        np.testing.assert_allclose(paired.at(np.zeros(1))[:, 0], [3.0, 1.0])
        self.assertIn("mode of 1 Hz by the first guess has hardly more share than that of 6 Hz", paired.cautions(np.zeros(1))[0])
        told = Paired(surveyed([(2.9, 0.1, 1), (1.1, 0.1, 2)], None), runs, parameters(G=1.0))
        self.assertEqual(told.cautions(np.zeros(1)), [])

    def test_far_frequencies_and_coarse_models_are_told(self):
        for scale, words in ((1.01, "moves what is computed by 1 %"), (None, "no finer reduced model converges")):
            runs = Modes((1.0, [0.0], constant(0.5)), scale=scale)
            paired = Paired(surveyed([(1.1, 0.02)], None), runs, parameters(G=1.0))
            far, coarse = paired.cautions(np.zeros(1))
            self.assertIn("the frequency 1.1 Hz lies 5.2 of its uncertainties from the fit", far)
            self.assertIn(words, coarse)


class Intervals(unittest.TestCase):
    def test_one_frequency_with_two_moduli_fixes_their_product(self):
        runs = Modes((1.0, [0.3, 0.2], constant(0.5)))
        paired, solution, found = fitted(surveyed([(1.1, 0.022)], None), runs, parameters(A=1.0, B=1.0))
        self.assertAlmostEqual(paired.at(solution.x)[0, 0], 1.1)
        (product,), (free,) = found["identifiable"].fixed, found["identifiable"].free
        self.assertAlmostEqual(product.exponents["B"], 2 / 3, places=6)
        self.assertAlmostEqual(product.interval, NORMAL * 0.02 / 0.3, places=6)
        self.assertAlmostEqual(free.exponents["A"] / free.exponents["B"], -2 / 3, places=6)
        self.assertEqual(free.within, "any")

    def test_hold_the_truth_as_often_as_they_say(self):
        """Intervals by a record of unknown noise, by two frequencies of an oscillator, and by both."""
        time, truth, noise, error = np.linspace(0.0, 2.0, 40), np.array([100.0, 0.1]), 0.15, np.array([0.02, 0.03, 0.2])
        keys = parameters(G=120.0, damping=0.08)

        def rows(x):
            g, zeta = np.exp(x) * [120.0, 0.08]
            w, damped = np.sqrt(g), np.sqrt(g * max(1 - zeta**2, 1e-6))
            return np.concatenate([10 * np.exp(-zeta * w * time) * np.sin(damped * time) / damped, np.log([w, 3 * w, zeta])])

        exact, width = rows(np.log(truth / [120.0, 0.08])), {}
        for name, part, samples, given in (("record", slice(0, 40), 40, error[:0]), ("modes", slice(40, None), 0, error),
                                           ("both", slice(0, None), 40, error)):
            weights, held, half = Weights(samples, None, given), [], []
            for seed in range(200):
                rng = np.random.default_rng(seed)
                measured = (exact + np.concatenate([noise * rng.standard_normal(40), error * rng.standard_normal(3)]))[part]
                solution = solve(lambda points: [rows(x)[part] for x in points], measured, keys, [], weights)
                found = judge(keys, solution, measured, None, 0.25, weights)
                ends = np.array(list(found["confidence"].values()))
                held.append((ends[:, 0] < truth) & (truth < ends[:, 1]))
                half.append(np.log(ends[:, 1] / ends[:, 0]) / 2)
            share, width[name] = np.mean(held, axis=0), np.mean(half, axis=0)
            self.assertTrue(((share > 0.90) & (share < 0.995)).all(), (name, share))  # 3 standard deviations of 200 trials
        self.assertTrue((width["both"] < np.minimum(width["record"], width["modes"])).all(), width)
        self.assertAlmostEqual(width["modes"][0], 2 * NORMAL / np.sqrt(0.02**-2 + 0.03**-2), places=5)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
