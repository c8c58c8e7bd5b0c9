#!/usr/bin/python3
"""Random scenes of stability_map whose soils yield by random laws and strengths: each is solved with finite numbers,
or refused with a reason (exit code 1 or 2); no run ends otherwise.

usage: random_laws.py UPBEAD STABILITY_MAP [--count N] [--seed S] [--longest SECONDS]
"""

import argparse
import collections
import json
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile

SECTION = pathlib.Path(__file__).resolve().parent / "section.geo"


def law(dice):
    name = dice.choice(["hysteretic", "mohr_coulomb"])
    angle = dice.uniform(0, 45)
    cohesion = dice.choice([0, 10 ** dice.uniform(0, 6)])
    strength = f"strength = {{ friction_angle = {angle:.3g}, cohesion = {cohesion:.3g}"
    if name == "mohr_coulomb":
        strength += f", dilatancy_angle = {dice.choice([0, dice.uniform(0, angle)]):.3g}"
    return f'law = "{name}"\n{strength} }}\n'


def with_laws(text, dice):
    """The text with laws for soils without a law, and with a still-water level."""
    parts = re.split(r"(?m)^(?=\[)", text)
    for i, part in enumerate(parts):
        if re.match(r"\[regions\.\w+\]\n", part) and re.search(r'kind = "(porous|solid)"', part) and "law =" not in part:
            head, body = part.split("\n", 1)
            parts[i] = f"{head}\n{law(dice)}{re.sub(r'(?m)^strength = .*$', '', body)}"
    text = "".join(parts)
    return text if "[initial]" in text else text.rstrip("\n") + "\n\n[initial]\nwater_level = 0.0\n"


def numbers(value):
    if isinstance(value, dict):
        for inner in value.values():
            yield from numbers(inner)
    elif isinstance(value, list):
        for inner in value:
            yield from numbers(inner)
    elif isinstance(value, float):
        yield value


def verdict(program, case, longest):
    try:
        done = subprocess.run([program, "run", case, "--json", "--out", case.parent / "out"], capture_output=True, text=True, timeout=longest)
    except subprocess.TimeoutExpired:
        return "too long"
    if done.returncode == 0:
        bad = [n for n in numbers(json.loads(done.stdout)) if not math.isfinite(n)]
        return "failed: a number that is not finite" if bad else "passed"
    if done.returncode in (1, 2) and done.stderr.strip():
        return "contradictory" if done.returncode == 1 else "refused"
    return f"failed: exit code {done.returncode}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("stability_map", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--longest", type=float, default=60.0)
    arguments = parser.parse_args()
    found = collections.Counter()
    for number in range(arguments.count):
        drawn = subprocess.run([arguments.stability_map, "--seed", str(arguments.seed), "--print", str(number), "--section", SECTION],
                               capture_output=True, text=True, check=True).stdout
        with tempfile.TemporaryDirectory() as folder:
            case = pathlib.Path(folder) / "case.toml"
            case.write_text(with_laws(drawn, random.Random(f"{arguments.seed} {number}")))
            told = verdict(arguments.program.resolve(), case, arguments.longest)
        found[told.split(":")[0]] += 1
        if told.startswith("failed"):
            print(f"scene {number} of seed {arguments.seed} {told}", flush=True)
    print(", ".join(f"{n} {kind}" for kind, n in found.most_common()))
    return 1 if found["failed"] else 0


if __name__ == "__main__":
    sys.exit(main())
