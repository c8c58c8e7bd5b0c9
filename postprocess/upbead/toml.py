"""Python's values as TOML."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from .errors import UserError

BARE = re.compile(r"^[A-Za-z0-9_-]+$")
CONTROL = re.compile("[\x00-\x1f\x7f]")


def toml_value(value: Any) -> str:
    """A value as TOML, for --set and for files.

    >>> toml_value("friction"), toml_value(True), toml_value(5e6), toml_value([[0, 1.0]]), toml_value({"ratio": 0.05})
    ('"friction"', 'true', '5000000.0', '[[0, 1.0]]', '{"ratio" = 0.05}')
    """
    if hasattr(value, "tolist"):  # numpy
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int) and abs(value) >= 2**63:  # TOML's integers have 64 bits
        return repr(float(value))
    if isinstance(value, (int, float)):
        return repr(value)  # inf and nan are the same words in TOML
    if isinstance(value, (str, Path)):
        escaped = str(value).replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n")
        return '"' + CONTROL.sub(lambda found: "\\u%04X" % ord(found.group()), escaped) + '"'
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{toml_value(str(key))} = {toml_value(v)}" for key, v in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(toml_value, value)) + "]"
    raise UserError(f"{value!r} has no form in TOML; use numbers, words, True, False, lists and dicts")


def toml_key(key: str) -> str:
    """
    >>> toml_key("mesh"), toml_key("regions.seabed.porosity")
    ('mesh', '"regions.seabed.porosity"')
    """
    return key if BARE.match(key) else toml_value(key)


def toml_text(values: Mapping[str, Any], above: tuple[str, ...] = ()) -> str:
    """A file: the values of each table first, then the tables in it; None is left out.

    >>> print(toml_text({"title": "A", "mesh": {"degree": 2, "parameters": {"cells": 0.4}}}))
    title = "A"
    [mesh]
    degree = 2
    [mesh.parameters]
    cells = 0.4
    <BLANKLINE>
    """
    inside = {str(key): value for key, value in values.items() if isinstance(value, Mapping)}
    lines = [f"[{'.'.join(map(toml_key, above))}]\n"] if above else []
    for key, value in values.items():
        if value is None or str(key) in inside:
            continue
        try:
            lines.append(f"{toml_key(str(key))} = {toml_value(value)}\n")
        except UserError as error:
            raise UserError(f"{'.'.join((*above, str(key)))}: {error}") from error
    return "".join(lines) + "".join(toml_text(value, (*above, key)) for key, value in inside.items())
