#!/usr/bin/python3
"""Draws study 1, model against prototype: F_T / P by the peak of P, stiffness, pulse, permeability, mound and caisson.

usage: model_prototype.py RESULTS_FOLDER [-o FIGURE.png]

RESULTS_FOLDER holds the results of `upbead study cases/study/model-prototype/*.toml`: peak-model/, peak-prototype/
and so on.
"""

import argparse
import json
from pathlib import Path

from common import beside, figure_argument, save
from upbead import figures
from upbead.figures.model_prototype import SCALES, STUDIES
from upbead.study_table import StudyTable

SPECTRUM = Path(__file__).resolve().parent.parent / "tests/reference/ref5_lumped.json"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", type=Path)
    figure_argument(parser, "model-prototype.png")
    arguments = parser.parse_args()
    folder = arguments.results
    tables = {(study, scale): StudyTable(folder / f"{study}-{scale}") for study in STUDIES for scale in SCALES}
    spectra = [s for s in json.loads(SPECTRUM.read_text())["sdof_spectrum"] if s["rise_fraction"] == 0.5]
    output = arguments.output or beside(folder, "model-prototype.png")
    save(figures.model_prototype(tables, spectra), output, SPECTRUM, *(table.folder for table in tables.values()))


if __name__ == "__main__":
    main()
