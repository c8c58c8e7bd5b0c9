"""Unit and meaning of a key of summary.json, as the program declares them."""

import json
from functools import cache
from pathlib import Path

NAMED = ("loads", "gauges", "wave_loads", "measured")  # tables whose keys are names of the case


@cache
def known(command="run"):
    """{path: [unit, meaning]} of the summary that a command writes; paths in lists are "slips[].start", by names
    "loads.NAME.arm"."""
    return json.loads((Path(__file__).parent / "outputs.json").read_text(encoding="utf-8"))[command]


def row(path, command="run"):
    first, *_, last = path.split(".")
    return known(command).get(path) or known(command).get(f"{first}.NAME.{last}" if first in NAMED else "", ["", ""])


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
