#!/usr/bin/python3
"""Every case that `upbead explain` accepts, `upbead run` either solves, or refuses with a reason and writes nothing.

Random cases with random mistakes, from a fixed seed, through the real program: exit codes are 0, 1 or 2, a refusal has a
message and leaves no file, an answer has finite numbers only, and nothing takes longer than --longest.
"""

import argparse
import collections
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import time

import h5py
import numpy

from mistakes import with_mistakes

MOST_SOLVES = 20_000  # a case that needs more is valid, but not run


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("upbead", type=pathlib.Path)
    parser.add_argument("stability_map", type=pathlib.Path, help="the program that draws the cases")
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--longest", type=float, default=60, help="seconds that one command may take")
    parser.add_argument("--seconds", type=float, default=float("inf"), help="begin no case after that time")
    parser.add_argument("--keep", type=pathlib.Path, help="folder for the cases that fail")
    parser.add_argument("--facts", type=pathlib.Path, help="write docs/reliability/property.json")
    return parser.parse_args()


class Trial:
    """One case and its outcome."""

    def __init__(self, options, number, folder):
        self.options, self.number, self.folder = options, number, folder
        self.case = folder / "case.toml"
        self.wrong = []

    def write(self):
        drawn = subprocess.run([self.options.stability_map, "--seed", str(1000 + self.options.seed), "--print",
                                str(self.number)], capture_output=True, text=True, check=True).stdout
        draw = random.Random(self.options.seed * 1_000_003 + self.number)
        self.case.write_text(with_mistakes(draw, drawn))

    def call(self, command, *more):
        try:
            return subprocess.run([self.options.upbead, command, self.case, *more], capture_output=True, text=True,
                                  errors="replace", timeout=self.options.longest, cwd=self.folder)
        except subprocess.TimeoutExpired:
            self.wrong.append(f"{command} takes longer than {self.options.longest} s")
            return None

    def check_end(self, command, done):
        if done.returncode not in (0, 1, 2):
            self.wrong.append(f"{command} ends with {done.returncode}: {done.stderr[-300:]}")
        elif done.returncode and len(done.stderr.strip()) < 20:
            self.wrong.append(f"{command} refuses without a reason: {done.stderr!r}")

    def check_answer(self):
        """All files exist and hold finite numbers."""
        out = self.folder / "out"
        text = (out / "summary.json").read_text()
        json.loads(text, parse_constant=lambda word: self.wrong.append(f"summary.json holds {word}"))
        with h5py.File(out / "results.h5") as file:
            def visit(name, item):
                if isinstance(item, h5py.Dataset) and not numpy.isfinite(item[...]).all():
                    self.wrong.append(f"results.h5 holds numbers that are not finite: {name}")
            file.visititems(visit)

    def run(self):
        """Returns the outcome as a short text."""
        self.write()
        explained = self.call("explain")
        if explained is None:
            return "wrong"
        self.check_end("explain", explained)
        solves = re.search(r"about (\d+) solves", explained.stdout)
        if explained.returncode == 0 and solves and int(solves[1]) > MOST_SOLVES:
            return "too long to run"
        if explained.returncode == 1 and self.number % 4:  # most refused cases are not run, to save time
            return "refused by explain" if not self.wrong else "wrong"
        before = sorted(self.folder.rglob("*"))
        done = self.call("run", "--out", "out")
        if done is None:
            return "wrong"
        self.check_end("run", done)
        if done.returncode == 0:
            if explained.returncode:
                self.wrong.append("run accepts what explain refuses")
            self.check_answer()
        elif sorted(self.folder.rglob("*")) != before:
            self.wrong.append("a refused run left files behind")
        if explained.returncode == 1:
            return "refused by explain"
        return ["answered", "refused by run", "numerics refused"][done.returncode] if not self.wrong else "wrong"


def facts(options, ends, wrong):
    accepted = ends["answered"] + ends["refused by run"] + ends["numerics refused"]
    return {
        "title": "Any case that explain accepts",
        "text": "Random case files over the whole range of physics, most with up to three random mistakes (numbers out of "
                "range, wrong kinds, words of other keys, missing or doubled lines, swapped tables, absurd but legal values), "
                "go through `upbead explain` and `upbead run`.",
        "command": f"tests/stability/property_test.py build/upbead build/tests/stability/stability_map --count "
                   f"{options.count} --seed {options.seed}",
        "figure": None,
        "rows": [
            {"what": "cases", "tried": str(options.count),
             "came_out": f"{ends['refused by explain']} refused by explain, {accepted} accepted and run, "
                         f"{ends['too long to run']} accepted but too long to run"},
            {"what": "accepted by explain", "tried": str(accepted),
             "came_out": f"{ends['answered']} answered with finite numbers, {ends['refused by run']} refused by run as input, "
                         f"{ends['numerics refused']} refused because the numerics failed"},
            {"what": "ended otherwise: a crash, exit code 3, a hang, no reason, files left behind", "tried": str(options.count),
             "came_out": str(wrong)},
        ],
    }


def main():
    options = arguments()
    options.upbead, options.stability_map = options.upbead.resolve(), options.stability_map.resolve()
    ends, wrong = collections.Counter(), 0
    begin = time.monotonic()
    for number in range(options.count):
        if time.monotonic() - begin > options.seconds:
            options.count = number
            break
        folder = pathlib.Path(tempfile.mkdtemp())
        try:
            trial = Trial(options, number, folder)
            ends[trial.run()] += 1
            if trial.wrong:
                wrong += 1
                print(f"case {number} of seed {options.seed}:", "; ".join(trial.wrong), flush=True)
                if options.keep:
                    options.keep.mkdir(parents=True, exist_ok=True)
                    shutil.copy(trial.case, options.keep / f"case-{options.seed}-{number}.toml")
        finally:
            shutil.rmtree(folder, ignore_errors=True)
    print(", ".join(f"{n} {end}" for end, n in ends.most_common()))
    if options.facts:
        options.facts.write_text(json.dumps(facts(options, ends, wrong), indent=2) + "\n")
    return wrong > 0


if __name__ == "__main__":
    os.environ.update(OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
    sys.exit(main())
