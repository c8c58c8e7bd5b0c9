"""Indices of each way to fail by each method, and which variables matter at the design points."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TYPE_CHECKING

import numpy as np

from .style import plain, styled, subplots

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MARKS = {"form": "s", "sorm": "D", "importance": "o", "subset": "^", "plain": "*"}


@styled
def reliability(summary: Mapping[str, Any]) -> Figure:
    """Two panels of a summary of `upbead reliability`: beta of an occasion, and the shares alpha^2."""
    modes = {name: mode for name, mode in summary["modes"].items() if mode["occasion"]["index"] is not None}
    rows = np.arange(len(modes))
    figure, (left, right) = subplots(1, 2, sharey=True, figsize=(8.8, 1.6 + 0.32 * len(modes)))
    for method, mark in MARKS.items():
        found = [(mode["methods"].get(method) or {}).get("index") for mode in modes.values()]
        points = [(index, row) for index, row in zip(found, rows) if index is not None]
        if points:
            left.plot(*zip(*points), mark, ms=5, alpha=0.7, label=method)
    left.set(xlabel="index beta of an occasion", yticks=rows, yticklabels=[plain(name) for name in modes])
    left.invert_yaxis()
    left.legend(loc="upper center", bbox_to_anchor=(0.5, -0.22), ncol=3)
    draw_shares(right, list(modes.values()), rows)
    figure.suptitle(plain(summary["title"]))
    return figure


def draw_shares(axes, modes, rows):
    variables = list(dict.fromkeys(name for mode in modes for name in mode["design_point"]))
    start = np.zeros(len(rows))
    for name in variables:
        share = np.array([(mode["design_point"].get(name) or {}).get("importance", 0.0) for mode in modes])
        axes.barh(rows, share, left=start, height=0.7, label=plain(name))
        start += share
    axes.set(xlabel="share of each variable at the design point", xlim=(0, 1))
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.22), ncol=3)
