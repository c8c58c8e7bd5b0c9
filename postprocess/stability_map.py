#!/usr/bin/python3
"""Draws what the stability map has swept and found.

usage: postprocess/stability_map.py SCENES.csv [-o docs/figures/stability.png] [--facts docs/reliability/stability.json]

SCENES.csv is written by build/tests/stability/stability_map --out FOLDER. Every point is a scene; the red line is what
must hold.
"""

import argparse
import csv
import json
import re
from collections import Counter
from pathlib import Path

import numpy as np

from common import UserError, plt, run, save

LEAST = 1e-18  # what is smaller is drawn here
MEASURES = [  # column, label, bound
    ("reaction", "both routes to $F_T$", 1e-7),
    ("energy", "energy account", 1e-6),
    ("growth", "energy gained\nwithout work", 1e-9),
    ("residual", "residual of a solve", 1e-10),
]
PARAMETERS = [  # values of a row, label
    (lambda r: value(r["k_min"]), "least $k$ (m/s)"),
    (lambda r: value(r["G_max"]) / value(r["G_min"]), "contrast of $G$"),
    (lambda r: min(value(r["K_f"]), 1e13), "$K_f$ (Pa; right: infinite)"),
    (lambda r: 0.5 - value(r["nu_max"]), r"$0.5 - \nu$"),
    (lambda r: value(r["step"]), "step (s)"),
    (lambda r: value(r["aspect"]), "aspect of cells"),
]


def size(row, column):
    """A measure; of the energy gained what is more than the account's own noise at both ends of a step."""
    size = value(row[column])
    return max(size - 2 * value(row["noise"]), 0.0) if column == "growth" else size


def value(text):
    return float(text) if text else float("nan")


def read(path):
    try:
        with open(path, newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))
    except OSError as error:
        raise UserError(f"cannot read '{path}': {error.strerror}") from error


def measured(rows, column):
    """The answered scenes that have the measure. generalised_alpha has a bound of its own on energy."""
    answered = [r for r in rows if r["verdict"] != "refused" and value(r[column]) == value(r[column])]
    if column == "reaction":
        answered = [r for r in answered if "caisson" in r["reading"] or r["reading"] in ("shear_force", "normal_force")]
    if column in ("energy", "growth"):
        answered = [r for r in answered if r["solved_by"] != "reduced"]
    if column == "growth":
        answered = [r for r in answered if r["loads_end"] == "1" and r["solved_by"] != "generalised_alpha"]
    return answered


def draw(rows, path):
    figure, axes = plt.subplots(len(MEASURES), len(PARAMETERS), figsize=(13, 8.2), sharex="col", sharey="row")
    for i, (column, label, bound) in enumerate(MEASURES):
        answered = measured(rows, column)
        values = [max(size(r, column), LEAST) for r in answered]
        for j, (parameter, name) in enumerate(PARAMETERS):
            ax = axes[i, j]
            ax.scatter([parameter(r) for r in answered], values, s=2, alpha=0.35, linewidths=0, rasterized=True)
            ax.axhline(bound, color="tab:red", linewidth=1)
            ax.set(xscale="log", yscale="log", ylim=(LEAST / 3, 1e-4))
            if i + 1 == len(MEASURES):
                ax.set_xlabel(name)
        axes[i, 0].set_ylabel(label)
        axes[i, -1].text(1.03, 0.5, f"{len(answered)} scenes\nworst {max(values):.1e}\nbound {bound:.0e}",
                         transform=axes[i, -1].transAxes, va="center")
    verdicts = Counter(r["verdict"] for r in rows)
    figure.suptitle(f"{len(rows)} random scenes: {verdicts['passed']} hold every bound, {verdicts['refused']} are refused "
                    f"with a reason, {verdicts['failed']} fail", y=0.94)
    figure.subplots_adjust(hspace=0.12, wspace=0.1)
    save(figure, path)


def kind(message):
    """A refusal without names and numbers."""
    message = re.sub(r"'[^']*'", "'...'", message.replace("numerics: ", ""))
    message = re.sub(r"\([^)]*\)", "(...)", message)
    return re.sub(r"-?\d[\d.e+-]*", "#", message).split(";")[0][:110]


def count_line(rows):
    refused = Counter("input" if not r["why"].startswith("numerics") else "numerics" for r in rows if r["verdict"] == "refused")
    verdicts = Counter(r["verdict"] for r in rows)
    return (f"{verdicts['passed']} hold every bound, {refused['input']} refused as contradictory input, {refused['numerics']} "
            f"refused because the numerics cannot do them, {verdicts['failed']} fail")


def halving_row(rows):
    marched = [r for r in rows if r["verdict"] != "refused" and r["solved_by"] != "reduced"]
    at_once = sum(int(r["halvings"]) <= 2 for r in marched)
    most = max(int(r["halvings"]) for r in marched)
    return {"what": "halving the step brings the answer closer", "tried": f"{len(marched)} marched scenes",
            "came_out": f"{at_once} at the first halving, {len(marched) - at_once} only once the steps resolve what the load "
                        f"excites: after at most {most} halvings"}


def facts(rows, command, figure):
    table = [{"what": "scenes", "tried": str(len(rows)), "came_out": count_line(rows)}]
    answered = [r for r in rows if r["verdict"] != "refused"]
    table.append({"what": "numbers that are not finite, or an inertia that is not as it must be",
                  "tried": f"{len(answered)} answered scenes",
                  "came_out": str(sum(r["finite"] != "1" or r["inertia"] != "0" for r in answered))})
    for column, label, bound in MEASURES:
        values = np.array([size(r, column) for r in measured(rows, column)])
        table.append({"what": label.replace("\n", " ").replace("$", ""), "tried": f"{len(values)} scenes",
                      "came_out": f"worst {values.max():.1e}, median {np.median(values):.1e}, bound {bound:.0e}"})
    kept = [value(r["kept"]) for r in answered if r["solved_by"] == "generalised_alpha" and r["loads_end"] == "1"]
    table.append({"what": "generalised_alpha: energy stored 400 steps after the loads, over the largest with them",
                  "tried": f"{len(kept)} scenes", "came_out": f"worst {max(kept):.3f}, bound 1.1"})
    table.append(halving_row(rows))
    reasons = Counter(kind(r["why"]) for r in rows if r["verdict"] == "refused")
    for reason, n in reasons.most_common(12):
        table.append({"what": "refused: " + reason, "tried": str(len(rows)), "came_out": str(n)})
    return {"title": "Stability map",
            "text": "Random small scenes over the whole range of physics: k 1e-10 to 1e3 m/s, G 1e4 to 1e11 Pa with contrasts to "
                    "1e6, K_f 1e5 Pa to infinity, nu 0 to 0.4999, steps 1e-7 to 10 s, pulses from 1 ms to static, bent cells "
                    "and cells 100 times as long as high, water 0.1 to 50 m deep, every kind of region, flow, boundary, load "
                    "and scheme, friction under the caisson. What is not refused must hold every bound.",
            "command": command, "figure": figure, "rows": table}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", type=Path)
    parser.add_argument("-o", "--output", type=Path, default=Path("docs/figures/stability.png"))
    parser.add_argument("--facts", type=Path, help="JSON file for docs/reliability.md")
    options = parser.parse_args()
    rows = read(options.scenes)
    if not rows:
        raise UserError(f"'{options.scenes}' has no scenes")
    draw(rows, options.output)
    if options.facts:
        command = f"build/tests/stability/stability_map --count {len(rows)} --seed 1 --out map"
        options.facts.write_text(json.dumps(facts(rows, command, options.output.name), indent=2) + "\n")


if __name__ == "__main__":
    run(main)
