#!/usr/bin/python3
"""Draws the results of `upbead calibrate`: k = tau_0/tau_0F against alpha*, the fits, and the confidence of their a
and b.

usage: calibration.py RESULTS_FOLDER [--measure MEASURE | --spectrum] [-o FIGURE.png]

A column per model. Above, a panel per r: the waves by their period, the fit with its 95 % band, and the given k (the
paper's a = 0.3, b = 2). Below: the 95 % ellipses of (a, b) and the given point. With --spectrum: peak F_T over peak P
of every wave by the rise of its force.
"""

import argparse
from pathlib import Path

from common import beside, figure_argument, save
from upbead import figures
from upbead.calibration_result import CalibrationResult
from upbead.figures.calibration import MEASURES


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", metavar="RESULTS_FOLDER", type=Path)
    parser.add_argument("--measure", choices=MEASURES, default="exact", help="formula that tau_0 is found with")
    parser.add_argument("--spectrum", action="store_true", help="draw F_T/P instead of k")
    figure_argument(parser, "calibration.png")
    arguments = parser.parse_args()
    results = CalibrationResult(arguments.folder)
    spectrum = arguments.spectrum
    figure = figures.calibration_spectrum(results) if spectrum else figures.calibration(results, arguments.measure)
    output = arguments.output or beside(arguments.folder, "calibration.png")
    save(figure, output, arguments.folder)


if __name__ == "__main__":
    main()
