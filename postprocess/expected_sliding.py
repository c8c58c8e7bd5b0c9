#!/usr/bin/python3
"""Draws the results of `upbead expected`: heights of the waves, S by height, and the part of each height in the
expected sliding distance.

usage: expected_sliding.py RESULTS_FOLDER... [--law LAW] [-o FIGURE.png]

One folder gives the three panels of Figs. 12-14 of Shimosako and Takahashi (1994); the curves of several folders are
drawn together. Of storms, which have no record of heights, the share of the lives that slide so far is drawn.
"""

import argparse
from pathlib import Path

from common import beside, figure_argument, save
from upbead import figures
from upbead.expected_result import ExpectedResult
from upbead.figures.expected import LAWS


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", metavar="RESULTS_FOLDER", type=Path, nargs="+")
    parser.add_argument("--law", choices=LAWS, action="append", help="draw this law only; may be given several times")
    figure_argument(parser, "expected.png")
    arguments = parser.parse_args()
    results = [ExpectedResult(folder) for folder in arguments.folders]
    output = arguments.output or beside(arguments.folders[0], "expected.png")
    save(figures.expected(results, arguments.law), output, *arguments.folders)


if __name__ == "__main__":
    main()
