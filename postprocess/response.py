#!/usr/bin/python3
"""Draws the response of a run: wave force, inertia force, shear force and displacement of the caisson over time.

The panels are those of Figs. 2a and 2b of Shimosako and Takahashi (1994). A result without a caisson shows its probes.
"""

import argparse
from pathlib import Path

from common import save
from upbead import figures
from upbead.results import Result


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path, help="folder of a finished run, with results.h5 and summary.json")
    parser.add_argument("-o", "--output", type=Path, help="figure (.png, .pdf, .svg); default: figure.png in the folder")
    parser.add_argument("--until", type=float, metavar="S", help="end of the time axis; default: where the response ends")
    arguments = parser.parse_args()
    figure = figures.response(Result(arguments.folder), arguments.until)
    save(figure, arguments.output or arguments.folder / "figure.png", arguments.folder)


if __name__ == "__main__":
    main()
