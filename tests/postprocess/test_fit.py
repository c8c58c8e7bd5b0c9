"""Fits to a record: known parameters are recovered, the intervals contain them, and parameters that the record does
not determine are reported.

usage: test_fit.py FOLDER_OF_THE_SCRIPTS PROGRAM
"""

import csv
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
from upbead import fit_directions, fit_record, least_squares  # noqa: E402
from upbead.fit import first_run, judge, solve  # noqa: E402
from upbead.fit_parameters import Parameters, parse_ties  # noqa: E402
from upbead.fit_runs import Runs  # noqa: E402

SCENE = section_scene.SCENE.replace("cells = 0.5", "cells = 0.2")
SEABED, MOUND, DAMPING = "regions.seabed.shear_modulus", "regions.mound.shear_modulus", "regions.seabed.damping.ratio"
PEAK, DURATION, FACTOR = "loads.impulse.pulse.peak", "loads.impulse.pulse.duration", "record.time_factor"
G = 30e6
TIE = {MOUND: f"1.6666667*{SEABED}"}


class InFolder(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def write_case(self, text=SCENE):
        path = self.folder / "case.toml"
        path.write_text(text)
        return path

    def plant(self, seed, every=1e-3, reading="shear_force", noise=0.05, keys=None):
        """Times and the case's own history with noise, a share of its peak."""
        keys = {"time.scheme": "reduced", "time.step": every / 2} | (keys or {})
        with upbead.run(self.write_case(), set=keys, out=self.folder / "truth") as result:
            time = np.arange(0.0, 0.6, every)
            value = np.interp(time, result.time, result[reading])
        return time, value + noise * np.abs(value).max() * np.random.default_rng(seed).standard_normal(time.size)

    def assert_within(self, found, truth, relative):
        self.assertLess(abs(found / truth - 1), relative)

    def assert_holds(self, interval, truth):
        self.assertTrue(interval[0] < truth < interval[1], f"{truth} is not in {interval}")


class Planted(InFolder):
    def test_stiffness_and_damping_come_back(self):
        found = upbead.fit(self.folder / "case.toml", self.plant(1), parameters={SEABED: 2 * G, DAMPING: 0.1}, ties=TIE)
        self.assert_within(found.values[SEABED], G, 0.02)
        self.assert_holds(found.confidence[SEABED], G)
        self.assert_holds(found.confidence[DAMPING], 0.05)
        self.assertLess(found.confidence[SEABED][1] / found.confidence[SEABED][0], 1.02)
        self.assert_within(found.noise, 0.05 * np.abs(found.computed.values).max(), 0.1)
        self.assertEqual(found.cautions, [])
        np.testing.assert_allclose(found.residual.values, found.record.values - found.computed.values)
        self.assertGreater(np.sum((found.record.values - found.first.values) ** 2), 10 * np.sum(found.residual.values**2))
        self.assert_within(found.settings[MOUND], 1.6666667 * found.values[SEABED], 1e-12)
        figure = upbead.figures.fit(found)
        self.assertEqual(len(figure.axes), 3)
        upbead.figures.save(figure, self.folder / "fit.png")

    def test_a_record_of_the_case_by_a_range(self):
        time, value = self.plant(3)
        np.savetxt(self.folder / "lab.csv", np.transpose([time + 2.0, value / 1e3]), delimiter=",", comments="",
                   header="t (s),F_T (kN/m)")
        lab = '[measured.lab]\nfile = "lab.csv"\ncolumn = "F_T"\nreading = "shear_force"\nrecord_start = 2.0\n'
        found = upbead.fit(self.write_case(SCENE + lab), "lab", parameters={SEABED: (G / 8, 5 * G)}, ties=TIE)
        self.assert_within(found.values[SEABED], G, 0.02)
        self.assert_holds(found.confidence[SEABED], G)
        self.assertIn(f"fixed: {SEABED}, within 0.", str(found))
        np.testing.assert_allclose(found.record.values, value, atol=1.0)
        with self.assertRaisesRegex(upbead.UserError, "'lob' is no file, and no record of the case; these are: lab"):
            upbead.fit(self.folder / "case.toml", "lob", parameters={SEABED: G})

    def test_by_the_command_from_below(self):
        time, value = self.plant(4, every=2e-3)
        with open(self.folder / "lab.csv", "w") as file:  # begins with a second of rest, with an offset of 7 kN/m
            print("time (ms);P (kN/m);F_T (kN/m)", file=file)
            rest = [(t, 0.0) for t in np.arange(-1.0, -1e-9, 2e-3)]
            for t, v in [*rest, *zip(time, value)]:
                print(f"{1e3 * (t + 1):.6f};0;{1e-3 * v + 7:.6f}".replace(".", ","), file=file)
        done = subprocess.run(
            [sys.executable, SCRIPTS / "fit.py", "case.toml", "--record", "lab.csv", "--column", "F_T", "--start", "1",
             "--zero", "0.9", "--parameter", f"{SEABED}=1.5e7", "--tie", f"{MOUND}=1.6666667*{SEABED}", "--out", "out"],
            cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"run it with --set {SEABED}=", done.stdout)
        told = json.loads((self.folder / "out/fit.json").read_text())
        self.assert_within(told["values"][SEABED], G, 0.02)
        self.assertEqual((told["unit"], told["samples"]), ("N/m", 300))
        with open(self.folder / "out/fit.csv", newline="") as file:
            head, *rows = csv.reader(file)
        self.assertEqual(head, ["time (s)", "record (N/m)", "first guess (N/m)", "fit (N/m)"])
        np.testing.assert_allclose([float(row[1]) for row in rows], value, atol=2.0)
        self.assertTrue((self.folder / "out/fit.png").is_file())


class NotIdentifiable(InFolder):
    DRAINED = {"regions.seabed.flow": "drained", "regions.mound.flow": "drained", "time.scheme": "sdirk4", "time.step": 2e-3}

    def test_of_a_short_pulse_only_the_impulse_is_known(self):
        short = {**self.DRAINED, DURATION: 0.002, PEAK: 75e6}  # the response takes a second
        found = upbead.fit(self.folder / "case.toml", self.plant(5, every=3e-3, keys=short), set=short,
                           parameters={PEAK: 90e6, DURATION: 0.0018})
        self.assert_within(found.values[PEAK] * found.values[DURATION], 150e3, 0.03)
        (impulse,), (free,) = found.identifiable.fixed, found.identifiable.free
        self.assertEqual(list(impulse.exponents), [PEAK, DURATION])
        self.assertAlmostEqual(impulse.exponents[DURATION], 1.0, delta=0.03)
        self.assert_holds(np.exp(impulse.interval * np.array([-1, 1])), found.values[PEAK] * found.values[DURATION] / 150e3)
        self.assertLess(impulse.interval, 0.03)
        self.assertAlmostEqual(free.exponents[DURATION], -1.0, delta=0.03)
        self.assertGreater(found.confidence[PEAK][1] / found.confidence[PEAK][0], 1.5)
        self.assertLess(found.correlation[0, 1], -0.99)
        self.assertIn(f"only this is fixed: {PEAK} x {DURATION}, within", str(found))
        self.assertIn(f"not fixed: {PEAK} x c with {DURATION} x c^-", str(found))

    def test_without_a_time_axis_only_g_td2_is_known(self):
        sides = {f"boundaries.{side}.displacement": "absorbing" for side in ("base", "left", "right")}
        case = self.write_case(SCENE.replace("damping = { ratio = 0.05, frequencies = [1, 10] }", ""))
        runs = Runs(case, "shear_force", parse_ties(TIE, [SEABED]), {**self.DRAINED, **sides}, 2, None)
        time = np.arange(0.0, 0.4, 2e-3)
        runs.look_at(time)
        parameters = Parameters({SEABED: G, DURATION: 0.15, FACTOR: 1.0}, -np.ones(3), np.ones(3), False)
        slower = {SEABED: G / 1.4**2, DURATION: 0.15 * 1.4, FACTOR: 1.4}
        own, similar = runs.at(time, [parameters.point(np.zeros(3)), slower])
        np.testing.assert_allclose(similar, own, atol=1e-10 * own.max())  # the record is the same
        jacobian, doubt = least_squares.differences(
            lambda points: runs.at(time, [parameters.point(x) for x in points]), np.zeros(3), parameters.low, parameters.high)
        known = fit_directions.identifiable(parameters.keys, jacobian, 0.05 * own.max(), 2.0, 0.25, doubt)
        self.assertEqual([list(product.exponents) for product in known.fixed], [[SEABED, DURATION], [SEABED, FACTOR]])
        for product, key in zip(known.fixed, (DURATION, FACTOR)):
            self.assertAlmostEqual(product.exponents[key], 2.0, delta=0.05)
            self.assertLess(product.interval, 0.05)
        self.assertEqual(known.free[0].within, "any")


class Oscillator:
    """x'' + 2 z w x' + w^2 x under an impulse, with w = sqrt(G): a model that takes no time."""

    time = np.linspace(0.0, 2.0, 50)
    truth = {"G": 100.0, "damping": 0.1}

    def __init__(self):
        self.parameters = Parameters({"G": 150.0, "damping": 0.07}, -2 * np.ones(2), 2 * np.ones(2), False)
        self.exact = self.of(self.truth)

    def of(self, point):
        w, z = np.sqrt(point["G"]), point["damping"]
        damped = w * np.sqrt(1 - z * z) if z < 1 else np.nan
        return np.exp(-z * w * self.time) * np.sin(damped * self.time) / damped * 10

    def compute(self, points):
        return [self.of(self.parameters.point(x)) for x in points]

    def fit(self, measured, noise=None):
        solution = solve(self.compute, measured, self.parameters)
        return self.parameters.point(solution.x), judge(self.parameters, solution, measured, noise, 0.25)


class Confidence(unittest.TestCase):
    def test_intervals_hold_the_truth_as_often_as_they_say(self):
        model, noise = Oscillator(), 0.05
        for given in (None, noise):
            held, logs, told = [], [], []
            for seed in range(200):
                rng = np.random.default_rng(seed)
                values, found = model.fit(model.exact + noise * rng.standard_normal(50), given)
                held.append([low < model.truth[key] < high for key, (low, high) in found["confidence"].items()])
                logs.append([np.log(value / model.truth[key]) for key, value in values.items()])
                told.append((found["noise"] ** 2, *np.diag(found["covariance"]), found["correlation"][0, 1]))
            share = np.mean(held, axis=0)
            self.assertTrue(((share > 0.90) & (share < 0.995)).all(), share)  # 3 standard deviations of 200 trials
            variance, g, damping, correlation = np.mean(told, axis=0)
            self.assertLess(abs(variance / noise**2 - 1), 0.03)
            np.testing.assert_allclose([g, damping], np.var(logs, axis=0), rtol=0.3)
            self.assertAlmostEqual(correlation, np.corrcoef(np.transpose(logs))[0, 1], delta=0.2)

    def test_a_guess_far_off_and_values_that_cannot_be(self):
        model, noise = Oscillator(), 0.05 * np.random.default_rng(1).standard_normal(Oscillator.time.size)
        model.parameters.guess.update(G=250.0, damping=0.6)  # nan for a damping ratio of 1 or more
        values, found = model.fit(model.exact + noise)
        self.assertLess(abs(values["G"] / 100 - 1), 0.05)
        self.assertLess(abs(values["damping"] / 0.1 - 1), 0.3)
        for side in (1, -1):  # undefined on one side of 0
            jacobian, doubt = least_squares.differences(
                lambda points: [np.where(side * x > 0, np.nan, 3 * x) for x in points], np.zeros(1), -np.ones(1), np.ones(1))
            np.testing.assert_allclose((jacobian[0, 0], doubt[0]), (3.0, 0.0))
        model.parameters.guess.update(damping=20.0)
        with self.assertRaisesRegex(upbead.CaseError, "refused"):
            solve(model.compute, model.exact, model.parameters, [upbead.CaseError("refused")])

    def test_a_first_look_goes_where_it_is_better(self):
        def compute(points):
            return [np.array([x[0] - 1.2, 0.1 * x[1]]) if x[1] < 1 else np.full(2, np.nan) for x in points]

        low, high = -np.ones(2), np.array([1.1, 3.0])
        found = least_squares.compass(compute, np.zeros(2), np.zeros(2), low, high)
        np.testing.assert_allclose(found, [1.1, 0.0])  # two steps, cut at the end of the range
        again = least_squares.compass(compute, np.zeros(2), found, low, high)
        np.testing.assert_array_equal(again, found)

    def test_slow_noise_and_ends_of_ranges_are_told(self):
        model = Oscillator()
        white = np.random.default_rng(1).standard_normal(52)
        self.assertEqual(model.fit(model.exact + 0.05 * white[2:])[1]["cautions"], [])
        slow = np.convolve(white, np.ones(3) / 3, "valid")
        (caution,) = model.fit(model.exact + 0.05 * slow)[1]["cautions"]
        self.assertIn("not white", caution)
        model.parameters.low[0] = np.log(0.8)
        cautions = model.fit(model.exact)[1]["cautions"]
        self.assertIn("G went to an end of its range, 120", cautions[0])


class Directions(unittest.TestCase):
    def known(self, jacobian, limit=0.25, doubt=None):
        return fit_directions.identifiable(["a", "b", "c"][: jacobian.shape[1]], jacobian, 0.01, 2.0, limit, doubt)

    def test_products_are_simple_and_right(self):
        curve = np.random.default_rng(1).standard_normal((50, 2))
        known = self.known(curve @ np.array([[1.0, 0.0, -0.5], [0.0, 1.0, 3.0]]))
        self.assertEqual([list(product.exponents) for product in known.fixed], [["a", "b"], ["b", "c"]])
        for product in known.fixed:  # along the null direction (0.5, -3, 1) neither changes
            powers = np.array([product.exponents.get(key, 0.0) for key in "abc"])
            self.assertAlmostEqual(powers @ [0.5, -3.0, 1.0], 0.0)
        np.testing.assert_allclose(list(known.free[0].exponents.values()), [-1 / 6, 1.0, -1 / 3])
        self.assertIn("not fixed: a x c^-0.17 with b x c with c x c^-0.33 fits as well, c any", str(known))

    def test_intervals_of_products_are_those_of_the_covariance(self):
        jacobian = np.random.default_rng(2).standard_normal((80, 2)) @ np.array([[1.0, 1.0], [0.0, 0.05]])
        known = self.known(jacobian)
        exact = 0.01**2 * np.linalg.inv(jacobian.T @ jacobian)
        np.testing.assert_allclose(known.ellipsoid() / 4, exact)
        for product, variance in zip(known.fixed, np.diag(exact)):
            self.assertAlmostEqual(product.interval, 2 * np.sqrt(variance))
        self.assertEqual(self.known(jacobian, limit=1e-4).fixed, [])
        weak = self.known(jacobian, limit=0.01)
        self.assertEqual((len(weak.fixed), len(weak.free)), (1, 1))
        self.assertAlmostEqual(weak.fixed[0].exponents["b"], 1.0, delta=0.05)

    def test_what_is_less_than_the_doubt_is_not_told(self):
        jacobian = np.random.default_rng(3).standard_normal((80, 2)) * [1.0, 0.1]
        self.assertEqual(len(self.known(jacobian, doubt=np.array([0.01, 0.01])).fixed), 2)
        self.assertEqual(len(self.known(jacobian, doubt=np.array([0.01, 0.2])).fixed), 1)


class Records(InFolder):
    """The program reads record files, and its tests cover that; tested here is that all options about them reach the
    program."""

    def read(self, column, unit=None, start=None, zero=None):
        runs = Runs(self.folder / "case.toml", None, {}, {"mesh.parameters.cells": 1.0}, 2, None)
        name, keys = fit_record.named(self.folder / "lab.csv", "shear_force", column, unit, start, zero)
        return first_run(runs, {}, name, keys)["record"]

    def test_files_are_read_by_the_program(self):
        (self.folder / "lab.csv").write_text("t [ms];P [kN/m];F_T [N/m]\n0;1;1\n200;1;3\n400;2;-2,5\n")
        self.write_case()
        record = self.read(column="F_T", unit="tf/m", start=0.1, zero=0.25)
        np.testing.assert_allclose(record.time, [-0.1, 0.1, 0.3])
        np.testing.assert_allclose(record.value, np.array([-1.0, 1.0, -4.5]) * 9806.65)
        for options, words in (({"column": "F_S"}, "'F_S'"), ({"column": None, "unit": "kPa"}, "kPa"),
                               ({"column": "F_T", "start": 7.0}, "record_start")):
            with self.assertRaisesRegex(upbead.UserError, words):
                self.read(**options)

    def test_cut(self):
        record = fit_record.Record(np.arange(6.0), np.array([1.0, 3.0, 5.0, 6.0, 7.0, 8.0]))
        kept = fit_record.cut(record, start=2.0, zero=1.0, until=2.0)
        np.testing.assert_array_equal(kept.time, [0.0, 1.0, 2.0])
        np.testing.assert_array_equal(kept.value, [3.0, 4.0, 5.0])

    def test_mistakes(self):
        with self.assertRaisesRegex(upbead.UserError, "nothing is left"):
            fit_record.cut(fit_record.Record(np.arange(3.0), np.arange(3.0)), start=5.0)
        for record, words in ((([0.0, 0.0], [1.0, 1.0]), "ascend"), (([0.0, 1.0], [1.0, np.nan]), "no finite number"),
                              (([0.0, 1.0], [1.0]), "as many values")):
            with self.assertRaisesRegex(upbead.UserError, words):
                fit_record.of_arrays(record)


class Mistakes(InFolder):
    def test_are_told_with_a_cure(self):
        case, time = self.write_case(), np.linspace(0.0, 0.5, 50)
        for options, words in (
                ({"parameters": {}}, "at least one key"),
                ({"parameters": {SEABED: -1.0}}, "positive first guess"),
                ({"parameters": {SEABED: (3e7, 2e7)}}, "positive first guess"),
                ({"parameters": {SEABED: None}, "ties": {MOUND: "2*regions.rock.shear_modulus"}}, "tie what is not fitted"),
                ({"parameters": {SEABED: None}, "ties": {MOUND: "a*b*c"}}, "FACTOR"),
                ({"parameters": {SEABED: None}, "noise": 0.0}, "standard deviation"),
                ({"parameters": ["regions.seabed.kind"]}, "regions.seabed.kind"),
                ({"parameters": {SEABED: None}, "reading": "shear"}, "no dataset"),
                ({"parameters": {"regions.seabed.stiffness": 3e7}}, "regions.seabed.stiffness = 3e.07 failed.*stiffness"),
                ({"parameters": {SEABED: None}, "set": {"mesh.refine": "auto", "time.scheme": "auto"}}, "another mesh")):
            with self.subTest(words), self.assertRaisesRegex(upbead.UserError, words):
                upbead.fit(case, (time, 0 * time), **options)

    def test_a_run_that_fails_is_kept_away_from(self):
        runs = Runs(self.write_case(), "shear_force", {}, None, 2, None)
        (_, value), = runs.histories([{DAMPING: 2.0}])
        self.assertTrue(np.isnan(value).all())
        self.assertIn(f"the run with {DAMPING} = 2 failed: --set", str(runs.failures[0]))

    def test_command(self):
        for more, words in ((["--parameter", "a=b"], "no first guess"),
                            (["--parameter", "a", "--tie", "b"], "--tie b: write KEY=")):
            done = subprocess.run([sys.executable, SCRIPTS / "fit.py", "case.toml", "--record", "lab.csv", *more],
                                  cwd=self.folder, capture_output=True, text=True)
            self.assertEqual(done.returncode, 1)
            self.assertIn(words, done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
