"""One moment of the animation as an SVG, for paper and for readers without scripts; the legends of its colours."""

import numpy as np

from . import bottom, geometry, strength
from . import frames as fields
from .language import say
from .markup import join, tag

COLOURS = [(33, 102, 172), (146, 197, 222), (247, 247, 247), (244, 165, 130), (178, 24, 43)]  # suction to pressure
SHADES = 24  # shades of pressure, and as many of suction
WIDTH, AIR = 860, 20
DASHES = {bottom.SLIPS: "6 3"}  # so that states differ not only by colour


def colour(share):
    """The colour of a share of the limit, from -1 to 1."""
    place = (min(1.0, max(-1.0, share)) + 1.0) / 2.0 * (len(COLOURS) - 1)
    low = min(int(place), len(COLOURS) - 2)
    mixed = (round(a + (place - low) * (b - a)) for a, b in zip(COLOURS[low], COLOURS[low + 1]))
    return "#" + "".join(f"{part:02x}" for part in mixed)


def draw(frames, told, index):
    """The SVG of a frame; water is drawn first, as it does not move."""
    x0, x1, y0, y1 = told["box"]
    scale = WIDTH / (x1 - x0)

    def pixels(place):
        return np.column_stack([(place[:, 0] - x0) * scale, (y1 - place[:, 1]) * scale + AIR])

    moved = pixels(frames.points - told["origin"] + told["magnify"] * frames.displacement[index])
    parts = []
    for kind in (fields.WATER, fields.GROUND, fields.RIGID):
        parts += cells(frames, told, index, moved, kind)
        parts += [edge(loop) for loop in loops(frames.cells[frames.kinds == kind], moved)]
    seams = "".join(f"M{path(moved[side])}" for side in frames.seams)
    parts += [tag("path", d=seams, class_="seam")] if seams else []
    if told["strength"]:
        zone = frames.cells[strength.in_zone(frames.mobilised[index])]
        parts += [edge(loop, "zone") for loop in loops(zone, moved)]
    if told["bottom"]:
        parts += contact(told["bottom"], index, moved)
    if told["slip"]:
        shifted = moved + [told["magnify"] * told["slip"][index] * scale, 0.0]
        parts += [edge(loop, "slipped") for loop in loops(frames.cells[frames.kinds == fields.RIGID], shifted)]
    if told["fails"]:
        parts.append(cross(*pixels(np.array([told["fails"]["at"]]))[0]))
    box = f"0 0 {WIDTH} {(y1 - y0) * scale + AIR + 4:.0f}"
    label = say("deformed section") + (f"; {told['bottom']['told'][index]}" if told["bottom"] else "")
    return tag("svg", *parts, class_="still", viewBox=box, role="img", aria_label=label)


def cells(frames, told, index, moved, kind):
    """A path for each of the SHADES colours."""
    chosen = frames.cells[frames.kinds == kind]
    share = np.clip(frames.pressure[index, chosen].mean(axis=1) / told["scale"]["limit"], -1.0, 1.0)
    shade = np.round(SHADES * share) * (kind != fields.RIGID)
    for one in np.unique(shade):
        fill = "#c9ccd4" if kind == fields.RIGID else colour(one / SHADES)
        drawn = "".join(f"M{path(moved[cell])}Z" for cell in chosen[shade == one])
        yield tag("path", d=drawn, fill=fill, stroke=fill)  # the stroke closes seams between cells


def contact(told, index, moved):
    """Pieces of the caisson's bottom in the colour of their node's state; gaps are filled."""
    upper, lower = (along(told, moved, side) for side in (0, 1))
    for node, state in enumerate(map(int, told["states"][index])):
        above, below = upper[2 * node : 2 * node + 3], lower[2 * node : 2 * node + 3]
        if state == bottom.OPEN:
            yield tag("polygon", points=path(np.vstack([above, below[::-1]])), fill=told["colours"][state], fill_opacity=0.35)
        yield tag(
            "polyline", points=path(above), fill="none", stroke=told["colours"][state], stroke_dasharray=DASHES.get(state), stroke_width=1.5 if state == 0 else 4
        )


def along(told, moved, side):
    """Ends and middles of the nodes' pieces on the caisson (0) or on the ground (1): 2 n + 1 points."""
    line, place = moved[np.array(told["pairs"])[:, side]], np.array(told["place"])
    middles = (place[1:] + place[:-1]) / 2
    all_ = np.empty(2 * len(place) + 1)
    all_[1::2], all_[2:-1:2], all_[0], all_[-1] = place, middles, place[0], place[-1]
    return np.column_stack([np.interp(all_, np.arange(len(line)), line[:, axis]) for axis in (0, 1)])


def loops(chosen, moved):
    return geometry.outline(chosen.tolist(), moved.tolist())


def path(points):
    return " ".join(f"{x:.1f},{y:.1f}" for x, y in points)


def edge(loop, class_="edge"):
    return tag("polygon", points=path(loop), class_=class_)


def cross(x, y):
    return tag("path", d=f"M{x - 7:.1f} {y - 7:.1f}l14 14m0 -14l-14 14", class_="fails")


def legends(told):
    """Colour bars with the values at their ends; the script shows the one of strength instead of that of pressure on
    request."""
    steps = (tag("i", style=f"background:{colour(i / 10 - 1)}") for i in range(21))
    low, high = told["scale"]["text"]
    parts = [legend("pressure", low, steps, say("{high} pore pressure", high=high))]
    if told["strength"]:
        steps = (tag("i", style=f"background:{shade}") for shade in told["strength"]["colours"])
        limits = ", ".join(f"{100 * limit:g}" for limit in told["strength"]["limits"])
        parts.append(legend("strength", "0 %", steps, say("100 % of the strength mobilised; steps at {limits} %", limits=limits), hidden="hidden"))
    if told["bottom"]:
        names = zip(told["bottom"]["names"], told["bottom"]["colours"])
        keys = (tag("span", tag("i", class_=f"key{state}", style=f"border-color:{shade}"), f" {name}") for state, (name, shade) in enumerate(names))
        parts.append(tag("div", tag("span", say("the caisson's bottom:")), *keys, class_="colours contact"))
    return join(parts)


def legend(name, low, steps, high, **attributes):
    return tag("div", tag("span", low), tag("span", *steps, class_="bar"), tag("span", high), class_=f"colours of-{name}", **attributes)
