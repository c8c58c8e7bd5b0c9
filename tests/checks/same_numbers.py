#!/usr/bin/python3
"""Two builds of upbead give the same numbers: every shipped case, study, life, calibration and reduced model by both.

    tests/checks/same_numbers.py BEFORE AFTER [--scratch FOLDER] [--only TEXT]

Compares every number of every summary and every dataset of every HDF5 file, and prints the largest difference of each
over the largest magnitude of the dataset, or of the number. Fails where one is above 1e-13, or where keys differ."""

import argparse
import json
import os
import pathlib
import subprocess
import sys

import h5py
import numpy

ROOT = pathlib.Path(__file__).resolve().parents[2]
CASES = ROOT / "cases"
BOUND = 1e-13
FRICTION = 'regions.caisson.interface.kind="friction"'
# times, which differ from run to run, and versions of the program
IGNORED = ("timing", "versions", "seconds", "time_left", "time")


def jobs():
    """Name, and the command with {out} for the folder that it writes."""
    prototype = CASES / "fig2b-prototype.toml"
    for path in sorted(CASES.rglob("*.toml")):
        text, name = path.read_text(), path.relative_to(CASES).with_suffix("").as_posix().replace("/", "-")
        if "[study]" in text or "[vary" in text:
            yield f"study {name}", ["study", path, "--out", "{out}"]
        elif "[section]" in text and "[mesh]" not in text:
            yield f"waves {name}", ["waves", path, "--json"]
            if "[expected" in text or "[life" in text or "[sea" in text:
                yield f"expected {name}", ["expected", path, "--json", "--out", "{out}"]
            if "[calibration" in text or "[calibrate" in text:
                yield f"calibrate {name}", ["calibrate", path, "--json", "--out", "{out}"]
        elif "[mesh]" in text:
            yield f"run {name}", ["run", path, "--json", "--out", "{out}"]
            yield f"march {name}", ["run", path, "--json", "--out", "{out}", "--set", "time.scheme=sdirk4"]
            yield f"explain {name}", ["explain", path, "--json"]
    yield "reduce", ["reduce", prototype, "--json", "--out", "{out}"]
    model = CASES / "fig2b-model.toml"
    sliding = ["--set", "sliding.submerged_weight=1000"]
    for name, keys in {
        "fields and strength": ["--set", "output.fields.every=0.01"],
        "base": ["--set", "output.base=true"],
        "auto": ["--set", "mesh.refine=auto", "--set", "accuracy.tolerance=0.02"],
        "estimate": ["--set", "accuracy.estimate=true", "--set", "mesh.parameters.cells=0.35"],
        "contact": ["--set", FRICTION, "--set", "mesh.parameters.cells=0.35", "--set", "initial.water_level=0.75"],
        "sliding": sliding,
        "sliding, marched": [*sliding, "--set", "time.scheme=sdirk4"],
        "alpha": ["--set", "time.scheme=generalised_alpha"],
    }.items():
        yield f"run model, {name}", ["run", model, "--json", "--out", "{out}", *keys]


def numbers(value, path=""):
    """All numbers and words of JSON by their paths."""
    if isinstance(value, dict):
        for key, item in value.items():
            if key not in IGNORED:
                yield from numbers(item, f"{path}/{key}")
    elif isinstance(value, list):
        seen = {}
        for i, item in enumerate(value):  # warnings and the like by their names, as their order says nothing
            name = (item.get("name") or item.get("what") or i) if isinstance(item, dict) else i
            seen[name] = seen.get(name, 0) + 1
            yield from numbers(item, f"{path}/{name}" + (f"/{seen[name]}" if seen[name] > 1 else ""))
    else:
        yield path, value


def datasets(folder):
    found = {}
    for path in sorted(folder.rglob("*.h5")):
        with h5py.File(path) as file:
            file.visititems(lambda name, item, of=path: found.__setitem__(
                f"{of.relative_to(folder)}:{name}", item[()]) if isinstance(item, h5py.Dataset) else None)
    for path in sorted(folder.rglob("*.csv")):
        found[str(path.relative_to(folder))] = path.read_text()
    return found


def difference(a, b):
    """Largest difference over the largest magnitude of a; infinite where the two are not of one kind or shape."""
    if isinstance(a, str) or a is None or isinstance(a, (bytes, bool)):
        return 0.0 if a == b else numpy.inf
    a, b = numpy.asarray(a), numpy.asarray(b)
    if a.shape != b.shape or a.dtype.kind not in "fiu":
        return 0.0 if a.shape == b.shape and (a == b).all() else numpy.inf
    if a.size == 0:
        return 0.0
    scale = numpy.abs(a).max()
    apart = numpy.abs(a - b).max()
    return float(apart / scale) if scale > 0 else float(apart)


def answers(program, command, out):
    out.mkdir(parents=True, exist_ok=True)
    words = [str(word).replace("{out}", str(out)) for word in command]
    result = subprocess.run([program, *words], capture_output=True, text=True,
                            env=dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", UPBEAD_MESHES=str(ROOT / "meshes")))
    found = {"exit code": result.returncode} | datasets(out)
    try:
        found |= dict(numbers(json.loads(result.stdout)))
    except json.JSONDecodeError:
        pass
    return found


def at_same_times(key, before, after):
    """Rows of a history after that stand at the times before, where there are more now; else all of them."""
    file, colon, _ = key.partition(":")
    old, new = before.get(f"{file}:history/time"), after.get(f"{file}:history/time")
    if not colon or old is None or new is None or len(old) == len(new) or len(after[key]) != len(new):
        return after[key]
    rows = numpy.searchsorted(new, old - 1e-12 * old[-1])
    return after[key][rows]


def compare(before, after):
    """Number of items compared, the largest difference and its place; the keys that only one of the two has, and those
    whose words differ."""
    worst, where, other = 0.0, "", sorted(before.keys() ^ after.keys())
    for key in sorted(before.keys() & after.keys()):
        if isinstance(before[key], str) and isinstance(after[key], str):
            other += [key] if before[key] != after[key] else []
            continue
        apart = difference(before[key], at_same_times(key, before, after))
        if apart > worst:
            worst, where = apart, key
    return len(before.keys() & after.keys()), worst, where, other


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("before")
    parser.add_argument("after")
    parser.add_argument("--scratch", type=pathlib.Path, default=pathlib.Path("results/same_numbers"))
    parser.add_argument("--only", default="", help="jobs whose name has this text")
    options = parser.parse_args()
    failed = False
    print("| job | numbers and datasets | largest difference | of |\n|---|---:|---:|---|")
    for name, command in jobs():
        if options.only not in name:
            continue
        folder = options.scratch / name.replace(" ", "-").replace(",", "")
        before, after = (answers(program, command, folder / label)
                         for program, label in ((options.before, "before"), (options.after, "after")))
        count, worst, where, only = compare(before, after)
        failed = failed or worst > BOUND or bool(only)
        print(f"| {name} | {count} | {worst:.1e} | {where} |", *only[:5], flush=True)
    return failed


if __name__ == "__main__":
    sys.exit(main())
