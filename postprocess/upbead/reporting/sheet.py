"""Each check of the section with demand, capacity, margin and its assumption; levels and layers of the section."""

from . import judged
from .language import as_written, heads, named, phrase, say, told
from .markup import Markup, join, prose, table, tag
from .units import digits_between, plain, quantity
from .. import told as told_of

FORMULAS = [
    ("sliding distance", "eq. (4) of Shimosako and Takahashi (1994): (W/g) x'' = F_T + mu U - mu W', x' >= 0; node by node Coulomb's law"),
    ("displacement with the ground", "residual displacement of the caisson on soil that yields, and S where it is bonded to it"),
    ("force against friction", "F_S = F_T + mu U against mu W'; slides where it is larger"),
    ("heel pressure p_e", "Goda (2000), ch. 4, under Goda's P and U: e = M'/N'; N'/B (1 + 6 e/B) for e <= B/6, else 2 N'/(3 t), t = B/2 - e"),
    ("heel and toe pressure in motion", "the same under N' and M' of the caisson in motion: it grows without bound as the resultant nears the edge, and the limit of p_e was not made for it"),
    ("margin against overturning", "(W' t - M_U) over the wave's moment about the edge; Goda's where nothing moves"),
]


def section(summary):
    """All checks of a summary, the worst first, and why a verdict is void."""
    checks, void = told_of.checks(summary), judged.void(summary)
    if not checks and not void:
        return Markup("")
    return tag("section", tag("h2", say("Checks")), tag("p", void) if void else "", verdicts(checks) if checks else "", id="sheet")


def verdicts(checks):
    head = heads("check", "demand", "capacity", "margin", "result", "measure and assumption")
    return table(head, [row(check) for check in checks], "numbers wide sheet")


def row(check):
    unit, margin = check.get("unit") or "", check.get("margin")
    stands_on = "; ".join(map(told, (check.get("assumption") or "").split("; ")))
    basis = join([tag("code", check["measure"]) if check.get("measure") else "", prose("; " + stands_on) if stands_on else ""])
    digits = digits_between(check.get("demand"), check.get("capacity"))
    capacity = "" if check.get("capacity") is None else quantity(check["capacity"], unit, digits=digits)
    demand = quantity(check["demand"], unit, digits=digits) if check.get("demand") is not None else "" if check.get("why_not") or is_bare(check) else say("without bound")
    if check.get("probability") is not None:
        demand = join([demand, " (P ", plain(check["probability"], 3), ")"])
    return name_of(check), demand, capacity, "" if margin is None else plain(margin, digits_between(margin, 1.0, 3)), result(check), basis


def name_of(check):
    """What is checked, by what, in which wave and at which level."""
    where = [named(check["by"])] if check.get("by") else []
    where += [as_written(check[key]) for key in ("wave", "level") if check.get(key)]
    return join([prose(told(check["name"])), *([" (", join(where, ", "), ")"] if where else [])])


def result(check):
    if told_of.fails(check):
        return tag("strong", say("does not hold"), *in_runs(check), class_="fails")
    if check.get("why_not"):
        return tag("span", say("not checked"), ": ", prose(told(check["why_not"])), class_="long")
    if told_of.is_judged(check) and check.get("unjudged"):
        words = phrase("holds in {judged} runs, not checked in {unjudged}", judged=check["judged"], unjudged=check["unjudged"])
        return tag("strong", words, class_="fails")
    return say("holds") if told_of.is_judged(check) else say("no limit given")


def is_bare(check):
    """Whether it is of a study of an older version, whose checks have no numbers."""
    return "failing" in check and "worst_run" not in check


def in_runs(check):
    """Of a study: in how many runs, and in which it is worst, whose numbers these are."""
    if "worst_run" not in check:  # studies of older versions told the first run that fails, without its numbers
        return []
    return [" ", phrase("in {failing} of {judged} runs, worst in run {run}", failing=check["failing"], judged=check["judged"], run=check["worst_run"])]


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
