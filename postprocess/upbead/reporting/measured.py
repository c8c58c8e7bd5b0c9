"""Measured records compared with computed histories: a plot of each, and their differences."""

import numpy as np

from . import figure
from .language import as_written, heads, named, phrase, say, spaced
from .markup import Markup, join, table, tag
from .plot import Line, Panel, Plot
from .units import percent, quantity


def records(result):
    """[(name, history that it is compared with, time, value, unit, description)] of /measured."""
    group = result.file.get("measured")
    found = []
    for name in group or ():
        record = group[name]
        if "time" in record and "value" in record:
            found.append(
                (
                    name,
                    attribute(record, "reading"),
                    record["time"][()].astype(float),
                    record["value"][()].astype(float),
                    attribute(record, "unit"),
                    attribute(record, "description"),
                )
            )
    return found


def attribute(record, key):
    """An attribute of the group, or of one of its datasets."""
    for item in (record, record["value"], record["time"]):
        if key in item.attrs and (key != "unit" or item is not record["time"]):
            value = item.attrs[key]
            return value.decode() if isinstance(value, bytes) else str(value)
    return ""


def by_reading(result):
    """{history: [(name, time, value)]}, for the plots that show that history."""
    found = {}
    for name, reading, time, value, _, _ in records(result):
        found.setdefault(reading, []).append((name, time, value))
    return found


def lines_over(records, name):
    """Of the records that are compared with a history, to be drawn over it."""
    return [Line(say("measured: {name}", name=named(what)), t, y, 4, "--") for what, t, y in records.get(name, [])]


def section(result):
    found = records(result)
    if not found:
        return Markup("")
    panels = []
    for name, reading, time, value, unit, _ in found:
        lines = [Line(say("measured"), time, value, 4)]
        if f"/history/{reading}" in result.file:
            history = result.history(reading)
            unit = unit or history.unit
            lines.append(Line(say("computed"), np.asarray(result.time), np.asarray(history), 2))
        panels.append(Panel(unit, lines, title=spaced(name)))
    start, end = float(result.time[0]), float(result.time[-1])
    plot = Plot("measured", panels, window=(start, end))
    described = join((join([as_written(name), f": {description.rstrip('.')}."]) for name, *_, description in found if description), " ")
    caption = phrase("Measured records and what was computed. {described}", described=described)
    return tag(
        "section",
        tag("h2", say("Measured and computed")),
        figure.of_plot(plot, caption),
        compared(result, found),
        id="measured-section",
    )


def compared(result, found):
    told, units, rows = result.summary.get("measured") or {}, {record[0]: record[4] for record in found}, []
    for name, numbers in told.items():
        unit = units.get(name, "")
        rows.append(
            (
                as_written(name),
                tag("code", numbers.get("reading", "")),
                quantity(numbers.get("peak_measured"), unit),
                quantity(numbers.get("peak_computed"), unit),
                quantity(numbers.get("peak_ratio")),
                quantity(numbers.get("rms"), unit),
                percent(numbers.get("rms_relative")),
                quantity(numbers.get("phase"), "s"),
            )
        )
    head = heads(
        "record",
        "compared with",
        "peak measured",
        "peak computed",
        "computed / measured",
        "RMS difference",
        "relative",
        "phase",
    )
    return table(head, rows, "numbers") if rows else Markup("")
