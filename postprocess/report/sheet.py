"""The sheet: each check of the section with demand, capacity and margin, and what it stands on."""

from report.markup import Markup, join, prose, table, tag
from report.units import plain, quantity

HEAD = ("project", "client", "author", "revision")
FORMULAS = [
    ("sliding distance", "eq. (4) of Shimosako and Takahashi (1994): (W/g) x'' = F_T + mu U - mu W', x' >= 0; node by node Coulomb's law"),
    ("displacement with the ground", "residual displacement of the caisson on soil that yields, and S where it is bonded to it"),
    ("force against friction", "F_S = F_T + mu U against mu W'; slides where it is larger"),
    ("heel and toe pressure", "Goda (2000), ch. 4: e = M'/N'; N'/B (1 + 6 e/B) for e <= B/6, else 2 N'/(3 t), t = B/2 - e"),
    ("margin against overturning", "(W' t - M_U) over the wave's moment about the edge; Goda's where nothing moves"),
]


def section(result, outline):
    checks = result.summary.get("checks") or []
    parts = [head(result.case.get("report") or {})]
    if checks:
        parts.append(verdicts(checks))
    parts.append(levels(result.case, outline))
    inside = [part for part in parts if part]
    return tag("section", tag("h2", "Verdict"), *inside, id="sheet") if inside else Markup("")


def head(told):
    rows = [(name, told[name]) for name in HEAD if told.get(name)]
    return table(None, rows, "words") if rows else Markup("")


def verdicts(checks):
    rows = []
    for check in checks:
        unit, holds = check["unit"], check["holds"]
        verdict = "no limit given" if holds is None else "holds" if holds else tag("strong", "does not hold", class_="fails")
        margin = "" if check["margin"] is None else plain(check["margin"], 3)
        basis = join([tag("code", check["measure"]), prose("; " + check["assumption"]) if check.get("assumption") else ""])
        capacity = "" if check["capacity"] is None else quantity(check["capacity"], unit)
        rows.append((check["name"], "without bound" if check["demand"] is None else quantity(check["demand"], unit), capacity, margin, verdict, basis))
    return table(("check", "demand", "capacity", "margin", "", "measure and assumption"), rows, "numbers wide sheet")


def levels(case, outline):
    """Still water, and bottom and top of every region."""
    rows = []
    level = (case.get("initial") or {}).get("water_level")
    if level is not None:
        rows.append(("still water", quantity(float(level), "m"), ""))
    if outline is not None:
        for name in sorted(outline.regions, key=lambda name: -outline.box(name)[3]):
            low, high = outline.box(name)[2:]
            region = (case.get("regions") or {}).get(name) or {}
            rows.append((name.replace("_", " "), join([quantity(low, "m"), " to ", quantity(high, "m")]), soil(region)))
    return join([tag("h3", "Levels and layers"), table(("", "height", ""), rows, "words")]) if rows else Markup("")


def soil(region):
    """What decides of a region, in a few words."""
    told = [region.get("kind", "")]
    for key, symbol in (("shear_modulus", "G"), ("hydraulic_conductivity", "k"), ("density", "ρ")):
        if isinstance(region.get(key), (int, float)):
            told.append(join([symbol, " ", quantity(float(region[key]), unit_of(key))]))
    return join([part for part in told if part], ", ")


def unit_of(key):
    return {"shear_modulus": "Pa", "hydraulic_conductivity": "m/s", "density": "kg/m3"}[key]


def formulas(result):
    """For the appendix."""
    if not result.summary.get("checks"):
        return Markup("")
    rows = [(name, prose(what)) for name, what in FORMULAS]
    return tag("section", tag("h2", "Formulas of the checks"), table(None, rows, "words"), id="formulas")

