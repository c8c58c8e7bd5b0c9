#!/usr/bin/python3
"""Draws the pressure over the height of the wall, with and without alpha_I, as Figs. 7 and 9 of Shimosako and
Takahashi (1994).

  build/upbead waves cases/fig7-9/impulsive.toml --out results/fig7-9/impulsive
  build/upbead waves cases/fig7-9/non_breaking.toml --out results/fig7-9/non_breaking
  postprocess/wave_pressure.py results/fig7-9/impulsive results/fig7-9/non_breaking

Measured pressures come from a CSV with one header line and the columns height above still water (m) and pressure (Pa),
one file for each summary.
"""

import argparse
from pathlib import Path

from common import UserError, beside, figure_argument, save
import numpy as np
from upbead import figures
from upbead.waves_result import read_waves


def measured_points(path):
    try:
        points = np.genfromtxt(path, delimiter=",", skip_header=1, ndmin=2)
    except (OSError, ValueError) as error:
        raise UserError(f"cannot read '{path}': {error}") from error
    if points.shape[0] == 0 or points.shape[1] != 2 or not np.isfinite(points).all():
        raise UserError(f"'{path}': expected a header line, then two numbers a line: height (m), pressure (Pa)")
    return points


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("summaries", type=Path, nargs="+", help="folders of 'upbead waves', or their summary.json")
    parser.add_argument("--wave", help="name of the wave; may be left out where there is only one")
    parser.add_argument("--measured", type=Path, nargs="+", metavar="CSV", help="measured pressures, a file a summary")
    figure_argument(parser, "wave_pressure.png")
    arguments = parser.parse_args()
    summaries = [read_waves(path) for path in arguments.summaries]
    if arguments.measured and len(arguments.measured) != len(summaries):
        raise UserError(f"{len(summaries)} summaries, but {len(arguments.measured)} files of --measured; give as many")
    measured = [measured_points(path) for path in arguments.measured] if arguments.measured else None
    output = arguments.output or beside(arguments.summaries[0], "wave_pressure.png")
    save(figures.wave_pressure(summaries, arguments.wave, measured), output, *arguments.summaries,
         *(arguments.measured or ()))


if __name__ == "__main__":
    main()
