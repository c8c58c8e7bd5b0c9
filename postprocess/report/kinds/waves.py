"""The document of waves on a section: pressures and forces by Goda's formulas, safety and sliding of each wave."""

from report.canvas import Canvas
from report.drawing import metres
from report.figure import of_drawing
from report.head import card
from report.kinds.frame import result_section
from report.language import heads, phrase, say, spaced
from report.markup import Markup, join, table, tag, text
from report.units import plain, quantity

KIND = "Report of wave forces by upbead"
QUESTION = "Which pressures and forces do these waves bring to the caisson, and does it hold?"
MOST_DRAWN = 4
SLOPE = 2.0  # of the mound in the drawing


def verdict(summary):
    waves = summary["waves"]
    sliding = min(waves, key=lambda name: waves[name]["safety_sliding"])
    turning = min(waves, key=lambda name: waves[name]["safety_overturning"])
    words = [verdict_of("sliding", sliding, waves[sliding]["safety_sliding"]), verdict_of("overturning", turning, waves[turning]["safety_overturning"])]
    worst = max(waves, key=lambda name: waves[name]["sliding_exact"] or 0.0)
    distance = waves[worst]["sliding_exact"]
    if distance:
        words.append(phrase("The wave {name} slides it about {distance} by eqs. (4) and (6).", name=spaced(worst), distance=quantity(distance, "m", digits=3)))
    words.append(say("These are formulas: neither the ground nor the course of a measured wave is in them."))
    largest = max(waves, key=lambda name: waves[name]["force"])
    cards = [
        card(phrase("largest force $P$"), quantity(waves[largest]["force"], "N/m"), spaced(largest)),
        card(say("least safety against sliding"), quantity(waves[sliding]["safety_sliding"], digits=3), spaced(sliding)),
        card(say("least safety against overturning"), quantity(waves[turning]["safety_overturning"], digits=3), spaced(turning)),
    ]
    return words, cards


def verdict_of(what, name, safety):
    words = {
        ("sliding", True): "The caisson holds against sliding: the least safety factor is {safety}, in the wave {name}.",
        ("sliding", False): "The caisson does not hold against sliding: the safety factor is {safety} in the wave {name}.",
        ("overturning", True): "It holds against overturning: the least safety factor is {safety}, in the wave {name}.",
        ("overturning", False): "It does not hold against overturning: the safety factor is {safety} in the wave {name}.",
    }
    told = phrase(words[what, safety >= 1], safety=quantity(safety, digits=3), name=spaced(name))
    return told if safety >= 1 else tag("strong", told, class_="fails")


def sections(summary):
    waves = summary["waves"]
    return [
        result_section("Section and pressures", "section", *(drawn(summary["section"], name, waves[name]) for name in list(waves)[:MOST_DRAWN])),
        result_section("Loads", "loads", pressures(waves)),
        result_section("Checks", "sheet", checks(waves)),
    ]


def pressures(waves):
    keys = (("H", "height", "m"), ("T", "period", "s"), ("alpha*", "alpha_star", ""), ("$p_1$", "p1", "Pa"), ("$p_3$", "p3", "Pa"),
            ("$p_4$", "p4", "Pa"), ("$p_u$", "pu", "Pa"), ("P", "force", "N/m"), ("$M_P$", "force_moment", "N m/m"), ("U", "uplift", "N/m"))  # fmt: skip
    return beside({phrase(sign): [quantity(wave[key], unit) for wave in waves.values()] for sign, key, unit in keys}, waves)


def checks(waves):
    rows = {
        say("safety, sliding"): [quantity(wave["safety_sliding"], digits=3) for wave in waves.values()],
        say("safety, overturning"): [quantity(wave["safety_overturning"], digits=3) for wave in waves.values()],
        say("heel pressure"): [heel(wave["heel_pressure"]) for wave in waves.values()],
    }
    for sign, key, unit in (("$τ_0$", "tau_0", "s"), ("$S$, eq. (7)", "sliding_paper", "m"), ("$S$, eqs. (4), (6)", "sliding_exact", "m"),
                            ("$S$, combined (1998)", "sliding_combined", "m")):  # fmt: skip
        rows[phrase(sign)] = [quantity(wave[key], unit) for wave in waves.values()]
    return beside(rows, waves)


def beside(rows, waves):
    """A column for each wave; if there are many, a row for each."""
    names = [Markup(text(spaced(name))) for name in waves]
    if len(names) <= MOST_DRAWN:
        return table(heads("quantity", *names), [(name, *cells) for name, cells in rows.items()], "numbers")
    return table(heads("wave", *map(Markup, rows)), list(zip(names, *rows.values())), "numbers")


def heel(value):
    """The heel pressure; a negative value has no meaning, as the resultant is then outside the bottom."""
    return quantity(value, "Pa") if value is not None and value >= 0 else Markup(say("none: the resultant leaves the base"))


def drawn(section, name, wave):
    caption = phrase(
        "{name}: $H$ = {height}, $T$ = {period}, α* = {alpha}. Pressures on the wall and under the bottom; dashed: without $α_I$. The slopes of the "
        "mound are drawn 1 : 2, as the formulas do not know them.",
        name=spaced(name),
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
    canvas = Canvas((min(toe, -0.9 * (base + crest)) - 1, B + back + SLOPE * (h - base) + 1, min(-h, -base - reach * wave["pu"]), crest), width, (8, 8, 30, 12))
    canvas.add(canvas.loop([(canvas.x0, -h), (canvas.x0, 0), (0, 0), (0, -h)], "area water"))
    mound = [(toe, -h), (-front, -berm), (0, -berm), (0, -base), (B, -base), (B + back, -base), (B + back + SLOPE * (h - base), -h)]
    canvas.add(canvas.loop(mound, "area rubble"), canvas.loop([(0, -base), (0, crest), (B, crest), (B, -base)], "area rigid"))
    top = min(wave["eta_star"], crest)
    canvas.add(outline(canvas, wall(wave, top, base, reach), "pressure"))
    canvas.add(outline(canvas, wall(wave["without_alpha_I"], top, base, reach), "pressure other"))
    canvas.add(outline(canvas, [(0, -base), (B, -base), (0, -base - reach * wave["pu"])], "pressure"))
    values(canvas, wave, top, base, reach, crest, B)
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


def values(canvas, wave, top, base, reach, crest, section_width):
    """The numbers at the corners of the diagram."""
    for key, y, dy in (("p4", top, -5), ("p1", 0.0, -5), ("p3", -base, 12)):
        canvas.text(-reach * wave[key], y, *named_value(key, wave), anchor="end", dx=-4, dy=dy)
    canvas.text(section_width / 2, -base - reach * wave["pu"] / 2, *named_value("pu", wave), anchor="start", dx=6, dy=14)
    if top < wave["eta_star"] and crest == top:
        canvas.text(0.0, top, say("overtopped"), anchor="start", dx=6, dy=14, class_="note small")
