"""What a record tells of the keys of a case, as a sample of their posterior distribution.

The prior is a box: the logarithms of the keys are uniform in it, independent of each other. What makes a history of keys
is any object with

    box             {key: (low, high)}
    answer(keys)    [array of the values that belong to each record, ...]; nan where there is no answer

and, if it answers many points side by side, answers([keys, ...]). A run of the program is one, a reduced model of many
soils another. docs/fit.md has the method.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .ensemble import autocorrelation_time, ensemble
from .errors import UserError
from .fit_directions import identifiable
from .posterior_check import Check, checked

BURN_IN = 0.25  # of the chain, which begins at the approximation of Laplace
LIMIT = 0.25  # relative; a combination with a larger uncertainty is called not fixed
WHOLE = 0.9  # of the width of an interval over that of the prior's: nothing was learnt
LEAST_TIMES = 50  # a shorter chain, in autocorrelation times, is doubtful
QUANTILE = 1.959964  # of 95 % of a normal distribution
ENDS = [2.5, 97.5]


@dataclass
class Likelihood:
    """Of records with white normal noise.

    measured: an array for each record. noise: for each the standard deviation, of all or of each sample; None if it is
    not known: s then has the density 1/s and is integrated out, which leaves (sum r^2)^(-n/2), the kernel of Student's t
    (Box and Tiao 1973, ch. 2.4 and 8.2).
    """

    measured: list[NDArray[np.float64]]
    noise: list[float | None]

    def __call__(self, computed):
        """ln of it, without a constant; -inf if something was not computed."""
        total = 0.0
        for value, measured, noise in zip(computed, self.measured, self.noise):
            residual = np.asarray(measured) - value
            if not np.isfinite(residual).all():
                return -np.inf
            if noise is None:
                total -= 0.5 * len(residual) * np.log(max(residual @ residual, 1e-300))
            else:
                total -= 0.5 * np.sum((residual / noise) ** 2)
        return total


@dataclass
class Posterior:
    """sample: values of the keys, a row for each. interval: 95 % (2.5 to 97.5 %) of each. covariance: of the logarithms.
    effective: number of independent samples that the chain is worth. undetermined: keys of which nothing was learnt.
    check: of the chain by full runs, None if the chain was made by these. cautions: reasons to doubt the numbers."""

    keys: list[str]
    sample: NDArray[np.float64] = field(repr=False)
    median: dict[str, float]
    interval: dict[str, tuple[float, float]]
    covariance: NDArray[np.float64]
    identifiable: Any
    undetermined: list[str]
    box: dict[str, tuple[float, float]]
    evaluations: int
    accepted: float
    effective: float
    check: Check | None = None
    cautions: list[str] = field(default_factory=list)

    def summary(self) -> dict[str, Any]:
        """As JSON has it, without the sample."""
        return {"median": self.median, "interval": self.interval, "covariance_of_logarithms": self.covariance.tolist(),
                "prior": self.box, "undetermined": self.undetermined, "fixed": str(self.identifiable), "evaluations": self.evaluations,
                "accepted": self.accepted, "effective": self.effective,
                "check": self.check and self.check.summary(), "cautions": self.cautions}

    def __str__(self) -> str:
        width = max(map(len, self.keys))
        lines = [f"{key:{width}}  {self.median[key]:.4g}  ({low:.4g} to {high:.4g})"
                 + (", as before the measurement: not determined" if key in self.undetermined else "")
                 for key, (low, high) in self.interval.items()]
        lines.append(f"posterior of {self.evaluations} evaluations, {100 * self.accepted:.0f} % accepted, worth {self.effective:.0f} "
                     "independent samples")
        lines += [str(self.identifiable)] + ([str(self.check)] if self.check else [])
        return "\n".join(lines + [f"caution: {text}" for text in self.cautions])


def posterior(model, likelihood, evaluations, *, start=None, covariance=None, walkers=None, full=None, checks=20, seed=1,
              limit=LIMIT):
    """The Posterior of the keys of model.box, sampled with some number of evaluations of the model.

    start, covariance: of ln(keys), where the chain begins, such as of a fit; default: anywhere in the box. walkers:
    even. full: an object as the model, by which `checks` points of the chain are answered again. limit: relative; a
    combination with a larger uncertainty is not fixed.
    """
    rng = np.random.default_rng(seed)
    keys = list(model.box)
    low, high = np.log(np.array([model.box[key] for key in keys], dtype=float)).T
    walkers = walkers or max(16, 4 * len(keys))
    steps = evaluations // walkers
    if steps < 20:
        raise UserError(f"{evaluations} evaluations are {steps} steps of {walkers} walkers; give at least {20 * walkers}")
    log = LogDensity(model, likelihood, low, high)
    begin = begin_at(log, low, high, start, covariance, walkers, rng)
    chain = ensemble(log, begin, steps, rng)
    kept = chain.after(BURN_IN)
    found = told(keys, low, high, kept, limit)
    time = max(autocorrelation_time(kept.points[:, :, k]) for k in range(len(keys)))
    found.update(evaluations=log.count, accepted=float(chain.accepted), effective=kept.log.size / time)
    cautions = []
    if len(kept.points) < LEAST_TIMES * time:
        cautions.append(f"the chain is {len(kept.points) / time:.0f} times as long as it remembers, less than {LEAST_TIMES}: take "
                        f"{int(np.ceil(LEAST_TIMES * time / (1 - BURN_IN)) * walkers)} evaluations")
    check = None
    if full is not None:
        check = checked(kept, LogDensity(full, likelihood, low, high), checks, time, rng)
        cautions += check.cautions()
    return Posterior(keys=keys, box={key: (float(model.box[key][0]), float(model.box[key][1])) for key in keys}, check=check, cautions=cautions, **found)


class LogDensity:
    """ln of prior times likelihood at points of ln(keys); counts its evaluations."""

    def __init__(self, model, likelihood, low, high):
        self.model, self.likelihood, self.low, self.high, self.count = model, likelihood, low, high, 0
        self.keys = list(model.box) if not isinstance(model, dict) else list(model)

    def __call__(self, points):
        inside = [bool(((self.low <= x) & (x <= self.high)).all()) for x in points]
        asked = [dict(zip(self.keys, map(float, np.exp(x)))) for x, good in zip(points, inside) if good]
        self.count += len(asked)
        answers = iter(self.answers(asked))
        return np.array([self.likelihood(next(answers)) if good else -np.inf for good in inside])

    def answers(self, asked):
        together = getattr(self.model, "answers", None)
        return together(asked) if together else [self.model.answer(keys) for keys in asked]


def begin_at(log, low, high, start, covariance, walkers, rng):
    """Points in the box with a density above zero: of the approximation of Laplace, or anywhere in the box. Along what
    the record does not determine that approximation is wider than the box, so that a coordinate beyond it is drawn from
    the whole of it."""
    points: list[Any] = []
    for _ in range(100):
        lacking = walkers - len(points)
        if start is None:
            drawn = low + (high - low) * rng.random((lacking, len(low)))
        else:
            drawn = rng.multivariate_normal(start, covariance, lacking, method="eigh")
            drawn = np.where((drawn < low) | (drawn > high), low + (high - low) * rng.random(drawn.shape), drawn)
        points += [x for x, value in zip(drawn, log(drawn)) if np.isfinite(value)]
        if len(points) == walkers:
            return np.array(points)
    raise UserError("hardly any point of the box can be answered: begin with a narrower one")


def told(keys, low, high, chain, limit):
    """Medians, intervals, covariance and what is determined, of a Chain."""
    values = np.exp(chain.flat)
    ends = np.percentile(chain.flat, ENDS, axis=0)
    covariance = np.atleast_2d(np.cov(chain.flat.T))
    share = (ends[1] - ends[0]) / ((ENDS[1] - ENDS[0]) / 100 * (high - low))
    root = np.linalg.cholesky(np.linalg.inv(covariance)).T  # a Jacobian with this covariance of its parameters
    return {"sample": values, "median": dict(zip(keys, map(float, np.median(values, axis=0)))), "covariance": covariance,
            "interval": {key: (float(np.exp(a)), float(np.exp(b))) for key, a, b in zip(keys, *ends)},
            "undetermined": [key for key, width in zip(keys, share) if width > WHOLE],
            "identifiable": identifiable(keys, root, 1.0, QUANTILE, limit)}
