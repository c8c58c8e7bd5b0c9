"""The deformed section in time: pore pressure or strength in colour, the bottom's contact, and histories in which the
reader chooses the time."""

import base64
import math

import numpy as np

from . import bottom, figure, moment, strength, ticks, units
from . import frames as fields
from .language import phrase, say, sentences
from .markup import Markup, data, tag
from .plot import Line, Panel, Plot
from ..errors import UserError

SHARE = 0.04  # the largest displacement is drawn as this share of the width
HISTORIES = [  # history, symbol, colour, panel; those that the run has are drawn
    ("force", "P", 0, "force"),
    ("shear_force", "F_T", 2, "force"),
    ("caisson/displacement_x", "x_G", 3, "displacement"),
    ("interface/slip", "mean slip", 1, "displacement"),
    ("interface/opened_width", "opened width", 4, "width"),
]


def section(result, window):
    """`window`: (x0, x1) near the caisson; an empty text if no fields were asked for."""
    pvd = result.folder / "fields.pvd"
    if not pvd.is_file():
        return Markup("")
    title = tag("h2", say("Deformation and pore pressure"))
    try:
        frames = fields.read(pvd, window)
        told = summary(frames, result)
    except UserError as error:
        return tag("section", title, tag("p", say("Not shown: {why}.", why=error), class_="quiet"), id="fields-section")
    peak = (result.summary.get("response") or {}).get("peak_shear_time", float(frames.times[len(frames.times) // 2]))
    told["start"] = index = int(np.argmin(np.abs(frames.times - peak)))
    moving = tag(
        "figure",
        moment.draw(frames, told, index),
        data(told, "fields"),
        moment.legends(told),
        tag("figcaption", caption(told, frames.times[index])),
        id="fields",
        class_="animation",
    )
    return tag("section", title, moving, scrubbed(result), id="fields-section")


def caption(told, time):
    low, high = told["scale"]["text"]
    rest = [
        say("Slip and gap under the caisson are magnified alike.") if told["bottom"] else "",
        say(
            "Dotted: the caisson that slides as a rigid block, by its slip beside where the fields, which know none, have it; "
            "magnified alike."
        )
        if told["slip"]
        else "",
        say("Dark line: around soil that mobilises {share} % of its strength or more.", share=f"{100 * strength.ZONE:.0f}")
        if told["strength"]
        else "",
        say("Cross: {where}.", where=told["fails"]["text"]) if told["fails"] else "",
        tag("span", say("On paper: the moment {time} s.", time=f"{time:.4g}"), class_="onpaper"),
    ]
    return phrase(
        "Displacements magnified {magnify} times; excess pore pressure in colour, {low} to {high} "
        "(beyond: the end colours). {moment}",
        magnify=units.plain(told["magnify"]),
        low=low,
        high=high,
        moment=sentences(rest),
    )


def scrubbed(result):
    """Histories below the section: dragging in them changes the time of the section. Empty without a caisson."""
    panels, time = {}, np.asarray(result.time)
    for name, symbol, colour, panel in HISTORIES:
        if f"/history/{name}" in result.file:
            history = result.history(name)
            line = Line(say(symbol), time, np.asarray(history), colour)
            panels.setdefault(panel, Panel(history.unit, [], height=80)).lines.append(line)
    if "displacement" in panels and "coupled/slip" in result.file and "interface/slip" not in result.file:
        course = (result.file[f"coupled/{name}"][()] for name in ("time", "slip"))
        panels["displacement"].lines.append(Line(say("slip as a whole"), *course, 5))
    if not panels:
        return Markup("")
    told = say("The same time in histories: drag across them, or click in any plot over time of this page, to move the section above.")
    return figure.of_plot(Plot("fields-histories", list(panels.values())), told, "plot scrubbed")


def summary(frames, result):
    """The frames for JSON: 16-bit integers in base64 with the value of one step, and 8-bit colours.

    Places are told from the corner of the picture: of survey coordinates (x = 441,871 m) 16 bits would hold steps of 13 m.
    """
    scale = pressure_scale(frames)
    slip = bottom.as_a_whole(result, frames)
    largest = float(np.max(np.linalg.norm(frames.displacement, axis=2), initial=0.0))
    largest = max(largest, float(np.max(np.abs(slip), initial=0.0)) if slip is not None else 0.0)
    origin = frames.points.min(axis=0)
    width, height = map(float, np.ptp(frames.points, axis=0))
    box = [0.0, width, 0.0, height]
    magnify = SHARE * width / largest if largest > 0 else 1.0
    magnify = ticks.step_for(magnify, 1) / 2 if magnify > 2 else 1.0
    return {
        "times": [float(f"{time:.6g}") for time in frames.times],
        "box": box,
        "origin": origin.tolist(),
        "magnify": magnify,
        "scale": scale,
        "points": coded((frames.points - origin).T),
        "cells": base64.b64encode(frames.cells.astype("<u4").tobytes()).decode(),
        "kinds": frames.kinds.tolist(),
        "seams": frames.seams.tolist(),
        "displacement": coded(frames.displacement),
        "pressure": shades(frames.pressure / scale["limit"]),
        "strength": strength.summary(frames),
        "fails": failing(result, origin),
        "bottom": bottom.contact(result, frames),
        "slip": None if slip is None else [float(f"{value:.5g}") for value in slip],
    }


def pressure_scale(frames):
    pressure = float(np.quantile(np.abs(frames.pressure), 0.998))
    limit = ticks.step_for(pressure, 4) * math.ceil(pressure / ticks.step_for(pressure, 4)) if pressure > 0 else 1.0
    factor, unit = units.scale("Pa", limit)
    return {"limit": limit, "text": [f"{units.plain(value * factor)} {unit}" for value in (-limit, limit)], "colours": moment.COLOURS}


def failing(result, origin):
    """The place, from the origin, at which the ground moves most as its strength is reduced, and a text about it."""
    found = strength.failing(result.summary)
    if found is None:
        return None
    at, lower, upper = found
    least, most = (units.plain(value) if value else "" for value in (lower, upper))
    by = say("{least} to {most}", least=least, most=most) if least and most else least or most
    return {"at": [float(place - corner) for place, corner in zip(at, origin)], "text": say("where the ground moves most as it fails at rest, its strength divided by {factor}", factor=by)}


def coded(values):
    """{step, data}: values as multiples of `step`, as Int16."""
    largest = float(np.max(np.abs(values), initial=0.0))
    step = largest / 32767 if largest > 0 else 1.0
    return {"step": step, "data": base64.b64encode(np.round(values / step).astype("<i2").tobytes()).decode()}


def shades(share):
    """A byte for each share of the limit from -1 to 1; beyond the limit the colour does not change."""
    return base64.b64encode(np.round(127.5 * (1.0 + np.clip(share, -1.0, 1.0))).astype("u1").tobytes()).decode()
