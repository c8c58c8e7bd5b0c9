"""Numbers for readers: four digits, a prefix that suits the size, and the exact value as an attribute."""

import math

from .language import say
from .markup import Markup, tag
from ..prefixes import common, pretty, scale


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


def digits_between(value, limit, least=4):
    """So many digits that a number and its limit do not look alike where they differ."""
    digits = least
    while digits < 12 and None not in (value, limit) and value != limit and f"{value:.{digits}g}" == f"{limit:.{digits}g}":
        digits += 1
    return digits


def superscript(number):
    return str(number).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))


def quantity(value, unit="", room=10.0, digits=4):
    """Markup of a number with its unit; the exact SI value is in the attribute `value`."""
    if value is None:
        return Markup(say("none"))
    return Quantity(value, unit, digits, scale(unit, value, room) if math.isfinite(value) else (1.0, unit))


class Quantity(Markup):
    """A number with its unit, which knows how to stand in one table with others of its unit."""

    def __new__(cls, value, unit, digits, drawn):
        factor, name = drawn
        text = f"{plain(value * factor if factor != 1.0 else value, digits)} {pretty(name)}".strip()
        made = super().__new__(cls, tag("data", text.replace(" ", "\u00a0"), value=repr(value)))
        made.value, made.unit, made.digits, made.drawn = value, unit, digits, drawn
        return made

    def beside(self, others):
        """In the unit that suits all of `others`, itself among them."""
        drawn = common(self.unit, [other.value for other in others if other.drawn[1] != self.unit or other.value]) or self.drawn
        return Quantity(self.value, self.unit, self.digits, drawn)


def percent(value):
    return Markup(say("none")) if value is None else tag("data", f"{plain(100 * value, 3)}\u00a0%", value=repr(value))
