#!/usr/bin/python3
"""Draws study 1, model against prototype: F_T / P by the peak of P, stiffness, pulse, permeability, mound and caisson.

usage: model_prototype.py RESULTS_FOLDER [-o FIGURE.png]

RESULTS_FOLDER holds what `upbead study cases/study/model-prototype/*.toml` wrote: peak-model/, peak-prototype/ and so on.
"""

import argparse
import csv
import json
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from common import UserError, run, save

SCALES = {"model": (20.0, "tab:blue"), "prototype": (1.0, "tab:red")}
RATIO = "response.shear_to_force_ratio"
SPECTRUM = Path(__file__).resolve().parent.parent / "tests/reference/ref5_lumped.json"
PANELS = [  # study, varied key, what stands on the x axis, power of the length scale that makes model and prototype one
    ("peak", "loads.impulse.factor", "peak of P / that of Fig. 2b", 0),
    ("stiffness", "regions.seabed.shear_modulus.reference", "G of the sand at 98 kPa (MPa)", 0),
    ("rise", "loads.impulse.pulse.rise", "rise / duration", 0.5),
    ("permeability", "regions.mound.hydraulic_conductivity", "k of the rubble, at full scale (m/s)", 0.5),
    ("mound", "mesh.parameters.mound_height", "height of the mound, at full scale (m)", 1),
    ("width", "mesh.parameters.caisson_width", "width of the caisson, at full scale (m)", 1),
]


def rows_of(folder):
    try:
        with open(folder / "study.csv", newline="") as file:
            return [row for row in csv.DictReader(file) if row["status"] == "done"]
    except OSError as error:
        raise UserError(f"'{folder}' holds no results of 'upbead study': {error.strerror}") from error


def column(rows, key):
    return np.array([float(row[key]) for row in rows])


def draw_panel(axis, root, panel):
    study, key, label, power = panel
    for scale, (length, colour) in SCALES.items():
        rows = rows_of(root / f"{study}-{scale}")
        x = column(rows, key) * length**power
        x = x / 0.15 if study == "rise" else x / 1e6 if study == "stiffness" else x
        axis.plot(x, column(rows, RATIO), "o-", ms=3, color=colour, label=scale)
    if study in ("peak", "stiffness", "permeability"):
        axis.set_xscale("log")
    axis.set_xlabel(label)
    axis.set_ylim(bottom=0)


def draw_duration(axis, root):
    """By pulse duration over the period that an oscillator of the same impulsive limit has."""
    with open(SPECTRUM) as file:
        spectra = [s for s in json.load(file)["sdof_spectrum"] if s["rise_fraction"] == 0.5]
    for spectrum in spectra:
        if spectrum["zeta"] in (0.05, 0.2):
            axis.plot(spectrum["td_over_Tn"], spectrum["peak_FT"], "-" if spectrum["zeta"] == 0.05 else "--", color="0.6",
                      label=f"one degree of freedom, {100 * spectrum['zeta']:.0f} %")
    damped = next(s for s in spectra if s["zeta"] == 0.1)
    limit = damped["peak_FT"][0] / damped["td_over_Tn"][0]
    for scale, (_, colour) in SCALES.items():
        for sea, style in (("6", "o-"), ("0", "x:")):
            rows = [r for r in rows_of(root / f"duration-{scale}") if float(r["mesh.parameters.sea_front"]) == float(sea)]
            td, ratio = column(rows, "loads.impulse.pulse.duration"), column(rows, RATIO)
            period = limit * td[0] / ratio[0]
            axis.plot(td / period, ratio, style, ms=3, color=colour,
                      label=f"{scale}, {'sea' if sea == '6' else 'no sea'}, T = {1e3 * period:.3g} ms")
    axis.set_xscale("log")
    axis.set_xlabel("duration of the pulse / T of the impulsive limit")
    axis.legend(fontsize=6)
    axis.set_ylim(bottom=0)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", type=Path)
    parser.add_argument("-o", "--output", type=Path, default=Path("model-prototype.png"))
    arguments = parser.parse_args()
    figure, axes = plt.subplots(2, 4, figsize=(13, 6.2), layout="constrained")
    draw_duration(axes[0, 2], arguments.results)
    places = [axes[0, 0], axes[0, 1], axes[0, 3], axes[1, 0], axes[1, 1], axes[1, 2]]
    for axis, panel in zip(places, PANELS):
        draw_panel(axis, arguments.results, panel)
    for axis in axes[:, 0]:
        axis.set_ylabel("peak $F_T$ / peak $P$")
    axes[0, 0].legend()
    axes[1, 3].axis("off")
    save(figure, arguments.output)


run(main)
