"""The response over time: the figure of Fig. 2b of Shimosako and Takahashi (1994), and its peaks as a table."""

import numpy as np

from . import figure, measured, points
from .language import heads, named, phrase, say, told
from .markup import Markup, join, prose, table, tag
from .markup import symbol as symbol_of
from .plot import Line, Panel, Plot
from .series import largest
from .units import percent, quantity
from .. import outputs

PANELS = [
    ("force", "P", 0, "forces"),
    ("inertia_force", "m ẍ_G", 1, "forces"),
    ("shear_force", "F_T", 2, "forces"),
    ("caisson/displacement_x", "x_G", 3, ""),
]
PEAKS = {"force": "peak_force", "shear_force": "peak_shear"}
ROWS = [  # key, symbol, key of the time
    ("peak_force", "P", "peak_force_time"),
    ("peak_shear", "F_T", "peak_shear_time"),
    ("peak_shear_seaward", "F_T", "peak_shear_seaward_time"),
    ("shear_to_force_ratio", "F_T / P", None),
    ("peak_shear_paper", "F_T", None),
    ("peak_shear_experiment", "F_T", None),
    ("impulse", "I", None),
    ("arm", "", None),
    ("peak_base_moment", "M", None),
    ("largest_base_moment", "M", None),
    ("peak_displacement", "x_G", None),
    ("largest_displacement", "x_G", "largest_displacement_time"),
    ("peak_rotation", "", None),
    ("largest_rotation", "", None),
]
MOST_PERIODS = 6


def window(time, histories, share=0.05):
    """The end of the plotted time: a little after the last time at which any history exceeds `share` of its own
    peak."""
    last = 0
    for values in histories:
        above = np.flatnonzero(np.abs(values) > share * largest(values))
        last = max(last, above[-1] if above.size else 0)
    end = time[0] + 1.1 * (time[last] - time[0])
    return float(time[0]), float(min(end, time[-1])) if last > 0 else float(time[-1])


def peak_of(result, name, values):
    """Time and value of the peak on the side of the larger force, whose ratio is told, or on the other if there is no
    such; the peaks of the summary take precedence. Of the displacement it is the largest either way."""
    response = result.summary.get("response") or {}
    seaward = abs(response.get("peak_force_seaward") or 0.0) > abs(response.get("peak_force") or 0.0)
    key = PEAKS[name] + ("_seaward" if seaward else "") if name in PEAKS else ""
    if (response.get(key) or 0.0) * (-1 if seaward else 1) > 0:
        return response[key + "_time"], response[key]
    first, other = (np.argmin, np.argmax) if seaward else (np.argmax, np.argmin)
    peak = int(first(values)) if values[first(values)] * (-1 if seaward else 1) > 0 else int(other(values))
    if name == "caisson/displacement_x":
        if response.get("largest_displacement") is not None:
            return response["largest_displacement_time"], response["largest_displacement"]
        peak = int(np.argmax(np.abs(values)))
    return float(result.time[peak]), float(values[peak])


def array(result, name):
    return np.asarray(result.history(name))


def plot(result, records):
    """What the report and figures.response draw; `records`: measured, by the history that they are compared with: {name: [(name, time, values)]}."""
    time = np.asarray(result.time)
    panels, shown = [], []
    for name, symbol, colour, group in PANELS:
        values = array(result, name)
        shown.append(values)
        lines = [Line(symbol, time, values, colour), *measured.lines_over(records, name)]
        panels.append(Panel(result.history(name).unit, lines, [peak_of(result, name, values)], group))
    return Plot("response", panels, window=window(time, shown))


def section(result, records):
    if not result.has_caisson:
        read = points.figures(result) or [
            tag("p", say("No point was read: add [probes.NAME] to the case to see how the section responds."))
        ]
        return tag("section", tag("h2", say("Response")), *read, id="response-section")
    caption = phrase(
        "Wave force $P$, inertia force $m ẍ_G$, shear force at the bottom $F_T$ and displacement of the centre of gravity "
        "$x_G$ over time, landward positive, as in Fig. 2b of Shimosako and Takahashi (1994). Dots mark the peaks."
    )
    return tag(
        "section",
        tag("h2", say("Response")),
        figure.of_plot(plot(result, records), caption),
        peaks(result),
        periods(result.summary),
        *points.figures(result, ("pressure",)),
        id="response-section",
    )


def periods(summary):
    rows = [
        (quantity(found["period"], "s"), percent(found["share"]), percent(found["damping_ratio"]))
        for found in (summary.get("periods") or [])[:MOST_PERIODS]
    ]
    if not rows:
        return Markup("")
    return join([tag("h3", say("Natural periods")), table(heads("period", "share in $F_T$", "of critical damping"), rows, "numbers")])


def same_as_peak(response, key):
    """Whether the largest of either sign is the largest landward, which stands above it."""
    return key.startswith("largest_") and response[key] == response.get(key.replace("largest_", "peak_"))


def peaks(result):
    response = result.summary.get("response") or {}
    rows = []
    for key, symbol, when in ROWS:
        if response.get(key) is not None and not same_as_peak(response, key):
            ratio, path = key == "shear_to_force_ratio", f"response.{key}"
            value = percent(response[key]) if ratio else quantity(response[key], outputs.unit(path))
            at = quantity(response[when], "s") if when else ""
            rows.append((prose(told(outputs.label(path))), symbol_of(symbol), value, at))
    return table(heads("quantity", "symbol", "value", "at"), rows, "numbers")
