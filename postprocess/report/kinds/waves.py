"""The document of waves on a section: pressures and forces by Goda's formulas, safety and sliding of each wave."""

from report.canvas import Canvas
from report.drawing import metres
from report.figure import of_drawing
from report.head import card
from report.kinds.frame import result_section
from report.language import heads, named, phrase, say
from report.markup import Markup, join, table, tag
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
        words.append(phrase("The wave {name} slides it about {distance} by eqs. (4) and (6).", name=named(worst), distance=quantity(distance, "m", digits=3)))
    words.append(say("These are formulas: neither the ground nor the course of a measured wave is in them."))
    largest = max(waves, key=lambda name: waves[name]["force"])
    cards = [
        card(phrase("largest force $P$"), quantity(waves[largest]["force"], "N/m"), named(largest)),
        card(say("least safety against sliding"), quantity(waves[sliding]["safety_sliding"], digits=3), named(sliding)),
        card(say("least safety against overturning"), quantity(waves[turning]["safety_overturning"], digits=3), named(turning)),
    ]
    return words, cards


def verdict_of(what, name, safety):
    words = {
        ("sliding", True): "The caisson holds against sliding: the least safety factor is {safety}, in the wave {name}.",
        ("sliding", False): "The caisson does not hold against sliding: the safety factor is {safety} in the wave {name}.",
        ("overturning", True): "It holds against overturning: the least safety factor is {safety}, in the wave {name}.",
        ("overturning", False): "It does not hold against overturning: the safety factor is {safety} in the wave {name}.",
    }
    told = phrase(words[what, safety >= 1], safety=quantity(safety, digits=3), name=named(name))
    return told if safety >= 1 else tag("strong", told, class_="fails")


def sections(summary):
    waves = summary["waves"]
    return [
        result_section("Section and pressures", "section", *(drawn(summary["section"], name, waves[name]) for name in list(waves)[:MOST_DRAWN])),
        result_section("Loads", "loads", pressures(waves)),
        result_section("Checks", "sheet", checks(waves)),
    ]


def pressures(waves):
    keys = (("height", "m"), ("period", "s"), ("alpha_star", ""), ("p1", "Pa"), ("p3", "Pa"), ("p4", "Pa"), ("pu", "Pa"), ("force", "N/m"),
            ("force_moment", "N m/m"), ("uplift", "N/m"))  # fmt: skip
    rows = [(named(name), *(quantity(wave[key], unit) for key, unit in keys)) for name, wave in waves.items()]
    return table(heads("wave", "H", "T", "alpha*", "$p_1$", "$p_3$", "$p_4$", "$p_u$", "P", "$M_P$", "U"), rows, "numbers")


def checks(waves):
    rows = [
        (named(name), quantity(wave["safety_sliding"], digits=3), quantity(wave["safety_overturning"], digits=3), heel(wave["heel_pressure"]),
         *(quantity(wave[key], unit) for key, unit in (("tau_0", "s"), ("sliding_paper", "m"), ("sliding_exact", "m"), ("sliding_combined", "m"))))
        for name, wave in waves.items()
    ]  # fmt: skip
    head = heads("wave", "safety, sliding", "safety, overturning", "heel pressure", "$τ_0$", "$S$, eq. (7)", "$S$, eqs. (4), (6)", "$S$, combined (1998)")
    return table(head, rows, "numbers")


def heel(value):
    """A negative one has no meaning: the resultant lies outside the base."""
    return quantity(value, "Pa") if value is not None and value >= 0 else Markup(say("none: the resultant leaves the base"))


def drawn(section, name, wave):
    caption = phrase(
        "{name}: $H$ = {height}, $T$ = {period}, α* = {alpha}. Pressures on the wall and under the bottom; dashed: without $α_I$. The slopes of the "
        "mound are drawn 1 : 2, as the formulas do not know them.",
        name=named(name),
        height=quantity(wave["height"], "m", digits=3),
        period=quantity(wave["period"], "s", digits=3),
        alpha=quantity(wave["alpha_star"], digits=3),
    )
    pictures = join(drawing(section, wave, width, class_) for width, class_ in ((860, "wide"), (380, "narrow")))
    return of_drawing(f"pressures-{name}", pictures, caption)


def drawing(section, wave, width, class_):
    """The wall at x = 0, still water at y = 0."""
    h, base, berm, crest, B = (section[key] for key in ("water_depth", "foundation_depth", "berm_depth", "crest", "width"))
    reach = 0.7 * (base + crest) / max(wave["p1"], wave["p3"], wave["p4"], wave["pu"])  # m per Pa
    front, back = section["berm_width"], 0.5 * B
    toe = -front - SLOPE * (h - berm)
    canvas = Canvas((min(toe, -0.9 * (base + crest)) - 1, B + back + SLOPE * (h - base) + 1, -h, crest), width, (8, 8, 30, 12))
    canvas.add(canvas.loop([(canvas.x0, -h), (canvas.x0, 0), (0, 0), (0, -h)], "area water"))
    mound = [(toe, -h), (-front, -berm), (0, -berm), (0, -base), (B, -base), (B + back, -base), (B + back + SLOPE * (h - base), -h)]
    canvas.add(canvas.loop(mound, "area rubble"), canvas.loop([(0, -base), (0, crest), (B, crest), (B, -base)], "area rigid"))
    top = min(wave["eta_star"], crest)
    canvas.add(outline(canvas, wall(wave, top, base, reach), "pressure"))
    canvas.add(outline(canvas, wall(wave["without_alpha_I"], top, base, reach), "pressure other"))
    canvas.add(outline(canvas, [(0, -base), (B, -base), (0, -base - reach * wave["pu"])], "pressure"))
    values(canvas, wave, top, base, reach, crest)
    canvas.across(0, B, crest, metres(B), -10)
    canvas.upright(B + 0.6, -base, crest, metres(base + crest))
    return canvas.svg(say("pressures of the wave on the section"), class_)


def wall(p, top, base, reach):
    return [(0, -base), (-reach * p["p3"], -base), (-reach * p["p1"], 0), (-reach * p["p4"], top), (0, top)]


def outline(canvas, points, class_):
    return tag("polygon", points=" ".join("{:.1f},{:.1f}".format(*canvas.at(*point)) for point in points), class_=class_)


def values(canvas, wave, top, base, reach, crest):
    """The numbers at the corners of the diagram."""
    for sign, key, y, dy in (("p₄", "p4", top, -5), ("p₁", "p1", 0.0, -5), ("p₃", "p3", -base, 12)):
        words = f"{sign} = {plain(wave[key] / 1e3, 3)} kPa"
        canvas.text(-reach * wave[key], y, words, anchor="end", dx=-4, dy=dy)
    canvas.text(0.0, -base - reach * wave["pu"], f"pᵤ = {plain(wave['pu'] / 1e3, 3)} kPa", anchor="start", dx=6, dy=0)
    if top < wave["eta_star"] and crest == top:
        canvas.text(0.0, top, say("overtopped"), anchor="start", dx=6, dy=14, class_="note small")
