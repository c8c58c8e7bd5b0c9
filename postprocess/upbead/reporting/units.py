"""Numbers for readers: four digits, a prefix that suits the size, and the exact value as an attribute."""

import math

from .language import say
from .markup import Markup, tag

# From 10,000 on the next prefix is used where results are compared at a glance: P = 1,600 kN/m and F_T = 634.6 kN/m.
PREFIXES = [(1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, "")]
PREFIXED = ("N/m", "Pa", "N m/m", "N s/m", "J/m", "N/m2", "N", "N m")
SMALL = {"m": (1.0, 1e3, "mm"), "rad": (1.0, 1e3, "mrad")}  # below: factor, name


def scale(unit, peak, room=1.0):
    """(factor, unit): the factor of values in `unit` for a prefix that suits the largest value `peak`.

    A prefix is used for values from `room` times the prefix on; with 10, 1,600 kN/m does not become 1.6 MN/m.
    """
    peak = abs(peak)
    if unit in PREFIXED:
        for size, prefix in PREFIXES:
            if peak >= size * (room if size > 1e3 else 1.0):
                return 1.0 / size, prefix + unit
        return 1.0, unit
    if unit in SMALL and 0 < peak < SMALL[unit][0]:
        return SMALL[unit][1:]
    return 1.0, unit


def plain(value, digits=4):
    """A number of four digits: 634.6, 1,600, 1.7 x 10^-13."""
    if isinstance(value, bool):
        return say("yes") if value else say("no")
    if isinstance(value, int):
        return f"{value:,}"
    if not math.isfinite(value):
        return say("infinite") if value > 0 else say("minus infinite") if value < 0 else say("not a number")
    if value == 0:
        return "0"
    exponent = math.floor(math.log10(abs(float(f"{value:.{digits}g}"))))
    if exponent < -4 or exponent > 9:
        return f"{value / 10.0**exponent:.{digits - 1}g} × 10" + superscript(exponent)
    text = f"{value:,.{max(0, digits - 1 - exponent)}f}"
    text = text.rstrip("0").rstrip(".") if "." in text else text
    return text.replace("-", "−")


def superscript(number):
    return str(number).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))


def pretty(unit):
    """m2 as m², N s/m as N s/m, and 1 as nothing."""
    return "" if unit in ("1", "-") else unit.replace("m2", "m²").replace("m3", "m³").replace("s2", "s²")


def quantity(value, unit="", room=10.0, digits=4):
    """Markup of a number with its unit; the exact SI value is in the attribute `value`."""
    if value is None:
        return Markup(say("none"))
    factor, name = scale(unit, value, room) if math.isfinite(value) else (1.0, unit)
    text = f"{plain(value * factor if factor != 1.0 else value, digits)} {pretty(name)}".strip()
    return tag("data", text.replace(" ", "\u00a0"), value=repr(value))


def percent(value):
    return Markup(say("none")) if value is None else tag("data", f"{plain(100 * value, 3)}\u00a0%", value=repr(value))
