"""The assumptions of a result: influential values that were not measured, and assumptions of the checks."""

from . import input_tables
from .language import phrase, say, told
from .markup import Markup, join, prose, tag

MARKS = ("assumed", "calibrated", "derived")
# Influential defaults, by the end of their path
DECIDING = (
    ("sliding", "uplift", "kind"),
    ("sliding", "uplift", "shape"),
    ("damping", "ratio"),
    ("saturation",),
    ("law",),
    ("measured_on_wall",),
)


def section(summary, rows, source):
    """`rows` are those of the inputs; `source` is the author's file, or None."""
    parts = [head(source), chosen(rows, source), stands_on(summary)]
    inside = [part for part in parts if part] or [tag("p", say("These results hold no inputs: what they assume stands in the cases that were run."))]
    return tag("section", tag("h2", say("Assumptions")), *inside, id="assumptions")


def head(source):
    """The author's comment at the head of the file."""
    if source is None:
        told_how = phrase(
            "The case as its author wrote it was not found: what was given is told from the defaults, and what is assumed "
            "or calibrated is not known. Give it by `--case`."
        )
        return tag("p", told_how, class_="quiet")
    if not source.head:
        return Markup("")
    foot = tag("footer", say("at the head of {file}", file=source.path.name))
    return tag("blockquote", " ".join(source.head.split()), foot, class_="written")


def chosen(rows, source):
    marked = [row for row in rows if row.mark in MARKS]
    defaults = [row for row in rows if row.mark == "default" and any(row.path[-len(end) :] == end for end in DECIDING)]
    note = say("Values that were assumed, calibrated or derived, and defaults that may decide. All values stand in the appendix.")
    none = say("No value of this case is marked as assumed or calibrated.") if source and rows and not marked else ""
    shown = input_tables.columns([*marked, *defaults]) if marked or defaults else ""
    return join([tag("p", note) if shown else "", tag("p", none) if none else "", shown])


def stands_on(summary):
    """Assumptions of the checks and of the loads by waves."""
    found = []
    for check in summary.get("checks") or []:
        found += (check.get("assumption") or "").split("; ")
    for wave in (summary.get("wave_loads") or {}).values():
        found += wave.get("assumptions") or []
    found = [what for what in dict.fromkeys(found) if what]
    if not found:
        return Markup("")
    return join([tag("h3", say("What the checks and loads stand on")), tag("ul", *(tag("li", prose(told(what))) for what in found))])
