#!/usr/bin/python3
"""Draws one slide as Figs. 6 and 8 of Shimosako and Takahashi (1994): forces, displacement and slip over time.

usage: slip_histories.py SLIDES BONDED [-o FIGURE.png] [--until S]

SLIDES is the folder of a run with regions.caisson.interface.kind = "friction", BONDED that of the same case without it.
"""

import argparse
from pathlib import Path

from common import beside, figure_argument, save
from upbead import figures
from upbead.results import Result
from upbead.slip_result import SlipResult


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("slides", type=Path)
    parser.add_argument("bonded", type=Path)
    figure_argument(parser, "slip-histories.png")
    parser.add_argument("--until", type=float, metavar="S", help="end of the time axis; default: that of the run")
    arguments = parser.parse_args()
    slides, bonded = SlipResult(arguments.slides), Result(arguments.bonded)
    output = arguments.output or beside(arguments.slides, "slip-histories.png")
    save(figures.slip_histories(slides, bonded, arguments.until), output, arguments.slides, arguments.bonded)


if __name__ == "__main__":
    main()
