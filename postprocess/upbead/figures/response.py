"""The response of a run over time.

The panels are those of Figs. 2a and 2b of Shimosako and Takahashi (1994): wave force, inertia force, shear force and
displacement of the caisson.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..errors import UserError
from .style import plain, styled, subplots

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ..results import Result

PANELS = [  # dataset, symbol, colour
    ("force", r"$P$", "tab:blue"),
    ("inertia_force", r"$m\,\ddot{x}_G$", "tab:green"),
    ("shear_force", r"$F_T$", "tab:red"),
    ("caisson/displacement_x", r"$x_G$", "black"),
]


@styled
def response(result: Result, until: float | None = None) -> Figure:
    """P, m x_G'', F_T and x_G of a Result with a caisson, with their peaks; or the probes of one without a caisson.

    Measured records are drawn over them. until: end of the time axis (s); default: the end of the response.
    """
    figure = draw_caisson(result) if result.has_caisson else draw_probes(result)
    return cut(figure, result, until)


@styled
def probes(result: Result, until: float | None = None) -> Figure:
    """All quantities of all probes of a Result, a panel for each quantity."""
    return cut(draw_probes(result), result, until)


def cut(figure, result, until):
    if until is not None:
        if not until > result.time[0]:
            raise UserError(f"--until {until} is not later than the first time, {result.time[0]} s")
        figure.axes[0].set_xlim(right=until)
    return figure


def window(time, histories, share=0.05):
    """The end of the plotted time: a little after the last time at which any history exceeds `share` of its own
    peak."""
    last = 0
    for history in histories:
        size = np.abs(history.values)
        above = np.flatnonzero(size > share * size.max(initial=0.0))
        last = max(last, above[-1] if above.size else 0)
    end = time[0] + 1.1 * (time[last] - time[0])
    return min(end, time[-1]) if last > 0 else time[-1]


def peak_of(result, name, values, factor):
    """Time and value of the landward (positive) peak, or of the seaward peak if there is no other.

    Peaks of the summary take precedence, as they are found inside the steps, not only at their ends.
    """
    found = result.summary.get("response") or {}
    if name in ("force", "shear_force"):
        key = {"force": "peak_force", "shear_force": "peak_shear"}[name]
        if found.get(key, 0.0) > 0:
            return found[key + "_time"], factor * found[key]
    peak = int(np.argmax(values)) if values.max() > 0 else int(np.argmin(values))
    return result.time[peak], values[peak]


def mark_peak(axes, time, value, unit):
    axes.plot(time, value, "o", color="black", ms=3)
    axes.annotate(f"{value:.3g} {unit}", (time, value), xytext=(6, 3), textcoords="offset points")


def draw_measured(axes, result, name, factor):
    """Draws records that are compared with a history over it."""
    records = {record: found for record, found in result.measured().items() if found["reading"] == name}
    for record, found in records.items():
        axes.plot(found["time"], factor * found["value"].values, "--", color="black", lw=0.8, label=f"{plain(record)}, measured")
    if records:
        axes.legend(fontsize=7.5, loc="upper right")


def stack(count):
    figure, axes = subplots(count, 1, sharex=True, figsize=(6.5, 1.0 + 1.5 * count), squeeze=False)
    axes[-1, 0].set_xlabel("time (s)")
    return figure, axes[:, 0]


def draw_caisson(result):
    histories = [result.history(name) for name, _, _ in PANELS]
    force, inertia, shear, _ = histories
    figure, rows = stack(len(PANELS))
    # All forces have the same unit and scale, so that they can be compared at a glance.
    force_scale = force.scale((inertia, shear))
    for axes, history, (name, symbol, colour) in zip(rows, histories, PANELS):
        factor, unit = force_scale if history.unit == force.unit else history.scale()
        values = factor * history.values
        axes.plot(result.time, values, color=colour, lw=1.2)
        axes.axhline(0.0, color="black", lw=0.5)
        axes.set_ylabel(f"{symbol} ({unit})")
        at, peak = peak_of(result, name, values, factor)
        mark_peak(axes, at, peak, unit)
        draw_measured(axes, result, name, factor)
    draw_slip(rows[-1], result, histories[-1].scale()[0])
    forces = [axes for axes, history in zip(rows, histories) if history.unit == force.unit]
    low, high = min(a.get_ylim()[0] for a in forces), max(a.get_ylim()[1] for a in forces)
    for axes in forces:
        axes.set_ylim(low, high)
    rows[0].set_xlim(result.time[0], window(result.time, histories))
    rows[0].set_title(f"{plain(result.title)}\n{ratio_text(result, force, shear)}")
    figure.align_ylabels()
    return figure


def draw_slip(axes, result, factor):
    """The caisson's slip over its ground, mean over the bottom, if contact was solved; x_G includes this slip."""
    if "interface/slip" not in result.file:
        return
    slip, length = result.dataset("/interface/slip").values, result.dataset("/interface/length").values
    axes.plot(result.time, factor * (slip @ length) / length.sum(), color="tab:orange", lw=1.2, label="slip")
    axes.legend(fontsize=7.5, loc="upper right")


def ratio_text(result, force, shear):
    """The ratio by the summary, whose peaks are found inside the steps; else the ratio by the histories."""
    ratio = (result.summary.get("response") or {}).get("shear_to_force_ratio")
    if ratio is None and force.max() > 0:
        ratio = shear.max() / force.max()
    return "no force" if ratio is None else rf"max $F_T$ / max $P$ = {ratio:.3f}"


def draw_probes(result):
    quantities = result.probes()
    if not quantities:
        raise UserError(f"'{result.path}' has nothing to draw: no caisson and no probes; add [probes.NAME] to the case")
    figure, rows = stack(len(quantities))
    for axes, (quantity, histories) in zip(rows, quantities.items()):
        first, *others = histories.values()
        factor, unit = first.scale(others)
        for probe, history in histories.items():
            axes.plot(result.time, factor * history.values, lw=1.2, label=plain(probe))
            draw_measured(axes, result, f"probes/{probe}/{quantity}", factor)
        axes.set_ylabel(f"{plain(quantity.replace('_', ' '))}\n({plain(unit)})")
    rows[0].legend(ncol=4, fontsize="small")
    rows[0].set_xlim(result.time[0], window(result.time, [h for q in quantities.values() for h in q.values()]))
    rows[0].set_title(plain(result.title))
    figure.align_ylabels()
    return figure
