"""Unit and meaning of a key of summary.json, as the program declares them."""

import json
from functools import cache
from pathlib import Path


@cache
def known(command="run"):
    """{path: [unit, meaning]} of the summary that a command writes; paths in lists are "slips[].start", by names
    "loads.NAME.arm"."""
    return json.loads((Path(__file__).parent / "outputs.json").read_text(encoding="utf-8")).get(command, {})


@cache
def with_names(command):
    """[(parts of a path, whether nothing is declared below it, [unit, meaning])] of the paths with names of the case."""
    found = [(tuple(path.replace("[]", "").split(".")), row) for path, row in known(command).items()]
    above = {parts[:-1] for parts, _ in found}
    return [(parts, parts not in above, row) for parts, row in found if any(part.isupper() for part in parts)]


def row(path, command="run"):
    """[unit, meaning] of a key; `path` with dots, or its parts."""
    parts = tuple(path.split(".")) if isinstance(path, str) else tuple(path)
    for joined in (".".join(parts), ".".join(parts) + "[]"):
        if joined in known(command):
            return known(command)[joined]
    return next((row for declared, is_last, row in with_names(command) if fits(parts, declared, is_last)), ["", ""])


def fits(parts, declared, is_last):
    """Whether a path is a declared one, or lies below the last name that is declared."""
    length = len(parts) == len(declared) or (is_last and declared[-1].isupper() and len(parts) > len(declared))
    return length and all(name.isupper() or name == part for part, name in zip(parts, declared))


def unit(path, command="run"):
    """
    >>> unit("response.peak_shear"), unit("loads.impulse.arm"), unit("response.shear_to_force_ratio")
    ('N/m', 'm', '')
    """
    return row(path, command)[0]


def label(path, command="run"):
    """The meaning without its second part.

    >>> label("response.peak_displacement")
    'largest displacement of the centre of gravity'
    """
    meaning = row(path, command)[1]
    return min(meaning.partition(": ")[0], meaning.partition("; ")[0], key=len)
