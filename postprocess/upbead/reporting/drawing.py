"""The section drawn with its dimensions, the water level, the heights of the loads and the probes.

One way for every section: what is drawn follows from the outlines of its regions, of a shipped geometry or of an own mesh.
"""

from . import patterns, units
from .canvas import Canvas
from .corners import column_at, corners, features, merged, slopes, top_at
from .language import named, say
from .markup import join, tag

NARROW = 500  # px; narrower drawings have no room for all words
ROOM = 0.28  # of the drawn width, beside the outermost corners
WIDEST = 3.2  # a drawing over the width of mound and caisson: what lies farther away is cut off
ARM = 62  # px between the dimensions of two loads' arms
ORDER = {"water": 0, "porous": 1, "solid": 2, "rigid": 3}


def draw(section, case, summary):
    """Two drawings of the section: for wide and for narrow pages."""
    return join(drawing(section, case, summary, width, class_) for width, class_ in ((860, "wide"), (380, "narrow")))


def drawing(section, case, summary, width, class_):
    body = body_of(section)
    window = near(section, case) if body else around(section)
    canvas = Canvas(window, width, (8, 8, 30, 50) if body else (70, 60, 30, 40), "section")
    areas(canvas, section, case)
    if body:
        still_water(canvas, section, case, summary)
        dimensions(canvas, section, body)
        ends(canvas, section)
    else:
        outer_dimensions(canvas, section)
    loads(canvas, section, case, summary)
    probes(canvas, case)
    names(canvas, section, case)
    return canvas.svg(say("section with its dimensions"), f"{class_} written")  # names of regions and loads, and numbers


def body_of(section):
    """The outline of what stands on the ground, from the toes of the mound to the walls; empty without a caisson."""
    found = [name for name in ("mound", "caisson") if name in section.regions]
    return found if "caisson" in found and len(section.regions) > 1 else []


def near(section, case):
    """The window of all ground that has a corner within the section, with room on either side; the ground continues."""
    whole = section.box()
    ground = [name for name, keys in keys_of(section, case).items() if keys.get("kind") != "water"]
    at = [x for name in ground for loop in corners(section.regions[name]) for x, _ in features(loop, whole)]
    boxes = [section.box(name) for name in body_of(section)]
    least, most = min(box[0] for box in boxes), max(box[1] for box in boxes)
    spare = (WIDEST - 1) / 2 * (most - least) / (1 + 2 * ROOM)
    left, right = max(min([least, *at]), least - spare), min(max([most, *at]), most + spare)
    room = ROOM * (right - left)
    return max(left - room, whole[0]), min(right + room, whole[1]), whole[2], whole[3]


def around(section):
    """The window of the whole section, widened if it is slender."""
    x0, x1, y0, y1 = section.box()
    air = max(0.0, 2.0 * (y1 - y0) - (x1 - x0)) / 2
    return x0 - air, x1 + air, y0, y1


def keys_of(section, case):
    return {name: case.get("regions", {}).get(name, {}) for name in section.regions}


def areas(canvas, section, case):
    looks = patterns.looks(keys_of(section, case))
    kinds = {name: keys.get("kind", "porous") for name, keys in keys_of(section, case).items()}
    for name in sorted(section.regions, key=lambda n: ORDER.get(kinds[n], 1)):
        class_, pattern = looks[name]
        canvas.add(*(canvas.loop(loop, "area " + class_, pattern) for loop in section.regions[name]))


def metres(length):
    """A length in metres, to the centimetre from ten on, else to the millimetre."""
    digits = 2 if abs(length) >= 10 else 3
    return f"{length:.{digits}f}".rstrip("0").rstrip(".") + "\u00a0m"


def still_water(canvas, section, case, summary):
    """The triangle at the level of every sea; a level of the state at rest alone, whose sea is left out, is a line."""
    seas = [name for name, keys in keys_of(section, case).items() if keys.get("kind") == "water"]
    wall = section.box("caisson")
    for name in seas:
        x0, x1, _, y = section.box(name)
        x0, x1 = max(x0, canvas.x0), min(x1, canvas.x1)
        if x1 > x0:
            at = x0 + 0.3 * (x1 - x0) if x1 <= wall[0] + 1e-9 else x0 + 0.55 * (x1 - x0)
            canvas.level(at, y)
    initial = case.get("initial") or {}
    level = initial.get("water_level")
    if seas or not isinstance(level, (int, float)) or not canvas.y0 < level < canvas.y1:
        return
    sides = ((canvas.x0, wall[0], level), (wall[1], canvas.x1, initial.get("harbour_level", level)))
    for a, b, y in sides:
        (px, py), (qx, _) = canvas.at(a, y), canvas.at(b, y)
        canvas.line((px, py), (qx, py), "waterline")
        canvas.level(a + 0.45 * (b - a), y)


def dimensions(canvas, section, body):
    left, right, bottom, top = section.box("caisson")
    canvas.across(left, right, top, metres(right - left), -10)
    canvas.upright(right + 14 / canvas.scale, bottom, top, metres(top - bottom))
    low = canvas.y0
    if "mound" in body:
        _, toe, foot, crest = section.box("mound")
        canvas.upright(toe + 24 / canvas.scale, foot, crest, metres(crest - foot))
    layers(canvas, section)
    loops = [loop for name in body for loop in corners(section.regions[name])]
    stations = merged([x for loop in loops for x, _ in loop if canvas.x0 <= x <= canvas.x1], 4 / canvas.scale)
    for a, b in zip(stations[:-1], stations[1:]):
        canvas.across(a, b, low, metres(b - a), 24)
    if "mound" in body:
        for loop in corners(section.regions["mound"]):
            for (x, y), slope, way in slopes(loop):
                px, py = canvas.at(x, y)
                places = [(px + way * d, py - d / 2 - 6, "start" if way > 0 else "end") for d in (2, 8, 16, 28)]
                if canvas.width > NARROW:
                    canvas.label(f"1 : {units.plain(slope, 3)}", places)


def layers(canvas, section):
    """Thicknesses of water and ground at both ends of the drawing; on the right only what is another one there."""
    inset = 0.5 / canvas.scale
    walls = section.box("caisson")
    shown = []
    for at, x in ((canvas.x0 + inset, canvas.x0 + 16 / canvas.scale), (canvas.x1 - inset, canvas.x1 - 22 / canvas.scale)):
        if walls[0] < at < walls[1]:
            continue
        heights = column_at(section, at)
        for low, high in zip(heights[:-1], heights[1:]):
            if (low, high) not in shown and (high - low) * canvas.scale > 9:
                canvas.upright(x, low, high, metres(high - low), side=1 if at < walls[0] else -1)
                shown.append((low, high))


def ends(canvas, section):
    """Marks where the drawing is cut off, with the length to which the section continues."""
    whole = section.box()
    foot = section.box("mound" if "mound" in section.regions else "caisson")
    for side, at, rest, anchor in (
        (-1, canvas.x0, foot[0] - whole[0], "start"),
        (1, canvas.x1, whole[1] - foot[1], "end"),
    ):
        hidden = canvas.x0 - whole[0] if side < 0 else whole[1] - canvas.x1
        if hidden <= 1e-3 * (whole[1] - whole[0]):
            continue
        px, low = canvas.at(at, canvas.y0)
        _, high = canvas.at(at, top_at(section, at + side * -0.5 / canvas.scale))
        step = (low - high + 2) / 12
        inward = -side
        points = [(px + inward * (6 if i % 2 else 1), high - 1 + i * step) for i in range(13)]
        cover = [*points, (px - 9 * inward, low + 1), (px - 9 * inward, high - 1)]
        canvas.add(tag("polygon", points=" ".join(f"{x:.1f},{y:.1f}" for x, y in cover), class_="cut"))
        canvas.add(tag("polyline", points=" ".join(f"{x:.1f},{y:.1f}" for x, y in points), class_="break"))
        beyond = "{length} beyond the toe" if "mound" in section.regions else "{length} beyond the caisson"
        words = say(beyond, length=metres(rest)) if canvas.width > NARROW else metres(rest)
        words = f"⟵ {words}" if anchor == "start" else f"{words} ⟶"
        canvas.label(words, [(px + 20 * inward, low - 10, anchor), (px + 10 * inward, low + 43, anchor)], "note small")


def outer_dimensions(canvas, section):
    x0, x1, y0, y1 = section.box()
    canvas.across(x0, x1, y0, metres(x1 - x0), 24)
    canvas.upright(x1 + 10 / canvas.scale, y0, y1, metres(y1 - y0))


def names(canvas, section, case):
    kinds = {name: keys.get("kind", "porous") for name, keys in keys_of(section, case).items()}
    for name in sorted(section.regions, key=lambda n: -ORDER.get(kinds[n], 1)):
        if canvas.width > NARROW or kinds[name] != "water":
            canvas.within(section.regions[name], named(name))


def probes(canvas, case):
    """Probes are numbered, as their names would cover the section; the caption has the names."""
    for number, probe in enumerate(case.get("probes", {}).values(), 1):
        px, py = canvas.at(*probe["at"])
        if not canvas.x0 <= probe["at"][0] <= canvas.x1:
            continue
        canvas.line((px - 4, py), (px + 4, py), "probe")
        canvas.line((px, py - 4), (px, py + 4), "probe")
        canvas.around(px, py, str(number))


def acting(case):
    return {name: load for name, load in case.get("loads", {}).items() if load.get("factor", 1.0) != 0}


def loads(canvas, section, case, summary):
    """An arrow at the height of each load's resultant on the caisson; loads at one height share an arrow."""
    known = (summary.get("loads") or {}) | (summary.get("gauges") or {})
    if "caisson" not in section.regions:
        return downward(canvas, section, case)
    x0, x1, bottom, _ = section.box("caisson")
    heights = {}
    for name, load in acting(case).items():
        for y in (load.get("heights") or {}).values():  # for loads by transducers
            px, py = canvas.at(x0, y)
            canvas.add(tag("circle", cx=f"{px:.1f}", cy=f"{py:.1f}", r=3, class_="loadhead"))
        arm = known.get(name, {}).get("arm")
        if arm is not None:
            heights.setdefault(round(arm, 6), []).append(named(name))
    for number, (arm, together) in enumerate(sorted(heights.items())):
        px, py = canvas.at(x0, bottom + arm)
        canvas.arrow((px - 64 - ARM * number, py), (px, py))
        words, far = ", ".join(together), px - 70 - ARM * number
        canvas.label(words, [(px - 14, py - 10, "end"), (far, py, "end"), (px - 14, py + 11, "end"), (far, py - 12, "end")], "note loadname")
        canvas.upright(x0 - (22 + ARM * number) / canvas.scale, bottom, bottom + arm, metres(round(arm, 2)), side=-1)


def downward(canvas, section, case):
    """A load on the top of a section without a caisson."""
    x0, x1, _, top = section.box()
    on_top = [named(name) for name, load in acting(case).items() if load.get("boundary") == "top"]
    if on_top:
        px, py = canvas.at((x0 + x1) / 2, top)
        canvas.arrow((px, py - 26), (px, py))
        canvas.around(px, py - 16, ", ".join(on_top), "note loadname", 12)
