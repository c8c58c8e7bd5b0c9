"""The parameters of a fit: keys, first guesses, ranges, and tied keys."""

import re
from dataclasses import dataclass

import numpy as np

from .errors import UserError

TIME_FACTOR = "record.time_factor"  # a parameter of the record: its times are multiplied with it
RANGE = 10.0  # a first guess may be wrong by this factor
TIE = re.compile(r"\s*(?:([^*\s]+)\s*\*)?\s*([^*\s]+)\s*")


@dataclass
class Parameters:
    """Keys with their first guess, positive; x = ln(value/guess) lies between low and high."""

    guess: dict
    low: np.ndarray
    high: np.ndarray
    searched: bool  # whether all parameters have ranges

    @property
    def keys(self):
        return list(self.guess)

    def point(self, x):
        """{key: value}"""
        return {key: float(value * np.exp(part)) for (key, value), part in zip(self.guess.items(), x)}


def as_asked(parameters):
    """{key: first guess, (low, high), or None}, checked."""
    asked = dict(parameters) if isinstance(parameters, dict) else dict.fromkeys(parameters or ())
    if not asked:
        raise UserError("give at least one key of the case to fit, as {'regions.seabed.shear_modulus': 30e6}")
    for key, value in asked.items():
        if value is not None:
            middle(key, value)
    return asked


def parameters_of(asked, case):
    """The Parameters; a key with neither guess nor range begins with the value of the case, a dict."""
    guess, low, high = {}, [], []
    for key, value in asked.items():
        if value is None:
            value = 1.0 if key == TIME_FACTOR else value_of(case, key)
        guess[key] = middle(key, value)
        ends = value if np.ndim(value) else (guess[key] / RANGE, guess[key] * RANGE)
        low.append(np.log(ends[0] / guess[key]))
        high.append(np.log(ends[1] / guess[key]))
    return Parameters(guess, np.array(low), np.array(high), all(np.ndim(value) for value in asked.values()))


def middle(key, value):
    """The value, or the geometric mean of a range; all positive."""
    try:
        ends = np.atleast_1d(np.array(np.nan if value is None else value, dtype=float))
    except (TypeError, ValueError):
        ends = np.array([np.nan])
    if ends.size not in (1, 2) or not ((ends > 0).all() and np.isfinite(ends).all() and (np.diff(ends) > 0).all()):
        raise UserError(f"'{key}' is fitted by its logarithm: give a positive first guess or a range (low, high)"
                        + ("; the case has no such number" if value is None else ""))
    return float(np.exp(np.log(ends).mean()))


def value_of(case, key):
    """A number or word of a case by its dotted key; None if the case does not have it."""
    for part in key.split("."):
        case = case.get(part) if isinstance(case, dict) else None
    return case if isinstance(case, (int, float, str)) else None


def parse_ties(ties, keys):
    """{tied key: (factor, key)} of {tied key: "1.667*key"}, or of such pairs.

    >>> parse_ties({"regions.mound.shear_modulus": "1.5*regions.seabed.shear_modulus"}, ["regions.seabed.shear_modulus"])
    {'regions.mound.shear_modulus': (1.5, 'regions.seabed.shear_modulus')}
    """
    found = {}
    for tied, tie in (ties or {}).items():
        try:
            if isinstance(tie, str):
                factor, other = TIE.fullmatch(tie).groups(default="1")
            else:
                factor, other = tie
            found[tied] = float(factor), other
        except (AttributeError, TypeError, ValueError) as error:
            raise UserError(f"the tie of '{tied}' is not understood: {tie!r}; write FACTOR*KEY") from error
        if other not in keys or tied in keys:
            raise UserError(f"'{tied}' is tied to '{other}'; tie what is not fitted to what is: {', '.join(keys)}")
    return found
