"""How far to trust the numbers: warnings, estimated errors, balances, and what was left out with why."""

from report.figure import words
from report.markup import Markup, join, prose, table, tag
from report.units import percent, quantity
from upbead import outputs


def section(result):
    summary = result.summary
    return tag(
        "section",
        tag("h2", "How far to trust these numbers"),
        warnings(summary),
        errors(summary),
        soil(summary),
        skipped(summary),
        id="quality",
    )


def warnings(summary):
    found = summary.get("warnings") or []
    if not found:
        return tag("p", "The program found nothing to warn of.")
    items = (
        tag("li", tag("strong", warning["name"].replace("_", " ")), ": ", prose(warning["text"])) for warning in found
    )
    return join([tag("h3", "Warnings"), tag("ul", *items, class_="warnings")])


def errors(summary):
    response, rows = summary.get("response") or {}, []
    if response.get("error_estimate") is not None:
        rows.append(
            ("estimated error of the peak shear force", percent(response["error_estimate"]), "sum of the parts below")
        )
        for key, value in (response.get("error_sources") or {}).items():
            rows.append((f"of it: {outputs.label(f'response.error_sources.{key}') or key.replace('_', ' ')}", percent(value), ""))
        if response.get("history_error_estimate") is not None:
            rows.append(
                (
                    "estimated error of the shear force at any time",
                    percent(response["history_error_estimate"]),
                    "over its largest; the far sides taken as they are",
                )
            )
        slip = (summary.get("sliding") or {}).get("error_estimate")
        if slip is not None:
            rows.append(("estimated error of the sliding distance", quantity(slip, "m"), "by eq. (4) on the history"))
    reduction = summary.get("reduction")
    if reduction:
        nested = "between nested reduced models, over the peak"
        rows += [
            (words("history of ", ("F_T",)), percent(reduction.get("error")), nested),
            (words("peak ", ("F_T",)), percent(reduction.get("error_peak")), nested),
            ("all other readings", percent(reduction.get("error_of_others")), "each over its own largest value"),
            ("highest frequency checked", quantity(reduction.get("highest_frequency"), "Hz"), ""),
        ]
    for key, what, about in (
        ("reaction_mismatch", "both routes to the shear force", "force balance and ground's reaction; round-off"),
        ("energy_mismatch", "energy", "work of the loads minus all energies stored and taken; round-off"),
    ):
        if response.get(key) is not None:
            rows.append((what, quantity(response[key]), about))
    told = Markup("")
    if response and response.get("error_estimate") is None:
        told = tag(
            "p",
            "The error by mesh and steps was not estimated in this run; ",
            tag("code", 'mesh.refine = "auto"'),
            " or ",
            tag("code", "accuracy.estimate = true"),
            " in the case asks for it.",
            class_="quiet",
        )
    return (
        join([tag("h3", "Errors and checks"), table(("error of", "relative", "about"), rows, "numbers wide"), told])
        if rows
        else told
    )


def soil(summary):
    """Soil that follows the strain, and its strength, where the case has them."""
    parts, found = [], summary.get("soil")
    if found:
        rows = [
            (outputs.label(f"soil.{key}"), (percent if key == "largest_damping" else quantity)(found[key]))
            for key in ("iterations", "converged", "largest_strain", "least_modulus_ratio", "largest_damping")
        ]
        parts += [tag("h3", "Soil that follows the strain"), table(("quantity", "value"), rows, "numbers")]
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
        head = ("region", "mobilised at rest", "at any time", "share of the area that yields at rest", "at any time")
        parts += [tag("h3", "Strength"), table(head, rows, "numbers")]
    return join(parts)


def skipped(summary):
    rows = [(entry["what"].replace("_", " "), prose(entry["why"])) for entry in summary.get("skipped") or []]
    if not rows:
        return Markup("")
    return join([tag("h3", "Left out, and why"), table(("what", "why"), rows, "words")])
