#!/usr/bin/python3
"""Draws the slip of a caisson by every measure against its safety factor, a panel for each study.

usage: slip_safety.py STUDY_FOLDER... [--scale LENGTH...] [-o FIGURE.png]

Each folder holds what `upbead study cases/study/slip/{prototype,model}.toml` wrote; --scale brings lengths to full
size.
"""

import argparse
import csv
from pathlib import Path

import numpy as np

from common import UserError, plt, run, save

MEASURES = [  # column, name, line
    ("sliding.equal_impulse.sliding_paper", "pulse of equal impulse, eq. (7)", "s:", "0.6"),
    ("sliding.equal_impulse.sliding_exact", "the same, integrated", "s-", "0.6"),
    ("sliding.sliding_history", "$F_T(t)$ of the bonded caisson, eq. (4)", "o-", "black"),
    ("sliding.sliding_coupled", "slips as a whole on its ground", "^-", "tab:blue"),
    ("contact.solved.slip", "node by node, mean", "o-", "tab:red"),
    ("contact.solved.least_slip", "node by node, least", "o:", "tab:red"),
]
LEAST = 0.03  # mm: slips below it are not shown


def rows_of(folder):
    try:
        with open(folder / "study.csv", newline="") as file:
            rows = [row for row in csv.DictReader(file) if row["status"] == "done"]
    except OSError as error:
        raise UserError(f"'{folder}' holds no results of 'upbead study': {error.strerror}") from error
    if not rows:
        raise UserError(f"all runs of '{folder}' failed, see the column 'message' of study.csv")
    return rows


def column(rows, key, folder):
    try:
        return np.array([float(row[key] or "nan") for row in rows])
    except KeyError:
        raise UserError(f"'{folder / 'study.csv'}' has no column {key}: add it to 'read' of the study") from None


def draw(axes, folder, scale):
    rows = rows_of(folder)
    safety = 1.0 / column(rows, "sliding.ratio", folder)
    for key, name, line, colour in MEASURES:
        slip = 1e3 * scale * column(rows, key, folder)
        shown = slip > LEAST
        axes.plot(safety[shown], slip[shown], line, color=colour, ms=3.5, lw=1.2, label=name)
    axes.set(yscale="log", xlabel=r"safety factor $\mu W' / F_{T,\mathrm{max}}$")
    axes.yaxis.set_major_formatter("{x:g}")
    axes.set_title(folder.resolve().name + (f", lengths times {scale:g}" if scale != 1 else ""), fontsize=9)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", metavar="STUDY_FOLDER", type=Path, nargs="+")
    parser.add_argument("--scale", metavar="LENGTH", type=float, nargs="+", help="one for each folder; default: 1")
    parser.add_argument("-o", "--output", type=Path, default=Path("slip-safety.png"))
    arguments = parser.parse_args()
    scales = arguments.scale or [1.0] * len(arguments.folders)
    if len(scales) != len(arguments.folders):
        raise UserError(f"--scale has {len(scales)} numbers for {len(arguments.folders)} folders; give one for each")
    figure, places = plt.subplots(1, len(scales), figsize=(4.6 * len(scales), 4.2), sharey=True, squeeze=False,
                                  layout="constrained")
    for axes, folder, scale in zip(places[0], arguments.folders, scales):
        draw(axes, folder, scale)
    places[0, 0].set_ylabel("$S$ (mm)")
    places[0, 0].set_ylim(bottom=LEAST)
    places[0, 0].legend(fontsize=7.5)
    save(figure, arguments.output)


if __name__ == "__main__":
    run(main)
