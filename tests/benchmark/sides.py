#!/usr/bin/python3
"""Error of F_T caused by the far sides of seabed and sea, on the section of cases/fig2b-prototype.toml.

usage: sides.py PROGRAM [-o FOLDER] [--only NUMBER...]
       sides.py --from FOLDER/sides.json... [-o FOLDER]

Writes FOLDER/sides.{json,md,png}; with --from the table and the figure only. All runs of a study have the same cells around
the mound and the same steps. Errors are relative to the peak of F_T of a very wide section: of the peak itself, and the
largest of the history over 1 s and over 3 s. Takes half an hour.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
import time

import h5py
import matplotlib
import matplotlib.ticker
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402  (the backend must be chosen first)

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
from section_scene import scene  # noqa: E402

# Without sea, and with G as it was when this was measured: later calibrations of the case change nothing here.
CASE = scene(("parameters = { cells = 0.5, seabed_front = 60, seabed_back = 60 }\n", ""), ("30e6", "29.516e6"),
             ("50e6", "49.193e6"), ("peak = 1e6", "peak = 1.6e6"))
MOUND = 56.0  # m, from toe to toe
TOE = 19.0  # m, from the caisson's wall
WATER = 15.0  # m
COMMON = {"time.end": 3.0, "time.step": 0.15 / 8, "time.scheme": "sdirk4"}  # marched, for its balance of energy
DAMPINGS = {"5 %": {}, "undamped": {"regions.seabed.damping.ratio": 0.0, "regions.mound.damping.ratio": 0.0}}

# Lengths beyond the toes (m): multiples of 3 m, the size of the cells there, so that all cells are equal.
LENGTHS = (3, 15, 27, 60, 84, 120, 195, 300, 420)
DEEP_LENGTHS = (15, 27, 60, 84, 195, 420)
SHORT_SEAS = (3, 12, 27, 42)
SEAS = (*SHORT_SEAS, 72)
BELOW_SEA = 195  # m, of the seabed


class Run:
    """One run of the scene with other values of some keys."""

    def __init__(self, program, *settings):
        with tempfile.TemporaryDirectory() as folder:
            case = pathlib.Path(folder) / "sides.toml"
            case.write_text(CASE)
            arguments = [str(program), "run", str(case), "--json"]
            for table in (COMMON, *settings):
                for key, value in table.items():
                    arguments += ["--set", f"{key}={value}"]
            begin = time.perf_counter()
            done = subprocess.run(arguments + ["--out", folder], capture_output=True, text=True, check=True)
            self.wall = time.perf_counter() - begin
            with h5py.File(pathlib.Path(folder) / "results.h5") as file:
                self.time, self.shear = file["history/time"][:], file["history/shear_force"][:]
        self.summary = json.loads(done.stdout)
        self.peak = self.summary["response"]["peak_shear"]

    def row(self, label, distance, condition, reference):
        history = abs(np.interp(self.time, reference.time, reference.shear) - self.shear) / reference.peak
        energy = self.summary["energy"]
        return {
            "label": label,
            "distance": distance,
            "condition": condition,
            "unknowns": self.summary["discretisation"]["unknowns"],
            "peak": self.peak,
            "peak_error": abs(self.peak / reference.peak - 1),
            "error_1s": float(history[self.time <= 1 + 1e-9].max()),
            "error_3s": float(history.max()),
            "radiated": energy["radiated"] / energy["work"],
            "mismatch": energy["mismatch"],
            "wall": self.wall,
        }


def seabed(length, condition):
    return {
        "mesh.parameters.seabed_front": length,
        "mesh.parameters.seabed_back": length,
        "boundaries.left.displacement": condition,
        "boundaries.right.displacement": condition,
    }


def sea(length, condition, compressibility="compressible"):
    settings = {"mesh.parameters.water_depth": WATER, "boundaries.sea_surface.pressure": "open"}
    for side, end in (("front", "left"), ("back", "right")):
        settings[f"mesh.parameters.sea_{side}"] = (TOE + length) / WATER
        settings[f"regions.sea_{side}.kind"] = "water"
        settings[f"regions.sea_{side}.compressibility"] = compressibility
        settings[f"boundaries.sea_{end}.pressure"] = condition
    return settings


def widths(length):
    return 0.5 + length / MOUND


def depths(length):
    return (TOE + length) / WATER


def study(program, name, damping, conditions, lengths, wide, check, settings, position, is_drawn=False, extra=()):
    """Rows of both conditions, of a second very wide section, and, undamped, of the runs `extra` (label, settings);
    settings(length, condition) are the keys of the scene."""

    def run(length, condition):
        return Run(program, DAMPINGS[damping], settings(length, condition))

    reference = run(wide, conditions[0])
    rows = [run(length, condition).row(length, position(length), condition, reference)
            for condition in conditions for length in lengths]
    if not DAMPINGS[damping]:
        rows += [Run(program, others).row(label, 0, "", reference) for label, others in extra]
    return {"name": name, "damping": damping, "conditions": conditions, "unit": position.__name__, "drawn": is_drawn,
            "reference": position(wide), "peak": reference.peak, "wall": reference.wall,
            "unknowns": reference.summary["discretisation"]["unknowns"], "rows": rows,
            "check": run(check, conditions[0]).row(check, position(check), conditions[0], reference)}


SIDES, SEA_ENDS = ("roller", "absorbing"), ("sealed", "absorbing")
DEEP = {"mesh.parameters.seabed_depth": 60}
ABSORBING_BASE = {**DEEP, "boundaries.base.displacement": "absorbing"}
HALF_SPACE = {**ABSORBING_BASE, **seabed(420, "absorbing"), "mesh.parameters.seabed_depth": 240}
DRAINED = {"regions.seabed.flow": "drained"}
STIFF = {"regions.seabed.shear_modulus": 29.516e10}


def on(ground):
    return lambda length, condition: {**ground, **seabed(length, condition)}


def below_sea(ground):
    return lambda length, condition: {**ground, **seabed(BELOW_SEA, "absorbing"), **sea(length, condition)}


def with_sea(length, condition):
    return {**seabed(length, condition), **sea(length, "sealed" if condition == "roller" else condition)}


INCOMPRESSIBLE = below_sea({})(162, "sealed") | sea(162, "sealed", "incompressible")

STUDIES = (
    ("15 m of sand on a rigid base", SIDES, LENGTHS, 1764, 1317, on({}), widths, True),
    ("15 m of drained sand on a rigid base", SIDES, (27, 60, 84), 420, 300, on(DRAINED), widths),
    ("60 m of sand on a rigid base", SIDES, DEEP_LENGTHS, 1317, 867, on(DEEP), widths, True),
    ("60 m of sand, absorbing base", SIDES, DEEP_LENGTHS, 1317, 867, on(ABSORBING_BASE), widths, True,
     (("240 m of sand, 420 m", HALF_SPACE), ("rigid base, 300 m", {**DEEP, **seabed(300, "roller")}))),
    ("sea over 15 m of sand of 195 m", SEA_ENDS, SEAS, 162, 117, below_sea({}), depths, True,
     (("162 m, incompressible", INCOMPRESSIBLE),)),
    ("sea over stiff ground", SEA_ENDS, SHORT_SEAS, 162, 72, below_sea(STIFF), depths),
    ("sea as long as the 15 m of sand below", SIDES, (27, 60, 84, 120), 420, 300, with_sea, widths),
)


def measure(program, numbers):
    """Yields the studies."""
    for number in numbers:
        name, *others = STUDIES[number]
        for damping in DAMPINGS:
            yield study(program, name, damping, *others)


def title(study):
    return f"{study['name']}, {study['damping']}"


def percent(value):
    if value < 5e-7:
        return "0"
    return f"{100 * value:.2g}" if value < 0.995 else f"{100 * value:.0f}"


def errors(row):
    return " / ".join(percent(row[key]) for key in ("peak_error", "error_1s", "error_3s"))


def block(studies):
    """Lines of the table for one scene, damped and undamped."""
    first = studies[0]
    check = max(study["check"]["error_3s"] for study in studies)
    unit = first["unit"]
    lines = [f"| **{first['name']}** | {first['reference']:.0f} {unit} | {first['unknowns']} | {first['wall']:.0f} | "
             f"{first['check']['distance']:.0f} {unit}: {percent(check)} | | | | |"]
    for label in dict.fromkeys(row["label"] for row in first["rows"]):
        rows = {(study["damping"], row["condition"]): row for study in studies for row in study["rows"]
                if row["label"] == label}
        any_row = next(iter(rows.values()))
        if any_row["distance"] > 0:
            start = f"| {label} m | {any_row['distance']:.2f} | "
            conditions = first["conditions"]
        else:
            start = f"| {label} | | "
            conditions = ("", None)
        cells = [errors(rows[key]) if (key := (damping, condition)) in rows else "" for damping in DAMPINGS
                 for condition in conditions]
        radiated = [100 * rows[key]["radiated"] for damping in DAMPINGS for condition in conditions[::-1]
                    if (key := (damping, condition)) in rows and condition != first["conditions"][0]]
        lines.append(start + f"{any_row['unknowns']} | {any_row['wall']:.1f} | " + " | ".join(cells) + " | " +
                     ", ".join(f"{share:.2g}" for share in radiated) + " |")
    return lines


def tables(studies):
    worst = max(row["mismatch"] for study in studies for row in study["rows"])
    lines = ["| sides beyond the toes | from the middle or wall | unknowns | time (s) | 5 %, closed | 5 %, absorbing | "
             "undamped, closed | undamped, absorbing | radiated (%) |", "|---|---:|---:|---:|---|---|---|---|---|"]
    for name in dict.fromkeys(study["name"] for study in studies):
        lines += block([study for study in studies if study["name"] == name])
    return "\n".join(lines) + f"\n\nLargest `energy.mismatch` of all runs: {worst:.0e}.\n"


def draw(studies, path):
    studies = [study for study in studies if study["drawn"]]
    if not studies:
        return
    names = list(dict.fromkeys(study["name"] for study in studies))
    figure, grid = plt.subplots(len(DAMPINGS), len(names), figsize=(3.9 * len(names), 7.4), sharey=True, sharex="col",
                                squeeze=False)
    quantities = (("error_3s", "3 s", "-"), ("error_1s", "1 s", "--"), ("peak_error", "peak", ":"))
    colours = {"roller": "tab:blue", "sealed": "tab:blue", "absorbing": "tab:red"}
    for study in studies:
        ax = grid[list(DAMPINGS).index(study["damping"]), names.index(study["name"])]
        for condition in study["conditions"]:
            name = "absorbing" if condition == "absorbing" else "roller or sealed"
            rows = [row for row in study["rows"] if row["condition"] == condition]
            for key, text, style in quantities:
                ax.loglog([row["distance"] for row in rows], [max(row[key], 1e-9) for row in rows], "o" + style, ms=3.5,
                          color=colours[condition], label=f"{name}, {text}")
        for limit in (1e-3, 5e-3):
            ax.axhline(limit, color="black", lw=0.6)
        ax.set_title(title(study), fontsize="medium")
        ax.grid(alpha=0.3)
        ax.set_ylim(1e-6, 2)
        is_sea = study["unit"] == "depths"
        ticks = (1.5, 2, 3, 4, 6) if is_sea else (0.5, 1, 2, 4, 8)
        ax.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
        ax.xaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())
        ax.tick_params(labelbottom=True)
        if study["damping"] == list(DAMPINGS)[-1]:
            ax.set_xlabel("end of the sea from the wall (depths of 15 m)" if is_sea
                          else "sides from the middle (mound widths of 56 m)")
    for row in grid:
        row[0].set_ylabel("error of $F_T$ over its peak (-)")
    figure.legend(*grid[0, 0].get_legend_handles_labels(), ncols=6, loc="lower center")
    figure.tight_layout(rect=(0, 0.04, 1, 1))
    figure.savefig(path, dpi=100)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path, nargs="?")
    parser.add_argument("--only", type=int, nargs="+", default=range(len(STUDIES)), help="numbers of studies, from 0")
    parser.add_argument("--from", dest="measured", type=pathlib.Path, nargs="+",
                        help="sides.json of earlier runs")
    parser.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("results/sides"))
    arguments = parser.parse_args()
    if (arguments.program is None) == (arguments.measured is None):
        parser.error("give either PROGRAM or --from")
    arguments.output.mkdir(parents=True, exist_ok=True)
    if arguments.measured:
        studies = sum((json.loads(path.read_text()) for path in arguments.measured), [])
        order = [name for name, *_ in STUDIES]
        studies.sort(key=lambda study: order.index(study["name"]))
    else:
        studies = []
        for study in measure(arguments.program, arguments.only):
            studies.append(study)
            (arguments.output / "sides.json").write_text(json.dumps(studies, indent=1))
            print("\n".join(block([study])), flush=True)
    (arguments.output / "sides.md").write_text(tables(studies))
    draw(studies, arguments.output / "sides.png")


if __name__ == "__main__":
    main()
