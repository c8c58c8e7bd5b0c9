"""Unit and meaning of a key of summary.json, as the program declares them."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any


@cache
def known(command: str = "run") -> dict[str, list[str]]:
    """{path: [unit, meaning]} of the summary that a command writes; paths in lists are "slips[].start", by names
    "loads.NAME.arm"."""
    declared: dict[str, Any] = json.loads((Path(__file__).parent / "outputs.json").read_text(encoding="utf-8"))
    return dict(declared.get(command, {}))


@cache
def with_names(command: str) -> list[tuple[tuple[str, ...], bool, list[str]]]:
    """[(parts of a path, whether nothing is declared below it, [unit, meaning])] of the paths with names of the case."""
    found = [(tuple(path.replace("[]", "").split(".")), row) for path, row in known(command).items()]
    above = {parts[:-1] for parts, _ in found}
    return [(parts, parts not in above, row) for parts, row in found if any(part.isupper() for part in parts)]


def row(path: str | tuple[str, ...], command: str = "run") -> list[str]:
    """[unit, meaning] of a key; `path` with dots, or its parts."""
    parts = tuple(path.split(".")) if isinstance(path, str) else tuple(path)
    for joined in (".".join(parts), ".".join(parts) + "[]"):
        if joined in known(command):
            return known(command)[joined]
    return next((row for declared, is_last, row in with_names(command) if fits(parts, declared, is_last)), ["", ""])


def fits(parts: tuple[str, ...], declared: tuple[str, ...], is_last: bool) -> bool:
    """Whether a path is a declared one, or lies below the last name that is declared."""
    length = len(parts) == len(declared) or (is_last and declared[-1].isupper() and len(parts) > len(declared))
    return length and all(name.isupper() or name == part for part, name in zip(parts, declared))


def unit(path: str | tuple[str, ...], command: str = "run") -> str:
    """
    >>> unit("response.peak_shear"), unit("loads.impulse.arm"), unit("response.shear_to_force_ratio")
    ('N/m', 'm', '')
    """
    return row(path, command)[0]


def label(path: str | tuple[str, ...], command: str = "run") -> str:
    """The meaning without its second part.

    >>> label("response.peak_displacement")
    'largest displacement x_G landward'
    """
    meaning = row(path, command)[1]
    return min(meaning.partition(": ")[0], meaning.partition("; ")[0], key=len)
