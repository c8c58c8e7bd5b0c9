"""Action of the caisson's bottom on the ground: forces over time, pressures over the width at chosen times."""

import re

import numpy as np

from . import figure
from .language import listed, phrase, say, sentences, told
from .markup import Markup, join, prose, symbol, tag
from .plot import Line, Panel, Plot
from .series import largest
from .units import quantity

FORCES = [  # history, symbol, colour, panel
    ("normal_force", "ΔN", 0, "force"),
    ("effective_normal_force", "N′", 1, "force"),
    ("uplift", "U", 4, "force"),
    ("base_moment", "M", 2, "moment"),
    ("effective_base_moment", "M′", 5, "moment"),
    ("eccentricity", "e", 3, "eccentricity"),
    ("toe_pressure", "p_toe", 2, "pressure"),
    ("heel_pressure", "p_heel", 0, "pressure"),
    ("interface/opened_width", "b_open", 1, "opened width"),
]
SIGNS = {name: sign for name, sign, _, _ in FORCES}
HIDDEN = {"heel_pressure": "peak_heel_pressure", "toe_pressure": "peak_toe_pressure"}  # history: its peak in the summary
INNER = 0.9  # share of the width over which stresses are drawn
ROUND_OFF = 1e-9
FLAT = 0.01  # of the largest in a panel
SYMBOL_BEFORE = re.compile(r"^[A-Z]\w*'*, ")  # descriptions may begin with the symbol
PROFILES = [
    ("normal_stress", "effective normal stress, change"),
    ("pore_pressure", "pore pressure, excess"),
    ("shear_stress", "shear stress on the ground, landward"),
]


def section(result):
    if not result.has_caisson:
        return Markup("")
    parts = [tag("h2", say("Pressures and forces at the base"))]
    over_width = profiles(result)
    if over_width:
        parts.append(figure.of_plot(over_width, width_caption(result)))
    else:
        parts.append(tag("p", say("This run has no pressures over the base (/base in results.h5)."), class_="quiet"))
    told_of_edges = edges(result.summary.get("base") or {})
    if told_of_edges:
        parts.append(tag("p", told_of_edges))
    over_time = forces(result)
    if over_time:
        parts.append(figure.of_plot(over_time, explained(result)))
    return tag("section", *parts, id="base-section")


def edges(summary):
    """What the pressures under the edges are, and when the base lifts; empty without such numbers."""
    if not any(key in summary for key in HIDDEN.values()):
        return ""
    words = [phrase("The pressures under the edges, $p_heel$ and $p_toe$, are those in motion, linear over the width in contact, and grow without bound as "
                    "the resultant comes to the edge. The limit of 400 to 600 kPa was made for Goda's $p_e$ and is not compared with them.")]  # fmt: skip
    if summary.get("lifts_time") is not None:
        edge = say({"seaward": "seaward edge", "landward": "landward edge"}.get(summary.get("lifts"), "whole base"))
        time = quantity(summary["lifts_time"], "s")
        told_when = phrase("The {edge} lifts, first at {time}. From then on a bonded base bears a tension that a real one does not.", time=time, edge=edge)
        words.append(tag("strong", told_when, class_="fails"))
    for name, key in HIDDEN.items():
        if key in summary and summary[key] is None:
            words.append(phrase("{pressure} is not drawn, as the resultant leaves the base.", pressure=symbol(SIGNS[name])))
    return sentences(words)


def is_drawn(result, name):
    """The pressure of an edge is a number only while the resultant is on the base."""
    summary = result.summary.get("base") or {}
    return f"/history/{name}" in result.file and not (name in HIDDEN and HIDDEN[name] in summary and summary[HIDDEN[name]] is None)


def is_zero(result, values):
    """Whether a force or moment is only round-off compared with the shear force."""
    return largest(values) <= ROUND_OFF * largest(result.history("shear_force"))


def is_flat(result, name, panel):
    """Whether a line would lie on the axis, as another one of its panel is a hundred times as large."""
    others = [other for other, _, _, place in FORCES if place == panel and is_drawn(result, other) and result.history(other) is not None]
    most = max((largest(result.history(other)) for other in others), default=0.0)
    return largest(result.history(name)) < FLAT * most


def forces(result):
    time, panels = np.asarray(result.time), {}
    for name, symbol, colour, panel in FORCES:
        history = result.history(name) if is_drawn(result, name) else None
        if history is not None and not is_zero(result, history) and not is_flat(result, name, panel):
            panels.setdefault(panel, Panel(history.unit, [], height=110)).lines.append(
                Line(symbol, time, np.asarray(history), colour)
            )
    return Plot("base", list(panels.values())) if panels else None


def width_caption(result):
    moments = listed(
        phrase("{what} is largest at {time} s", what=symbol(name), time=f"{time:.4g}") for name, time in instants(result)
    )
    return phrase(
        "Under the caisson over its width, the sea on the left, compression positive, at chosen moments: {moments}. "
        "Stresses are drawn over the inner {share} of the width: under the edges of a rigid caisson they are singular, "
        "and what is computed there depends on the cells.",
        moments=moments,
        share=f"{INNER:.0%}",
    )


def explained(result):
    found = []
    for name, sign, _, panel in FORCES:
        if is_drawn(result, name):
            history = result.history(name)
            about = prose(told(SYMBOL_BEFORE.sub("", history.description)))
            zero = say(", zero here") if is_zero(result, history) else ""
            if not zero and is_flat(result, name, panel):
                zero = phrase(", not drawn: at most {value}", value=quantity(largest(history), history.unit))
            found.append(join([symbol(sign), ": ", about, zero]))
    return phrase("At the bottom, over time: {quantities}.", quantities=join(found, "; "))


def instants(result):
    """[(quantity that has its largest value, time)], in the order of time."""
    found = []
    for what, name in (("P", "force"), ("F_T", "shear_force"), ("M", "base_moment")):
        if f"/history/{name}" in result.file:
            values = np.abs(np.asarray(result.history(name)))
            found.append((what, float(result.time[int(np.argmax(values))])))
    return sorted(found, key=lambda pair: pair[1])


def profiles(result):
    base = result.file.get("base")
    if base is None or "position" not in base:
        return None
    position = np.asarray(base["position"][()], dtype=float)
    order, panels = np.argsort(position), []
    inner = abs(position - position.mean()) <= INNER * (position.max() - position.min()) / 2
    for name, title in PROFILES:
        if name not in base:
            continue
        values, lines = base[name], []
        drawn = order[inner[order]] if name.endswith("stress") else order
        for colour, (what, time) in enumerate(instants(result)):
            row = int(np.searchsorted(np.asarray(result.time), time))
            lines.append(Line(say("{what} largest", what=what), position[drawn], np.asarray(values[row], dtype=float)[drawn], colour))
        panels.append(Panel("Pa", lines, height=120, title=say(title)))
    return Plot("base-pressures", panels, axis=(say("position"), "m")) if panels else None
