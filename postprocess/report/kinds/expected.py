"""The document of a life: the sliding distance by the waves of a record, and its uncertainty."""

import numpy as np

from report import figure
from report.head import card
from report.kinds.frame import result_section
from report.language import heads, phrase, say
from report.markup import Markup, join, prose, table, tag
from report.measures import at
from report.plot import Line, Panel, Plot
from report.units import percent, quantity

KIND = "Report of an expected sliding distance by upbead"
QUESTION = "How far do the waves of these sea states slide the caisson over the years?"
LAWS = {  # best first
    "dynamic": "the caisson's own dynamics",
    "exact": "eqs. (4) and (6), integrated",
    "combined": "pulse beside a standing wave (1998)",
    "paper": "eq. (7) of the paper",
}
COLOURS = {"paper": 0, "exact": 4, "combined": 1, "dynamic": 2}
BINS = 40


def verdict(result):
    expected, lives = result.summary.get("expected"), result.summary.get("monte_carlo")
    words, cards = [], []
    if expected:
        law, distance = chosen(expected)
        words.append(sentence_of(expected, law, distance))
        words.append(between_laws(expected))
        words += overturning(expected)
        cards.append(card(phrase("expected sliding $E(S)$"), quantity(distance, "m", digits=3), say(LAWS[law]) if law else ""))
        slide = (expected.get("waves_that_slide") or {}).get(law)
        if slide is not None:
            years = say("in {years} years", years=f"{expected['years']:g}")
            cards.append(card(say("waves that slide the caisson"), quantity(slide, digits=3), years))
    if lives:
        words.append(of_lives(lives))
        cards.append(card(say("95 % of the lives stay below"), quantity(at(lives, "quantiles").get("0.95"), "m", digits=3), span(lives)))
    if expected:
        words.append(limit(expected["limit"]))
    return words, cards


def chosen(expected):
    """The most detailed law that the results have, and its distance."""
    return next(((law, expected[f"distance_{law}"]) for law in LAWS if expected.get(f"distance_{law}") is not None), (None, None))


def sentence_of(expected, law, distance):
    if distance is None:
        return say("The run tells no expected sliding distance.")
    words = "In {years} years the waves of the record are expected to slide the caisson about {distance}, by this law: {law}."
    return phrase(words, years=f"{expected['years']:g}", distance=quantity(distance, "m", digits=3), law=say(LAWS[law]))


def between_laws(expected):
    values = [expected[f"distance_{law}"] for law in LAWS if expected.get(f"distance_{law}") is not None]
    if len(values) < 2 or not max(values) > 0:
        return ""
    low, high = quantity(min(values), "m", digits=3), quantity(max(values), "m", digits=3)
    return phrase("Other laws say from {low} to {high}: no number is surer than that.", low=low, high=high)


def overturning(expected):
    """Sentences on tilting: if the caisson would overturn, its sliding does not matter."""
    margin = at(expected, "base.goda.least_overturning_margin")
    if margin is None or margin >= 1:
        return []
    words = "By formulas the highest wave overturns the caisson (margin {margin}): its sliding distance alone does not tell its fate."
    return [tag("strong", phrase(words, margin=quantity(margin, digits=3)), class_="fails")]


def limit(kind):
    words = {
        "breaking": "Waves above Goda's highest random breaker break, and arrive with its height.",
        "cut": "Waves above a height that the case gives are set aside.",
        "none": "The heights of the waves have no limit here: where the depth breaks them, the numbers are too large.",
    }
    return say(words[kind]) if kind in words else ""


def of_lives(lives):
    low, high = (quantity(end, "m", digits=3) for end in lives["confidence_interval"])
    words = "The mean of {count} lives drawn at random, of {years} years each, is {mean} (95 % interval {low} to {high})."
    return phrase(words, count=f"{lives['lives']:,}", years=f"{lives['years']:g}", low=low, high=high,
                  mean=quantity(lives["mean"], "m", digits=3))  # fmt: skip


def span(lives):
    return say("of {count} lives of {years} years", count=f"{lives['lives']:,}", years=f"{lives['years']:g}")


def sections(result):
    expected, lives = result.summary.get("expected"), result.summary.get("monte_carlo")
    return [
        result_section("Sea states", "loads", states(expected), exceedance(result.summary)),
        result_section("Response", "response-section", by_height(result)),
        result_section("Expected sliding by every law", "sliding", laws(expected)),
        result_section("Lives", "lives", quantiles(lives), beyond(lives)),
        result_section("Checks", "sheet", base(expected)),
    ]


def states(expected):
    rows = [
        (str(number), quantity(state["significant_height"], "m"), quantity(state["period"], "s"), quantity(state["waves"]),
         quantity(state["highest_breaker"], "m"), *(quantity(state["distance"].get(law), "m") for law in LAWS))
        for number, state in enumerate((expected or {}).get("states") or [], 1)
    ]  # fmt: skip
    head = heads("sea state", "$H_1/3$", "$T$", "waves", "highest breaker", *(f"E(S), {law}" for law in LAWS))
    return table(head, rows[:60], "numbers") if rows else ""


def exceedance(summary):
    rows = [(name, quantity(found["height"], "m"), quantity(found["waves"])) for name, found in (summary.get("exceedance") or {}).items()]
    return table(heads("height", "H", "waves above it"), rows, "numbers") if rows else ""


def by_height(result):
    """Waves, S of one wave and expected sliding over the height, from the height on at which waves slide the
    caisson."""
    sets = (("waves a metre of height", "1/m", {"": result.waves}), ("sliding distance of one wave", "m", result.distance),
            ("expected sliding a metre of height", "", result.contribution))  # fmt: skip
    thresholds, panels = result.thresholds(), []
    shown = result.height >= 0.85 * min(thresholds, default=0.0)
    for title, unit, found in sets:
        lines = [
            Line(say(law) if law else " ", result.height[shown], np.asarray(values, dtype=float)[shown], COLOURS.get(law, 3))
            for law, values in found.items()
            if np.any(values[shown])
        ]
        if lines:
            panels.append(Panel(unit, lines, height=140, title=say(title)))
    if not panels:
        return ""
    plot = Plot("heights", panels, axis=("wave height", "m"))
    return figure.of_plot(plot, say("Over the height of the waves: how many come, how far one slides the caisson, and which heights bring the sliding."))


def laws(expected):
    if not expected:
        return ""
    rows = [
        (join([say(what), " ", tag("code", law)]), quantity(expected[f"distance_{law}"], "m"), quantity(at(expected, f"threshold_height.{law}"), "m"),
         quantity(at(expected, f"waves_that_slide.{law}")), quantity(at(expected, f"error_estimate.{law}"), "m"))
        for law, what in LAWS.items()
        if expected.get(f"distance_{law}") is not None
    ]  # fmt: skip
    return table(heads("law", "$E(S)$", "slides from H", "waves that slide", "error of the quadrature"), rows, "numbers")


def quantiles(lives):
    if not lives:
        return ""
    rows = [(percent(float(share)), quantity(value, "m")) for share, value in lives["quantiles"].items()]
    return table(heads("share of the lives", "$S$ not above"), rows, "numbers")


def beyond(lives):
    if not lives or not lives.get("probability"):
        return ""
    rows = []
    for bound, found in lives["probability"].items():
        between = join([percent(end) for end in found["confidence_interval"]], " – ")
        rows.append((quantity(float(bound), "m"), percent(found["value"]), between))
    return table(heads("$S$ above", "probability", "95 % interval"), rows, "numbers")


def base(expected):
    """Edge pressures under the highest wave."""
    found = at(expected or {}, "base.goda")
    if not found:
        return ""
    rows = [
        (say("heel pressure"), pressure(found["peak_heel_pressure"])),
        (say("toe pressure"), pressure(found["peak_toe_pressure"])),
        (say("eccentricity"), quantity(found["largest_eccentricity"], "m")),
        (say("margin against overturning"), quantity(found["least_overturning_margin"])),
    ]
    height = phrase("In the highest wave of the worst sea state, {height} high, by Goda's formulas:", height=quantity(expected["base"]["height"], "m"))
    return join([tag("p", height), table(heads("check", "demand"), rows, "numbers")])


def pressure(value):
    return Markup(prose(say("none: the resultant leaves the base"))) if value is None else quantity(value, "Pa")
