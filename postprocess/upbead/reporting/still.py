"""Draws a plot as an SVG that needs no script: for paper, and for readers without JavaScript."""

from .markup import Markup, join, tag
from .ticks import decades, ticks

WIDTH, LEFT, RIGHT, HEAD, TITLE, GAP, FOOT = 720, 62, 12, 20, 17, 10, 38


def draw(data, label):
    """The SVG of the data of Plot.data()."""
    low, high = data["window"]
    place = Place(low, high, decades if data.get("log") else ticks)
    parts, top = [], 0
    for panel, limits in zip(data["panels"], all_limits(data)):
        top += HEAD + (TITLE if panel["title"] else 0)
        parts.append(panel_parts(panel, limits, place, top))
        top += panel["height"] + GAP
    parts.append(axis_parts(data, place, top - GAP))
    box = f"0 0 {WIDTH} {top - GAP + FOOT}"
    return tag("svg", *parts, class_="still", viewBox=box, role="img", aria_label=label)


class Place:
    """Conversion from the plot's axis to the drawing's."""

    def __init__(self, low, high, ticks_of=ticks):
        self.low, self.high, self.ticks_of = low, high, ticks_of

    def ticks(self):
        """Round values along the axis."""
        return self.ticks_of(self.low, self.high, 8)

    def x(self, value):
        return LEFT + (value - self.low) / (self.high - self.low) * (WIDTH - LEFT - RIGHT)


def all_limits(data):
    """(low, high) of each panel's values within the window; panels of a group have the same limits."""
    low, high = data["window"]
    own = []
    for panel in data["panels"]:
        seen = [y for line in panel["lines"] for x, y in zip(line["x"], line["y"]) if low <= x <= high]
        seen += [mark["y"] for mark in panel["marks"]]
        own.append(range_of(seen, panel["from_zero"]))
    limits = []
    for panel, range_ in zip(data["panels"], own):
        same = [o for p, o in zip(data["panels"], own) if panel["group"] and p["group"] == panel["group"]] or [range_]
        least, most = min(o[0] for o in same), max(o[1] for o in same)
        room = 0.08 * ((most - least) or 1.0)
        limits.append((least - (room if least < 0 or not panel["from_zero"] else 0), most + room))
    return limits


def range_of(values, from_zero):
    """Least and largest value, with zero where the panel begins there."""
    ends = [0.0, *values] if from_zero or not values else values
    return min(ends), max(ends)


def panel_parts(panel, limits, place, top):
    height = panel["height"]

    def y_of(value):
        return top + height - (value - limits[0]) / (limits[1] - limits[0]) * height

    parts = [legend(panel, top - 6)]
    for value, text in ticks(*limits, max(4, height // 26)):
        y = f"{y_of(value):.1f}"
        parts.append(tag("line", x1=LEFT, x2=WIDTH - RIGHT, y1=y, y2=y, class_="zero" if value == 0 else "grid"))
        parts.append(tag("text", text, x=LEFT - 6, y=y, dy=".32em", class_="tick", text_anchor="end"))
    for value, _ in place.ticks():
        parts.append(
            tag("line", x1=f"{place.x(value):.1f}", x2=f"{place.x(value):.1f}", y1=top, y2=top + height, class_="grid")
        )
    parts += [line_part(line, place, y_of) for line in panel["lines"]]
    parts += [mark_parts(mark, place, y_of) for mark in panel["marks"] if place.low <= mark["x"] <= place.high]
    return join(parts)


def line_part(line, place, y_of):
    """The line within the window, with one point beyond each end, so that the line continues to the edges."""
    points = list(zip(line["x"], line["y"]))
    inside = [place.low <= x <= place.high for x, _ in points]
    if True not in inside:
        return Markup("")
    first, last = inside.index(True), len(inside) - 1 - inside[::-1].index(True)
    shown = [(place.x(x), y_of(y)) for x, y in points[first : last + 1]]
    if line["dots"]:
        return join(tag("circle", cx=f"{x:.1f}", cy=f"{y:.1f}", r=2, class_=f"dot c{line['colour']}") for x, y in shown)
    path = "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in shown)
    return tag("path", d=path, class_=f"line c{line['colour']}", stroke_dasharray=line["dash"] or None)


def mark_parts(mark, place, y_of):
    x, y = place.x(mark["x"]), y_of(mark["y"])
    right = x > LEFT + 0.7 * (WIDTH - LEFT - RIGHT)
    where = {"x": f"{x + (-7 if right else 7):.1f}", "y": f"{y + (10 if mark['y'] < 0 else -1):.1f}"}
    return join(
        [
            tag("circle", cx=f"{x:.1f}", cy=f"{y:.1f}", r=3, class_="mark"),
            tag("text", mark["text"], **where, class_="note", text_anchor="end" if right else "start"),
        ]
    )


def legend(panel, y):
    """Symbol and colour of each line, then the unit, above the panel."""
    parts = []
    for line in panel["lines"]:
        if not named(line):
            continue
        words, lowered = [], False
        for text, style in [*line["symbol"], ("\u2003", "")]:
            shift = 3 if style == "sub" else -3 if lowered else None
            words.append(tag("tspan", text, class_=style or None, dy=shift))
            lowered = style == "sub"
        parts.append(tag("tspan", "╍ " if line["dash"] else "━ ", *words, class_=f"key c{line['colour']}"))
    parts.append(tag("tspan", f"({panel['unit']})" if panel["unit"] else "", class_="tick"))
    title = tag("text", panel["title"], x=LEFT, y=y - TITLE, class_="title") if panel["title"] else ""
    return join([title, tag("text", *parts, x=LEFT, y=y, class_="legend")])


def named(line):
    return bool("".join(text for text, _ in line["symbol"]).strip())


def axis_parts(data, place, bottom):
    parts = []
    for value, text in place.ticks():
        parts.append(tag("text", text, x=f"{place.x(value):.1f}", y=bottom + 16, class_="tick", text_anchor="middle"))
    middle = (LEFT + WIDTH - RIGHT) / 2
    parts.append(tag("text", data["axis"], x=middle, y=bottom + 33, class_="tick", text_anchor="middle"))
    return join(parts)
