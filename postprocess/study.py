#!/usr/bin/python3
"""Draws the results of `upbead study`: a number read from each run against every varied key.

usage: study.py RESULTS_FOLDER [--read PATH] [--x KEY]... [-o FIGURE.png]

Keys that were varied over a few values give lines, one for each combination of the other keys; random draws give points,
with their rank correlation, and the distribution of the number. Several cases have a colour each.
"""

import argparse
from pathlib import Path

from common import beside, figure_argument, save
from upbead import figures
from upbead.study_table import StudyTable


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", metavar="RESULTS_FOLDER", type=Path)
    parser.add_argument("--read", help="the number to draw (default: the first that was read)")
    parser.add_argument("--x", action="append", help="draw against this key only; may be given several times")
    figure_argument(parser, "study.png")
    arguments = parser.parse_args()
    table = StudyTable(arguments.folder)
    output = arguments.output or beside(arguments.folder, "study.png")
    save(figures.study(table, arguments.read, arguments.x), output, arguments.folder)


if __name__ == "__main__":
    main()
