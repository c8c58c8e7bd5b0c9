"""Loads on the section: each load with its history, its largest force and its height; uplift; their records and
waves."""

from . import gauges, waves
from .drawing import acting
from .language import as_written, heads, listed, named, phrase, say, told
from .markup import Markup, prose, table, tag
from .measures import at
from .units import quantity

PULSE = (("peak", ""), ("rise", "s"), ("duration", "s"), ("plateau", ""), ("plateau_duration", "s"))


def section(result):
    rows = [row(name, load, result) for name, load in acting(result.case).items()]
    parts = [part for part in (table_of(rows), uplift(result), waves.records(result.summary), gauges.records(result.summary)) if part]
    return tag("section", tag("h2", say("Loads")), *parts, id="loads") if parts else Markup("")


def table_of(rows):
    return table(heads("load", "acts on", "kind", "course", "height above the bottom"), rows, "words") if rows else ""


def row(name, load, result):
    arm = (at(result.summary, "loads") or {}).get(name, {}).get("arm")
    height = quantity(arm, "m") if arm is not None else ""
    where = load.get("boundary") or load.get("region") or ""
    return as_written(name), named(where), named(load.get("kind", "force")), course(load), height


def course(load):
    """The source of a load's values, in a few words."""
    parts = []
    if load.get("pulse"):
        parts = pulse(load["pulse"], "N/m" if load.get("kind", "force") == "force" else "Pa")
    elif load.get("history") or load.get("gauges"):
        file = (load.get("history") or load["gauges"]).replace("\\", "/").rpartition("/")[2]
        parts = [phrase("record {file}", file=tag("code", file))]
    elif load.get("wave"):
        parts = [say("by Goda's formulas")]
    if load.get("factor", 1.0) != 1.0:
        parts.append(phrase("times {factor}", factor=quantity(float(load["factor"]))))
    return listed(parts)


def pulse(keys, unit):
    parts = [named(keys.get("shape", ""))]
    for key, of in PULSE:
        if isinstance(keys.get(key), (int, float)):
            value = quantity(float(keys[key]), unit if key == "peak" else of)
            parts.append(phrase("{what} {value}", what=named(key), value=value))
    return parts


def uplift(result):
    """A sentence on the uplift of the sliding block."""
    sliding = result.summary.get("sliding") or {}
    kind = sliding.get("uplift")
    if not kind:
        return ""
    if kind == "none":
        return tag("p", say("No uplift lessens the friction of the caisson."))
    keys = at(result.case, "sliding.uplift") or {}
    words = phrase("The uplift under the caisson is {kind}", kind=told(kind))
    if isinstance(keys.get("peak"), (int, float)):
        peak = quantity(float(keys["peak"]), "N/m")
        return tag("p", phrase("{words}: largest {peak}, {shape}.", words=words, peak=peak, shape=prose(named(keys.get("shape", "")))))
    return tag("p", phrase("{words}.", words=words))
