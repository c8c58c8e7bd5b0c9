"""Readings of probes: a plot for each quantity, with its components one below the other."""

import re

import numpy as np

from . import figure, measured
from .language import named, say, told
from .plot import Line, Panel, Plot
from .series import largest

COMPONENT = re.compile(r"_([xyz]{1,2})$")
ROUND_OFF = 1e-9  # of the largest component: smaller values are round-off


def figures(result, wanted=None):
    """The plots as HTML; `wanted` names quantities without their components, all by default."""
    found = {}
    for name, probes in result.probes().items():
        found.setdefault(COMPONENT.sub("", name), {})[name] = probes
    drawn = (of_quantity(result, what, parts) for what, parts in found.items() if wanted is None or what in wanted)
    return [one for one in drawn if one]


def of_quantity(result, what, parts):
    """`parts`: {name of the component: {probe: History}}; empty if all values are zero."""
    peaks = {name: max(largest(values) for values in probes.values()) for name, probes in parts.items()}
    panels, zero = [], []
    for name, probes in parts.items():
        component = COMPONENT.search(name)
        if peaks[name] > ROUND_OFF * max(peaks.values()):
            panels.append(panel(result, probes, component[1] if component else ""))
        else:
            zero.append(component[1] if component else say("it"))
    words = named(what) if COMPONENT.search(next(iter(parts))) else told(described(parts))
    words = words[:1].upper() + words[1:]
    if zero:
        caption = say("{what} at the points read; zero here: {zero}.", what=words, zero=", ".join(zero))
    else:
        caption = say("{what} at the points read.", what=words)
    return figure.of_plot(Plot(f"probe-{what}", panels), caption) if panels else ""


def described(parts):
    """The description that the first reading has in the results."""
    return next(iter(next(iter(parts.values())).values())).description


def panel(result, probes, title, quantity="", records=None):
    """`records` of that quantity, by the history that they are compared with, are drawn over it."""
    time, lines, order = np.asarray(result.time), [], list(result.file["/history/probes"])  # a point has one colour in all panels
    for name, history in probes.items():
        lines += [Line(name.replace("_", " "), time, np.asarray(history), order.index(name) % 6), *measured.lines_over(records or {}, f"probes/{name}/{quantity}")]
    return Panel(next(iter(probes.values())).unit, lines, height=120, title=title)
