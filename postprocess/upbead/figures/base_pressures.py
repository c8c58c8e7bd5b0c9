"""Pressures and stresses over the width of the caisson's bottom, at characteristic times."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .style import plain, styled, subplots

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ..results import Result

TIMES = [("shear_force", "largest $F_T$", "tab:red"), ("base_moment", "largest moment landward", "tab:blue"),
         ("uplift", "largest $U$", "tab:green")]
INNER = 0.9  # share of the width over which stresses are drawn: under the edges of a rigid base they are singular


@styled
def base_pressures(result: Result) -> Figure:
    """A panel for each quantity by time and position in the table `base` of a Result, stresses and pressure first."""
    table = result.table("base")
    position = table["position"]
    shown = {name: history for name, history in sorted(table.items(), key=lambda item: "displacement" in item[0])
             if history.shape == (result.time.size, position.size)}
    figure, rows = subplots(len(shown), 1, sharex=True, figsize=(6.5, 1.0 + 2.1 * len(shown)), squeeze=False,
                            layout="constrained")
    times = telling_times(result)
    for axes, (name, history) in zip(rows[:, 0], shown.items()):
        factor, unit = history.scale()
        drawn = inner(position) if name.endswith("stress") else slice(None)
        for index, what, colour in times:
            axes.plot(position[drawn], factor * history[index][drawn], "o-", ms=2.5, lw=1, color=colour,
                      label=f"{result.time[index]:.3g} s, {what}")
        axes.axhline(0.0, color="black", lw=0.5)
        axes.set_ylabel(f"{plain(name.replace('_', ' '))} ({plain(unit)})")
    rows[0, 0].legend(fontsize=7.5)
    rows[0, 0].set_title(plain(result.title))
    rows[-1, 0].set_xlabel("place under the caisson, landward (m)")
    return figure


def inner(position):
    return np.abs(position - np.mean([position.min(), position.max()])) <= INNER * np.ptp(position) / 2


def telling_times(result):
    """[(index, event, colour)] in the order of time."""
    found = {int(np.argmax(result[name])): (what, colour) for name, what, colour in TIMES if name in result}
    return [(index, *found[index]) for index in sorted(found)]
