"""Until when functions of time are sampled: the largest end that a run of the case may have."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from typing import Any

import numpy as np

from .toml import toml_value

BOUNDS = ("values", "to", "high")  # of a key that a study varies
KEY = "time.end"


def overlaid(tables: Mapping[str, Any], values: Mapping[str, Any] | None) -> dict[str, Any]:
    """The tables with values by their dotted keys, as of --set.

    >>> overlaid({"time": {"end": 1.0, "step": 0.1}}, {"time.end": 0.5, 'vary."time.end".to': 3})
    {'time': {'end': 0.5, 'step': 0.1}, 'vary': {'time.end': {'to': 3}}}
    """
    found = dict(tables)
    for key, value in (values or {}).items():
        try:
            found = joined(found, tomllib.loads(f"{key} = {toml_value(value)}"))
        except ValueError:  # the program tells what is wrong with a key
            continue
    return found


def joined(below: Mapping[str, Any], above: Mapping[str, Any]) -> dict[str, Any]:
    both = dict(below)
    for key, value in above.items():
        inside = both.get(key)
        both[key] = joined(inside, value) if isinstance(inside, Mapping) and isinstance(value, Mapping) else value
    return both


def sampled_until(case: Mapping[str, Any], changes: Mapping[str, Any] | None) -> float | None:
    """time.end of a case; of a study the largest that it sets or varies; None where it says nothing of it, infinity where that has no bound."""
    both = joined(case, changes or {})
    varied = table(both, "vary").get(KEY)
    if KEY in table(both, "follow") or (isinstance(varied, Mapping) and not set(BOUNDS) & set(varied)):
        return np.inf
    given = [varied[key] for key in BOUNDS if key in varied] if isinstance(varied, Mapping) else []
    given = given or [table(both, "set").get(KEY, table(both, "time").get("end"))]
    ends = [float(one) for one in np.ravel(np.array(given, dtype=object)) for one in np.ravel(one) if isinstance(one, (int, float, np.number)) and one > 0]
    return max(ends, default=None)


def table(both: Mapping[str, Any], name: str) -> Mapping[str, Any]:
    found = both.get(name)
    return found if isinstance(found, Mapping) else {}
