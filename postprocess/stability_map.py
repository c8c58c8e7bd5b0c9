#!/usr/bin/python3
"""Draws the scenes and the results of the stability map.

usage: postprocess/stability_map.py SCENES.csv [-o docs/figures/stability.png] [--facts docs/reliability/stability.json]

SCENES.csv is written by build/tests/stability/stability_map --out FOLDER. Every point is a scene; the red line is the
bound that must hold.
"""

import argparse
import csv
import json
import re
from collections import Counter
from pathlib import Path

from common import UserError, save
import numpy as np
from upbead import figures
from upbead.figures.stability import MEASURES, is_answered, measured, size, value


def read(path):
    try:
        with open(path, newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
    except OSError as error:
        raise UserError(f"cannot read '{path}': {error.strerror}") from error
    if not rows or "verdict" not in rows[0]:
        raise UserError(f"'{path}' is no table of stability_map: it has no rows with a verdict")
    return rows


def kind(message):
    """A refusal without names and numbers."""
    message = re.sub(r"'[^']*'", "'...'", message.replace("no way to solve this scene holds:", "").strip())
    message = re.sub(r"\([^)]*\)", "(...)", message)
    return re.sub(r"-?\d[\d.e+-]*", "#", message).split(";")[0][:110]


def count_line(rows):
    verdicts = Counter(r["verdict"] for r in rows)
    possible = len(rows) - verdicts["contradictory"]
    return (f"{verdicts['passed']} hold every bound, {verdicts['contradictory']} contradict themselves, {verdicts['refused']} are "
            f"refused ({100 * verdicts['refused'] / possible:.2f} % of the {possible} others), {verdicts['failed']} fail")


def halving_row(rows):
    marched = [r for r in rows if is_answered(r) and r["solved_by"] != "reduced"]
    at_once = sum(int(r["halvings"]) <= 2 for r in marched)
    most = max(int(r["halvings"]) for r in marched)
    return {"what": "halving the step brings the answer closer", "tried": f"{len(marched)} marched scenes",
            "came_out": f"{at_once} at the first halving, {len(marched) - at_once} only once the steps resolve what the load "
                        f"excites: after at most {most} halvings"}


def facts(rows, command, figure):
    table = [{"what": "scenes", "tried": str(len(rows)), "came_out": count_line(rows)}]
    answered = [r for r in rows if is_answered(r)]
    table.append({"what": "numbers that are not finite, or an inertia that is not as it must be",
                  "tried": f"{len(answered)} answered scenes",
                  "came_out": str(sum(r["finite"] != "1" or r["inertia"] != "0" for r in answered))})
    loose = sum(any(value(r[column]) > bound for column, _, bound in MEASURES[:2]) for r in answered)
    table.append({"what": "answered with the warning balance_loose: forces or energies balance to 1e-4 only",
                  "tried": f"{len(answered)} answered scenes", "came_out": str(loose)})
    for column, label, bound in MEASURES:
        values = np.array([size(r, column) for r in measured(rows, column)])
        table.append({"what": label.replace("\n", " ").replace("$", ""), "tried": f"{len(values)} scenes",
                      "came_out": f"worst {values.max():.1e}, median {np.median(values):.1e}, bound {bound:.0e}"})
    kept = [value(r["kept"]) for r in answered if r["solved_by"] == "generalised_alpha" and r["loads_end"] == "1"]
    table.append({"what": "generalised_alpha: energy stored 400 steps after the loads, over the largest with them",
                  "tried": f"{len(kept)} scenes", "came_out": f"worst {max(kept):.3f}, bound 1.1"})
    table.append(halving_row(rows))
    reasons = Counter(f"{r['verdict']}: {kind(r['why'])}" for r in rows if not is_answered(r))
    for reason, n in reasons.most_common(15):
        table.append({"what": reason, "tried": str(len(rows)), "came_out": str(n)})
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
    parser.add_argument("--facts", type=Path, help="JSON file for docs/reference/reliability.md")
    options = parser.parse_args()
    rows = read(options.scenes)
    if not rows:
        raise UserError(f"'{options.scenes}' has no scenes")
    save(figures.stability(rows), options.output, options.scenes)
    if options.facts:
        command = f"build/tests/stability/stability_map --count {len(rows)} --seed 1 --out map"
        options.facts.write_text(json.dumps(facts(rows, command, options.output.name), indent=2) + "\n")


if __name__ == "__main__":
    main()
