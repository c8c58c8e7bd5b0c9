#!/usr/bin/env python3
"""Draws sliding distance against the safety factor, as Fig. 10 of Shimosako and Takahashi (1994).

Each summary is one curve, its waves are the points. Colours tell the friction coefficient, lines the design:

  for mu in 0.5 0.6 0.7; do
    for design in impulsive non_breaking; do
      build/upbead waves cases/fig10/$design.toml --set section.friction=$mu --out results/fig10/$design-$mu
    done
  done
  postprocess/sliding_safety.py results/fig10/*
"""

import argparse
from pathlib import Path

import numpy as np

from common import UserError, plt, run, save
from wave_summary import read

FORMULAS = {"paper": "eq. (7)", "exact": "eqs. (4) and (6), integrated", "combined": "standing wave and pulse"}
COLOURS = ["tab:blue", "tab:red", "tab:green", "tab:purple", "tab:orange", "tab:brown"]
LINES = ["-", "--", ":", "-."]


def curve(summary, formula):
    """Safety factors in ascending order, and S."""
    points = sorted((w["safety_sliding"], w[f"sliding_{formula}"]) for w in summary["waves"].values())
    return zip(*points)


def draw(summaries, formula, low, high):
    figure, axes = plt.subplots(figsize=(5.6, 3.8))
    titles = sorted({s["title"] for s in summaries})
    frictions = sorted({s["section"]["friction"] for s in summaries})
    largest = 0.0
    for summary in summaries:
        safety, distance = (np.array(values) for values in curve(summary, formula))
        line = LINES[titles.index(summary["title"]) % len(LINES)]
        colour = COLOURS[frictions.index(summary["section"]["friction"]) % len(COLOURS)]
        axes.plot(safety, distance, line, color=colour, lw=1.3)
        inside = np.linspace(max(low, safety[0]), min(high, safety[-1]), 100)
        largest = max(largest, np.interp(inside, safety, distance).max())
    if largest == 0:
        raise UserError(f"no wave with a safety factor from {low} to {high} slides the caisson")
    axes.set(xlim=(low, high), ylim=(0, 1.05 * largest), xlabel="safety factor against sliding",
             ylabel="sliding distance $S$ (m)", title=f"S by {FORMULAS[formula]}")
    handles = [plt.Line2D([], [], color="black", ls=LINES[i % len(LINES)], label=t) for i, t in enumerate(titles)]
    handles += [plt.Line2D([], [], color=COLOURS[i % len(COLOURS)], label=rf"$\mu$ = {f:g}")
                for i, f in enumerate(frictions)]
    axes.legend(handles=handles)
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("summaries", type=Path, nargs="+", help="folders of 'upbead waves', or their summary.json")
    parser.add_argument("-o", "--output", type=Path, default=Path("sliding_safety.png"),
                        help="figure (.png, .pdf, .svg); default: sliding_safety.png")
    parser.add_argument("--formula", choices=FORMULAS, default="paper", help="which S; default: paper, eq. (7)")
    parser.add_argument("--range", type=float, nargs=2, default=(0.6, 1.0), metavar=("LOW", "HIGH"),
                        help="of the safety factor; default: 0.6 1.0")
    arguments = parser.parse_args()
    low, high = arguments.range
    if not low < high:
        raise UserError(f"--range {low} {high}: the first number must be the smaller one")
    save(draw([read(path) for path in arguments.summaries], arguments.formula, low, high), arguments.output)


if __name__ == "__main__":
    run(main)
