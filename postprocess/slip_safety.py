#!/usr/bin/python3
"""Draws the slip of a caisson by every measure against its safety factor, a panel for each study.

usage: slip_safety.py STUDY_FOLDER... [--scale LENGTH...] [-o FIGURE.png]

Each folder holds the results of `upbead study cases/study/slip/{prototype,model}.toml`; --scale converts lengths to
full size.
"""

import argparse
from pathlib import Path

from common import UserError, beside, figure_argument, save
from upbead import figures
from upbead.study_table import StudyTable


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", metavar="STUDY_FOLDER", type=Path, nargs="+")
    parser.add_argument("--scale", metavar="LENGTH", type=float, nargs="+", help="one for each folder; default: 1")
    figure_argument(parser, "slip-safety.png")
    arguments = parser.parse_args()
    scales = arguments.scale or [1.0] * len(arguments.folders)
    if len(scales) != len(arguments.folders):
        raise UserError(f"--scale has {len(scales)} numbers for {len(arguments.folders)} folders; give one for each")
    tables = [StudyTable(folder) for folder in arguments.folders]
    output = arguments.output or beside(arguments.folders[0], "slip-safety.png")
    save(figures.slip_safety(tables, scales), output, *arguments.folders)


if __name__ == "__main__":
    main()
