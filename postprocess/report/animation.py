"""The deformed section and its pore pressure in time: data for the script, and a still picture of one moment."""

import base64
import math

import numpy as np

from report import frames as fields
from report import geometry, ticks, units
from report.language import phrase, say
from report.markup import Markup, data, tag
from upbead.errors import UserError

SHARE = 0.04  # of the width, that the largest displacement is drawn as
COLOURS = [(33, 102, 172), (146, 197, 222), (247, 247, 247), (244, 165, 130), (178, 24, 43)]  # suction to pressure
WIDTH = 860


def section(result, window):
    """`window`: (x0, x1) near the caisson; an empty text where no fields were asked for."""
    pvd = result.folder / "fields.pvd"
    if not pvd.is_file():
        return Markup("")
    title = tag("h2", say("Deformation and pore pressure"))
    try:
        frames = fields.read(pvd, window)
    except UserError as error:
        return tag("section", title, tag("p", say("Not shown: {why}.", why=error), class_="quiet"), id="fields-section")
    told = summary(frames)
    peak = (result.summary.get("response") or {}).get("peak_shear_time", float(frames.times[len(frames.times) // 2]))
    told["start"] = index = int(np.argmin(np.abs(frames.times - peak)))
    low, high = told["scale"]["text"]
    caption = phrase(
        "Displacements drawn {magnify} times too large; excess pore pressure in colour, {low} to {high} "
        "(beyond: the end colours). {moment}",
        magnify=units.plain(told["magnify"]),
        low=low,
        high=high,
        moment=tag("span", say("On paper: the moment {time} s.", time=f"{frames.times[index]:.4g}"), class_="onpaper"),
    )
    figure = tag(
        "figure",
        still(frames, told, index),
        data(told, "fields"),
        legend(told),
        tag("figcaption", caption),
        id="fields",
        class_="animation",
    )
    return tag("section", title, figure, id="fields-section")


def summary(frames):
    """The frames for JSON: integers of 16 bits in base64, each with what one of them stands for."""
    largest = float(np.max(np.linalg.norm(frames.displacement, axis=2), initial=0.0))
    box = [float(edge) for edge in (*extent(frames.points[:, 0]), *extent(frames.points[:, 1]))]
    magnify = SHARE * (box[1] - box[0]) / largest if largest > 0 else 1.0
    magnify = ticks.step_for(magnify, 1) / 2 if magnify > 2 else 1.0
    pressure = float(np.quantile(np.abs(frames.pressure), 0.998))
    limit = ticks.step_for(pressure, 4) * math.ceil(pressure / ticks.step_for(pressure, 4)) if pressure > 0 else 1.0
    text = [
        units.plain(value * units.scale("Pa", limit)[0]) + " " + units.scale("Pa", limit)[1]
        for value in (-limit, limit)
    ]
    return {
        "times": [float(f"{time:.6g}") for time in frames.times],
        "box": box,
        "magnify": magnify,
        "scale": {"limit": limit, "text": text, "colours": COLOURS},
        "points": coded(frames.points.T),
        "cells": base64.b64encode(frames.cells.astype("<u4").tobytes()).decode(),
        "kinds": frames.kinds.tolist(),
        "displacement": coded(frames.displacement),
        "pressure": coded(frames.pressure),
    }


def extent(values):
    return values.min(), values.max()


def coded(values):
    """{step, data}: whole multiples of `step`, as Int16."""
    largest = float(np.max(np.abs(values), initial=0.0))
    step = largest / 32767 if largest > 0 else 1.0
    return {"step": step, "data": base64.b64encode(np.round(values / step).astype("<i2").tobytes()).decode()}


def colour(share):
    """The colour of a share of the limit, from -1 to 1."""
    place = (min(1.0, max(-1.0, share)) + 1.0) / 2.0 * (len(COLOURS) - 1)
    low = min(int(place), len(COLOURS) - 2)
    mixed = (round(a + (place - low) * (b - a)) for a, b in zip(COLOURS[low], COLOURS[low + 1]))
    return "#" + "".join(f"{part:02x}" for part in mixed)


def still(frames, told, index):
    """One frame as an SVG: water first, as it stays where it is."""
    x0, x1, y0, y1 = told["box"]
    scale = WIDTH / (x1 - x0)
    place = frames.points + told["magnify"] * frames.displacement[index]
    pixels = np.column_stack([(place[:, 0] - x0) * scale, (y1 - place[:, 1]) * scale + 20])
    parts = []
    for kind in (fields.WATER, fields.GROUND, fields.RIGID):
        for cell in frames.cells[frames.kinds == kind]:
            fill = (
                colour(frames.pressure[index, cell].mean() / told["scale"]["limit"])
                if kind != fields.RIGID
                else "#c9ccd4"
            )
            points = " ".join(f"{x:.1f},{y:.1f}" for x, y in pixels[cell])
            parts.append(tag("polygon", points=points, fill=fill, stroke=fill))  # the stroke closes seams between cells
        parts += [edge(loop) for loop in geometry.outline(frames.cells[frames.kinds == kind].tolist(), pixels.tolist())]
    return tag(
        "svg",
        *parts,
        class_="still",
        viewBox=f"0 0 {WIDTH} {(y1 - y0) * scale + 24:.0f}",
        role="img",
        aria_label=say("deformed section"),
    )


def edge(loop):
    return tag("polygon", points=" ".join(f"{x:.1f},{y:.1f}" for x, y in loop), class_="edge")


def legend(told):
    """A bar of the colours with its ends."""
    steps = (tag("i", style=f"background:{colour(i / 10 - 1)}") for i in range(21))
    low, high = told["scale"]["text"]
    return tag(
        "div",
        tag("span", low),
        tag("span", *steps, class_="bar"),
        tag("span", say("{high} pore pressure", high=high)),
        class_="colours",
    )
