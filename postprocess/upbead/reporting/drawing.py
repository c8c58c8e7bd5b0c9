"""The section drawn with its dimensions, the water level, the heights of the loads and the probes."""

from . import units
from .canvas import Canvas
from .geometry import floors, of_side, toes
from .language import named, say
from .markup import join, tag

NARROW = 500  # px; narrower drawings have no room for all words
FILLS = {"rigid": "rigid", "water": "water", "solid": "solid"}


def draw(section, case, summary):
    """Two drawings of the section: for wide and for narrow pages."""
    return join(drawing(section, case, summary, width, class_) for width, class_ in ((860, "wide"), (380, "narrow")))


def drawing(section, case, summary, width, class_):
    p = section.parameters
    composite = "mound_slope" in p and "caisson_width" in p
    window = near(section, p) if composite else around(section)
    canvas = Canvas(window, width, (8, 8, 30, 40) if composite else (70, 60, 30, 40))
    areas(canvas, section, case)
    if composite:
        dimensions(canvas, p)
        ends(canvas, p)
    else:
        outer_dimensions(canvas, section)
    names(canvas, section, case, composite)
    probes(canvas, case)
    loads(canvas, section, case, summary)
    return canvas.svg(say("section with its dimensions"), class_)


def near(section, p):
    """The window of the mound and 0.28 of its width on either side; the seabed continues."""
    left, right = toes(p).values()
    room = 0.28 * (right - left)
    _, _, low, high = section.box()
    whole = section.box()
    return max(left - room, whole[0]), min(right + room, whole[1]), low, high


def around(section):
    """The window of the whole section, widened if it is slender."""
    x0, x1, y0, y1 = section.box()
    air = max(0.0, 2.0 * (y1 - y0) - (x1 - x0)) / 2
    return x0 - air, x1 + air, y0, y1


def areas(canvas, section, case):
    order = {"water": 0, "porous": 1, "solid": 2, "rigid": 3}
    kinds = {name: case.get("regions", {}).get(name, {}).get("kind", "porous") for name in section.regions}
    for name in sorted(section.regions, key=lambda n: order.get(kinds[n], 1)):
        class_ = FILLS.get(kinds[name]) or {"mound": "rubble", "subsoil": "subsoil"}.get(name, "soil")
        canvas.add(*(canvas.loop(loop, "area " + class_) for loop in section.regions[name]))


def metres(length):
    """A length in metres, to the millimetre at most."""
    return f"{length:.3f}".rstrip("0").rstrip(".") + "\u00a0m"


def dimensions(canvas, p):
    wall, height = p["caisson_width"] / 2, p["mound_height"]
    toe = toes(p)
    left, right = toe.values()
    top, layers = height + p["caisson_height"], floors(p)
    canvas.across(-wall, wall, top, metres(p["caisson_width"]), -10)
    canvas.upright(wall + 14 / canvas.scale, height, top, metres(p["caisson_height"]))
    canvas.upright(right + 10 / canvas.scale, 0, height, metres(height))
    far = canvas.x0 + 14 / canvas.scale
    for high, low in zip(layers[:-1], layers[1:]):
        canvas.upright(far, low, high, metres(high - low))
    for side in seas(p):
        level, at = of_side(p, "water_depth", side), far if side < 0 else canvas.x1 - 60 / canvas.scale
        canvas.upright(at, 0, level, metres(level))
        canvas.level(at + 34 / canvas.scale, level)
    stations = [left, -p["mound_crest_front"], -wall, wall, p["mound_crest_back"], right]
    for a, b in zip(stations[:-1], stations[1:]):
        canvas.across(a, b, layers[-1], metres(b - a), 24)
    sides = ((-1, -p["mound_crest_front"]), (1, p["mound_crest_back"]))
    for side, edge in sides if canvas.width > NARROW else ():
        canvas.text(
            (edge + toe[side]) / 2,
            height / 2,
            f"1 : {units.plain(of_side(p, 'mound_slope', side))}",
            anchor="end" if side < 0 else "start",
            dx=6 * side,
            dy=-6,
        )


def wet_sides(p):
    return [side for side, name in ((-1, "sea_front"), (1, "sea_back")) if p.get(name, 0) > 0]


def seas(p):
    """The sides at which the water depth is drawn: both only if their levels differ."""
    wet = wet_sides(p)
    return wet if len({of_side(p, "water_depth", side) for side in wet}) > 1 else wet[:1]


def ends(canvas, p):
    """Marks where the drawing is cut off, with the length to which the section continues."""
    left, right = toes(p).values()
    base = floors(p)[-1]
    for side, at, rest, toe, anchor in (
        (-1, canvas.x0, p["seabed_front"], left, "start"),
        (1, canvas.x1, p["seabed_back"], right, "end"),
    ):
        if rest > abs(at - toe) * 1.001:
            px, low = canvas.at(at, base)
            level = of_side(p, "water_depth", side) if side in wet_sides(p) else 0.0
            _, high = canvas.at(at, level)
            step = (low - high + 2) / 12
            inward = 1 if anchor == "start" else -1
            points = [(px + inward * (6 if i % 2 else 1), high - 1 + i * step) for i in range(13)]
            hidden = [*points, (px - 8 * inward, low + 1), (px - 8 * inward, high - 1)]
            canvas.add(tag("polygon", points=" ".join(f"{x:.1f},{y:.1f}" for x, y in hidden), class_="cut"))
            for a, b in zip(points[:-1], points[1:]):
                canvas.line(a, b)
            words = say("{length} beyond the toe", length=metres(rest))
            words = f"⟵ {words}" if anchor == "start" else f"{words} ⟶"
            canvas.text(at, base, words, anchor=anchor, dx=12 * inward, dy=-6, class_="note small")


def outer_dimensions(canvas, section):
    x0, x1, y0, y1 = section.box()
    canvas.across(x0, x1, y0, metres(x1 - x0), 24)
    canvas.upright(x1 + 10 / canvas.scale, y0, y1, metres(y1 - y0))
    if "caisson" in section.regions and len(section.regions) > 1:
        x0, x1, y0, y1 = section.box("caisson")
        canvas.across(x0, x1, y1, metres(x1 - x0), -8)
        canvas.upright(x1 + 8 / canvas.scale, y0, y1, metres(y1 - y0))


def names(canvas, section, case, composite):
    for name in section.regions:
        if canvas.width < NARROW and case.get("regions", {}).get(name, {}).get("kind") == "water":
            continue
        x0, x1, y0, y1 = section.box(name)
        x0, x1 = max(x0, canvas.x0), min(x1, canvas.x1)
        low = composite and name in ("seabed", "subsoil")
        share = 0.3 if low else 0.62 if name == "caisson" else 0.45 if composite else 0.2
        canvas.text((x0 + x1) / 2, y0 + share * (y1 - y0), named(name), class_="name")


def probes(canvas, case):
    """Probes are numbered, as their names would cover the section; the caption has the names."""
    for number, probe in enumerate(case.get("probes", {}).values(), 1):
        px, py = canvas.at(*probe["at"])
        canvas.line((px - 4, py), (px + 4, py), "probe")
        canvas.line((px, py - 4), (px, py + 4), "probe")
        canvas.text(*probe["at"], str(number), dx=8, dy=-3, class_="note small")


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
            heights.setdefault(round(arm, 6), []).append(name)
    for arm, together in heights.items():
        px, py = canvas.at(x0, bottom + arm)
        canvas.arrow((px - 64, py), (px, py))
        canvas.text(x0, bottom + arm, ", ".join(together), anchor="end", dx=-14, dy=-7, class_="note loadname")
        canvas.upright(x0 - 22 / canvas.scale, bottom, bottom + arm, metres(arm), side=-1)


def downward(canvas, section, case):
    """A load on the top of a section without a caisson."""
    x0, x1, _, top = section.box()
    on_top = [name for name, load in acting(case).items() if load.get("boundary") == "top"]
    if on_top:
        px, py = canvas.at((x0 + x1) / 2, top)
        canvas.arrow((px, py - 26), (px, py))
        canvas.text((x0 + x1) / 2, top, ", ".join(on_top), anchor="start", dx=8, dy=-12, class_="note loadname")
