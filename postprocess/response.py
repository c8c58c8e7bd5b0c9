#!/usr/bin/env python3
"""Draws the response of a run: wave force, inertia force, shear force and displacement of the caisson over time.

The panels are those of Figs. 2a and 2b of Shimosako and Takahashi (1994). A result without a caisson shows its probes.
"""

import argparse
from pathlib import Path

import numpy as np

from common import UserError, plt, run, save
from histories import Result

PANELS = [  # dataset, symbol, colour
    ("force", r"$P$", "tab:blue"),
    ("inertia_force", r"$m\,\ddot{x}_G$", "tab:green"),
    ("shear_force", r"$F_T$", "tab:red"),
    ("caisson/displacement_x", r"$x_G$", "black"),
]


def window(time, histories, share=0.05):
    """The time after which no history exceeds `share` of its own peak any more, and a little more."""
    last = 0
    for history in histories:
        size = np.abs(history.values)
        above = np.flatnonzero(size > share * size.max(initial=0.0))
        last = max(last, above[-1] if above.size else 0)
    end = time[0] + 1.1 * (time[last] - time[0])
    return min(end, time[-1]) if last > 0 else time[-1]


def peak_of(result, name, values, factor):
    """Time and value of the landward (positive) peak, or of the seaward one where there is no other.

    The summary's own peaks come first: they are found inside the steps, not only at their ends.
    """
    response = result.summary.get("response") or {}
    if name in ("force", "shear_force"):
        key = {"force": "peak_force", "shear_force": "peak_shear"}[name]
        if response.get(key, 0.0) > 0:
            return response[key + "_time"], factor * response[key]
    peak = int(np.argmax(values)) if values.max() > 0 else int(np.argmin(values))
    return result.time[peak], values[peak]


def mark_peak(axes, time, value, unit):
    axes.plot(time, value, "o", color="black", ms=3)
    axes.annotate(f"{value:.3g} {unit}", (time, value), xytext=(6, 3), textcoords="offset points")


def stack(count):
    figure, axes = plt.subplots(count, 1, sharex=True, figsize=(6.5, 1.0 + 1.5 * count), squeeze=False)
    axes[-1, 0].set_xlabel("time (s)")
    return figure, axes[:, 0]


def draw_caisson(result):
    histories = [result.history(name) for name, _, _ in PANELS]
    force, inertia, shear, _ = histories
    figure, rows = stack(len(PANELS))
    # Forces share their unit and the height of a unit, so that they compare at a glance.
    force_scale = force.scale((inertia, shear))
    for axes, history, (name, symbol, colour) in zip(rows, histories, PANELS):
        factor, unit = force_scale if history.unit == force.unit else history.scale()
        values = factor * history.values
        axes.plot(result.time, values, color=colour, lw=1.2)
        axes.axhline(0.0, color="black", lw=0.5)
        axes.set_ylabel(f"{symbol} ({unit})")
        mark_peak(axes, *peak_of(result, name, values, factor), unit)
    forces = [axes for axes, history in zip(rows, histories) if history.unit == force.unit]
    low, high = min(a.get_ylim()[0] for a in forces), max(a.get_ylim()[1] for a in forces)
    for axes in forces:
        axes.set_ylim(low, high)
    rows[0].set_xlim(result.time[0], window(result.time, histories))
    rows[0].set_title(f"{result.title}\n{ratio_text(result, force, shear)}")
    figure.align_ylabels()
    return figure


def ratio_text(result, force, shear):
    """The ratio of the summary, whose peaks are found inside the steps; else that of the histories."""
    ratio = (result.summary.get("response") or {}).get("shear_to_force_ratio")
    if ratio is None and force.values.max() > 0:
        ratio = shear.values.max() / force.values.max()
    return "no force" if ratio is None else rf"max $F_T$ / max $P$ = {ratio:.3f}"


def draw_probes(result):
    quantities = result.probes()
    if not quantities:
        raise UserError(f"'{result.path}' has nothing to draw: no caisson and no probes; add [probes.NAME] to the case")
    figure, rows = stack(len(quantities))
    for axes, (quantity, probes) in zip(rows, quantities.items()):
        histories = list(probes.values())
        factor, unit = histories[0].scale(histories[1:])
        for probe, history in probes.items():
            axes.plot(result.time, factor * history.values, lw=1.2, label=probe)
        axes.set_ylabel(f"{quantity.replace('_', ' ')}\n({unit})")
    rows[0].legend(ncol=4, fontsize="small")
    rows[0].set_xlim(result.time[0], window(result.time, [h for p in quantities.values() for h in p.values()]))
    rows[0].set_title(result.title)
    figure.align_ylabels()
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path, help="folder of a finished run, with results.h5 and summary.json")
    parser.add_argument("-o", "--output", type=Path, help="figure (.png, .pdf, .svg); default: figure.png in the folder")
    parser.add_argument("--until", type=float, metavar="S", help="end of the time axis; default: where the response ends")
    arguments = parser.parse_args()
    result = Result(arguments.folder)
    figure = draw_caisson(result) if result.has_caisson else draw_probes(result)
    if arguments.until is not None:
        if not arguments.until > result.time[0]:
            raise UserError(f"--until {arguments.until} is not later than the first time, {result.time[0]} s")
        figure.axes[0].set_xlim(right=arguments.until)
    save(figure, arguments.output or arguments.folder / "figure.png")


if __name__ == "__main__":
    run(main)
