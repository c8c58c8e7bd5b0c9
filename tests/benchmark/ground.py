#!/usr/bin/python3
"""Contact node by node on a reduced ground against the march of all unknowns: S and the peak of F_T, and what is told.

    /usr/bin/python3 tests/benchmark/ground.py build/upbead named [docs/reference/measured-slip.md]
    /usr/bin/python3 tests/benchmark/ground.py build/upbead random 100 [--seed 1] [-o FILE.jsonl]

`named`: unlike scenes, a row each, between the markers of the page. `random`: scenes until so many are answered by the
reduced ground; prints in how many of these both errors are within what is told, and the share that was marched.
"""
import argparse
import json
import os
import random
import re
import subprocess
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
WEIGHT, FRICTION = 4.296e6, 0.6  # W' (N/m) and mu of the prototype
SLIPS = {"regions.caisson.interface.kind": '"friction"'}
SOLID = 'kind = "solid"\nshear_modulus = 48.970e6\npoissons_ratio = 0.30\ndensity = 2000.0'
UPLIFT = '\n[sliding.uplift]\nkind = "prescribed"\npeak = {}\nshape = "{}"\n'
BEGIN, END = "<!-- measured by tests/benchmark/ground.py -->", "<!-- end -->"


def text_of(case):
    """A shipped case whose files are found from anywhere."""
    path = ROOT / "cases" / case
    return re.sub(r'(history|file) = "', rf'\1 = "{path.parent}/', path.read_text())


PROTOTYPE = re.sub(r"\[probes\..*?(?=\[sliding\])", "", text_of("fig2b-prototype.toml"), flags=re.S)


def with_solid_mound(text):
    return re.sub(r'(\[regions\.mound\].*?\n)kind = "porous".*?(?=\n\[|\ndamping)', rf"\1{SOLID}", text, flags=re.S)


def prototype(factor, text=PROTOTYPE, **more):
    return text, {**SLIPS, "loads.impulse.factor": factor, "time.end": 2, **more}


def named():
    """Title -> (case, keys)."""
    undamped = re.sub(r"damping = .*", "", PROTOTYPE)
    seaward = PROTOTYPE.replace("direction = [1.0, 0.0]", "direction = [-1.0, 0.0]")
    sea = {"regions.caisson.interface": '{ kind = "friction", gap = "sea" }'}
    return {
        "prototype of Fig. 2b, times 5": prototype(5),
        "model of Fig. 2b, times 3": (text_of("fig2b-model.toml"), {**SLIPS, "loads.impulse.factor": 3}),
        "undamped, times 5": prototype(5, undamped),
        "mound of solid, times 5": prototype(5, with_solid_mound(PROTOTYPE)),
        "lift-off to half the base, times 5.5": prototype(5.5),
        "uplift held, times 4": prototype(4, PROTOTYPE + UPLIFT.format("0.6e6", "held")),
        "uplift in phase, times 5": prototype(5, PROTOTYPE + UPLIFT.format("0.6e6", "in_phase")),
        "the sea in gaps, times 5": (PROTOTYPE, {**prototype(5)[1], **sea}),
        "pulled seaward, times 5": prototype(5, seaward),
        "layers, clay under sand": (text_of("gallery/replaced-clay.toml"), {**SLIPS, "loads.wave.factor": 2}),
        "high mound, impulsive": (text_of("gallery/high-mound.toml"), {}),
        "Goda's example": (text_of("gallery/goda.toml"), {}),
        "wide berm": (text_of("gallery/wide-berm.toml"), {**SLIPS, "loads.wave.factor": 2}),
    }


def drawn(dice):
    """A random section: ground, damping, sea, uplift, course and force."""
    log = lambda low, high: low * (high / low) ** dice.random()
    text, duration = PROTOTYPE, log(0.08, 2.0)
    shape = dice.choice(["triangle", "half_sine"])
    pulse = f'pulse = {{ shape = "{shape}", peak = 1.0, duration = {duration:.4g} }}'
    text = re.sub(r'history = ".*impulse.csv"', pulse, text)
    text = re.sub(r"damping = .*", dice.choice(["", "damping = { ratio = 0.02, frequencies = [1, 10] }",
                                               "damping = { ratio = 0.05, frequencies = [1, 10] }",
                                               "damping = { ratio = 0.1, frequencies = [1, 10] }"]), text)
    if dice.random() < 0.25:
        text = with_solid_mound(text)
    if dice.random() < 0.3:
        text += UPLIFT.format(f"{dice.uniform(0.1, 0.25) * WEIGHT:.4g}", dice.choice(["held", "in_phase"]))
    keys = {**SLIPS, "loads.impulse.factor": dice.uniform(0.8, 2.2) * FRICTION * WEIGHT,
            "time.end": min(2.0 * duration + 1.0, 4.0), "sliding.friction": dice.uniform(0.45, 0.7),
            "mesh.parameters.cells": dice.uniform(0.3, 0.5), "mesh.parameters.mound_height": dice.uniform(3, 8),
            "regions.seabed.shear_modulus": log(15e6, 100e6), "regions.mound.shear_modulus": log(25e6, 150e6)}
    if dice.random() < 0.3:
        keys.update({"mesh.parameters.sea_front": 0, "mesh.parameters.sea_back": 0})
    return text, keys


def solve(program, scene, scheme=None):
    text, keys = scene
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "case.toml").write_text(text)
        more = {**keys, **({"time.scheme": f'"{scheme}"'} if scheme else {})}
        command = [program, "run", "case.toml", "--json", "--out", "results"]
        command += [part for key, value in more.items() for part in ("--set", f"{key}={value}")]
        begin = os.times()
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, env={**os.environ, "OMP_NUM_THREADS": "1"})
        end = os.times()
        if not done.stdout.startswith("{"):
            return {"refused": done.stderr.strip()[:300]}
    summary = json.loads(done.stdout)
    summary["cpu"] = end.children_user + end.children_system - begin.children_user - begin.children_system
    return summary


def compared(program, scene):
    """None where nothing slips; the row of a scene."""
    marched = solve(program, scene)
    if "refused" in marched:
        return marched
    whole = (marched.get("contact") or {}).get("solved")
    if not whole:
        return None
    asked = solve(program, scene, "reduced")
    if "refused" in asked:
        return asked
    found = asked["contact"]["solved"]
    row = {"unknowns": marched["discretisation"]["unknowns"], "slip": whole["slip"], "contact": whole["least_contact"],
           "largest_slip": whole["largest_slip"], "peak": marched["response"]["peak_shear"],
           "seconds": [marched["cpu"], asked["cpu"]], "answered": found["ground"] is not None}
    if row["answered"]:
        ground = found["ground"]
        row.update(slip_error=abs(found["slip"] - whole["slip"]), slip_told=ground["slip"],
                   peak_error=abs(asked["response"]["peak_shear"] / row["peak"] - 1), peak_told=ground["peak_shear"])
    else:
        row["why"] = [step["refused"] for step in asked["ladder"] if step["way"] == "contact on a reduced ground"]
    return row


def line(title, row):
    if row is None or "refused" in row:
        return f"| {title} | nothing slips |" if row is None else f"| {title} | refused: {row['refused']} |"
    head = f"| {title} | {row['unknowns']:,} | {row['contact']:.0%} | {1e3 * row['slip']:.2f} | "
    if not row["answered"]:
        return head + f"marched | | | | {row['seconds'][0]:.1f}, {row['seconds'][1]:.1f} |"
    return head + (f"{1e3 * row['slip_error']:.4f} | {1e3 * row['slip_told']:.4f} | {row['peak_error']:.2%} | {row['peak_told']:.2%} | "
                   f"{row['seconds'][0]:.1f}, {row['seconds'][1]:.1f} |")


def run_named(options):
    rows = ["| scene | unknowns | least in contact | S (mm) | error of S (mm) | told | error of the peak | told | seconds marched, reduced |",
            "|---|---:|---:|---:|---:|---:|---:|---:|---:|"]
    for title, scene in named().items():
        rows.append(line(title, compared(options.program, scene)))
        print(rows[-1], flush=True)
    if options.rest:
        page = Path(options.rest)
        before, after = page.read_text().split(BEGIN)[0], page.read_text().split(END)[1]
        page.write_text(before + BEGIN + "\n\n" + "\n".join(rows) + "\n\n" + END + after)


def run_random(options):
    dice, rows, begin = random.Random(options.seed), [], time.monotonic()
    while sum(row["answered"] for row in rows) < int(options.rest) and time.monotonic() - begin < options.seconds:
        row = compared(options.program, drawn(dice))
        if row is None:
            continue
        if "refused" in row:
            print(row["refused"], flush=True)
            continue
        rows.append(row)
        if options.o:
            with open(options.o, "a") as file:
                file.write(json.dumps(row) + "\n")
    told(rows)


def told(rows):
    answered = [row for row in rows if row["answered"]]
    held = [row for row in answered if row["slip_error"] <= row["slip_told"] and row["peak_error"] <= row["peak_told"]]
    worst = max((row["slip_error"] / abs(row["largest_slip"]) for row in answered), default=0.0)
    peak = max((row["peak_error"] for row in answered), default=0.0)
    print(f"{len(rows)} scenes slip, {len(rows) - len(answered)} were marched; of {len(answered)} answered {len(held)} are within "
          f"what is told; S within {worst:.2%} of its largest, peak within {peak:.2%}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=os.path.abspath)
    parser.add_argument("what", choices=["named", "random"])
    parser.add_argument("rest", nargs="?")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=1e9)
    parser.add_argument("-o")
    options = parser.parse_args()
    run_named(options) if options.what == "named" else run_random(options)


if __name__ == "__main__":
    main()
