"""The slip circle that governs: drawn on the section with its slices, the load of the base and the pore pressure; and its
factor over time."""

import numpy as np

from . import figure, numbers
from .canvas import Canvas
from .drawing import areas
from .language import phrase, say
from .markup import Markup, join, tag
from .plot import Line, Panel, Plot
from .units import plain, pretty, quantity, scale

AIR = 0.12  # of the circle's width, beside the drawing
TALL = 0.3  # of the drawing's height: the longest bar of pressure, and the load of the base
WIDTHS = ((860, "wide"), (380, "narrow"))


def section(result, outline):
    """`outline`: the Section of the drawing, or None; empty where nothing was looked for."""
    peak = numbers.alone(result.summary.get("peak_safety"), ("peak_safety",), "run")
    lifted = (result.summary.get("liquefaction") or {}).get("places") or []
    places = {" ".join(filter(None, (place["region"], side(place["side"])))): place for place in lifted}
    parts = [governing(result, outline)]
    parts += [tag("h3", say("Strength at the peak of the wave")), peak] if peak else []
    parts += [tag("h3", say("Momentary liquefaction")), numbers.beside(places, ("liquefaction", "places"), "run", ("region", "side"))] if places else []
    return tag("section", tag("h2", say("Ground under the wave")), *parts, id="circle-section") if any(parts) else Markup("")


def side(name):
    """Of the caisson; empty without one."""
    return {"sea": say("sea side"), "harbour": say("harbour side")}.get(name, "")


def governing(result, outline):
    """The circle and its course; empty where no circle governs."""
    found = result.summary.get("circles") or {}
    if found.get("factor") is None or "circle/x" not in result.file:
        return Markup("")
    circle, parts = found[found["by"]], [tag("h3", say("Slip circle that governs"))]
    if outline is not None and "caisson" in outline.regions:
        drawn = join(drawing(result, outline, circle, width, class_) for width, class_ in WIDTHS)
        parts.append(figure.of_drawing("circle", drawn, caption(circle, found["by"], most_pressure(result))))
    over_time = course(result)
    if over_time is not None:
        text = say("Least factor over time of the circles found at rest and in motion, each held.")
        parts.append(figure.of_plot(over_time, text))
    return join(parts)


def most_pressure(result):
    return quantity(float(np.abs(result.file["circle/pressure"][()]).max()), "Pa")


def caption(circle, by, most):
    when = say("at rest") if circle["time"] is None else say("at {time} s", time=f"{circle['time']:.4g}")
    pressure = {"computed": say("the computed pore pressure"), "still": say("the pore pressure of still water")}.get(by, say("the pore pressure of still water"))
    return phrase(
        "The least safe circle, {when}: $F$ = {factor} by Bishop's simplified method with {pressure}. It is drawn with its slices, "
        "the effective width that $N'$ loads evenly (block on the bottom), $F_T$ (arrow) and, along the circle, the excess pore "
        "pressure (bars inward where it is positive, at most {most}).",
        when=when,
        factor=f"{circle['factor']:.3g}",
        pressure=pressure,
        most=most,
    )


def slices(result):
    return {name: result.file[f"circle/{name}"][()] for name in ("x", "width", "base", "surface", "pressure")}


def window_of(outline, circle, cut):
    """Around the circle, with the caisson's foot above it."""
    room = AIR * (circle["to"] - circle["from"])
    x0, x1, bottom, top = outline.box("caisson")
    low, high = cut["base"].min() - room, bottom + TALL * (top - bottom) + room
    return min(circle["from"], x0) - room, max(circle["to"], x1) + room, low, max(high, cut["surface"].max() + room)


def drawing(result, outline, circle, width, class_):
    cut = slices(result)
    canvas = Canvas(window_of(outline, circle, cut), width, (8, 8, 10, 10), "circle")
    box = clip(canvas)
    areas(canvas, outline, result.case)
    canvas.parts = [box, tag("g", *canvas.parts, clip_path=f"url(#circle-{width})")]
    pressures(canvas, circle, cut)
    for x, w, base, surface in zip(cut["x"], cut["width"], cut["base"], cut["surface"]):
        for at in (x - w / 2, x + w / 2):
            canvas.line(canvas.at(at, base), canvas.at(at, surface), "slice")
    arc(canvas, circle)
    base_load(canvas, outline, circle)
    return canvas.svg(say("slip circle that governs"), class_)


def clip(canvas):
    frame = tag("rect", x=f"{canvas.left:.1f}", y=f"{canvas.top:.1f}", width=f"{canvas.inner[0]:.1f}", height=f"{canvas.inner[1]:.1f}")
    return tag("defs", tag("clipPath", frame, id=f"circle-{canvas.width}"))


def arc(canvas, circle):
    """The circle between its ends."""
    (cx, cy), radius = circle["centre"], circle["radius"]
    x = np.linspace(circle["from"], circle["to"], 121)
    y = cy - np.sqrt(np.maximum(radius**2 - (x - cx) ** 2, 0.0))
    points = " ".join("{:.1f},{:.1f}".format(*canvas.at(*p)) for p in zip(x, y))
    canvas.add(tag("polyline", points=points, class_="circle"))
    px, py = canvas.at(cx, cy)
    if canvas.top <= py:
        canvas.line((px - 5, py), (px + 5, py))
        canvas.line((px, py - 5), (px, py + 5))


def pressures(canvas, circle, cut):
    """A bar for each slice along the normal of the circle, inward where the pressure is positive."""
    most = np.abs(cut["pressure"]).max()
    if not most > 0:
        return
    length = TALL * (canvas.y1 - canvas.y0) / most
    cx, cy = circle["centre"]
    inner, outer = [], []
    for x, y, p in zip(cut["x"], cut["base"], cut["pressure"]):
        away = np.hypot(cx - x, cy - y)
        outer.append((x, y))
        inner.append((x + p * length * (cx - x) / away, y + p * length * (cy - y) / away))
    points = " ".join("{:.1f},{:.1f}".format(*canvas.at(*p)) for p in outer + inner[::-1])
    canvas.add(tag("polygon", points=points, class_="pore"))


def base_load(canvas, outline, circle):
    """The block on the effective width, and F_T."""
    bottom = outline.box("caisson")[2]
    (left, low), (right, _) = canvas.at(circle["strip_from"], bottom), canvas.at(circle["strip_to"], bottom)
    high = low - 26
    canvas.add(tag("rect", x=f"{left:.1f}", y=f"{high:.1f}", width=f"{right - left:.1f}", height=f"{low - high:.1f}", class_="strip"))
    for i in range(5):
        px = left + (i + 0.5) * (right - left) / 5
        canvas.arrow((px, high), (px, low))
    middle = (circle["strip_from"] + circle["strip_to"]) / 2
    canvas.text(middle, bottom, f"N′ {force(circle['force'])}", dy=-32)
    if circle["shear"]:
        px, py = canvas.at(middle, bottom)
        way = 1 if circle["shear"] > 0 else -1
        canvas.arrow((px - 34 * way, py + 12), (px + 34 * way, py + 12))
        canvas.text(middle, bottom, "F", tag("tspan", "T", dy=3, class_="sub"), tag("tspan", f" {force(abs(circle['shear']))}", dy=-3), dy=30)


def force(value):
    factor, unit = scale("N/m", value, 10.0)
    return f"{plain(value * factor)} {pretty(unit)}"


def course(result):
    if "circle/factor" not in result.file:
        return None
    time, factor = result.file["circle/time"][()], result.file["circle/factor"][()]
    known = np.isfinite(factor)
    if known.sum() < 2:
        return None
    return Plot("circle-factor", [Panel("1", [Line("F", time[known], factor[known], 0)], marks=[lowest(time[known], factor[known])])])


def lowest(time, factor):
    row = int(np.argmin(factor))
    return float(time[row]), float(factor[row])
