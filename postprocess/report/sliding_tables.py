"""What is told of a slip besides its distance: contact node by node, slips one by one, equivalent durations."""

from report.markup import Markup, fold, join, table, tag
from report.measures import at
from report.units import percent, quantity


def contact(summary):
    solved = at(summary, "contact.solved")
    if not solved:
        return Markup("")
    rows = [
        ("largest slip on the way", quantity(solved["largest_slip"], "m")),
        ("largest opening of the seaward end", quantity(solved["opening_seaward"], "m")),
        ("largest opening of the landward end", quantity(solved["opening_landward"], "m")),
        ("least share of the bottom that touches", percent(solved["least_contact"])),
        ("least normal force", quantity(solved["least_normal_force"], "N/m")),
        ("energy taken by friction", quantity(solved["dissipated"], "J/m")),
    ]
    return join([tag("h3", "Contact node by node"), table(("quantity", "value"), rows, "numbers")])


def slips(sliding):
    rows = []
    for name, found in (("eq. (4)", sliding.get("slips")), ("as a whole", (sliding.get("coupled") or {}).get("slips"))):
        for number, slip in enumerate(found or [], 1):
            rows.append(
                (
                    f"{name}, slip {number}",
                    quantity(slip["start"], "s"),
                    quantity(slip["stop"], "s"),
                    quantity(slip["distance"], "m"),
                    quantity(slip["peak_velocity"], "m/s"),
                )
            )
    return (
        fold(
            f"{len(rows)} slips one by one",
            table(("slip", "from", "until", "distance", "largest velocity"), rows, "numbers"),
        )
        if rows
        else Markup("")
    )


def durations(sliding):
    rows = [
        (
            quantity(row["ratio"]),
            quantity(row["sliding"], "m"),
            *(quantity(row[key], "s") for key in ("by_paper", "by_exact", "by_excess", "by_impulse")),
        )
        for row in sliding.get("duration_table") or []
    ]
    if not rows:
        return Markup("")
    head = ("F_S / μW′", "S", "τ₀ by eq. (7)", "integrated", "by time above μW′", "by impulse")
    about = tag(
        "p",
        "Duration of the triangular pulse of equal peak that slides as far as this history, were the resistance "
        "less or more than it is.",
    )
    return fold("Equivalent duration of this history, for other resistances", about, table(head, rows, "numbers"))
