#!/usr/bin/python3
"""Runs the test suite of a build with sanitizers and writes what came out to docs/reliability/sanitizers.json.

usage: sanitized.py BUILD_FOLDER
"""

import collections
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).parent.parent.parent
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


def write(found):
    """The facts of all labels that have run."""
    rows = [{"what": LABELS[label], "tried": f"{total} tests",
             "came_out": f"{failed or 'none'} failed{f', {skipped} skipped' if skipped else ''} ({seconds / 60:.0f} min)"}
            for label, (total, failed, skipped, seconds) in found.items()]
    facts = {"title": "Sanitizers", "text": "The test suite built with gcc's address and undefined-behaviour sanitizers, every "
             "report an error, and with the assertions of Eigen and of the standard library. Leaks are not looked for here, as "
             "MPI and HDF5 keep memory until the process ends; valgrind does that.",
             "command": "./bootstrap sanitize", "figure": None, "rows": rows}
    path = ROOT / "docs/reliability/sanitizers.json"
    path.write_text(json.dumps(facts, indent=1) + "\n")
    print(path, flush=True)


def main():
    build, found = sys.argv[1], collections.OrderedDict()
    for label in LABELS:
        found[label] = run(build, label)
        write(found)
    return any(failed for _, failed, _, _ in found.values())


if __name__ == "__main__":
    sys.exit(main())
