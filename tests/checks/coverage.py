#!/usr/bin/python3
"""Which lines and branches of each layer its unit tests reach: gcc's counts, read by gcovr.

    tests/checks/coverage.py                      the layers without meshes; twenty minutes on two cores
    tests/checks/coverage.py --layers base waves  some layers; the rows of the other layers stay

Built in build-coverage (preset `coverage`). Counted are the lines of a layer's sources and headers that the tests of
that layer alone reach: a call from another layer's test does not test them. The result goes to
docs/reliability/coverage.json."""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = ROOT / "build-coverage"
FACTS = ROOT / "docs" / "reliability" / "coverage.json"
LAYERS = ["base", "input", "model", "material", "waves", "algebra", "dynamics", "sliding", "expected"]
DIVIDED = ["algebra", "dynamics"]  # layers with tests that mpirun starts
ENVIRONMENT = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")


def forget():
    """Removes the counts of earlier runs."""
    for path in BUILD.rglob("*.gcda"):
        path.unlink()


def built(layers, jobs):
    """The test programs; each may take minutes to compile."""
    subprocess.run(["cmake", "--preset", "coverage"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    programs = [f"test_{layer}" for layer in layers] + [f"test_{layer}_divided" for layer in layers if layer in DIVIDED]
    subprocess.run(["cmake", "--build", BUILD, "-j", str(jobs), "--target", *programs], check=True)


def files_reached(layer):
    """gcovr's summary of the files of a layer. Branches that only an exception takes are not counted: every call has one."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "summary.json"
        subprocess.run(["gcovr", "--root", ROOT, "--object-directory", BUILD, "--exclude-throw-branches",
                        "--exclude-unreachable-branches", "--filter", f"{ROOT}/src/{layer}/",
                        "--filter", f"{ROOT}/include/upbead/{layer}/", "--json-summary", path, BUILD / "src" / layer,
                        BUILD / "tests" / layer], check=True)
        return json.loads(path.read_text())["files"]


def row(layer):
    """Runs the tests of a layer and counts."""
    forget()
    test = BUILD / "tests" / layer / f"test_{layer}"
    subprocess.run([test, "--gtest_brief=1"], cwd=test.parent, env=ENVIRONMENT, check=True)
    if layer in DIVIDED:
        subprocess.run(["ctest", "--test-dir", BUILD, "--quiet", "-R", rf"^{layer}\.divided"], check=True)
    files = files_reached(layer)
    lines, reached, branches, taken = (sum(file[key] for file in files) for key in
                                       ("line_total", "line_covered", "branch_total", "branch_covered"))
    least = min(files, key=lambda file: file["line_covered"] - file["line_total"])
    missed = least["line_total"] - least["line_covered"]
    told = f"; most lines not reached: {missed} of {least['filename']}" if missed else ""
    return {"what": layer, "tried": f"{lines} lines, {branches} branches in {len(files)} files",
            "came_out": f"{100 * reached / lines:.1f} % of lines, {100 * taken / max(branches, 1):.1f} % of branches{told}"}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--layers", nargs="+", default=LAYERS)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    built(options.layers, options.jobs)
    rows = {one["what"]: one for one in json.loads(FACTS.read_text())["rows"]} if FACTS.exists() else {}
    for layer in options.layers:
        rows[layer] = row(layer)
        print(f"{layer}: {rows[layer]['tried']}: {rows[layer]['came_out']}", flush=True)
    order = [*(layer for layer in LAYERS if layer in rows), *sorted(set(rows) - set(LAYERS))]
    page = {"title": "Coverage",
            "text": "Lines and branches of each layer that the unit tests of that layer alone reach, by gcc's counts. A branch "
                    "that only an exception takes is not counted, nor is what runs in a confined process, which leaves no "
                    "counts. A line reached is not a line tested: see mutation testing.",
            "command": "tests/checks/coverage.py", "figure": None, "rows": [rows[layer] for layer in order]}
    FACTS.write_text(json.dumps(page, indent=1, ensure_ascii=False) + "\n")


if __name__ == "__main__":
    sys.exit(main())
