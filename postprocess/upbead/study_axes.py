"""What a study is drawn over, and how strongly a number follows a key; needs no matplotlib."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

GROUPS = ("regions", "loads", "mesh", "parameters", "response")  # of keys, that say nothing to a reader


def is_drawn(table: Any, key: str) -> bool:
    """Whether a key was drawn at random: nearly all values are different, but for the matrices of a Sobol sample, which
    share them."""
    share = 2 / (len(table.keys) + 2) if "matrix" in table.columns else 1.0
    return len(table.rows) >= 20 and len(set(table.words(key))) > 0.9 * share * len(table.rows)


def default_axes(table: Any) -> list[str]:
    """Keys that vary; keys with words only if none has numbers, as the lines also show them."""
    different: list[str] = [key for key in table.keys if len(set(table.words(key))) > 1] or table.keys[:1]
    return [key for key in different if table.numbers(key) is not None] or different


def spreads(values: Any) -> bool:
    """Whether values cover so much of a decade or more that an axis over decades shows them better."""
    return bool(np.all(values > 0) and values.max() > 8 * values.min())


def in_words(key: str) -> str:
    """A key of a case as a reader says it: regions.seabed.shear_modulus as 'seabed: shear modulus'."""
    parts = [part.strip("\"'").replace("_", " ") for part in key.split(".")]
    where = [part for part in parts[:-1] if part not in GROUPS]
    return ": ".join([" ".join(where), parts[-1]] if where else parts[-1:])


def rank_correlation(x: ArrayLike, y: ArrayLike) -> float:
    """Spearman's correlation of values without ties."""
    ranks = [np.argsort(np.argsort(values)) for values in (x, y)]
    return float(np.corrcoef(ranks[0], ranks[1])[0, 1])
