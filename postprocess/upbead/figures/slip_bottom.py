"""The bottom of a caisson that slips and lifts: normal stress, state of the nodes, contact and normal force."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.patches import Patch

from .style import mosaic, plain, styled

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ..slip_result import SlipResult

STATES = [("sticks", "0.88"), ("slips", "tab:orange"), ("is open", "tab:blue")]


@styled
def slip_bottom(result: SlipResult, until: float | None = None) -> Figure:
    """Draws a SlipResult; until: end of the time axes (s)."""
    figure, places = mosaic([["stress", "states"], ["stress", "contact"]], figsize=(11, 5.2), layout="constrained")
    places["states"].sharex(places["contact"])
    until = until or result.time[-1]
    times = telling_times(result, until)
    draw_stress(places["stress"], result, times)
    draw_states(places["states"], result, times)
    draw_contact(places["contact"], result, times)
    places["contact"].set_xlim(result.time[0], until)
    figure.suptitle(plain(result.title), fontsize=10)
    return figure


def telling_times(result, until):
    """[(index, event, colour)] in the order of time."""
    n = np.count_nonzero(result.time <= until)
    times = {
        int(np.argmax(result.history("shear_force").values[:n])): ("largest $F_T$", "tab:red"),
        int(np.argmax(result.opening[:n, 0])): ("seaward edge highest", "tab:blue"),
        int(np.argmin(result.normal[:n].sum(axis=1))): ("least $N$", "tab:green"),
        int(np.argmin(result.history("base_moment").values[:n])): ("rocked seaward", "tab:purple"),
    }
    return [(index, *times[index]) for index in sorted(times)]


def draw_stress(axes, result, times):
    mean = result.normal[0].sum() / result.length.sum()
    unit, name = (1e-6, "MPa") if mean >= 1e5 else (1e-3, "kPa")
    stress = unit * result.normal / result.length
    axes.plot(result.position, stress[0], "o-", ms=2.5, lw=1, color="black", label="at rest")
    for index, what, colour in times:
        axes.plot(result.position, stress[index], "o-", ms=2.5, lw=1, color=colour,
                  label=f"{result.time[index]:.3g} s, {what}")
    axes.set_ylim(-0.15 * unit * mean, 6 * unit * mean)
    axes.axhline(0.0, color="black", lw=0.5)
    axes.set(xlabel="place under the caisson, landward (m)", ylabel=f"effective normal stress ({name})")
    axes.set_title(f"stress under the bottom; at the edges, beyond the frame, up to {stress.max():.2g} {name}",
                   fontsize=8)
    axes.legend(fontsize=7.5)


def mark(axes, result, times):
    for index, _, colour in times:
        axes.axvline(result.time[index], color=colour, lw=1)


def draw_states(axes, result, times):
    states = np.where(result.is_open(), 2, np.where(result.slips(), 1, 0))
    ends = np.concatenate([[0.0], np.cumsum(result.length)])
    edges = result.position[0] + ends * np.ptp(result.position) / ends[-1]
    colours = ListedColormap([colour for _, colour in STATES])
    axes.grid(False)
    axes.pcolormesh(result.time, edges, states[1:].T, cmap=colours, vmin=0, vmax=2, rasterized=True)
    mark(axes, result, times)
    axes.set_ylabel("place (m)")
    axes.set_title("state of the nodes of the bottom, sea below", fontsize=8)
    axes.legend(handles=[Patch(color=colour, label=name) for name, colour in STATES], fontsize=7.5, ncol=3,
                frameon=True, framealpha=1, loc="center right")


def draw_contact(axes, result, times):
    total = result.normal.sum(axis=1)
    axes.plot(result.time, result.contact(), drawstyle="steps-pre", color="black", lw=1,
              label="share of the bottom in contact")
    axes.plot(result.time, total / total[0], color="tab:green", lw=1, label="$N$, effective, over that at rest")
    axes.plot(result.time, result.history("uplift").values / total[0], "--", color="tab:cyan", lw=1,
              label="$U$, of excess pore pressure, over $N$ at rest")
    mark(axes, result, times)
    axes.set_xlabel("time (s)")
    axes.legend(fontsize=7.5)
