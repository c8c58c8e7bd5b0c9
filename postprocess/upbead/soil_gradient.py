"""How an answer changes with each key of a soil, by differences of a model of soils."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from .errors import UserError

FIRST, LEAST = 0.1, 0.01  # steps of ln(key), or of a key over the width of its range
# the answer at x + offset*h, by weight: of second order, within the box and at either end of it
CENTRAL = ((-1.0, -0.5), (1.0, 0.5))
FORWARD = ((0.0, -1.5), (1.0, 2.0), (2.0, -0.5))
BACKWARD = tuple((-offset, -weight) for offset, weight in FORWARD)


@dataclass
class Gradient:
    """By key: value, d quantity/d ln(key) for keys whose soils are spread over their logarithm, else d quantity/d key.
    error: that of the steps, and the quantity's own by the model, which may change by itself as ln(key) does by 1, or the
    key over its range. of_steps: the difference to the slope over twice the step; of an array, the largest. step: of
    ln(key), or of the key. logarithmic: by key."""

    value: dict[str, Any]
    error: dict[str, float]
    of_steps: dict[str, float] = field(repr=False)
    step: dict[str, float] = field(repr=False)
    logarithmic: dict[str, bool] = field(repr=False)


def gradient(box: Mapping[str, tuple[float, float, bool]], soil: Mapping[str, float], answer: Callable[[dict[str, float]], Any],
             known_to: float = 0.0) -> Gradient:
    """The Gradient at a soil that has all keys of the box, {key: (low, high, logarithmic)}; answer(soil): a number, or
    an array, which is known to a difference of `known_to`."""
    value: dict[str, Any] = {}
    of_steps: dict[str, float] = {}
    step: dict[str, float] = {}
    for key, axis in box.items():

        def along(at: float, key: str = key) -> Any:
            return answer({**soil, key: at})

        value[key], of_steps[key], step[key] = slope(axis, soil[key], along)
    error = {key: of_steps[key] + known_to / (1.0 if logarithmic else high - low) for key, (low, high, logarithmic) in box.items()}
    return Gradient(value, error, of_steps, step, {key: bool(axis[2]) for key, axis in box.items()})


def slope(axis: tuple[float, float, bool], at: float, answer: Callable[[float], Any]) -> tuple[Any, float, float]:
    """(slope, error, step) along one key: the step is halved as long as the slope changes by less than before."""
    low, high, logarithmic = axis
    if logarithmic:
        low, high, at = np.log(low), np.log(high), np.log(at)
    scale = 1.0 if logarithmic else high - low
    known: dict[float, Any] = {}

    def of(x: float) -> Any:
        x = float(np.clip(x, low, high))
        if x not in known:
            inside = np.clip(np.exp(x), *axis[:2]) if logarithmic else x
            known[x] = np.asarray(answer(float(inside)), dtype=float)
        return known[x]

    h = min(FIRST * scale, (high - low) / 4)
    before, best = difference(of, at, h, low, high), None
    while h / 2 >= LEAST * scale or best is None:
        h /= 2
        now = difference(of, at, h, low, high)
        error = float(np.max(np.abs(now - before)))
        if best is not None and error >= best[1]:
            break
        best, before = (now if now.ndim else float(now), error, float(h)), now
    return best


def difference(of: Callable[[float], Any], x: float, h: float, low: float, high: float) -> Any:
    scheme = FORWARD if x - h < low else BACKWARD if x + h > high else CENTRAL
    return sum(weight * of(x + offset * h) for offset, weight in scheme) / h


def number(answer: Any, quantity: str | Callable[[Any], Any]) -> Any:
    """A quantity of an answer, by name or by a function of it."""
    value = quantity(answer) if callable(quantity) else getattr(answer, quantity)
    if value is None or isinstance(value, (str, dict)):
        raise UserError(f"'{quantity}' is no number in the answer to {answer.soil}, but {value!r}")
    return value
