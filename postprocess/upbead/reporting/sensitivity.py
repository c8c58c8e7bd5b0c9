"""Sensitivity of the result as far as the run shows it: S by eq. (4) for other friction and weight, other uplift."""

import numpy as np

from . import friction
from .language import heads, phrase, say
from .markup import Markup, prose, table, tag
from .measures import at
from .units import quantity
from ..live.scene import of_same_scene

SHARE = 0.1
SAME = 1e-3  # relative: accuracy of F_T between the times of the file
FINER = 8  # times as many
MOST_ROWS = 5000  # up to this number of times cubics are used
MOST = 100_000  # times; with more, this would take too long


def section(result):
    sliding = result.summary.get("sliding") or {}
    parts = [part for part in (varied(result, sliding), threshold(sliding), courses(sliding), pointer(result)) if part]
    return tag("section", tag("h2", say("Sensitivity")), *parts, id="sensitivity") if parts else Markup("")


def varied(result, sliding):
    """S by eq. (4) with mu and W' a tenth less and more; empty if eq. (4) does not give the S of the summary here."""
    uplift = uplift_of(result, sliding)
    if uplift is None or result.time.size > MOST or sliding.get("drag") or sliding.get("sliding_history") is None:
        return ""
    nominal = slip_of(result, sliding, uplift, 1.0, 1.0)
    if abs(nominal - sliding["sliding_history"]) > SAME * max(abs(sliding["sliding_history"]), 1e-3):
        return ""
    shares = (1.0 - SHARE, 1.0, 1.0 + SHARE)
    cases = (("friction coefficient $μ$", [(s, 1.0) for s in shares]), ("submerged weight $W′$, mass as it is", [(1.0, s) for s in shares]))
    rows = [
        (phrase(what), *(cell(result, sliding, uplift, pair) for pair in pairs))
        for what, pairs in cases
    ]
    told = phrase(
        "$S$ by eq. (4) on the shear force of the bonded caisson, worked out again for this page; as given it is that of the "
        "run. Slip on the shaken ground is not worked out again."
    )
    return tag("div", tag("p", told), table(heads("varied", "−10 %", "as given", "+10 %"), rows, "numbers"))


def cell(result, sliding, uplift, pair):
    if pair == (1.0, 1.0):
        return quantity(sliding["sliding_history"], "m")
    value = slip_of(result, sliding, uplift, *pair)
    return quantity(float(f"{value:.4g}"), "m")


def slip_of(result, sliding, uplift, friction_share, weight_share):
    mu, weight = friction_share * sliding["friction"], weight_share * sliding["submerged_weight"]
    time, force = np.asarray(result.time, dtype=float), np.asarray(result.history("shear_force"), dtype=float)
    resistance = mu * np.maximum(weight - uplift, 0.0)
    if np.all(np.abs(force) < 0.99 * resistance):
        return 0.0
    return friction.slip(sliding["weight"] / result.case.get("gravity", 9.81), *finer(time, force, resistance))


def finer(time, force, resistance):
    """Between its times F_T is smooth, not straight: with cubics S agrees with that of the program."""
    if time.size > MOST_ROWS:
        return time, force, resistance
    dense = np.interp(np.arange(FINER * (time.size - 1) + 1) / FINER, np.arange(time.size), time)
    return dense, hermite(time, force, dense), np.interp(dense, time, resistance)


def hermite(time, value, at):
    """Cubics through the values; the slopes where they meet are of second order."""
    slope = np.gradient(value, time)
    i = np.clip(np.searchsorted(time, at, side="right") - 1, 0, time.size - 2)
    h = time[i + 1] - time[i]
    s = (at - time[i]) / h
    left = (1 + 2 * s) * value[i] + s * h * slope[i]
    right = (3 - 2 * s) * value[i + 1] + (s - 1) * h * slope[i + 1]
    return (1 - s) ** 2 * left + s**2 * right


def uplift_of(result, sliding):
    """U over time, if the run and its case determine it; else None."""
    kind, keys = sliding.get("uplift"), at(result.case, "sliding.uplift") or {}
    if not result.has_caisson or kind is None:
        return None
    force = np.asarray(result.history("force"), dtype=float)
    if kind == "none":
        return np.zeros_like(force)
    if kind == "computed" and "uplift" in result:
        return np.asarray(result.history("uplift"), dtype=float)
    shape, peak = keys.get("shape"), keys.get("peak")
    if kind == "prescribed" and isinstance(peak, (int, float)) and not keys.get("lag") and force.max() > 0:
        course = np.maximum(force, 0.0) / force.max()
        if shape == "held":
            course[int(np.argmax(force)) :] = 1.0
        return peak * course if shape in ("held", "in_phase") else None
    return None


def threshold(sliding):
    ratio, mu = sliding.get("ratio"), sliding.get("friction")
    if not ratio or not mu or sliding.get("uplift") != "none":
        return ""
    words = phrase("A rigid block under this shear force would slide with a friction coefficient below {mu}.", mu=quantity(mu * ratio))
    return tag("p", words)


def courses(sliding):
    """Effect of the assumed history of the uplift."""
    found = sliding.get("uplift_courses")
    if not found:
        return ""
    rows = [(prose(say("uplift held at its peak")), quantity(found["held"], "m")), (say("uplift in phase with the wave's force"), quantity(found["in_phase"], "m"))]
    return table(heads("course of the uplift", "$S$ by eq. (4)"), rows, "numbers")


def pointer(result):
    if not of_same_scene(result.folder / "reduced.h5", result.case):
        return ""
    return tag("p", phrase("Other waves, friction, weight and uplift are answered at once under “{title}” on the screen.", title=say("What if")))
