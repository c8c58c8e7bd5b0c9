"""The case as its author wrote it: the given keys and their comments.

A comment that begins with one of MARKS, behind a key or behind the head of its table, states the source of the
number:

    shear_modulus = 6.57e6  # calibrated: peak F_T / peak P = 0.75
    [regions.mound]  # assumed

The sentence "All other numbers are assumed" (or another mark) in the comment at the head of the file applies to every
number without a mark.
"""

import re
import tomllib
from dataclasses import dataclass

LARGEST = 10_000_000  # bytes; the limit of the program
MARKS = ("assumed", "calibrated", "measured", "derived")
PATHS = ("history", "gauges", "file")  # values that a run rewrites for its own folder
TABLE = re.compile(r"^\[([^\[\]]+)\]\s*(?:#\s*(.*))?$")
KEY = re.compile(r"^([\w.\"-]+)\s*=\s*(.*)$")
MARK = re.compile(r"^(" + "|".join(MARKS) + r")\b[:,;.]?\s*", re.IGNORECASE)
OTHERS = re.compile(r"\ball other numbers are (" + "|".join(MARKS) + r")\b", re.IGNORECASE)


@dataclass
class SourceCase:
    path: object
    values: dict
    remarks: dict  # {path of a key or table: comment}
    head: str  # the comment above all keys

    def mark(self, path, is_number, is_physical):
        """(mark, remark) of a key; mark is '' if there is none.

        A mark of a table holds for its numbers and files, that of the head for numbers that are physical quantities.
        """
        remark = self.remarks.get(path, "")
        marks_its_table = is_number or path[-1] in PATHS
        for length in range(len(path), 0 if marks_its_table else len(path) - 1, -1):
            comment = self.remarks.get(path[:length], "")
            marked = MARK.match(comment)
            if marked:
                return marked[1].lower(), comment[marked.end() :] if length == len(path) else remark
        others = OTHERS.search(" ".join(self.head.split()))
        return others[1].lower() if others and is_number and is_physical else "", remark

    def value(self, path):
        """What the author wrote at a path, or None."""
        found = self.values
        for part in path:
            found = found.get(part) if isinstance(found, dict) else None
        return found


def comment_of(rest):
    """The comment behind a value: what follows the first # outside quotes."""
    quote = ""
    for place, sign in enumerate(rest):
        if quote:
            quote = "" if sign == quote else quote
        elif sign in "\"'":
            quote = sign
        elif sign == "#":
            return rest[place + 1 :].strip()
    return ""


def parts(name):
    return tuple(part.strip().strip('"') for part in name.split("."))


def read(path):
    """The SourceCase of a file; raises ValueError or OSError if it is no TOML or no case."""
    if path.exists() and not path.is_file():
        raise ValueError("it is no file")  # reading a pipe could wait for ever
    if path.stat().st_size > LARGEST:
        raise ValueError(f"it holds more than {LARGEST // 1000000} MB")
    text = path.read_text(encoding="utf-8")
    remarks, table, head = {}, (), []
    begun = False
    for line in text.splitlines():
        stripped = line.strip()
        opened, key = TABLE.match(stripped), KEY.match(stripped)
        begun = begun or bool(opened or key)
        if opened:
            table = parts(opened[1])
            remarks[table] = opened[2] or ""
        elif key:
            remarks[table + parts(key[1])] = comment_of(key[2])
        elif not begun and line.startswith("#"):
            head.append(line.lstrip("# ").rstrip())
    try:
        return SourceCase(path, tomllib.loads(text), remarks, "\n".join(head))
    except RecursionError as error:
        raise ValueError("it is nested too deeply") from error


def units(path):
    """{path of a key: its unit}, from the comments that the program writes behind the values of case.toml."""
    remarks = read(path).remarks if path.is_file() else {}
    return {key: remark for key, remark in remarks.items() if remark}


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
