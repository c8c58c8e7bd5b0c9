"""Writes docs/reference/datasets.md: every dataset of results.h5, reduced.h5 and responses.h5 with its unit and description, as runs
of some shipped cases have them.

    /usr/bin/python3 postprocess/dataset_tables.py build/upbead docs             # half a minute
    /usr/bin/python3 postprocess/dataset_tables.py build/upbead docs --check     # writes nothing
"""

import argparse
import re
import subprocess
import tempfile
from pathlib import Path

import h5py
from common import UserError
from pages.reference import from_reference

CASES = Path(__file__).resolve().parent.parent / "cases"
COARSE = {"mesh.parameters.cells": "0.4"}
BONDED = {**COARSE, "loads.impulse.factor": "5", "output.base": "true", "output.times": "[0.1, 0.2]", "output.every": "0.05", "output.fields": "{ every = 0.5 }"}
TIED = {**COARSE, "loads.impulse.factor": "5", "regions.caisson.interface.kind": '"friction"'}
SOILS = {**COARSE, "regions.mound.strength": "{ friction_angle = 40, cohesion = 2e4 }", "regions.seabed.strength": "{ friction_angle = 35 }",
         "initial.water_level": "15", "regions.seabed.cyclic": "{ relative_density = 0.6 }", "cycles": "{ number = [100], period = [10] }"}
RUNS = [BONDED, TIED, SOILS]
HEAD = """# Datasets

For those who read files by a program: what each HDF5 file holds, as the program describes it in the attributes `unit` and `description`. Made by
`postprocess/dataset_tables.py build/upbead docs`. [What a run writes](../output.md) says what rows and steps mean. A dataset is there where the case asks for
what it holds; `/at_times/...` and `/dense/...` are as `/history/...`.

"""
NAMES = [(re.compile(r"/probes/[^/]+/"), "/probes/NAME/")]


def call(program, *arguments):
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, check=False)
    if done.returncode:
        raise UserError(f"upbead {' '.join(map(str, arguments))}\n{done.stderr}")


def rows(path, at):
    """{name: (unit, description)}; `at`: what the name of the file's own group of waves is replaced by."""
    found = {}

    def take(name, item):
        if not isinstance(item, h5py.Dataset) or name.startswith(("at_times/", "dense/")):
            return
        name = f"/{name}"
        for pattern, text in NAMES:
            name = pattern.sub(text, name)
        name = re.sub(r"^/fig2b-prototype-impulse/", at, name)
        text = {key: item.attrs[key].decode() if isinstance(item.attrs[key], bytes) else str(item.attrs[key]) for key in ("unit", "description") if key in item.attrs}
        text["description"] = re.sub(r"at most [0-9.]+ %", "at most the tolerance", text.get("description", ""))
        found.setdefault(name, (text.get("unit", ""), text["description"]))

    with h5py.File(path) as file:
        file.visititems(take)
    return found


def attributes(path):
    lines = []

    def take(name, item):
        if isinstance(item, h5py.Group) and len(item.attrs):
            lines.append(f"| `/{name}` | {', '.join(f'`{key}`' for key in item.attrs)} |")

    with h5py.File(path) as file:
        lines.append(f"| `/` | {', '.join(f'`{key}`' for key in file.attrs)} |")
        file.visititems(take)
    return ["", "| attributes of | |", "|---|---|", *lines]


def table(found):
    lines = ["| dataset | unit | description |", "|---|---|---|"]
    return lines + [f"| `{name}` | {unit} | {text.replace('|', chr(92) + '|')} |" for name, (unit, text) in sorted(found.items()) if text]


def page(program):
    with tempfile.TemporaryDirectory() as temporary:
        folder, results = Path(temporary), {}
        for n, keys in enumerate(RUNS):
            settings = [word for key, value in keys.items() for word in ("--set", f"{key}={value}")]
            call(program, "run", CASES / "fig2b-prototype.toml", *settings, "--out", folder / str(n))
            results = {**rows(folder / str(n) / "results.h5", ""), **results}
        soils = [word for key, value in SOILS.items() for word in ("--set", f"{key}={value}") if key != "cycles"]
        call(program, "reduce", CASES / "fig2b-prototype.toml", *soils, "--out", folder / "model")
        call(program, "respond", folder / "model/reduced.h5", CASES / "fig2b-prototype-impulse.csv", "--out", folder / "answer")
        model, answer = rows(folder / "model/reduced.h5", ""), rows(folder / "answer/responses.h5", "/FILE/")
        lines = ["## results.h5", "", *table(results), "", "## reduced.h5", "", *table(model), *attributes(folder / "model/reduced.h5"),
                 "", "## responses.h5", "", *table(answer)]
    return HEAD + from_reference("\n".join(lines)) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("program", type=Path, help="the program, such as build/upbead")
    parser.add_argument("docs", type=Path, help="folder of the pages: docs")
    parser.add_argument("--check", action="store_true", help="write nothing; fail where the page is not current")
    arguments = parser.parse_args()
    path, text = arguments.docs / "reference/datasets.md", page(arguments.program)
    if not arguments.check:
        path.write_text(text, encoding="utf-8")
        print(path)
    elif path.read_text(encoding="utf-8") != text:
        raise UserError(f"'{path}' is not what the program writes; make it anew, without --check")


if __name__ == "__main__":
    main()
