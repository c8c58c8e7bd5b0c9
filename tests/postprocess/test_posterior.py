"""The posterior: of linear problems it is the exact one, its intervals hold the truth as often as they say, what is not
determined is told, and full runs notice a fast model that is too coarse.

usage: test_posterior.py FOLDER_OF_THE_SCRIPTS
"""

import sys
import unittest
from pathlib import Path

import numpy as np

SCRIPTS = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parents[2] / "postprocess").resolve()
sys.path.insert(0, str(SCRIPTS))
from upbead import UserError  # noqa: E402
from upbead.ensemble import autocorrelation_time, ensemble  # noqa: E402
from upbead.posterior import Likelihood, posterior  # noqa: E402


class Linear:
    """Histories that are linear in ln(keys)."""

    def __init__(self, matrices, half=5.0):
        self.matrices = matrices
        self.box = {key: (np.exp(-half), np.exp(half)) for key in "abc"[: matrices[0].shape[1]]}

    def answer(self, keys):
        x = np.log(list(keys.values()))
        return [matrix @ x for matrix in self.matrices]


class Oscillator:
    """x'' + 2 z w x' + w^2 x under an impulse, with w = sqrt(G): a model of one degree of freedom."""

    time = np.linspace(0.0, 2.0, 50)
    truth = {"G": 100.0, "damping": 0.1}
    box = {"G": (20.0, 500.0), "damping": (0.01, 0.9)}

    def answer(self, keys):
        w, z = np.sqrt(keys["G"]), keys["damping"]
        damped = w * np.sqrt(1 - z * z)
        return [10 * np.exp(-z * w * self.time) * np.sin(damped * self.time) / damped]


class Exact(unittest.TestCase):
    def setUp(self):
        rng = np.random.default_rng(3)
        self.matrices = [rng.standard_normal((30, 2)), rng.standard_normal((12, 2)) @ np.array([[1.0, 0.9], [0.0, 0.1]])]
        truth, self.noise = np.array([0.3, -0.2]), [0.5, 0.2]
        self.measured = [a @ truth + s * rng.standard_normal(len(a)) for a, s in zip(self.matrices, self.noise)]

    def assert_is(self, found, mean, covariance):
        """Within four standard errors of as many independent samples as the chain is worth."""
        logs, root = np.log(found.sample), np.sqrt(np.diag(covariance))
        error = 4 * root / np.sqrt(found.effective)
        self.assertTrue((np.abs(logs.mean(axis=0) - mean) < error).all(), (logs.mean(axis=0), mean, error))
        unit = found.covariance / np.outer(root, root)
        np.testing.assert_allclose(unit, covariance / np.outer(root, root), atol=6 / np.sqrt(found.effective))
        ends = np.log(np.array(list(found.interval.values())))
        np.testing.assert_allclose(ends.T, [mean - 1.96 * root, mean + 1.96 * root], atol=6 * root.max() / np.sqrt(found.effective))

    def test_two_records_with_known_noise_are_normal(self):
        found = posterior(Linear(self.matrices), Likelihood(self.measured, self.noise), 48000, start=np.zeros(2),
                          covariance=np.eye(2))
        precision = sum(a.T @ a / s**2 for a, s in zip(self.matrices, self.noise))
        mean = np.linalg.solve(precision, sum(a.T @ y / s**2 for a, y, s in zip(self.matrices, self.measured, self.noise)))
        self.assertGreater(found.effective, 300)
        self.assert_is(found, mean, np.linalg.inv(precision))
        self.assertEqual((found.cautions, found.undetermined), ([], []))

    def test_unknown_noise_is_a_t_distribution(self):
        a, y = self.matrices[1], self.measured[1]
        found = posterior(Linear([a]), Likelihood([y], [None]), 30000, start=np.zeros(2), covariance=np.eye(2))
        mean, rest = np.linalg.lstsq(a, y, rcond=None)[:2]
        freedom = len(y) - 2  # covariance of Student's t: s^2 (A^T A)^-1 nu/(nu - 2), s^2 = RSS/nu
        logs = np.log(found.sample)
        covariance = rest[0] / (freedom - 2) * np.linalg.inv(a.T @ a)
        root = np.sqrt(np.diag(covariance))
        np.testing.assert_allclose(logs.mean(axis=0), mean, atol=5 * root.max() / np.sqrt(found.effective))
        np.testing.assert_allclose(found.covariance / covariance, np.ones((2, 2)), atol=0.25)

    def test_what_is_not_determined_is_told(self):
        column = np.linspace(-1.0, 1.0, 40)[:, None]
        model = Linear([column @ np.array([[1.0, 1.0, 0.0]])], half=2.0)  # the product of a and b only, and nothing of c
        found = posterior(model, Likelihood([0.0 * column[:, 0]], [0.1]), 16000)
        self.assertEqual(found.undetermined, ["a", "b", "c"])  # each alone; the product is
        text = str(found)
        self.assertIn("only this is fixed: a x b", text)
        self.assertIn("not determined", text)

    def test_a_function_is_found_along_a_narrow_valley(self):
        def log(points):
            return [-0.5 * ((x[0] - x[1]) / 0.01) ** 2 - 0.5 * (x[0] + x[1]) ** 2 for x in points]

        rng = np.random.default_rng(1)
        start = rng.standard_normal((16, 1)) + 0.01 * rng.standard_normal((16, 2))
        chain = ensemble(log, start, 3000, rng).after(0.2)
        self.assertLess(abs(np.std(chain.flat @ [1, -1]) / 0.01 - 1), 0.1)
        self.assertLess(abs(np.std(chain.flat @ [1, 1]) - 1), 0.1)
        self.assertLess(autocorrelation_time(rng.standard_normal((2000, 8))), 1.2)


class Intervals(unittest.TestCase):
    def test_hold_the_truth_as_often_as_they_say(self):
        model, held = Oscillator(), []
        exact = model.answer(model.truth)[0]
        for seed in range(50):
            measured = exact + 0.05 * np.random.default_rng(seed).standard_normal(exact.size)
            found = posterior(model, Likelihood([measured], [None if seed % 2 else 0.05]), 1920, seed=seed,
                              start=np.log(list(model.truth.values())), covariance=np.diag([0.02, 0.2]) ** 2)
            held.append([low < model.truth[key] < high for key, (low, high) in found.interval.items()])
        share = np.mean(held, axis=0)
        self.assertTrue(((share >= 0.88) & (share <= 1.0)).all(), share)


class Stiffened(Oscillator):
    """A fast model, wrong by a factor of G."""

    def __init__(self, factor):
        self.factor = factor

    def answer(self, keys):
        return super().answer({**keys, "G": keys["G"] * self.factor})


class FullRuns(unittest.TestCase):
    def found(self, factor):
        model = Oscillator()
        measured = model.answer(model.truth)[0] + 0.05 * np.random.default_rng(5).standard_normal(model.time.size)
        return posterior(Stiffened(factor), Likelihood([measured], [0.05]), 48000, full=model, checks=200,
                         start=np.log(list(model.truth.values())), covariance=np.diag([0.02, 0.2]) ** 2)

    def test_agree_with_a_good_fast_model_and_refuse_a_coarse_one(self):
        good = self.found(1.0005)
        self.assertGreater(good.check.worth, 190)
        self.assertGreater(good.check.accepted, 0.9)
        self.assertEqual(good.cautions, [])
        coarse = self.found(1.2)
        self.assertLess(coarse.check.worth, 100)
        self.assertIn("too coarse", coarse.cautions[-1])
        self.assertIn("checked by 200 full runs", str(coarse))

    def test_mistakes(self):
        with self.assertRaisesRegex(UserError, "give at least 320"):
            posterior(Oscillator(), Likelihood([np.zeros(50)], [1.0]), 100)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
