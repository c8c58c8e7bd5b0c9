#!/usr/bin/python3
"""Evaluates a reduced model (MODEL.h5 of 'upbead reduce') for a wave: it is a sum of modes, and needs no upbead.

As a library:

    from reduced_model import ReducedModel
    model = ReducedModel("prototype.h5")
    time = np.linspace(0.0, 2.0, 2001)
    answer = model.respond(time, {"impact": force})     # N/m at those times
    print(model.peaks(time, {"impact": force}).largest / force.max())  # peaks between those times, too

As a script it draws P and F_T of a wave in a CSV file, and |F_T / P| over frequency.
"""

import argparse
from pathlib import Path

from common import save
from upbead import figures
from upbead.reduced_model import ModelError, ReducedModel, fine, phi_functions, read_wave

__all__ = ["ModelError", "ReducedModel", "fine", "phi_functions", "read_wave"]  # for programs that import this file


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("model", type=Path, help="the model (.h5)")
    parser.add_argument("wave", type=Path, help="the wave (.csv): time (s), then columns named like loads of the model")
    parser.add_argument("--reading", default="shear_force", help="what to draw beside P (default: shear_force)")
    parser.add_argument("--until", type=float, metavar="S", help="how long to answer (default: twice the wave)")
    parser.add_argument("-o", "--out", type=Path, help="figure (.png, .pdf, .svg); default: beside the wave")
    arguments = parser.parse_args()
    model = ReducedModel(arguments.model)
    if arguments.reading not in model.readings:
        raise ModelError(f"the model has no reading '{arguments.reading}', but: {', '.join(model.readings)}")
    time, loads = read_wave(arguments.wave, model)
    time, loads = fine(time, loads, model, arguments.until or 2.0 * time[-1])
    figure = figures.reduced_model(model, time, loads, arguments.reading)
    save(figure, arguments.out or arguments.wave.with_suffix(".png"), arguments.model, arguments.wave)


if __name__ == "__main__":
    main()
