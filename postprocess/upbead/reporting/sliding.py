"""The sliding distance by every measure that the run has, with an explanation of each measure."""

import numpy as np

from . import figure, sensitivity, sliding_tables
from .language import heads, phrase, say, told
from .markup import Markup, join, prose, table, tag
from .measures import at, measures
from .plot import Line, Panel, Plot
from .series import largest
from .units import percent, quantity
from .. import told as told_of

FLAT = 0.01  # of W': less uplift is not seen


def section(result):
    sliding = result.summary.get("sliding")
    found = measures(result.summary)
    if not found:
        return Markup("")
    rows = [(prose(measure.what), quantity(measure.value, "m"), tag("code", measure.key)) for measure in found]
    parts = [tag("h2", say("Sliding"))]
    if sliding:
        parts += [tag("p", balance(sliding, told_of.is_all_void(result.summary))), figure.of_plot(forces(result, sliding), force_caption(result))]
    course = slip_course(result, sliding or {})
    if course:
        parts.append(
            figure.of_plot(
                course,
                say("Slip of the caisson over its ground, landward positive. Dots mark the largest slip on the way."),
            )
        )
    parts += [
        tag("h3", say("Sliding distance by every measure")),
        table(heads("measure", "$S$", "in summary.json"), rows, "numbers keys"),
    ]
    if sliding and sliding.get("why_not_coupled"):
        why = phrase("Slip as a whole on the shaken ground could not be computed: {why}.", why=prose(told(sliding["why_not_coupled"])))
        parts.append(tag("p", why))
    if sliding:
        parts += [
            sliding_tables.contact(result.summary),
            sliding_tables.slips(sliding),
            sliding_tables.durations(sliding),
        ]
    return tag("section", *parts, id="sliding")


def balance(sliding, void=False):
    """One sentence on how near the caisson is to sliding; without a verdict where its ground has no rest."""
    text = phrase(
        "The largest sliding force of the bonded caisson, {force} ($F_S$ = $F_T$ + $μ U$), is {ratio} of the resistance "
        "$μ W′$ = {friction} × {weight} = {resistance}.",
        force=quantity(sliding["peak_sliding_force"], "N/m"),
        ratio=percent(sliding["ratio"]),
        friction=quantity(sliding["friction"]),
        weight=quantity(sliding["buoyant_weight"], "N/m"),
        resistance=quantity(sliding["resistance"], "N/m"),
    )
    if not void and sliding["ratio"] is not None and sliding["ratio"] <= 1:
        return join([text, " ", say("So the caisson does not slide as a rigid block.")])
    return text


def forces(result, sliding):
    time = np.asarray(result.time)
    resistance = sliding["resistance"]
    ends = np.array([time[0], time[-1]])
    lines = [Line("F_T", time, np.asarray(result.history("shear_force")), 2)]
    coupled = slipped(result)
    if coupled:
        lines.append(Line(say("F_T coupled"), coupled["time"], coupled["shear_force"], 5))
    limits = [
        Line("μ W′", ends, np.full(2, resistance), 3, "--"),
        Line("−μ W′", ends, np.full(2, -resistance), 3, "--"),
    ]
    left = friction_left(result, sliding)
    if left is not None:
        limits = [Line("±μ (W′ − U)", time, left, 3), Line("", time, -left, 3), Line("μ W′", ends, np.full(2, resistance), 3, ":")]
    return Plot("friction", [Panel("N/m", lines + limits, height=170)])


def friction_left(result, sliding):
    """mu (W' - U) over time, where U is known and not nothing; else None."""
    uplift = sensitivity.uplift_of(result, sliding)
    mu, weight = sliding.get("friction"), sliding.get("submerged_weight")
    if uplift is None or mu is None or weight is None or largest(uplift) < FLAT * weight:
        return None
    return mu * np.maximum(weight - uplift, 0.0)


def force_caption(result):
    solved = result.summary.get("contact") and at(result.summary, "contact.solved")
    if friction_left(result, result.summary["sliding"]) is not None:
        caption = (
            "Shear force at the bottom $F_T$ against the friction that holds it on either side, $μ (W′ − U)$: the uplift $U$ takes a part of "
            "$μ W′$ (dotted). {coupled}"
        )
        return phrase(caption, coupled=say("“Coupled” is the caisson that slides as a rigid block on the moving ground.") if slipped(result) else "")
    caption = (
        "Shear force at the bottom $F_T$ of this run against the friction that holds it, $μ W′$ on either side. {coupled}"
        if solved
        else "Shear force at the bottom $F_T$ of the bonded caisson against the friction that holds it, $μ W′$ on either side. "
        "{coupled}"
    )
    coupled = say("“Coupled” is the caisson that slides as a rigid block on the moving ground.") if slipped(result) else ""
    return phrase(caption, coupled=coupled)


def slipped(result):
    """/coupled of the results as arrays, or an empty value."""
    group = result.file.get("coupled")
    if group is None:
        return {}
    return {name: np.asarray(group[name][()], dtype=float) for name in group}


def slip_course(result, sliding):
    lines, marks = [], []
    coupled = slipped(result)
    if coupled:
        lines.append(Line(say("as a whole"), coupled["time"], coupled["slip"], 5))
    if "/history/interface/slip" in result.file:
        lines.append(
            Line(say("node by node, mean"), np.asarray(result.time), np.asarray(result.history("interface/slip")), 0)
        )
    for line in lines:
        largest = int(np.argmax(np.abs(line.values)))
        marks.append((float(line.x[largest]), float(line.values[largest])))
    rest = sliding.get("slips") or []
    if rest and sliding.get("sliding_history"):
        stop, end = rest[-1]["stop"], float(result.time[-1])
        lines.append(
            Line(
                say("eq. (4), where it rests"),
                np.array([min(stop, end), max(stop, end)]),
                np.full(2, sliding["sliding_history"]),
                3,
                "--",
            )
        )
    return Plot("slip", [Panel("m", lines, marks, height=170)]) if lines else None
