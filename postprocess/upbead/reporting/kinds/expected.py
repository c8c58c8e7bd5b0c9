"""The document of a life: the sliding distance by the waves of a record, and its uncertainty."""

import numpy as np

from .. import figure, numbers
from ..head import card
from .frame import result_section
from ..language import heads, phrase, say, sentences, told
from ..markup import join, prose, table, tag
from ..measures import at
from ..plot import Line, Panel, Plot
from ..units import percent, quantity
from ... import outputs

COMMAND = "expected"
ROUTES = ("by_formulas", "by_dynamics")
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
    routes = routes_of(lives)
    words += [of_lives(found) for found in routes]
    words += [of_base(found) for found in routes]
    if routes:
        words.append(headline_of(lives))
        cards.append(card(say("mean sliding distance of a life"), quantity(routes[0].get("mean"), "m", digits=3), say(LAWS.get(routes[0].get("law"), ""))))
        cards.append(card(say("95 % of the lives stay below"), quantity(at(routes[0], "quantiles").get("0.95"), "m", digits=3), span(routes[0])))
    words.append(limit((expected or lives or {}).get("limit")))
    return words, cards


def chosen(expected):
    """The law of the headline and its distance: the program's, else the largest, as no law is surer than another."""
    head = expected.get("headline")
    if head:
        return head.get("law"), head.get("value")
    found = [(expected[f"distance_{law}"], law) for law in LAWS if expected.get(f"distance_{law}") is not None]
    return max(found)[::-1] if found else (None, None)


def routes_of(lives):
    """The lives of every route that was gone, by formulas and by own dynamics: the one with the largest mean first."""
    if not lives:
        return []
    asked = {key: lives[key] for key in ("lives", "years", "seed", "limit") if key in lives}  # the same for all
    found = [lives, *({**asked, **lives[route]} for route in ROUTES if lives.get(route))]
    return sorted(found, key=lambda one: -(one.get("mean") or 0.0))


def headline_of(lives):
    why = (lives.get("headline") or {}).get("why")
    return prose(told(why[:1].upper() + why[1:].rstrip(".") + ".")) if why else ""


def of_base(lives):
    """Sentences on how many lives go beyond the limits of pressure and margin."""
    parts = []
    for key, found in (lives.get("base") or {}).items():
        if isinstance(found, dict) and (found.get("probability") or 0) > 0:
            words = "In {share} of the lives the {what} goes beyond its limit of {limit}, by this law: {law}."
            bound = quantity(found["limit"], outputs.unit(("monte_carlo", "base", key, "limit"), COMMAND))
            beyond = phrase(words, share=percent(found["probability"]), what=told(key.replace("_", " ")), limit=bound, law=say(LAWS.get(lives.get("law"), "")))
            parts.append(tag("strong", beyond, class_="fails"))
    return sentences(parts)


def sentence_of(expected, law, distance):
    if distance is None:
        return say("The run tells no expected sliding distance.")
    words = "In {years} years the waves of the record are expected to slide the caisson about {distance}, by this law: {law}."
    return phrase(words, years=f"{expected['years']:g}", distance=quantity(distance, "m", digits=3), law=say(LAWS.get(law, law or "")))


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
    if lives.get("mean") is None:
        return ""
    low, high = (quantity(end, "m", digits=3) for end in lives["confidence_interval"])
    words = "The mean of {count} lives drawn at random, of {years} years each, is {mean} (95 % interval {low} to {high}), by this law: {law}."
    return phrase(words, count=f"{lives['lives']:,}", years=f"{lives['years']:g}", low=low, high=high,
                  mean=quantity(lives["mean"], "m", digits=3), law=say(LAWS.get(lives.get("law"), lives.get("law") or "")))  # fmt: skip


def span(lives):
    return say("of {count} lives of {years} years", count=f"{lives['lives']:,}", years=f"{lives['years']:g}")


def sections(result):
    expected, lives = result.summary.get("expected"), result.summary.get("monte_carlo")
    return [
        result_section("Sea states", "loads", states(expected), exceedance(result.summary)),
        result_section("Response", "response-section", by_height(result)),
        result_section("Expected sliding by every law", "sliding", laws(expected)),
        result_section("Base in the highest wave", "base-section", numbers.alone((expected or {}).get("base"), ("expected", "base"), COMMAND)),
        result_section("Lives", "lives", by_life(result), *(of_route(found) for found in routes_of(lives))),
    ]


def of_route(lives):
    """All numbers of the lives by one law."""
    law = lives.get("law")
    return join([tag("h3", say(LAWS[law])) if law in LAWS else "", numbers.alone(lives, ("monte_carlo",), COMMAND, (*ROUTES, "headline"))])


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
            Line(say(law) if law else "", result.height[shown], np.asarray(values, dtype=float)[shown], COLOURS.get(law, 3))
            for law, values in found.items()
            if np.any(values[shown])
        ]
        if lines:
            panels.append(Panel(unit, lines, height=140, title=say(title)))
    if not panels:
        return ""
    plot = Plot("heights", panels, axis=("wave height", "m"))
    return figure.of_plot(plot, say("Over the height of the waves: how many come, how far one slides the caisson, and which heights bring the sliding."))


def by_life(result):
    """Share of the lives that slide at least so far; empty where none slides."""
    distance = np.sort(result.lives)
    if not distance.any():
        return ""
    line = Line(say("share of the lives"), np.repeat(distance, 2), np.repeat(1.0 - np.arange(distance.size + 1) / distance.size, 2)[1:-1], 2)
    plot = Plot("lives-plot", [Panel("", [line], height=170)], axis=(say("sliding distance of a life"), "m"))
    return figure.of_plot(plot, say("Share of the lives that slide at least so far."))


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
