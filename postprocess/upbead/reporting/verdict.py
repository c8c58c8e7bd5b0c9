"""The result of a run in plain sentences and three numbers, stated with no more certainty than the run has."""

from . import judged
from .head import card, trust
from .language import phrase, say, sentences, told
from .markup import Markup, prose, tag
from .measures import best
from .units import percent, quantity
from .. import told as told_of

WITHOUT_REST = (
    "Whether the caisson slides is not known: the ground has no state at rest, and what was computed from there, in the "
    "tables below, is not of a section that stands."
)


def section(result):
    summary = result.summary
    numbers = [
        judged.unreliable(summary) or tag("p", sentences([slides(result), carried(summary), shear(result)])),
        tag("p", rests_on(summary)),
        tag("div", *cards(result), class_="cards"),
    ]
    if summary.get("void"):
        numbers = [tag("p", say(WITHOUT_REST))]
    return tag(
        "section",
        tag("h2", say("Verdict")),
        judged.verdict(summary),
        *numbers,
        trust(len(told_of.warnings(summary)), *error_of_peak(summary)),
        id="verdict",
    )


def question(result):
    """The question that such a run answers, in one line."""
    if not result.has_caisson:
        return say("How does this section respond to its loads? It has no caisson, so there is no shear force to tell.")
    if result.summary.get("sliding"):
        return say(
            "How much of the wave's horizontal force reaches the caisson's bottom as shear force, and how far does the "
            "caisson slide?"
        )
    return say("How much of the wave's horizontal force reaches the caisson's bottom as shear force?")


def slides(result):
    """Whether the caisson slides and how far."""
    summary = result.summary
    if not result.has_caisson:
        return say("This section has no caisson: nothing is told of sliding.")
    measure, sliding = best(summary), summary.get("sliding") or {}
    if measure is None:
        return say("Whether the caisson slides was not asked of this run.")
    if measure.value == 0:
        ratio = sliding.get("ratio")
        if ratio is not None and ratio <= 1:
            ratio = percent(ratio)
            return phrase(
                "By this run the caisson does not slide: the largest sliding force is {ratio} of the friction that holds it.",
                ratio=ratio,
            )
        return say("By this run the caisson has not moved over its mound in the end.")
    way = say("landward") if measure.value > 0 else say("seaward")
    if not rests(summary):
        return phrase("By this run the caisson does not come to rest: it has slid {distance} {way} when the run ends, and slides on.",
                      distance=rounded(measure.value, "m"), way=way)  # fmt: skip
    if (why := not_all(summary)):
        return phrase("By this run the caisson slides at least {distance} {way}, and more is not known: {why}.",
                      distance=rounded(measure.value, "m"), way=way, why=prose(told(why)))  # fmt: skip
    return phrase("By this run the caisson slides about {distance} {way}.", distance=rounded(measure.value, "m"), way=way)


def rests(summary):
    """Whether S has a bound; results of older versions do not say."""
    return ((summary.get("sliding") or {}).get("design") or {}).get("rests", True)


def not_all(summary):
    """Why S is not the whole distance, though it has a bound; None where it is."""
    return ((summary.get("sliding") or {}).get("design") or {}).get("why_not_all")


def carried(summary):
    """How far ground that yields carries the caisson, which no S counts."""
    moved = summary.get("residual") if summary.get("nonlinear") else None
    if not moved or moved.get("displacement_x") is None:
        return ""
    way = say("landward") if moved["displacement_x"] >= 0 else say("seaward")
    return phrase("Ground that yields carries it {distance} {way}; it settles by {down} and tilts by {angle}.",
                  distance=rounded(moved["displacement_x"], "m"), way=way,
                  down=quantity(-moved["displacement_y"], "m", digits=3),
                  angle=quantity(moved["rotation"], "rad", digits=3))  # fmt: skip


def shear(result):
    """Peak F_T and its ratio to peak P; a missing number is mentioned."""
    response = result.summary.get("response") or {}
    if not result.has_caisson or response.get("peak_shear") is None:
        return "" if not result.has_caisson else say("The run tells no shear force.")
    key, _, force = larger_way(response)
    peak = phrase("The peak shear force at its bottom is about $F_T$ = {peak}", peak=rounded(response[key], "N/m"))
    ratio = response.get("shear_to_force_ratio")
    if ratio is None:
        return phrase("{peak}; it has no ratio to the wave's force, as there is no such force.", peak=peak)
    share = tag("data", f"{ratio:.3f}", value=repr(ratio))
    return phrase("{peak}, {ratio} of the wave's peak force $P$ = {force}.", peak=peak, ratio=share,
                  force=rounded(response[force], "N/m"))  # fmt: skip


def rounded(value, unit):
    """The magnitude in three digits, as a sentence should not be more precise than the run."""
    return quantity(abs(value), unit, digits=3)


def larger_way(response):
    """Keys of peak F_T, of its direction and of peak P: seaward if the seaward force is larger."""
    if abs(response.get("peak_force_seaward") or 0.0) > abs(response.get("peak_force") or 0.0):
        return "peak_shear_seaward", "seaward", "peak_force_seaward"
    return "peak_shear", "landward", "peak_force"


def rests_on(summary):
    """The measure of S, and what is known of errors."""
    measure, sliding = best(summary), summary.get("sliding") or {}
    parts = [phrase("$S$ rests on this measure: {measure}.", measure=prose(measure.short))] if measure else []
    if sliding.get("why_not_coupled"):
        why = prose(told(sliding["why_not_coupled"]))
        parts.append(phrase("Slip on the ground that the caisson shakes could not be told: {why}.", why=why))
    response = summary.get("response") or {}
    error = response.get("error_estimate")
    if response and error is None:
        parts.append(say("The error by mesh and steps was not estimated, so the digits are not all sure."))
    elif error is not None:
        parts.append(phrase("The error of peak $F_T$ is estimated at {error} at most.", error=percent(error)))
        slip = sliding.get("error_estimate")
        if slip is not None:
            parts.append(phrase("That of $S$ by eq. (4) is estimated at {slip} at most.", slip=quantity(slip, "m")))
    return sentences(parts)


def error_of_peak(summary):
    response = summary.get("response") or {}
    if response.get("error_estimate") is not None:
        yield phrase("estimated error of peak $F_T$: {error}", error=percent(response["error_estimate"]))
    elif response:
        yield phrase("error of peak $F_T$ not estimated in this run")


def cards(result):
    response = result.summary.get("response") or {}
    if not result.has_caisson or not response:
        below = say("no shear force without a caisson")
        return [card(say("length of the run"), quantity(float(result.time[-1]), "s"), below)]
    key, way, force = larger_way(response)
    when = quantity(response.get(key + "_time"), "s")
    told_when = phrase("largest shear force at the bottom, {way}, at {time}", way=say(way), time=when)
    ratio = response.get("shear_to_force_ratio")
    share = say("none") if ratio is None else tag("data", f"{ratio:.3f}", value=repr(ratio))
    of = phrase("of the wave's peak force $P$ = {force}", force=quantity(response.get(force), "N/m"))
    return [
        card(phrase("peak $F_T$"), quantity(response.get(key), "N/m"), told_when),
        card(phrase("peak $F_T$ / peak $P$"), share, of),
        sliding_card(result.summary),
    ]


def sliding_card(summary):
    measure, name = best(summary), phrase("sliding distance $S$")
    if measure is None:
        return card(name, say("not asked"), say("the case has no table [sliding]"))
    ratio = (summary.get("sliding") or {}).get("ratio") or 0
    below = Markup(prose(measure.short))
    if measure.value == 0 and ratio > 0:
        below = phrase("the sliding force is {ratio} of the resistance", ratio=percent(ratio))
    value = quantity(measure.value, "m")
    if not rests(summary):
        below = phrase("until the end of the run; it slides on, without bound")
    elif (why := not_all(summary)):
        value, below = phrase("at least {distance}", distance=value), prose(told(why))
    return card(name, value, below)
