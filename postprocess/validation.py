#!/usr/bin/python3
"""Computes what cases/validation predicts and compares it with what was measured: docs/validation.md.

    /usr/bin/python3 postprocess/validation.py build/upbead docs            # some minutes
    /usr/bin/python3 postprocess/validation.py build/upbead docs --check    # a second; solves nothing
    /usr/bin/python3 postprocess/validation.py build/upbead --predict column    # before the measured value is looked at
"""

import argparse
import importlib
import json
import tempfile
from pathlib import Path

from common import UserError, save
from measured import figures, numbers, page
from measured.runs import CASES, rounded


def predict(program, name, folder):
    """A prediction is written once; what comes later is compared with it and does not change it."""
    path = CASES / name / "prediction.json"
    if path.exists():
        raise UserError(f"{path} stands as it was predicted; a new prediction is another folder")
    found = rounded(importlib.import_module(f"measured.{name}").predict(program, folder))
    path.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
    print(path)


def write(program, docs, folder, only):
    path = CASES / "numbers.json"
    kept = json.loads(path.read_text()) if only else {}
    found = kept | rounded(numbers.all_of(program, folder, only), 6)
    path.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
    draw(docs)


def draw(docs):
    said, now = page.predictions(), json.loads((CASES / "numbers.json").read_text())
    (docs / "figures/validation").mkdir(parents=True, exist_ok=True)
    for name, figure in (("column", figures.of_column(said, now)), ("flume", figures.of_flume(said)), ("tornado", figures.of_tornado(now)), ("tornado-more", figures.of_more(now))):
        save(figure, docs / f"figures/validation/{name}.png")
    (docs / "validation.md").write_text(page.page(), encoding="utf-8")
    print(docs / "validation.md")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path, help="the program: build/upbead")
    parser.add_argument("docs", type=Path, nargs="?", default=Path("docs"), help="folder to write to: docs")
    parser.add_argument("--predict", metavar="NAME", help="write the prediction of one folder of cases/validation instead")
    parser.add_argument("--only", metavar="PART", help="compute one part of numbers.json anew, such as beach, and keep the others")
    parser.add_argument("--draw", action="store_true", help="make page and figures of the numbers that are there; solve nothing")
    parser.add_argument("--check", action="store_true", help="write nothing; fail where the page is not that of its numbers")
    arguments = parser.parse_args()
    program = arguments.program.resolve()
    if arguments.check:
        if (arguments.docs / "validation.md").read_text(encoding="utf-8") != page.page():
            raise UserError("docs/validation.md is not that of its numbers; make it anew, without --check")
    elif arguments.draw:
        draw(arguments.docs)
    else:
        with tempfile.TemporaryDirectory() as folder:
            if arguments.predict:
                predict(program, arguments.predict, Path(folder))
            else:
                write(program, arguments.docs, Path(folder), arguments.only)


if __name__ == "__main__":
    main()
