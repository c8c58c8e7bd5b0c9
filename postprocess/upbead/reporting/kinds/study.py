"""The document of a study: how a number depends on the keys that were varied."""

import numpy as np

from .. import figure
from ..head import card
from .frame import result_section
from ..language import heads, named, phrase, say, told
from ..markup import Markup, fold, join, prose, table, tag
from ..plot import Line, Panel, Plot
from ..units import plain, quantity
from ... import outputs
from ...study_axes import default_axes, in_words, is_drawn, rank_correlation, spreads

COMMAND = "study"
KIND = "Report of a study by upbead"
QUESTION = "How do the answers depend on the keys that were varied?"
FLAGS = ("checks_failing", "warnings", "void")  # columns of every study
MOST_LINES = 6  # as many colours
MOST_ROWS = 400
SHARES = (5, 50, 95)


def verdict(study):
    words = [phrase("{count} runs were done.", count=len(study))]
    missing = [row for row in study.failed if row["status"] == "missing"]
    failed = len(study.failed) - len(missing)
    if missing:
        words.append(tag("strong", phrase("{count} more are missing.", count=len(missing)), class_="fails"))
    if failed:
        words.append(tag("strong", phrase("{count} more failed, and nothing here knows of them.", count=failed), class_="fails"))
    if study.void.any():
        words.append(tag("strong", void_runs(study), class_="fails"))
    cards = [extent_card(study, name) for name in numeric(study)[:3]]
    for name in numeric(study)[:1]:
        low, high = extent(study, name)
        words.append(phrase("{what} lies between {low} and {high}.", what=title_of(name),
                            low=value_of(name, low, 3), high=value_of(name, high, 3)))  # fmt: skip
        words.append(say("That is the extent of these runs, and not of all that could be."))
    missing = [name for name in study.reads if study.numbers(name) is not None and np.isnan(study.numbers(name)).any()]
    if missing:
        words.append(phrase("Some runs have no value of {names}.", names=join([tag("code", name) for name in missing], ", ")))
    return words, cards


def void_runs(study):
    """How many runs are void, why, and that numbers over all runs are without them."""
    why = join([named(name) for name in dict.fromkeys(name for row in study.rows for name in (row.get("void") or "").split("; ") if name)], ", ")
    left = say("All runs are void.") if study.void.all() else say("They are left out of the figures and of all numbers over runs.")
    return join([phrase("Of {count} runs no verdict may be drawn: {why}.", count=int(study.void.sum()), why=why), " ", left])


def sound_numbers(study, name):
    """A column with nan in void runs, unless all are void; None of words."""
    return study.numbers(name) if study.numbers(name) is None or study.void.all() else study.sound(name)


def numeric(study):
    """The numbers read from the runs that at least one run has."""
    return [name for name in study.reads if study.numbers(name) is not None and np.isfinite(sound_numbers(study, name)).any()]


def extent(study, name):
    values = sound_numbers(study, name)
    return float(np.nanmin(values)), float(np.nanmax(values))


def extent_card(study, name):
    low, high = extent(study, name)
    between = phrase("{low} to {high}", low=value_of(name, low, 3), high=value_of(name, high, 3))
    return card(title_of(name), between, tag("code", name))


def plain_title(name):
    words = told(outputs.label(name)) or name
    return words[:1].upper() + words[1:]


def title_of(name):
    return prose(plain_title(name))


def head_of(study, name):
    """A key by its place, a number by what it is."""
    return prose(told(in_words(name))) if name not in study.reads or not outputs.label(name) else title_of(name)


def value_in_words(value):
    return say({"true": "yes", "false": "no"}.get(value, value))


def value_of(name, value, digits=4):
    return quantity(value, outputs.unit(name), digits=digits) if np.isfinite(value) else say("none")


def sections(study):
    return [
        result_section("Results", "results", *(drawn(study, name, key) for name in numeric(study)[:1] for key in axes(study))),
        result_section("Values", "values", spread(study), runs(study)),
    ]


def axes(study):
    return [key for key in default_axes(study) if study.numbers(key) is not None]


def drawn(study, name, key):
    """A figure of one number against one key."""
    x, y, random = study.numbers(key), sound_numbers(study, name), is_drawn(study, key)
    good = np.isfinite(x) & np.isfinite(y)
    if good.sum() < 2:
        return ""
    lines = [Line("", x[good], y[good], 0, dots=True)] if random else courses(study, key, x, y, good)
    caption = phrase("{what} against {key}.", what=title_of(name), key=tag("code", key))
    if random:
        correlation = plain(float(round(rank_correlation(x[good], y[good]), 2)))
        caption = join([caption, " ", say("Rank correlation {value}.", value=correlation)])
    axis = (in_words(key), study.units.get(key, ""))
    panel = Panel(outputs.unit(name), lines, height=240, title=plain_title(name), from_zero=False)
    plot = Plot("study-" + key.replace(".", "-"), [panel], axis=axis, log=spreads(x[good]))
    return figure.of_plot(plot, caption)


def courses(study, key, x, y, good):
    """A line for each combination of the other keys, or points if there are too many combinations."""
    others = [other for other in study.keys if other != key and not is_drawn(study, other)]
    combinations = list(zip(*(study.words(other) for other in others))) or [()] * len(x)
    different = list(dict.fromkeys(combinations))
    if len(different) > MOST_LINES:
        return [Line("", x[good], y[good], 0, dots=True)]
    lines = []
    for colour, one in enumerate(different):
        chosen = good & np.array([found == one for found in combinations])
        order = np.argsort(x[chosen], kind="stable")
        name = ", ".join(f"{in_words(other)} {value_in_words(value)}" for other, value in zip(others, one))
        if chosen.sum() > 1:
            lines.append(Line(name, x[chosen][order], y[chosen][order], colour))
    return lines or [Line("", x[good], y[good], 0, dots=True)]


def spread(study):
    """Least, median and largest of each number."""
    rows = []
    for name in numeric(study):
        values = sound_numbers(study, name)
        values = values[np.isfinite(values)]
        row = [values.min(), *np.percentile(values, SHARES), values.max()]
        rows.append((join([title_of(name), " ", tag("code", name)]), len(values), *(value_of(name, float(value)) for value in row)))
    return table(heads("number", "runs", "least", "5 %", "median", "95 %", "largest"), rows, "numbers") if rows else ""


def runs(study):
    """A table of all runs that can be folded."""
    names = [*study.keys, *study.reads, *(name for name in FLAGS if name in study.columns)]
    rows = [(row["run"], *(cell(study, name, row[name]) for name in names)) for row in study.rows[:MOST_ROWS]]
    head = [say("run"), *(tag("span", head_of(study, name), title=name) for name in names)]
    count = say("{count} runs one by one", count=len(rows))
    left = len(study.rows) - len(rows)
    rest = tag("p", say("{count} more stand in {file}.", count=left, file="study.csv"), class_="quiet") if left else Markup("")
    return fold(count, table(heads(*(Markup(part) for part in head)), rows, "numbers"), rest, open_=len(rows) <= 40)


def cell(study, name, value):
    if value == "":
        return say("none")
    if value in ("true", "false"):
        return value_in_words(value)
    try:
        return quantity(float(value), study.units.get(name) or outputs.unit(name))
    except ValueError:
        return value
