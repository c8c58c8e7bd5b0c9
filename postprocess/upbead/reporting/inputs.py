"""Every input of a case: its value, unit, meaning, source, and the author's remark."""

import math
from dataclasses import dataclass

from . import geometry, reference
from .language import say, told
from .source_case import PATHS
from .units import plain, pretty, scale

# tables with the numbers meant by "all other numbers"
PHYSICAL = ("mesh", "regions", "fluid", "loads", "initial", "sliding", "boundaries", "section", "limits", "waves", "sea", "storms", "scatter",
            "levels", "ground", "duration", "combined")
SWITCHES = ("degree", "refine", "direction", "factor")  # numbers in these tables that are no physical quantities
# From where the program takes what is left out (src/case/case.cc), the first that the case has
CONTACT = ("regions", "caisson", "interface", "coefficient")
TAKEN_FROM = {
    ("sliding", "friction"): (("section", "friction"), CONTACT),
    ("sliding", "submerged_weight"): (("section", "submerged_weight"),),
    CONTACT: (("sliding", "friction"), ("section", "friction")),
}
OLDER = {("sliding", "submerged_weight"): ("sliding", "buoyant_weight")}  # names that the program still reads


@dataclass
class Row:
    path: tuple
    what: str
    value: object
    unit: str
    mark: str
    remark: str


def rows(case, source, units=None, known=None):
    """Every value of the effective case as a Row.

    `source` is None if the author's file is not known. `units` by path take precedence over those of the reference;
    the reference is that of cases unless `known` gives another.
    """
    known = reference.read() if known is None else known
    declared = geometry.declared(case.get("mesh", {}).get("geometry", ""))
    found = []
    order = list(declared)
    for path, value in sorted(leaves(case), key=lambda leaf: order.index(leaf[0][-1]) if leaf[0][-1] in order else -1):
        key = reference.find(known, path)
        unit, what = (key.unit, key.meaning) if key else ("", "")
        unit = (units or {}).get(path, unit)
        if path[:2] == ("mesh", "parameters") and path[-1] in declared:
            default, unit, what = declared[path[-1]]
            what = reference.short(what)
            key = reference.Key(unit, repr(default), what)
        if " or " in unit:  # for a load, by its kind
            unit = "N/m" if case["loads"][path[1]].get("kind", "force") == "force" else "Pa"
        mark, remark = status(path, value, key, source, case)
        found.append(Row(path, what or " ".join(path[2:]).replace("_", " "), value, unit, mark, remark))
    return [row for row in found if row.path != ("title",) and row.path[0] != "report"]


def leaves(table_, path=()):
    for key, value in table_.items():
        if isinstance(value, dict):
            yield from leaves(value, (*path, key))
        else:
            yield (*path, key), value


def status(path, value, key, source, case):
    """(where a value comes from, remark)."""
    path = OLDER[path] if source and path in OLDER and source.value(OLDER[path]) is not None else path
    written = source.value(path) if source else None
    if written is not None:
        # a path is rewritten for the folder of results, a range is replaced by its values
        if written != value and path[-1] not in PATHS and not isinstance(written, dict):
            return "changed", say("set for this run; the case file has {value}", value=written_as(written, key.unit if key else ""))
        is_number = isinstance(value, (int, float, list)) and not isinstance(value, bool)
        mark, remark = source.mark(path, is_number, path[0] in PHYSICAL and path[-1] not in SWITCHES)
        return mark or "given", remark
    origin = next((origin for origin in TAKEN_FROM.get(path, ()) if at(case, origin) == value), None)
    if origin:
        mark = status(origin, value, None, source, case)[0]
        return "derived", say("taken from {key}, there: {mark}", key=".".join(origin), mark=told(mark))
    if key is not None and key.is_default(value):
        return "default", ""
    return ("changed", say("set for this run")) if source else ("given", "")


def at(case, path):
    for part in path:
        case = case.get(part) if isinstance(case, dict) else None
    return case


def written_as(value, unit):
    if isinstance(value, str):
        return value
    if isinstance(value, list):
        return "(" + ", ".join(written_as(part, "") for part in value) + ")" + (f" {pretty(unit)}" if unit else "")
    if isinstance(value, bool) or not math.isfinite(value):
        return plain(value)
    factor, name = (1.0, unit) if unit == "m" else scale(unit, value)  # all lengths of a section are in metres
    digits = 5 if value == float(f"{value:.5g}") else 9 if unit in ("m", "") and abs(value) >= 1e4 else 4  # 9: of a survey
    return f"{plain(value * factor if factor != 1.0 else value, digits)} {pretty(name)}".strip()
