"""Reliability of the numbers: warnings, estimated errors, balances, and the parts that were left out, with
reasons."""

from .judged import said
from .language import heads, named, phrase, say, spoken, told
from .markup import Markup, join, prose, table, tag
from .units import percent, quantity
from .. import outputs
from .. import told as told_of


def section(summary):
    """Of any summary: warnings, and what a run has of errors and soil."""
    return tag(
        "section",
        tag("h2", say("How far to trust these numbers")),
        warnings(told_of.warnings(summary)),
        errors(summary),
        soil(summary),
        id="quality",
    )


def warnings(found):
    """`found`: [(name, text)]. The texts stand as the program has them, the cure first."""
    if not found:
        return tag("p", say("The program found nothing to warn of."))
    items = (tag("li", tag("strong", named(name)), " ", tag("code", name), ": ", said(text)) for name, text in found)
    return join([tag("h3", say("Warnings")), in_english(), tag("ul", *items, class_="warnings")])


def in_english():
    """A note that the program's own texts are not translated."""
    return tag("p", say("The texts of the program are in English."), class_="quiet") if spoken() != "en" else Markup("")


def errors(summary):
    response, rows = summary.get("response") or {}, []
    if response.get("error_estimate") is not None:
        rows.append(
            (say("estimated error of the peak shear force"), percent(response["error_estimate"]), say("sum of the parts below"))
        )
        for key, value in (response.get("error_sources") or {}).items():
            source = told(outputs.label(f"response.error_sources.{key}")) or named(key)
            rows.append((say("of it: {source}", source=source), percent(value), ""))
        if response.get("history_error_estimate") is not None:
            rows.append(
                (
                    say("estimated error of the shear force at any time"),
                    percent(response["history_error_estimate"]),
                    say("over its largest; the far sides taken as they are"),
                )
            )
        slip = (summary.get("sliding") or {}).get("error_estimate")
        if slip is not None:
            rows.append((say("estimated error of the sliding distance"), quantity(slip, "m"), say("by eq. (4) on the history")))
    reduction = summary.get("reduction")
    if reduction:
        nested = say("by a larger model beside it, over the peak")
        rows += [
            (phrase("history of $F_T$"), percent(reduction.get("error")), nested),
            (phrase("peak $F_T$"), percent(reduction.get("error_peak")), nested),
            (say("all other readings"), percent(reduction.get("error_of_others")), say("each over its own largest value")),
            (say("highest frequency checked"), quantity(reduction.get("highest_frequency"), "Hz"), ""),
        ]
    for key, what, about in (
        ("reaction_mismatch", "both routes to the shear force", "force balance and ground's reaction; round-off"),
        ("energy_mismatch", "energy", "work of the loads minus all energies stored and taken; round-off"),
    ):
        if response.get(key) is not None:
            rows.append((say(what), quantity(response[key]), say(about)))
    note = Markup("")
    if response and response.get("error_estimate") is None:
        asked = "The error by mesh and steps was not estimated in this run; `mesh.refine = \"auto\"` or `accuracy.estimate = true` in the case asks for it."
        note = tag("p", phrase(asked), class_="quiet")
    return (
        join([tag("h3", say("Errors and checks")), table(heads("error of", "relative", "about"), rows, "numbers wide"), note])
        if rows
        else note
    )


def soil(summary):
    """Soil that follows the strain, and the mobilised strength, if the case has them."""
    parts, found = [], summary.get("soil")
    if found:
        rows = [
            (told(outputs.label(f"soil.{key}")), (percent if key == "largest_damping" else quantity)(found[key]))
            for key in ("iterations", "converged", "largest_strain", "least_modulus_ratio", "largest_damping", "largest_velocity", "least_conductivity_ratio")
        ]
        parts += [tag("h3", say("Soil that follows the strain")), table(heads("quantity", "value"), rows, "numbers")]
    strength = summary.get("strength") or []
    if strength:
        rows = [
            (
                row["region"],
                quantity(row.get("initial")),
                quantity(row.get("largest")),
                percent(row.get("initial_share")),
                percent(row.get("share")),
            )
            for row in strength
        ]
        head = heads("region", "mobilised at rest", "at any time", "share of the area that yields at rest", "at any time")
        parts += [tag("h3", say("Strength")), table(head, rows, "numbers")]
    return join(parts)


def skipped(summary):
    rows = [(named(entry["what"]), prose(entry["why"])) for entry in summary.get("skipped") or []]
    if not rows:
        return Markup("")
    return tag("section", tag("h2", say("Left out, and why")), in_english(), table(heads("what", "why"), rows, "words"), id="skipped")
