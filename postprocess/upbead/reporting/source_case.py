"""The case as its author wrote it: the given keys and their comments.

A comment with one of MARKS, behind a key or above it, or with the head of its table, states the source of the number:

    shear_modulus = 6.57e6  # calibrated: peak F_T / peak P = 0.75
    [regions.mound]  # rubble, assumed

The sentence "All other numbers are assumed" (or another mark) in the comment at the head of the file applies to every
number without a mark. Which words say so: remarks.py.
"""

import tomllib
from dataclasses import dataclass

from . import remarks

LARGEST = 10_000_000  # bytes; the limit of the program
MARKS = tuple(remarks.WORDS)
PATHS = ("history", "gauges", "file", "states", "model")  # values that a run rewrites for its own folder
# What `upbead new` tells the author: nothing of it is for a client
TEMPLATE = ("Complete it in an editor that reads TOML", "Written from a few numbers. What is marked")


@dataclass
class SourceCase:
    path: object
    values: dict
    remarks: dict  # {path of a key or table: comment}
    head: str  # the comment above all keys

    def mark(self, path, is_number, is_physical):
        """(mark, remark) of a key; mark is '' if there is none.

        A mark of a table holds for its numbers and files, that of the head for numbers that are physical quantities.
        Of numbers that are none a word within the comment says nothing: "estimated error" of a tolerance.
        """
        remark = self.remarks.get(path, "")
        marks_its_table = is_number or path[-1] in PATHS
        for length in range(len(path), 0 if marks_its_table else len(path) - 1, -1):
            mark, rest = remarks.marked(self.remarks.get(path[:length], ""), is_physical)
            if mark:
                return mark, rest if length == len(path) else remark
        return remarks.of_the_rest(self.head) if is_number and is_physical else "", remark

    def value(self, path):
        """What the author wrote at a path, or None."""
        found = self.values
        for part in path:
            found = found.get(part) if isinstance(found, dict) else None
        return found


def read(path):
    """The SourceCase of a file; raises ValueError or OSError if it is no TOML or no case."""
    if path.exists() and not path.is_file():
        raise ValueError("it is no file")  # reading a pipe could wait for ever
    if path.stat().st_size > LARGEST:
        raise ValueError(f"it holds more than {LARGEST // 1000000} MB")
    text = path.read_text(encoding="utf-8-sig")
    try:
        values = tomllib.loads(text)
    except RecursionError as error:
        raise ValueError("it is nested too deeply") from error
    found, head = remarks.read(text)
    return SourceCase(path, values, found, "\n".join(line for line in head.split("\n") if not line.startswith(TEMPLATE)))


def shown(path):
    """The text of a case for a client: without lines for editors, and without those of the template."""
    text = path.read_text(encoding="utf-8-sig")
    lines = [line for line in text.splitlines() if not line.startswith("#:") and not line.lstrip("# ").startswith(TEMPLATE)]
    return "\n".join(lines).strip("\n") + "\n"


def units(path):
    """{path of a key: its unit}, from the comments that the program writes behind the values of case.toml."""
    found = remarks.read(path.read_text(encoding="utf-8"), behind_only=True)[0] if path.is_file() else {}
    return {key: remark for key, remark in found.items() if remark}


def find(case, folder):
    """The author's file of a run, by its title: beside the files that the case names, or else near the results.

    Of several files, the one whose values agree best with those of the run. None if no file has the title, or if two
    that differ agree equally well.
    """
    named = [load.get(key) for load in case.get("loads", {}).values() for key in ("history", "gauges")]
    named += [record.get("file") for record in case.get("measured", {}).values()]
    named.append(case.get("mesh", {}).get("file"))
    beside = {(folder / name).resolve().parent for name in named if name}
    beside |= {inner for place in beside if place.is_dir() for inner in place.iterdir() if inner.is_dir()}
    near = {place for parent in folder.resolve().parents[:2] for place in (parent, parent / "cases")}
    near |= {inner for parent in folder.resolve().parents[:2] for inner in folders(parent / "cases")}
    for places in (beside, near):
        found = sorted(candidates(case, places), key=lambda source: agreement(source.values, case), reverse=True)
        best = [source for source in found if agreement(source.values, case) == agreement(found[0].values, case)]
        if found:
            return best[0] if all(source.values == best[0].values for source in best) else None
    return None


def folders(place):
    return [inner for inner in place.iterdir() if inner.is_dir()] if place.is_dir() else []


def candidates(case, folders):
    """The cases in the folders that have the title of a run; files that a run wrote beside its results are left
    out."""
    for path in sorted(path for folder in folders if folder.is_dir() for path in folder.glob("*.toml")):
        try:
            source = read(path)
        except (OSError, ValueError):
            continue
        of_a_run = path.name == "case.toml" and (path.parent / "summary.json").exists()
        if case.get("title") and source.values.get("title") == case["title"] and not of_a_run:
            yield source


def agreement(written, run):
    """Number of equal values less that of different ones; paths, which are rewritten for a run, do not count."""
    score = 0
    for key, value in written.items():
        if isinstance(value, dict):
            score += agreement(value, run[key]) if isinstance(run.get(key), dict) else -1
        elif key not in PATHS:
            score += 1 if run.get(key) == value else -1
    return score
