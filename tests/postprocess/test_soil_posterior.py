"""Posteriors by a model of soils: several records under waves of their own tell planted soils, what they do not tell is
told, 95 % intervals hold the truth as often as they say (at_length), and the fit of a record passes its check by full runs.

usage: test_soil_posterior.py FOLDER_OF_THE_SCRIPTS PROGRAM PROGRAM_THAT_WRITES_A_MODEL [at_length]
"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

SCRIPTS, PROGRAM, WRITER = (Path(argument).resolve() for argument in sys.argv[1:4])
AT_LENGTH = sys.argv[4:] == ["at_length"]
sys.path.insert(0, str(SCRIPTS))
import upbead  # noqa: E402
from upbead import fit_record  # noqa: E402
from upbead.fit import judge, solve  # noqa: E402
from upbead.fit_parameters import parameters_of  # noqa: E402
from upbead.fit_posterior import OfRuns, SoilFit, sampled  # noqa: E402
from upbead.fit_soils import SoilHistories  # noqa: E402
from upbead.fit_weights import Weights  # noqa: E402

G, K = "regions.sand.shear_modulus", "regions.sand.hydraulic_conductivity"
SHEAR, PRESSURE = "shear_force", "probes/A/pressure"
TRUTH = {G: 4e7, K: 0.1}
TRIALS, EVALUATIONS, NOISE = 50, 1920, 0.05  # fixed before the first trial
QUICK = 400  # evaluations of other tests
TIME = np.linspace(0.0, 1.0, 101)


def pulse(duration):
    return TIME, {"impact": 1.6e6 * np.interp(TIME, [0, duration / 2, duration], [0, 1, 0])}


WAVES = [pulse(0.15), pulse(0.4)]


class Case(unittest.TestCase):
    def setUp(self):
        if "at_length" in self.id() and not AT_LENGTH:
            self.skipTest("only with ctest -C long")
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = Path(folder.name) / "soils.h5"
        subprocess.run([WRITER, path], check=True)
        self.model = upbead.SoilModel(path, histories=[SHEAR, PRESSURE, "force"], program=PROGRAM)
        self.addCleanup(self.model.close)

    def records(self, seed, readings=(SHEAR, PRESSURE), known=True):
        """Of the planted soil with white noise, each under a wave of its own."""
        rng, found = np.random.default_rng(seed), []
        for wave, reading in zip(WAVES, readings):
            answer = self.model.respond(wave, TRUTH)
            exact = np.interp(TIME, answer.time, answer.histories[reading])
            noise = NOISE * np.abs(exact).max()
            value = exact + noise * rng.standard_normal(TIME.size)
            found.append(upbead.SoilRecord(wave, reading, TIME, value, noise if known else None))
        return found

    def assert_holds(self, interval, truth):
        self.assertTrue(interval[0] < truth < interval[1], f"{truth} is not in {interval}")


class Posteriors(Case):
    def test_two_records_tell_the_planted_soil(self):
        for known in (True, False):
            found = upbead.soil_posterior(self.model, self.records(1, known=known), evaluations=QUICK)
            for key, truth in TRUTH.items():
                self.assert_holds(found.interval[key], truth)
            self.assertLess(found.interval[G][1] / found.interval[G][0], 1.1)
            self.assertEqual(found.undetermined, [])

    def test_two_records_tell_more_than_one(self):
        both = self.records(2)
        alone, together = (upbead.soil_posterior(self.model, records, evaluations=QUICK) for records in (both[:1], both))
        self.assertLess(together.covariance[1, 1], 0.7 * alone.covariance[1, 1])

    def test_a_key_of_which_nothing_is_learnt_is_told(self):
        records = self.records(3, readings=("force",))  # P, which no soil changes
        found = upbead.soil_posterior(self.model, records, evaluations=QUICK)
        self.assertEqual(found.undetermined, [G, K])
        self.assertIn("not determined", str(found))

    def test_keys_may_be_fewer_tied_or_set(self):
        records = self.records(4)
        found = upbead.soil_posterior(self.model, records, {G: (2e7, 9e7)}, QUICK, set={K: 0.1})
        self.assertEqual((found.keys, found.box), ([G], {G: (2e7, 9e7)}))
        self.assert_holds(found.interval[G], TRUTH[G])
        tied = SoilHistories(self.model, records, {G: (2e7, 9e7)}, {K: (2.5e-9, G)})
        for one, other in zip(tied.answer({G: 4e7}), SoilHistories(self.model, records, {}).answer(TRUTH)):
            np.testing.assert_allclose(one, other, atol=1e-9 * np.abs(other).max())

    def test_what_does_not_fit_is_refused(self):
        records = self.records(5)
        for keys, options, text in (({G: (1e6, 5e7)}, {}, "the model is good for 1e\\+07 to 1e\\+08"),
                                    (["regions.sand.porosity"], {}, "no key that the model varies"),
                                    ([G], {"set": {"loads.impact.factor": 2.0}}, "does not vary it")):
            with self.assertRaisesRegex(upbead.UserError, text):
                upbead.soil_posterior(self.model, records, keys, QUICK, **options)

    def test_a_soil_beyond_the_box_has_no_density(self):
        fast = SoilHistories(self.model, self.records(6), {G: (1e7, 1e8)}, {K: (1e-7, G)})
        self.assertTrue(np.isnan(fast.answer({G: 5e7})[0]).all())  # K = 5
        self.assertEqual(len(fast.failures), 2)

    def test_full_runs_notice_a_model_that_is_wrong(self):
        records = self.records(7)
        exact = SoilHistories(self.model, records, {key: axis[:2] for key, axis in self.model.box.items()})
        found = upbead.soil_posterior(self.model, records, evaluations=QUICK, full=exact, checks=10)
        self.assertEqual((found.check.failed, found.check.accepted), (0, 1.0))
        self.assertEqual(found.check.cautions(), [])
        found = upbead.soil_posterior(self.model, records, evaluations=QUICK, full=Stiffened(exact), checks=10)
        self.assertTrue(found.check.cautions())

    def test_intervals_hold_the_truth_as_often_as_they_say_at_length(self):
        held = []
        for seed in range(TRIALS):
            found = upbead.soil_posterior(self.model, self.records(100 + seed, known=seed % 2 == 0), evaluations=EVALUATIONS, seed=seed)
            held.append([low < TRUTH[key] < high for key, (low, high) in found.interval.items()])
        share = np.mean(held, axis=0)
        print(f"\nof {TRIALS} trials the 95 % intervals held {dict(zip(TRUTH, share))}")
        self.assertTrue(((share >= 0.88) & (share <= 1.0)).all(), share)


class OfAFit(Case):
    """What `fit` does with a model, where runs of the program are answers of another model of the same soils."""

    def runs(self, factor=1.0):
        test, wave = self, self.model.path.with_name("wave.csv")
        wave.write_text("time,impact\n" + "".join(f"{t!r},{f!r}\n" for t, f in zip(*map(list, (TIME, WAVES[0][1]["impact"])))))

        class Runs:
            case, ties, set, jobs, program, reading = wave, {}, {"time.scheme": "reduced", "mesh.refine": 0, K: 0.1}, 1, PROGRAM, SHEAR

            def at(self, time, points):
                record = [upbead.SoilRecord(wave, SHEAR, time, 0 * time)]
                return [SoilHistories(test.model, record, {}).answer({K: 0.1, G: factor * keys[G]})[0] for keys in points]

        return Runs()

    def fitted(self, record, runs, evaluations=QUICK):
        window, parameters = fit_record.Record(record.time, record.value), parameters_of({G: 2e7}, {})
        soils = SoilFit(self.model.path, runs, window, parameters, None, (), record.noise)

        def compute(points):
            return soils.at(window.time, [soils.parameters.point(x) for x in points])

        weights = Weights(window.time.size, record.noise)
        solution = solve(compute, record.value, soils.parameters, soils.failures, weights)
        statistics = judge(soils.parameters, solution, record.value, record.noise, 0.25, weights)
        found = sampled(soils, record.value, solution, statistics, weights, record.noise, evaluations, 0.25, 10)
        return soils.parameters.point(solution.x)[G], statistics["confidence"][G], found

    def test_with_a_model_agrees_with_least_squares_and_its_check(self):
        value, confidence, found = self.fitted(self.records(8)[0], self.runs(), 1600)
        width = np.log(found.interval[G][1] / found.interval[G][0])
        self.assertLess(abs(np.log(found.median[G] / value)), 0.2 * width)
        self.assertLess(abs(width / np.log(confidence[1] / confidence[0]) - 1), 0.25)
        self.assertEqual((found.check.points, found.check.failed, found.check.cautions()), (10, 0, []))

    def test_with_a_model_of_another_case_is_noticed(self):
        found = self.fitted(self.records(9)[0], self.runs(factor=1.1))[2]
        self.assertTrue(any("the fast model is too coarse" in text for text in found.cautions))

    def test_refuses_what_the_model_cannot(self):
        record, runs = self.records(10)[0], self.runs()
        window = fit_record.Record(record.time, record.value)
        for guess, text in (({G: 2e8}, "lies outside the model's box"), ({"record.time_factor": 1.0}, "and no record's times"),
                            ({"regions.sand.porosity": 0.3}, "no key that the model varies")):
            with self.assertRaisesRegex(upbead.UserError, text):
                SoilFit(self.model, runs, window, parameters_of(guess, {}), None, (), None)
        with self.assertRaisesRegex(upbead.UserError, "has no modes"):
            SoilFit(self.model, runs, window, parameters_of({G: 2e7}, {}), object(), (), None)

    def test_by_runs_is_that_of_their_histories(self):
        parameters, slope = parameters_of({"a": 2.0}, {}), np.linspace(0.0, 1.0, 40)

        def compute(points):
            return [slope * (np.log(2.0) + x[0]) for x in points]

        measured = slope * np.log(3.0) + 0.05 * np.random.default_rng(1).standard_normal(40)
        weights = Weights(40, 0.05)
        solution = solve(compute, measured, parameters, [], weights)
        statistics = judge(parameters, solution, measured, 0.05, 0.25, weights)
        found = sampled(OfRuns(compute, parameters, 40), measured, solution, statistics, weights, 0.05, 4000, 0.25, 0)
        np.testing.assert_allclose(np.log(found.interval["a"]), np.log(statistics["confidence"]["a"]), atol=0.01)
        self.assertIsNone(found.check)


class Stiffened:
    """Full runs of a ground that is a fifth stiffer than the model has it."""

    def __init__(self, exact):
        self.exact, self.box = exact, exact.box

    def answer(self, keys):
        return self.exact.answer({**keys, G: min(1.2 * keys[G], 1e8)})


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *(["-k", "at_length"] if AT_LENGTH else [])], verbosity=2)
