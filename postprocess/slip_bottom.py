#!/usr/bin/python3
"""Draws the state of the bottom of a caisson that slips and lifts: normal stress, state of the nodes, contact and
normal force.

usage: slip_bottom.py FOLDER [-o FIGURE.png] [--until S]

FOLDER is the result of a run with regions.caisson.interface.kind = "friction".
"""

import argparse
from pathlib import Path

from common import beside, figure_argument, save
from upbead import figures
from upbead.slip_result import SlipResult


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    figure_argument(parser, "slip-bottom.png")
    parser.add_argument("--until", type=float, metavar="S", help="end of the time axes; default: that of the run")
    arguments = parser.parse_args()
    output = arguments.output or beside(arguments.folder, "slip-bottom.png")
    save(figures.slip_bottom(SlipResult(arguments.folder), arguments.until), output, arguments.folder)


if __name__ == "__main__":
    main()
