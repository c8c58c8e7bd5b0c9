"""Each check of the section with demand, capacity, margin and its assumption; levels and layers of the section."""

from report.language import heads, named, phrase, say, told
from report.markup import Markup, join, prose, table, tag
from report.units import plain, quantity

FORMULAS = [
    ("sliding distance", "eq. (4) of Shimosako and Takahashi (1994): (W/g) x'' = F_T + mu U - mu W', x' >= 0; node by node Coulomb's law"),
    ("displacement with the ground", "residual displacement of the caisson on soil that yields, and S where it is bonded to it"),
    ("force against friction", "F_S = F_T + mu U against mu W'; slides where it is larger"),
    ("heel and toe pressure", "Goda (2000), ch. 4: e = M'/N'; N'/B (1 + 6 e/B) for e <= B/6, else 2 N'/(3 t), t = B/2 - e"),
    ("margin against overturning", "(W' t - M_U) over the wave's moment about the edge; Goda's where nothing moves"),
]


def section(summary):
    checks = summary.get("checks") or []
    return tag("section", tag("h2", say("Checks")), verdicts(checks), id="sheet") if checks else Markup("")


def verdicts(checks):
    rows = []
    for check in checks:
        unit, holds = check["unit"], check["holds"]
        fails = tag("strong", say("does not hold"), class_="fails")
        verdict = say("no limit given") if holds is None else say("holds") if holds else fails
        margin = "" if check["margin"] is None else plain(check["margin"], 3)
        stands_on = "; ".join(map(told, (check.get("assumption") or "").split("; ")))
        basis = join([tag("code", check["measure"]), prose("; " + stands_on) if stands_on else ""])
        capacity = "" if check["capacity"] is None else quantity(check["capacity"], unit)
        demand = say("without bound") if check["demand"] is None else quantity(check["demand"], unit)
        rows.append((named(check["name"]), demand, capacity, margin, verdict, basis))
    head = heads("check", "demand", "capacity", "margin", "result", "measure and assumption")
    return table(head, rows, "numbers wide sheet")


def levels(case, outline):
    """A table of still water, and of bottom and top of every region."""
    rows = []
    level = (case.get("initial") or {}).get("water_level")
    if level is not None:
        rows.append((say("still water"), quantity(float(level), "m"), ""))
    if outline is not None:
        for name in sorted(outline.regions, key=lambda name: -outline.box(name)[3]):
            low, high = outline.box(name)[2:]
            region = (case.get("regions") or {}).get(name) or {}
            between = phrase("{low} to {high}", low=quantity(low, "m"), high=quantity(high, "m"))
            rows.append((named(name), between, soil(region)))
    head = heads("layer", "height", "what it is")
    return join([tag("h3", say("Levels and layers")), table(head, rows, "words")]) if rows else Markup("")


def soil(region):
    """The main properties of a region, in a few words."""
    parts = [told(region.get("kind", ""))]
    for key, symbol in (("shear_modulus", "G"), ("hydraulic_conductivity", "k"), ("density", "ρ")):
        if isinstance(region.get(key), (int, float)):
            parts.append(join([symbol, " ", quantity(float(region[key]), unit_of(key))]))
    return join([part for part in parts if part], ", ")


def unit_of(key):
    return {"shear_modulus": "Pa", "hydraulic_conductivity": "m/s", "density": "kg/m3"}[key]


def formulas(result):
    """The formulas of the checks, for the appendix."""
    if not result.summary.get("checks"):
        return Markup("")
    rows = [(say(name), prose(say(what))) for name, what in FORMULAS]
    return tag("section", tag("h2", say("Formulas of the checks")), table(None, rows, "words"), id="formulas")
