"""The result of a fit."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .fit_directions import Identifiable
from .fit_parameters import RANGE, TIME_FACTOR
from .history import History
from .shown import Shown

if TYPE_CHECKING:
    from .posterior import Posterior


@dataclass
class Fit(Shown):
    """Parameters by key, in SI units. docs/fit.md explains what the intervals include, and what they do not.

    values: of the best fit. confidence: (low, high) of 95 %. covariance, correlation: of the logarithms of the
    values, in the order of `values`. residual: record minus computed, in the unit of `record`, at `time` (s).
    identifiable: which products of powers the record fixes. noise: standard deviation of a sample. n_runs: number of
    runs of the program. first, computed: the reading by the first guess and by the fit. modes: each measured
    frequency and the computed mode that it was paired with. cautions: reasons to doubt the numbers. For modes alone
    noise is None, and there is no history. posterior: a Posterior, if it was asked for.
    """

    values: dict[str, float]
    confidence: dict[str, tuple[float, float]]
    covariance: NDArray[np.float64]
    correlation: NDArray[np.float64]
    residual: History
    identifiable: Identifiable
    noise: float | None
    n_runs: int
    reading: str | None
    guess: dict[str, float]
    time: NDArray[np.float64] = field(repr=False)
    record: History = field(repr=False)
    first: History = field(repr=False)
    computed: History = field(repr=False)
    ties: dict[str, tuple[float, str]] = field(default_factory=dict)
    modes: list[dict[str, Any]] = field(default_factory=list)
    cautions: list[str] = field(default_factory=list)
    posterior: Posterior | None = None

    @property
    def settings(self) -> dict[str, float]:
        """{key: value} for `set` of a run with the fitted values, including tied keys, without keys of the record."""
        tied = {key: factor * self.values[other] for key, (factor, other) in self.ties.items()}
        return {key: value for key, value in {**self.values, **tied}.items() if key != TIME_FACTOR}

    def summary(self) -> dict[str, Any]:
        """All but the histories, as JSON has it."""
        told: dict[str, Any] = {"reading": self.reading, "values": self.values, "confidence": self.confidence, "guess": self.guess,
                "settings": self.settings, "noise": self.noise, "unit": self.record.unit,
                "rms": float(np.sqrt(np.mean(self.residual.values**2))) if self.time.size else None, "samples": self.time.size,
                "runs": self.n_runs, "modes": self.modes,
                "covariance_of_logarithms": self.covariance.tolist(), "correlation": self.correlation.tolist()}
        told["identifiable"] = {name: [vars(combination) for combination in getattr(self.identifiable, name)]
                                for name in ("directions", "fixed", "free")} | {"text": str(self.identifiable)}
        if self.posterior:
            told["posterior"] = self.posterior.summary()
        plain: dict[str, Any] = json.loads(json.dumps(told | {"cautions": self.cautions}))
        return plain

    def __repr__(self) -> str:
        return f"<Fit of {self.reading or 'modes'}: {', '.join(f'{key} {value:.4g}' for key, value in self.values.items())}; {self.n_runs} runs>"

    def __str__(self) -> str:
        width = max(map(len, self.values))
        lines = [f"{key:{width}}  {value:.4g}  {interval_text(self.confidence[key])}" for key, value in self.values.items()]
        lines += [mode_text(mode) for mode in self.modes] + [str(self.identifiable)] + [f"caution: {text}" for text in self.cautions]
        return "\n".join(lines + [str(self.posterior)] * bool(self.posterior))


def mode_text(mode: Mapping[str, Any]) -> str:
    """A measured mode and the computed one that it is paired with, in words."""
    measured, first, now = mode["measured"], mode["first guess"], mode["fit"]
    percent = 100 * abs(now["damping_ratio"])  # without damping this is round-off of either sign
    text = f"mode of {measured['frequency']:.4g} +- {measured['frequency_uncertainty']:.2g} Hz"
    if measured["damping_ratio"]:
        text += f", damping {100 * measured['damping_ratio']:.3g} +- {100 * measured['damping_uncertainty']:.2g} %"
    return (f"{text}: fitted {now['frequency']:.4g} Hz, damping {percent:.2g} %, {100 * now['share']:.2g} % of F_T; "
            f"it is mode {first['mode']} of the first guess, of {first['frequency']:.4g} Hz, {100 * first['share']:.2g} % of F_T")


def interval_text(ends: tuple[float, float]) -> str:
    """An interval in words; an interval as wide as the range of a guess counts as not determined.

    >>> interval_text((1.0, 2.0)), interval_text((0.1, 10.0))
    ('(1 to 2)', '(not determined by the measurement)')
    """
    low, high = ends
    return f"({low:.4g} to {high:.4g})" if high < 0.95 * RANGE**2 * low else "(not determined by the measurement)"
