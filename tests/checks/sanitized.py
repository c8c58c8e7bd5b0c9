#!/usr/bin/python3
"""Runs the test suite of a build with sanitizers and writes what came out to docs/reliability/sanitizers.json.

usage: sanitized.py BUILD_FOLDER [LABEL ...]   LABEL: unit, verification, cli (default: all); rows of others stay
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


def run(build, label):
    """(tests, failed, skipped, seconds) of one label; the tests' own output goes to the terminal."""
    command = ["ctest", "--test-dir", build, "--parallel", "2", "--label-regex", f"^{label}$", "--output-on-failure",
               "--timeout", "3000"]
    text = subprocess.run(command, stdout=subprocess.PIPE, text=True).stdout
    print(text)
    failed, total = map(int, re.search(r"(\d+) tests failed out of (\d+)", text).groups())
    seconds = float(re.search(r"Total Test time \(real\) = +([\d.]+)", text)[1])
    return total, failed, len(re.findall(r"\(Skipped\)", text)), seconds


def write(label, found):
    """The facts of one label, beside those of the others that have run before."""
    total, failed, skipped, seconds = found
    known = json.loads(FACTS.read_text())["rows"] if FACTS.exists() else []
    rows = {row["what"]: row for row in known}
    rows[LABELS[label]] = {
        "what": LABELS[label], "tried": f"{total} tests",
        "came_out": f"{failed or 'none'} failed{f', {skipped} skipped' if skipped else ''} ({seconds / 60:.0f} min)"}
    facts = {"title": "Sanitizers", "text": "The test suite built with gcc's address and undefined-behaviour sanitizers, every "
             "report an error, and with the assertions of Eigen and of the standard library. Leaks are not looked for here, as "
             "MPI and HDF5 keep memory until the process ends; valgrind does that.",
             "command": "./bootstrap sanitize", "figure": None,
             "rows": [rows[what] for what in LABELS.values() if what in rows]}
    FACTS.write_text(json.dumps(facts, indent=1) + "\n")
    print(FACTS, flush=True)


def main():
    build, labels = sys.argv[1], sys.argv[2:] or list(LABELS)
    any_failed = False
    for label in labels:
        found = run(build, label)
        write(label, found)
        any_failed = any_failed or found[1] > 0
    return any_failed


if __name__ == "__main__":
    sys.exit(main())
