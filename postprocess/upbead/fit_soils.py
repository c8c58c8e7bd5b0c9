"""Records answered by a model of soils, for fits and posteriors of thousands of evaluations.

    records = [upbead.SoilRecord("storm.csv", "shear_force", time, values), ...]
    found = upbead.soil_posterior(upbead.SoilModel("soils.h5", histories=["shear_force"]), records, keys)
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .errors import SoilError, UserError
from .fit_parameters import TIME_FACTOR
from .least_squares import compass, least_squares
from .posterior import Likelihood, Posterior, posterior
from .soil_model import SoilModel

OF_RUNS = ("mesh.", "accuracy.", "time.", "output.")  # keys that change how exactly runs compute, not what
ROUND_OFF = 1e-9  # of ends that were logarithms
SHARE, TURNS = 0.05, 3  # first guess of the noise over the largest value, and how often it is found again


@dataclass
class SoilRecord:
    """What was measured under one wave.

    Attributes
    ----------
    wave : path or (times, {load: values})
        As SoilModel.respond() takes it, one wave.
    reading : str
        What was measured.
    time : ndarray, shape (N,), s
        Of the wave.
    value : ndarray, shape (N,)
        In the SI unit of the reading.
    noise : float, optional
        Standard deviation of a sample, None if unknown.
    """

    wave: Any
    reading: str
    time: NDArray[np.float64]
    value: NDArray[np.float64]
    noise: float | None = None


class SoilHistories:
    """A model for posterior(): what each record would be, by the keys that are asked for.

    model: a SoilModel with the records' readings in its histories. box: {key: (low, high)}. ties: {tied key: (factor, key)}.
    fixed: values of other keys. failures: soils that could not be answered; their histories are nan.
    """

    def __init__(self, model, records, box, ties=None, fixed=None):
        self.model, self.records, self.box = model, records, box
        self.ties, self.fixed, self.failures, self.voids = ties or {}, fixed or {}, [], set()

    def soil(self, keys):
        return {**self.fixed, **keys, **{tied: factor * keys[key] for tied, (factor, key) in self.ties.items()}}

    def answer(self, keys):
        return self.answers([keys])[0]

    def answers(self, asked):
        soils = [self.soil(keys) for keys in asked]
        known: list[Any] = []
        found: list[Any] = []
        for record in self.records:
            same = [answers for wave, answers in known if wave is record.wave]
            answers = same[0] if same else self.model.respond_all(record.wave, soils)
            if not same:
                known.append((record.wave, answers))
                self.failures += [answer for answer in answers if isinstance(answer, SoilError)]
                self.voids |= {why for answer in answers if (why := getattr(answer, "why_void", None))}
            found.append([self.read(record, answer) for answer in answers])
        return [list(of_soil) for of_soil in zip(*found)]

    @staticmethod
    def read(record, answer):
        if isinstance(answer, SoilError):
            return np.full(len(record.time), np.nan)
        return np.interp(record.time, answer.time, answer.histories[record.reading])

    def errors(self, keys):
        """Estimates of the model's error in each record, in its unit."""
        answers = [self.model.respond(record.wave, self.soil(keys)) for record in self.records]
        return [answer.history_errors[record.reading] * np.abs(answer.histories[record.reading]).max()
                for answer, record in zip(answers, self.records)]


def range_of(model, key, asked=None):
    """(low, high) in which a key may lie: the model's own range, or a part of it."""
    if key not in model.box:
        raise UserError(f"'{key}' is no key that the model varies; it varies {', '.join(model.box)}"
                        + (", and no record's times" if key == TIME_FACTOR else ""))
    low, high = model.box[key][:2]
    if low <= 0:
        raise UserError(f"'{key}' is fitted by its logarithm, and the model's range begins with {low:.4g}")
    if asked and not (low * (1 - ROUND_OFF) <= asked[0] and asked[1] <= high * (1 + ROUND_OFF)):
        raise UserError(f"'{key}' is asked for from {asked[0]:.4g} to {asked[1]:.4g}, the model is good for {low:.4g} to {high:.4g}")
    return tuple(float(np.clip(end, low, high)) for end in asked or (low, high))


def fixed_by(model, set):
    """The keys of `set` that the model varies. Others would change the case without the model, and are refused."""
    other = [key for key in set if key not in model.box and not key.startswith(OF_RUNS)]
    if other:
        raise UserError(f"'{other[0]}' is set, but the model of soils does not vary it; write it into the case, and make the model again")
    return {key: float(value) for key, value in set.items() if key in model.box}


def soil_posterior(model: SoilModel, records: Sequence[SoilRecord], keys: Mapping[str, Any] | Sequence[str] | None = None, evaluations: int = 4000, *,
                   ties: Mapping[str, tuple[float, str]] | None = None, set: Mapping[str, float] | None = None, full: Any = None, checks: int = 20,
                   seed: int = 1, limit: float = 0.25) -> Posterior:
    """What records tell of the soil: the posterior of keys by one or several records, from their best fit on.

    Parameters
    ----------
    model : SoilModel
        With the records' readings in its histories.
    records : list of SoilRecord
        Each with a wave and a noise of its own.
    keys : dict or list of str, optional
        {key: (low, high) or None}, SI units, or names; default: all that the model varies.
    evaluations : int
        Of the model.
    ties : dict, optional
        {tied key: (factor, key)}.
    set : dict, optional
        Values of other keys of the box.
    full : optional
        An object as the model, by which `checks` points of the chain are answered again.
    checks, seed : int
        See full; of the random numbers.
    limit : float
        Relative; a combination with a larger uncertainty is not fixed.

    Returns
    -------
    Posterior
        `sample` has the shape (points, keys).
    """
    asked = dict(keys) if isinstance(keys, dict) else dict.fromkeys(keys or model.box)
    box = {key: range_of(model, key, ends) for key, ends in asked.items()}
    fast = SoilHistories(model, records, box, ties, fixed_by(model, set or {}))
    start, covariance = best_fit(fast, records)
    likelihood = Likelihood([np.asarray(record.value) for record in records], [record.noise for record in records])
    found: Posterior = posterior(fast, likelihood, evaluations, start=start, covariance=covariance, full=full, checks=checks, seed=seed, limit=limit)
    found.cautions += model_cautions(fast, found.median, [record.noise for record in records])
    return found


def best_fit(fast, records):
    """(ln(keys), covariance) of the least squares with each record over its noise, which is found in turns."""
    keys, (low, high) = list(fast.box), np.log(list(fast.box.values())).T
    measured = np.concatenate([record.value for record in records])
    noise = [record.noise or SHARE * max(np.abs(record.value).max(), 1e-300) for record in records]

    def compute(points):
        return [np.concatenate(answer) for answer in fast.answers([dict(zip(keys, map(float, np.exp(x)))) for x in points])]

    def size(answers, against):
        scale = scales(noise, records)
        sums = [np.sum(((answer - against) / scale) ** 2) for answer in answers]
        return np.where(np.isfinite(sums), sums, np.inf)

    x = compass(compute, measured, (low + high) / 2, low, high, size=size)
    for _ in range(1 if all(record.noise for record in records) else TURNS):
        solution = least_squares(compute, measured, x, low, high, scales(noise, records))
        x, ends = solution.x, np.cumsum([len(record.value) for record in records])[:-1]
        rest = np.split(measured - solution.computed, ends)
        noise = [record.noise or max(float(np.std(part)), 1e-9 * np.abs(record.value).max()) for record, part in zip(records, rest)]
    J = solution.jacobian / scales(noise, records)[:, None]
    # along what the records do not fix, as wide as the box
    return x, np.linalg.inv(J.T @ J + np.diag(12.0 / (high - low) ** 2))


def scales(noise, records):
    return np.concatenate([np.full(len(record.value), s) for s, record in zip(noise, records)])


def model_cautions(fast, keys, noise):
    """Where answers are void, or the model's own error is no smaller than the noise."""
    computed = fast.answer(keys)
    found = [f"no verdict may be drawn of answers of the model, as its warnings say: {'; '.join(sorted(fast.voids))}"] * bool(fast.voids)
    for record, error, s, values in zip(fast.records, fast.errors(keys), noise, computed):
        s = s or float(np.std(np.asarray(record.value) - values))
        if error > s:
            found.append(f"the model of soils may be wrong by {error:.3g} in {record.reading}, more than its noise, {s:.3g}: lower the "
                         "model's tolerance")
    return found
