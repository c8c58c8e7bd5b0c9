#!/usr/bin/python3
"""Responses of linear, equivalent-linear and hysteretic soil with the same curve of G by strain, against the size of
the force.

    /usr/bin/python3 postprocess/yielding_amplitudes.py build/upbead docs      # two minutes

Solves cases/fig2b-prototype.toml with the same table `strain` in mound and sand, and prints the table of
docs/yielding.md; the figure goes to docs/figures/yielding-amplitudes.png. Hysteretic soil starts unloaded (start
"virgin"), as equivalent-linear soil has no stress at rest either.
"""

import argparse
import tempfile
from pathlib import Path

from common import save

import upbead
from upbead import figures

CASE = Path(__file__).resolve().parents[1] / "cases/fig2b-prototype.toml"
SOILS, FACTORS, REFERENCE = ("seabed", "mound"), (0.1, 0.5, 1.0, 2.0, 4.0, 8.0), 5e-4


def setting(way, factor):
    found = {"loads.impulse.factor": factor}
    if way != "elastic":
        found |= {f"regions.{soil}.strain.reference_strain": REFERENCE for soil in SOILS}
    if way == "hysteretic":
        found |= {f"regions.{soil}.law": "hysteretic" for soil in SOILS}
        found |= {"initial.start": "virgin", "initial.bounds": False}
    return found


def solved(program, folder):
    return {
        way: [(factor, upbead.run(CASE, setting(way, factor), folder / f"{way}-{factor}", program=program)) for factor in FACTORS]
        for way in ("elastic", "equivalent", "hysteretic")
    }


def table(rows):
    lines = ["| factor of P | F_T/P linear | equivalent-linear | hysteretic | x_G, mm, equivalent-linear | hysteretic | residual x, mm |", "|---:|---:|---:|---:|---:|---:|---:|"]
    for (factor, linear), (_, equivalent), (_, hysteretic) in zip(*(rows[way] for way in ("elastic", "equivalent", "hysteretic"))):
        ratios = [f"{found.summary['response']['shear_to_force_ratio']:.3f}" for found in (linear, equivalent, hysteretic)]
        peaks = [f"{1e3 * found.summary['response']['peak_displacement']:.3g}" for found in (equivalent, hysteretic)]
        rest = f"{1e3 * hysteretic.summary['residual']['displacement_x']:.2g}"
        lines.append("| " + " | ".join([f"{factor:g}", *ratios, *peaks, rest]) + " |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path, help="the program: build/upbead")
    parser.add_argument("docs", type=Path, help="folder whose figures/ is written to: docs")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        rows = solved(arguments.program, Path(folder))
        print(table(rows))
        save(figures.amplitudes(rows), arguments.docs / "figures/yielding-amplitudes.png")


if __name__ == "__main__":
    main()
