"""Which soil decides: Sobol's indices of a model of soils, and what each key alone does between the ends of its range.

    with upbead.SoilModel("soils.h5", jobs=2) as model:
        for of in upbead.sensitivity(model, "storm.csv", ["ratio", "sliding"], samples=300):
            print(of.quantity, [(key.key, key.total) for key in of.keys])

Soils are spread evenly over the box of the model, over the logarithm of a key where the box says so. Of the variance of a
quantity, `first` is the share that a key brings alone, `total` that with all its interactions (Sobol 1993; Homma and
Saltelli 1996), by the estimators of Martinez (2011) of OpenTURNS, with intervals of 95 %. The box decides them: a key with
a wide range brings much.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, field
from difflib import get_close_matches
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .errors import SoilError, UserError
from .soil_answer import SoilAnswer
from .soil_gradient import number
from .soil_model import Axis, SoilModel

AT_ONCE = 64  # soils between two tellings of progress
LEAST = 16  # rows of the design that intervals need
MOST_LEFT_OUT = 0.1  # of the rows: with more the shares would be those of another box
MOST_HALF = 0.1  # of an interval, as `upbead indices` has it


@dataclass
class KeyShare:
    """first, total: shares of the variance, with their intervals; None where the quantity does not vary. at_low, at_high:
    the quantity with this key at the ends of its range and all others as in the case; None where there is no answer."""

    key: str
    first: float | None = None
    first_interval: tuple[float, float] | None = None
    total: float | None = None
    total_interval: tuple[float, float] | None = None
    at_low: float | None = None
    at_high: float | None = None


@dataclass
class Sensitivity:
    """Of one quantity of one wave. value: of the case's own soil. mean, deviation: over the box. soils: how many were
    answered. left_out: rows of the design that were left out, as one of their soils had no answer, and why the first one had
    none. largest_error: the largest estimate of the model's error in F_T over its peak. warnings: texts, by name, of what is
    doubtful: of the case's own soil, `void_soils` of those of which no verdict may be drawn, and `indices_uncertain` of intervals that
    are too wide. why_void: of all soils, the names of the warnings that void their answers; None where none is void."""

    quantity: str
    value: float | None
    mean: float | None
    deviation: float | None
    soils: int
    left_out: int
    why_left_out: str | None
    largest_error: float
    keys: list[KeyShare] = field(default_factory=list)
    warnings: dict[str, str] = field(default_factory=dict)
    why_void: str | None = None

    def summary(self) -> dict[str, Any]:
        return asdict(self)


Array = NDArray[np.float64]
Quantity = str | Callable[[SoilAnswer], float]
Told = Callable[[int, int], None] | None


def sensitivity(model: SoilModel, wave: Any, quantities: Sequence[Quantity], *, samples: int = 300, seed: int = 1, told: Told = None) -> list[Sensitivity]:
    """Which key of a soil decides each of some quantities.

    Parameters
    ----------
    model : SoilModel
        Whose box is the range of each key.
    wave : path, list of paths or (times, {load: values})
        As of `SoilModel.respond`.
    quantities : list of str or of functions
        Names of numbers of a wave's answer, such as "ratio" and "sliding", or functions of a SoilAnswer.
    samples : int
        Rows of the design; samples x (2 + keys) soils are answered.
    seed : int
        Of the design.
    told : function, optional
        Called with how many soils are answered, and how many there are.

    Returns
    -------
    list of Sensitivity
        One for each quantity.
    """
    if samples < LEAST:
        raise UserError(f"{samples} samples give no interval: ask for {LEAST} or more")
    keys = list(model.box)
    own = model.respond(wave, {})
    check_names(own, quantities)
    design = design_of(model.box, samples, seed)
    answers = answered(model, wave, [dict(zip(keys, map(float, row))) for row in design], told)
    ends = answered(model, wave, [{key: end} for key in keys for end in (model.box[key].low, model.box[key].high)], None)
    return [judged(quantity, keys, design, own, answers, ends) for quantity in quantities]


def check_names(answer: SoilAnswer, quantities: Sequence[Quantity]) -> None:
    """Before an hour is spent."""
    for name in (name for name in quantities if isinstance(name, str)):
        if len(answer.waves) != 1:
            raise UserError(f"'{name}' is of one wave, and there are {len(answer.waves)}; give one, or a function of the answer")
        known = [key for key, value in answer.waves[0].numbers.items() if not isinstance(value, (str, dict, list))]
        if name not in known:
            near = get_close_matches(name, known, 1, 0.4)
            raise UserError(f"an answer has no number '{name}'; {f'did you mean {near[0]!r}?' if near else ''} it has {', '.join(known)}")


def design_of(box: dict[str, Axis], samples: int, seed: int) -> Array:
    """Rows of soils by OpenTURNS: two independent samples, then for each key the first with that key of the second."""
    import openturns as ot

    ot.RandomGenerator.SetSeed(seed)
    each = [(ot.LogUniform(*map(float, np.log([low, high]))) if logarithmic else ot.Uniform(low, high))
            for low, high, logarithmic in box.values()]
    design = np.array(ot.SobolIndicesExperiment(ot.ComposedDistribution(each), samples, False).generate())
    low, high = (np.array([axis[end] for axis in box.values()]) for end in (0, 1))
    return np.clip(design, low, high)  # exp(ln x) may be beyond x by its last digit


def answered(model: SoilModel, wave: Any, soils: list[dict[str, float]], told: Told) -> list[SoilAnswer | SoilError]:
    found: list[SoilAnswer | SoilError] = []
    for start in range(0, len(soils), AT_ONCE):
        found += model.respond_all(wave, soils[start : start + AT_ONCE])
        if told:
            told(len(found), len(soils))
    return found


def value_of(answer: SoilAnswer | SoilError, quantity: Quantity) -> tuple[float, str]:
    """The number, or nan with the reason why there is none."""
    if isinstance(answer, SoilError):
        return np.nan, str(answer)
    try:
        value = number(answer, quantity)
    except UserError as error:
        return np.nan, str(error)
    return float(value), ""


def or_none(value: float) -> float | None:
    return float(value) if np.isfinite(value) else None


def judged(quantity: Quantity, keys: list[str], design: Array, own: SoilAnswer, answers: list[SoilAnswer | SoilError],
           ends: list[SoilAnswer | SoilError]) -> Sensitivity:
    name = quantity if isinstance(quantity, str) else quantity.__name__
    of_case, _ = value_of(own, quantity)
    values, whys = zip(*(value_of(answer, quantity) for answer in answers))
    rows = np.reshape(values, (len(keys) + 2, -1))
    kept = np.isfinite(rows).all(axis=0)
    reason = next((text for text in whys if text), None)
    if kept.sum() < max(LEAST, (1 - MOST_LEFT_OUT) * kept.size):
        raise UserError(f"'{name}' has no value for {(~kept).sum()} of {kept.size} rows of soils: {reason}; give the model a box that has one")
    left = rows[:, kept]
    mean, deviation = float(left[:2].mean()), float(left[:2].std(ddof=1))
    found = Sensitivity(name, or_none(of_case), mean, deviation, int(np.isfinite(values).sum()),
                        int((~kept).sum()), reason, max(a.error for a in answers if not isinstance(a, SoilError)))
    at = [or_none(value_of(answer, quantity)[0]) for answer in ends]
    shares = indices(design, kept, left) if deviation > 1e-9 * abs(mean) else [{} for _ in keys]
    found.keys = [KeyShare(key, at_low=at[2 * i], at_high=at[2 * i + 1], **share) for i, (key, share) in enumerate(zip(keys, shares))]
    void = [answer.why_void for answer in (own, *answers, *ends) if isinstance(answer, SoilAnswer) and answer.why_void]
    found.why_void = "; ".join(dict.fromkeys(name for why in void for name in why.split("; "))) or None
    found.warnings = {warning["name"]: warning["text"] for warning in own.warnings} | uncertain(found.keys)
    if void:
        found.warnings["void_soils"] = f"no verdict may be drawn of {len(void)} of {1 + len(answers) + len(ends)} answers, and they are in all numbers here: {found.why_void}"
    return found


def uncertain(keys: list[KeyShare]) -> dict[str, str]:
    """Warning indices_uncertain, with the widest of all intervals."""
    halves = [(0.5 * (high - low), key.key) for key in keys for low, high in (key.first_interval or (0.0, 0.0), key.total_interval or (0.0, 0.0))]
    worst, key = max(halves)
    if worst <= MOST_HALF:
        return {}
    return {"indices_uncertain": f"a share of {key} is known to +-{worst:.2g} only: ask for more samples, as intervals narrow with their root"}


def indices(design: Array, kept: NDArray[np.bool_], values: Array) -> list[dict[str, Any]]:
    import openturns as ot

    blocks = design.reshape(values.shape[0], -1, design.shape[1])[:, kept]
    algorithm = ot.MartinezSensitivityAlgorithm(blocks.reshape(-1, design.shape[1]), values.reshape(-1, 1), int(kept.sum()))
    algorithm.setUseAsymptoticDistribution(True)
    found = []
    for first, total, *ends in zip(algorithm.getFirstOrderIndices(), algorithm.getTotalOrderIndices(),
                                   *(getattr(interval, f"get{end}Bound")() for interval in
                                     (algorithm.getFirstOrderIndicesInterval(), algorithm.getTotalOrderIndicesInterval())
                                     for end in ("Lower", "Upper"))):
        found.append({"first": first, "first_interval": tuple(ends[:2]), "total": total, "total_interval": tuple(ends[2:])})
    return found
