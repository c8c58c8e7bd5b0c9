"""How far the caisson slides, by every measure that the run has, and what each measure is."""

import numpy as np

from report import figure, sliding_tables
from report.figure import words
from report.markup import Markup, join, prose, table, tag
from report.measures import at, measures
from report.plot import Line, Panel, Plot
from report.units import percent, quantity


def section(result):
    sliding = result.summary.get("sliding")
    found = measures(result.summary)
    if not found:
        return Markup("")
    rows = [(prose(measure.what), quantity(measure.value, "m"), tag("code", measure.key)) for measure in found]
    parts = [tag("h2", "Sliding")]
    if sliding:
        parts += [tag("p", balance(sliding)), figure.of_plot(forces(result, sliding), force_caption(result))]
    course = slip_course(result, sliding or {})
    if course:
        parts.append(
            figure.of_plot(
                course,
                words("Slip of the caisson over its ground, landward positive. Dots mark the largest slip on the way."),
            )
        )
    parts += [
        tag("h3", "Sliding distance by every measure"),
        table(("measure", "S", "in summary.json"), rows, "numbers keys"),
    ]
    if sliding and sliding.get("why_not_coupled"):
        why = "Slip as a whole on the shaken ground could not be computed: " + sliding["why_not_coupled"] + "."
        parts.append(tag("p", prose(why)))
    if sliding:
        parts += [
            sliding_tables.contact(result.summary),
            sliding_tables.slips(sliding),
            sliding_tables.durations(sliding),
        ]
    return tag("section", *parts, id="sliding")


def balance(sliding):
    """One sentence: how near the caisson comes to sliding."""
    resistance, ratio = sliding["resistance"], sliding["ratio"]
    text = words(
        "The largest sliding force of the bonded caisson, ",
        quantity(sliding["peak_sliding_force"], "N/m"),
        " (",
        ("F_S",),
        " = ",
        ("F_T",),
        " + ",
        ("μ U",),
        "), is ",
        percent(ratio),
        " of the resistance ",
        ("μ W′",),
        " = ",
        quantity(sliding["friction"]),
        " × ",
        quantity(sliding["buoyant_weight"], "N/m"),
        " = ",
        quantity(resistance, "N/m"),
        ".",
    )
    if ratio is not None and ratio <= 1:
        return join([text, " So the caisson does not slide as a rigid block."])
    return text


def forces(result, sliding):
    time = np.asarray(result.time)
    resistance = sliding["resistance"]
    ends = np.array([time[0], time[-1]])
    lines = [Line("F_T", time, np.asarray(result.history("shear_force")), 2)]
    coupled = slipped(result)
    if coupled:
        lines.append(Line("F_T coupled", coupled["time"], coupled["shear_force"], 5))
    limits = [
        Line("μ W′", ends, np.full(2, resistance), 3, "--"),
        Line("−μ W′", ends, np.full(2, -resistance), 3, "--"),
    ]
    return Plot("friction", [Panel("N/m", lines + limits, height=170)])


def force_caption(result):
    bonded = (
        "of this run"
        if result.summary.get("contact") and at(result.summary, "contact.solved")
        else "of the bonded caisson"
    )
    parts = [
        "Shear force at the bottom ",
        ("F_T",),
        f" {bonded} against the friction that holds it, ",
        ("μ W′",),
        " on either side.",
    ]
    if slipped(result):
        parts += [" “Coupled” is the caisson that slips as a whole."]
    return words(*parts)


def slipped(result):
    """/coupled of the results as arrays, or nothing."""
    group = result.file.get("coupled")
    if group is None:
        return {}
    return {name: np.asarray(group[name][()], dtype=float) for name in group}


def slip_course(result, sliding):
    lines, marks = [], []
    coupled = slipped(result)
    if coupled:
        lines.append(Line("as a whole", coupled["time"], coupled["slip"], 5))
    if "/history/interface/slip" in result.file:
        lines.append(
            Line("node by node, mean", np.asarray(result.time), np.asarray(result.history("interface/slip")), 0)
        )
    for line in lines:
        largest = int(np.argmax(np.abs(line.values)))
        marks.append((float(line.x[largest]), float(line.values[largest])))
    rest = sliding.get("slips") or []
    if rest and sliding.get("sliding_history"):
        stop, end = rest[-1]["stop"], float(result.time[-1])
        lines.append(
            Line(
                "eq. (4), where it rests",
                np.array([min(stop, end), max(stop, end)]),
                np.full(2, sliding["sliding_history"]),
                3,
                "--",
            )
        )
    return Plot("slip", [Panel("m", lines, marks, height=170)]) if lines else None
