"""The document of a calibration: k(alpha*) fitted to the dynamics of a caisson, compared with the given k."""

import numpy as np

from .. import figure
from ..head import card
from .frame import result_section
from ..language import heads, listed, phrase, say
from ..markup import Markup, join, table, tag
from ..plot import Line, Panel, Plot
from ..units import plain, quantity

COMMAND = "calibrate"
KIND = "Report of a calibration by upbead"
QUESTION = "Which k(alpha*) makes tau_0 = k tau_0F slide the caisson as far as its own dynamics do?"
MEASURE = "exact"
MEASURES = {
    "paper": "eq. (7)",
    "exact": "eqs. (4) and (6), integrated",
    "excess": "time above the resistance",
    "impulse": "impulse",
}
CURVE = 80  # points


def verdict(result):
    words, cards = [], []
    for name, model in result.models.items():
        best = model.get("recommended")
        if not best or best.get("a") is None:
            words.append(tag("strong", phrase("For {model} no fit is sure enough to be told.", model=name), class_="fails"))
            continue
        words.append(
            phrase(
                "For {model} the fit is $a$ = {a}, $b$ = {b}, by this measure: {measure}; $k$ scatters by {scatter} about it.",
                model=name,
                a=quantity(best["a"], digits=3),
                b=quantity(best["b"], digits=3),
                measure=say(MEASURES[best["measure"]]),
                scatter=quantity(best["residual_deviation"], digits=2),
            )
        )
        cards.append(card(name, join([phrase("$a$ = {a}", a=plain(best["a"], 3)), ", ", phrase("$b$ = {b}", b=plain(best["b"], 3))]), scatter_of(best)))
    words.append(given(result))
    words.append(say("Waves of a grid are no sample: the bands of the fits say how well a curve fits, and not how sure nature is of it."))
    return words, cards


def scatter_of(best):
    return phrase("$k$ scatters by {scatter}", scatter=quantity(best["residual_deviation"], digits=2))


def given(result):
    """A sentence on whether the given a and b are within the confidence ellipses of the fits."""
    fits = [fit for model in result.models.values() for fit in model["fits"] if fit["given_in_ellipse"] is not None]
    inside = sum(fit["given_in_ellipse"] for fit in fits)
    a, b = (quantity(float(result.given[key])) for key in ("a", "b"))
    return phrase("The given $a$ = {a}, $b$ = {b} lie within the 95 % ellipse of {inside} of {count} fits.", a=a, b=b, inside=inside, count=len(fits))


def sections(result):
    return [
        result_section("Waves", "loads", waves(result.summary)),
        *(of_model(result, name) for name in result.models),
    ]


def waves(summary):
    found = summary["waves"]
    left = listed(f"{reason.replace('_', ' ')}: {count}" for reason, count in (found.get("left_out") or {}).items())
    words = phrase("{taken} of the {grid} waves of the family can be.", taken=found["taken"], grid=found["grid"])
    return tag("p", join([words, " ", phrase("Left out: {left}.", left=left) if left else ""]))


def of_model(result, name):
    return result_section(
        "Calibrated and given", f"model-{name}", tag("h3", name), drawn(result, name), table_of(result, name)
    )


def factor(alpha, a, b):
    return (alpha**a + 1.0) ** -b


def drawn(result, name):
    """A panel per r: waves, the calibrated curve, and the given one."""
    panels = []
    for fit in result.fits(name, MEASURE):
        alpha, k, _ = result.points(name, fit["ratio"], MEASURE)
        if not len(alpha):
            continue
        x = np.linspace(0.0, float(alpha.max()), CURVE)
        lines = [Line(say("waves"), *by_x(alpha, k), 4, dots=True)]
        if fit["a"] is not None and fit["b"] is not None:
            lines.append(Line(say("calibrated"), x, factor(x, fit["a"], fit["b"]), 2))
        lines.append(Line(say("given"), x, factor(x, result.given["a"], result.given["b"]), 3, "--"))
        panels.append(Panel("", lines, height=150, title=f"r = {fit['ratio']:g}"))
    if not panels:
        return ""
    plot = Plot(f"fits-{name}", panels, axis=("α*", ""))
    caption = phrase(
        "$k$ = $τ_0$/$τ_0F$ over α* for each $r$ = $F_S$/$μ W′$, by {measure}: the waves, the curve fitted to them (calibrated), and "
        "the curve that the case gives (predicted).",
        measure=say(MEASURES[MEASURE]),
    )
    return figure.of_plot(plot, caption)


def by_x(x, y):
    order = np.argsort(x, kind="stable")
    return x[order], y[order]


def table_of(result, name):
    rows = []
    for fit in result.models[name]["fits"]:
        ratio = say("all") if fit["ratio"] is None else f"{fit['ratio']:g}"
        error = fit.get("standard_error") or {}
        rows.append(
            (
                say(MEASURES[fit["measure"]]),
                ratio,
                value(fit["a"], error.get("a")),
                value(fit["b"], error.get("b")),
                quantity(at_quality(fit, "quality", "deviation"), digits=3),
                quantity(at_quality(fit, "quality", "r_squared"), digits=2),
                quantity(at_quality(fit, "given", "deviation"), digits=3),
                "" if fit["doubt"] == "none" else fit["doubt"].replace("_", " "),
            )
        )
    head = heads("measure", "$r$", "$a$", "$b$", "deviation, calibrated", "R²", "deviation, given", "doubt")
    return table(head, rows, "numbers")


def at_quality(fit, part, key):
    return (fit.get(part) or {}).get(key)


def value(number, error):
    if number is None:
        return Markup(say("none"))
    return join([quantity(number, digits=3), f" ± {plain(error, 2)}" if error is not None else ""])
