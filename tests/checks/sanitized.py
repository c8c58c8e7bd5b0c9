#!/usr/bin/python3
"""Runs the test suite of a build with sanitizers and writes the result to docs/reliability/sanitizers.json.

usage: sanitized.py BUILD_FOLDER [LABEL ...]    LABEL: unit, verification, cli (default: all); other rows stay
       sanitized.py BUILD_FOLDER LABEL --again  only tests that failed in the last run, which must be of this label
"""

import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).parent.parent.parent
FACTS = ROOT / "docs/reliability/sanitizers.json"
LABELS = {"unit": "unit tests of all layers, postprocessing", "verification": "exact solutions, identities",
          "cli": "the program as a person meets it"}


def run(build, *which):
    """(tests, failed, skipped, seconds) of some tests; their own output goes to the terminal."""
    command = ["ctest", "--test-dir", build, "--parallel", "2", *which, "--output-on-failure", "--timeout", "3000"]
    text = subprocess.run(command, stdout=subprocess.PIPE, text=True).stdout
    print(text)
    failed, total = map(int, re.search(r"(\d+) tests failed out of (\d+)", text).groups())
    seconds = float(re.search(r"Total Test time \(real\) = +([\d.]+)", text)[1])
    return total, failed, len(re.findall(r"\(Skipped\)", text)), seconds


def known_rows():
    return {row["what"]: row for row in json.loads(FACTS.read_text())["rows"]} if FACTS.exists() else {}


def write(label, tried, came_out):
    """Writes the facts of one label; the facts of the other labels stay."""
    rows = known_rows()
    rows[LABELS[label]] = {"what": LABELS[label], "tried": tried, "came_out": came_out}
    facts = {"title": "Sanitizers", "text": "The test suite built with gcc's address and undefined-behaviour sanitizers, every "
             "report an error, and with the assertions of Eigen and of the standard library. Leaks are not looked for here, as "
             "MPI and HDF5 keep memory until the process ends; valgrind does that.",
             "command": "./bootstrap sanitize", "figure": None,
             "rows": [rows[what] for what in LABELS.values() if what in rows]}
    FACTS.write_text(json.dumps(facts, indent=1) + "\n")
    print(FACTS, flush=True)


def run_label(build, label):
    total, failed, skipped, seconds = run(build, "--label-regex", f"^{label}$")
    write(label, f"{total} tests",
          f"{failed or 'none'} failed{f', {skipped} skipped' if skipped else ''} ({seconds / 60:.0f} min)")
    return failed


def run_again(build, label):
    """Counts the tests that passed at once and those that passed when run again, as after a test was repaired."""
    total, failed, _, _ = run(build, "--rerun-failed")
    before = known_rows()[LABELS[label]]
    write(label, before["tried"], f"{failed or 'none'} failed, {total - failed} of them when run again")
    return failed


def main():
    labels = sys.argv[2:] or list(LABELS)
    if "--again" in labels:
        return run_again(sys.argv[1], labels[0]) > 0
    return sum(run_label(sys.argv[1], label) for label in labels) > 0


if __name__ == "__main__":
    sys.exit(main())
