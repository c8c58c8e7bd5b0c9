#!/usr/bin/python3
"""Computes what cases/validation predicts and compares it with what was measured: docs/validation.md.

    /usr/bin/python3 postprocess/validation.py build/upbead docs
    /usr/bin/python3 postprocess/validation.py build/upbead --predict column    # before the measured value is looked at
"""

import argparse
import importlib
import json
import tempfile
from pathlib import Path

from measured.runs import CASES, rounded


def predict(program, name, folder):
    """A prediction is written once; what comes later is compared with it and does not change it."""
    found = rounded(importlib.import_module(f"measured.{name}").predict(program, folder))
    path = CASES / name / "prediction.json"
    path.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
    print(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path, help="the program: build/upbead")
    parser.add_argument("docs", type=Path, nargs="?", help="folder to write to: docs")
    parser.add_argument("--predict", metavar="NAME", help="write the prediction of one folder of cases/validation instead")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        predict(arguments.program.resolve(), arguments.predict, Path(folder))


if __name__ == "__main__":
    main()
