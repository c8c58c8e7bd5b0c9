"""Which soil decides: indices of Sobol, and what each key alone does between the ends of its range."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .style import plain, styled, subplots

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ..sensitivity import Sensitivity


@styled
def sensitivity(found: list[Sensitivity], labels: dict[str, str] | None = None, title: str = "") -> Figure:
    """A row for each Sensitivity of `found`: shares of the variance on the left, the range of the quantity on the right; keys
    by their total share, the largest on top. labels: {quantity: axis label}."""
    height = 1.0 + len(found) * (0.7 + 0.24 * max(len(of.keys) for of in found))
    figure, rows = subplots(len(found), 2, figsize=(9, height), layout="constrained", squeeze=False)
    for of, (left, right) in zip(found, rows):
        keys = sorted(of.keys, key=lambda share: share.total or 0.0)
        place = np.arange(len(keys))
        draw_shares(left, of, keys, place)
        draw_range(right, of, keys, place, (labels or {}).get(of.quantity, of.quantity))
    rows[0][0].legend(loc="lower right", fontsize=7)
    if title:
        figure.suptitle(plain(title), fontsize=9)
    return figure


def draw_shares(axes: Any, of: Sensitivity, keys: list[Any], place: Any) -> None:
    axes.set_yticks(place, [share.key.removeprefix("regions.") for share in keys], fontsize=7)
    axes.set_xlabel("share of the variance")
    if keys[0].total is None:
        axes.text(0.5, 0.5, "does not vary", transform=axes.transAxes, ha="center")
        return
    for share, at in zip(keys, place):
        for value, ends, offset, colour in ((share.total, share.total_interval, 0.18, "C0"), (share.first, share.first_interval, -0.18, "C1")):
            axes.barh(at + offset, value, 0.36, color=colour, label={"C0": "with interactions", "C1": "alone"}[colour] if at == place[-1] else None)
            axes.plot(ends, (at + offset,) * 2, color="k", lw=1)
    axes.set_xlim(min(0.0, min(share.first_interval[0] for share in keys)), None)


def draw_range(axes: Any, of: Sensitivity, keys: list[Any], place: Any, label: str) -> None:
    axes.set_yticks(place, [""] * len(keys))
    axes.set_xlabel(label)
    for share, at in zip(keys, place):
        for end, colour in ((share.at_low, "C9"), (share.at_high, "C3")):
            if end is not None and of.value is not None:
                axes.barh(at, end - of.value, 0.7, left=of.value, color=colour,
                          label={"C9": "least value of the key", "C3": "largest"}[colour] if at == place[-1] else None)
    if of.value is not None:
        axes.axvline(of.value, color="k", lw=1)
    axes.legend(fontsize=7)
