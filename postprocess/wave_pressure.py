#!/usr/bin/env python3
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

import numpy as np

from common import UserError, plt, run, save
from wave_summary import read


def pick(summary, name):
    """The wave of that name; the only one where no name is given."""
    waves = summary["waves"]
    if name is None and len(waves) > 1:
        raise UserError(f"the summary has {len(waves)} waves; choose one with --wave: {', '.join(waves)}")
    if name is not None and name not in waves:
        raise UserError(f"there is no wave '{name}'; the summary has {', '.join(waves)}")
    return name or next(iter(waves)), waves[name or next(iter(waves))]


def profile(section, eta_star, p):
    """Heights above still water (m) and pressures (kPa) from the caisson's bottom to where the pressure ends."""
    top = min(eta_star, section["crest"])
    return np.array([-section["foundation_depth"], 0.0, top]), np.array([p["p3"], p["p1"], p["p4"]]) / 1e3


def measured_points(path):
    try:
        points = np.genfromtxt(path, delimiter=",", skip_header=1, ndmin=2)
    except (OSError, ValueError) as error:
        raise UserError(f"cannot read '{path}': {error}") from error
    if points.shape[0] == 0 or points.shape[1] != 2 or not np.isfinite(points).all():
        raise UserError(f"'{path}': expected a header line, then two numbers a line: height (m), pressure (Pa)")
    return points


def draw_one(axes, summary, name, measured):
    section = summary["section"]
    name, wave = pick(summary, name)
    for p, style, label in ((wave, "-", r"with $\alpha_I$"), (wave["without_alpha_I"], "--", r"$\alpha_2$ alone")):
        height, pressure = profile(section, wave["eta_star"], p)
        colour = "tab:red" if style == "-" else "tab:blue"
        axes.plot(pressure, height, style, color=colour, lw=1.5,
                  label=f"{label}: P = {p['force'] / 1e6:.3g} MN/m")
    if measured is not None:
        points = measured_points(measured)
        axes.plot(points[:, 1] / 1e3, points[:, 0], "o", color="black", ms=4, label="measured")
    axes.axhline(0, color="black", lw=0.6)
    axes.plot([0, 0], [-section["foundation_depth"], section["crest"]], color="black", lw=4, solid_capstyle="butt")
    axes.set(xlabel="pressure (kPa)", title=f"{summary['title'] or name}\nH = {wave['height']:.3g} m, "
             f"T = {wave['period']:.3g} s, " + rf"$\alpha^*$ = {wave['alpha_star']:.2g}")
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.14))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("summaries", type=Path, nargs="+", help="folders of 'upbead waves', or their summary.json")
    parser.add_argument("--wave", help="name of the wave; may be left out where there is only one")
    parser.add_argument("--measured", type=Path, nargs="+", metavar="CSV", help="measured pressures, a file a summary")
    parser.add_argument("-o", "--output", type=Path, default=Path("wave_pressure.png"),
                        help="figure (.png, .pdf, .svg); default: wave_pressure.png")
    arguments = parser.parse_args()
    measured = arguments.measured or [None] * len(arguments.summaries)
    if len(measured) != len(arguments.summaries):
        raise UserError(f"{len(arguments.summaries)} summaries, but {len(measured)} files of --measured; give as many")
    summaries = [read(path) for path in arguments.summaries]
    size = (4.4 * len(summaries), 4.4)
    figure, rows = plt.subplots(1, len(summaries), sharex=True, sharey=True, squeeze=False, figsize=size)
    for axes, summary, points in zip(rows[0], summaries, measured):
        draw_one(axes, summary, arguments.wave, points)
    rows[0, 0].set_xlim(left=0)
    rows[0, 0].set_ylabel("height above still water (m)")
    save(figure, arguments.output)


if __name__ == "__main__":
    run(main)
