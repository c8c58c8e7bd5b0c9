"""Loads by waves: P and U of Goda's formulas, the history, and the assumptions."""

from .language import as_written, heads, named, say
from .markup import Markup, fold, join, prose, table, tag
from .units import quantity

HEAD = ("load", "H", "T", "alpha*", "p_1", "P", "M_P", "U", "course", "largest P", "rise", "duration", "impulse")


def records(summary):
    """A fold with one row for each load by a wave, and its assumptions; empty if there are none."""
    waves = summary.get("wave_loads") or {}
    rows = [
        (
            as_written(name),
            quantity(wave["height"], "m"),
            quantity(wave["period"], "s"),
            quantity(wave["alpha_star"]),
            quantity(wave["p1"], "Pa"),
            quantity(wave["force"], "N/m"),
            quantity(wave["force_moment"], "N m/m"),
            quantity(wave["uplift"], "N/m"),
            named(wave["course"]),
            quantity(wave["peak"], "N/m"),
            quantity(wave["rise"], "s"),
            quantity(wave["duration"], "s"),
            quantity(wave["impulse"], "N s/m"),
        )
        for name, wave in waves.items()
    ]
    if not rows:
        return Markup("")
    lists = [
        tag("p", as_written(name), prose(": " + "; ".join(wave["assumptions"]) + "."))
        for name, wave in waves.items()
    ]
    return fold(say("Loads by waves"), table(heads(*HEAD), rows, "numbers"), join(lists), open_=True)
