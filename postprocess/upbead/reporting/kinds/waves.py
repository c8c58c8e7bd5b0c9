"""The document of waves on a section: pressures and forces by Goda's formulas, safety and sliding of each wave."""

from .. import numbers
from ..canvas import Canvas
from ..drawing import NARROW, metres
from ..figure import of_drawing
from ..head import card
from .frame import result_section
from ..language import as_written, listed, phrase, say
from ..markup import join, tag
from ..units import plain, quantity

COMMAND = "waves"
KIND = "Report of wave forces by upbead"
QUESTION = "Which pressures and forces do these waves bring to the caisson, and does it hold?"
MOST_DRAWN = 4
SLOPE = 2.0  # of the mound in the drawing
BED = 0.12  # of the wall's height: the ground that is drawn below the mound


def verdict(summary):
    waves = summary["waves"]
    sliding, turning = least(waves, "safety_sliding"), least(waves, "safety_overturning")
    words = [verdict_of("sliding", *sliding), verdict_of("overturning", *turning)]
    distance, where = largest(waves, "sliding_exact")
    if distance:
        words.append(phrase("The wave {name} slides it about {distance} by eqs. (4) and (6).", name=where, distance=quantity(distance, "m", digits=3)))
    words.append(say("These are formulas: neither the ground nor the course of a measured wave is in them."))
    force, wave = largest(waves, "force")
    cards = [
        card(phrase("largest force $P$"), quantity(force, "N/m"), wave),
        card(say("least safety against sliding"), quantity(sliding[0], digits=3), sliding[1]),
        card(say("least safety against overturning"), quantity(turning[0], digits=3), turning[1]),
    ]
    return words, cards


def least(waves, key):
    """(the least value of a key, whose it is) over all waves, levels, crests and troughs."""
    return min(values(waves, key))


def largest(waves, key):
    return max(values(waves, key))


def values(waves, key):
    found = []
    for name, wave in waves.items():
        for path, value in numbers.leaves({part: inner for part, inner in wave.items() if part != "governing"}):
            if path[-1] in (key, f"trough_{key}") and "without_alpha_I" not in path and isinstance(value, (int, float)):
                found.append((value, whose(name, path)))
    return found or [(None, "")]


def whose(name, path):
    """The wave, its level, and whether it is the standing wave and its trough."""
    place = [as_written(path[path.index("levels") + 1])] if "levels" in path else []
    place += [say("standing wave")] if "standing" in path else []
    place += [say("its trough")] if path[-1].startswith("trough") else []
    return listed([as_written(name), *place])


def verdict_of(what, safety, name):
    words = {
        ("sliding", True): "The caisson holds against sliding: the least safety factor is {safety}, in the wave {name}.",
        ("sliding", False): "The caisson does not hold against sliding: the safety factor is {safety} in the wave {name}.",
        ("overturning", True): "It holds against overturning: the least safety factor is {safety}, in the wave {name}.",
        ("overturning", False): "It does not hold against overturning: the safety factor is {safety} in the wave {name}.",
    }
    if safety is None:
        return ""
    told = phrase(words[what, safety >= 1], safety=quantity(safety, digits=3), name=name)
    return told if safety >= 1 else tag("strong", told, class_="fails")


def sections(summary):
    return [
        result_section("Section and pressures", "section", *(drawn(*one) for one in shown(summary)[:MOST_DRAWN])),
        result_section("Loads and safety", "loads", *tables(summary["waves"])),
    ]


def at_levels(wave):
    """[(level, the wave there)], the one with the least safety against sliding first; without levels the wave alone."""
    levels = (wave.get("levels") or {}).items()
    return sorted(levels, key=lambda pair: pair[1]["safety_sliding"]) or [("", wave)]


def shown(summary):
    """[(section, name, wave)], each wave at the level that governs its sliding."""
    found = []
    for name, wave in summary["waves"].items():
        level, there = at_levels(wave)[0]
        found.append((there.get("section", summary["section"]), f"{name} at {level}" if level else name, there))
    return found


def tables(waves):
    """All numbers: the waves side by side, or where there are levels a table of them for each wave."""
    if not any(wave.get("levels") for wave in waves.values()):
        return [numbers.beside(waves, ("waves", "NAME"), COMMAND)]
    parts = []
    for name, wave in waves.items():
        parts += [tag("h3", as_written(name)), numbers.beside(dict(at_levels(wave)), ("waves", "NAME", "levels", "LEVEL"), COMMAND),
                  numbers.alone(wave.get("governing"), ("waves", "NAME", "governing"), COMMAND)]  # fmt: skip
    return parts


def drawn(section, name, wave):
    caption = phrase(
        "{name}: $H$ = {height}, $T$ = {period}, α* = {alpha}. Pressures on the wall and under the bottom; dashed: without $α_I$. The slopes of the "
        "mound are drawn 1 : 2, as the formulas do not know them.",
        name=as_written(name),
        height=quantity(wave["height"], "m", digits=3),
        period=quantity(wave["period"], "s", digits=3),
        alpha=quantity(wave["alpha_star"], digits=3),
    )
    pictures = join(drawing(section, wave, width, class_) for width, class_ in ((860, "wide"), (380, "narrow")))
    return of_drawing(f"pressures-{name}", pictures, caption)


def drawing(section, wave, width, class_):
    """The diagram of pressures; the wall is at x = 0, still water at y = 0."""
    h, base, berm, crest, B = (section[key] for key in ("water_depth", "foundation_depth", "berm_depth", "crest", "width"))
    reach = 0.7 * (base + crest) / max(wave["p1"], wave["p3"], wave["p4"], wave["pu"])  # m per Pa
    front, back = section["berm_width"], 0.5 * B
    toe = -front - SLOPE * (h - berm)
    low = min(-h - BED * (base + crest), -base - reach * wave["pu"] - BED * (base + crest))
    window = (min(toe, -0.75 * (base + crest)) - 1, B + back + SLOPE * (h - base) + 1, low, crest)
    canvas = Canvas(window, width, (70 if width > NARROW else 64, 8, 30, 8), "pressures")
    for x0, x1 in ((canvas.x0, 0), (B, canvas.x1)):
        canvas.add(canvas.loop([(x0, -h), (x0, 0), (x1, 0), (x1, -h)], "area water"))
    mound = [(toe, -h), (-front, -berm), (0, -berm), (0, -base), (B, -base), (B + back, -base), (B + back + SLOPE * (h - base), -h)]
    canvas.add(canvas.loop([(canvas.x0, -h), (canvas.x1, -h), (canvas.x1, low), (canvas.x0, low)], "area sand0"))
    canvas.add(canvas.loop(mound, "area rubble0"), canvas.loop([(0, -base), (0, crest), (B, crest), (B, -base)], "area rigid"))
    canvas.level(B + 0.6 * (canvas.x1 - B), 0.0)
    top = min(wave["eta_star"], crest)
    canvas.add(outline(canvas, wall(wave, top, base, reach), "pressure"))
    canvas.add(outline(canvas, wall(wave["without_alpha_I"], top, base, reach), "pressure other"))
    canvas.add(outline(canvas, [(0, -base), (B, -base), (0, -base - reach * wave["pu"])], "pressure"))
    corners(canvas, wave, top, base, reach, crest)
    canvas.across(0, B, crest, metres(B), -10)
    canvas.upright(B + 0.6, -base, crest, metres(base + crest))
    return canvas.svg(say("pressures of the wave on the section"), class_)


def wall(p, top, base, reach):
    return [(0, -base), (-reach * p["p3"], -base), (-reach * p["p1"], 0), (-reach * p["p4"], top), (0, top)]


def outline(canvas, points, class_):
    return tag("polygon", points=" ".join("{:.1f},{:.1f}".format(*canvas.at(*point)) for point in points), class_=class_)


def named_value(key, wave):
    """p with the subscript 1 for "p1", and its value."""
    number = f" = {plain(wave[key] / 1e3, 3)} kPa"
    return tag("tspan", key[0], class_="i"), tag("tspan", key[1], class_="sub", dy=3), tag("tspan", number, dy=-3)


def corners(canvas, wave, top, base, reach, crest):
    """The numbers at the corners of the diagram."""
    for key, y, dy in (("p4", top, -5), ("p1", 0.0, -5), ("p3", -base, 12)):
        px, py = canvas.at(-reach * wave[key], y)
        words = join(named_value(key, wave))
        canvas.label(words, [(px - 4, py + dy - 4, "end"), (px - 4, py - 12, "end"), (px - 4, py + 14, "end"), (px, py - 12, "middle")])
    px, py = canvas.at(0, -base - reach * wave["pu"])
    canvas.label(join(named_value("pu", wave)), [(px + 8, py - 4, "start"), (px - 8, py - 6, "end"), (px + 8, py + 8, "start")])
    if top < wave["eta_star"] and crest == top:
        canvas.text(0.0, top, say("overtopped"), anchor="start", dx=6, dy=14, class_="note small")
