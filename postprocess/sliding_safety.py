#!/usr/bin/python3
"""Draws sliding distance against the safety factor, as Fig. 10 of Shimosako and Takahashi (1994).

Each summary is one curve, its waves are the points. Colours stand for the friction coefficient, line styles for the
design:

  for mu in 0.5 0.6 0.7; do
    for design in impulsive non_breaking; do
      build/upbead waves cases/fig10/$design.toml --set section.friction=$mu --out results/fig10/$design-$mu
    done
  done
  postprocess/sliding_safety.py results/fig10/*
"""

import argparse
from pathlib import Path

from common import beside, figure_argument, save
from upbead import figures
from upbead.figures.sliding_safety import FORMULAS
from upbead.waves_result import read_waves


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("summaries", type=Path, nargs="+", help="folders of 'upbead waves', or their summary.json")
    figure_argument(parser, "sliding_safety.png")
    parser.add_argument("--formula", choices=FORMULAS, default="paper", help="which S; default: paper, eq. (7)")
    parser.add_argument("--range", type=float, nargs=2, default=(0.6, 1.0), metavar=("LOW", "HIGH"),
                        help="of the safety factor; default: 0.6 1.0")
    arguments = parser.parse_args()
    summaries = [read_waves(path) for path in arguments.summaries]
    output = arguments.output or beside(arguments.summaries[0], "sliding_safety.png")
    save(figures.sliding_safety(summaries, arguments.formula, *arguments.range), output, *arguments.summaries)


if __name__ == "__main__":
    main()
