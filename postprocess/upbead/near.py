"""Which name somebody meant."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Mapping

MOST = 3


def nearest(name: str, known: Mapping[str, str] | Iterable[str]) -> list[str]:
    """Names like this one, or whose meaning begins with it: F_T of "F_T, shear force at the bottom".

    >>> nearest("F_T", {"force": "P, wave force", "shear_force": "F_T, shear force at the bottom"})
    ['shear_force']
    >>> nearest("shear", ["force", "shear_force", "caisson/displacement_x"]), nearest("displacment_x", ["caisson/displacement_x"])
    (['shear_force'], ['caisson/displacement_x'])
    >>> nearest("zzz", ["force"])
    []
    """
    meanings = dict(known) if isinstance(known, Mapping) else dict.fromkeys(known, "")
    short = name.strip("/").removeprefix("history/")
    by_symbol = [one for one, meaning in meanings.items() if meaning.partition(",")[0].strip() == short]
    by_part = [one for one in meanings if short and short.lower() in one.lower()]
    by_word = [one for one in meanings if short and any(short.lower() == word.strip(".,;:()").lower() for word in meanings[one].split())]
    last = {one.rpartition("/")[2].rpartition(".")[2]: one for one in reversed(list(meanings))}
    alike = difflib.get_close_matches(short, list(meanings), MOST, 0.6)
    alike += [last[part] for part in difflib.get_close_matches(short.rpartition("/")[2].rpartition(".")[2], list(last), MOST, 0.7)]
    return list(dict.fromkeys(by_symbol or [*alike, *by_part, *by_word]))[:MOST]


def hint(name: str, known: Mapping[str, str] | Iterable[str]) -> str:
    """The end of a message.

    >>> hint("shear", ["shear_force"]), hint("zzz", ["force"]), hint("zzz", [])
    ('; did you mean shear_force?', '; there are: force', '')
    """
    names = list(known)
    found = nearest(name, known)
    if found:
        return f"; did you mean {' or '.join(found)}?"
    few = ", ".join(names[:8]) + (f" and {len(names) - 8} more" if len(names) > 8 else "")
    return f"; there are: {few}" if names else ""
