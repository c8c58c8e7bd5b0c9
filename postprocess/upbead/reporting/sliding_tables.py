"""Details of a slip besides its distance: contact node by node, single slips, equivalent durations."""

from .language import heads, say, told
from .markup import Markup, fold, join, table, tag
from .measures import at
from .units import percent, quantity
from .. import outputs


def contact(summary):
    solved = at(summary, "contact.solved")
    if not solved:
        return Markup("")
    keys = ("largest_slip", "opening_seaward", "opening_landward", "least_contact", "least_normal_force", "dissipated")
    rows = [(told(outputs.label(path)), percent(solved[key]) if key == "least_contact" else quantity(solved[key], outputs.unit(path)))
            for key, path in ((key, f"contact.solved.{key}") for key in keys)]
    return join([tag("h3", say("Contact node by node")), table(heads("quantity", "value"), rows, "numbers")])


def slips(sliding):
    rows = []
    for name, found in ((say("eq. (4)"), sliding.get("slips")), (say("as a whole"), (sliding.get("coupled") or {}).get("slips"))):
        for number, slip in enumerate(found or [], 1):
            rows.append(
                (
                    say("{name}, slip {number}", name=name, number=number),
                    quantity(slip["start"], "s"),
                    quantity(slip["stop"], "s"),
                    quantity(slip["distance"], "m"),
                    quantity(slip["peak_velocity"], "m/s"),
                )
            )
    return (
        fold(
            say("{count} slips one by one", count=len(rows)),
            table(heads("slip", "from", "until", "distance", "largest velocity"), rows, "numbers"),
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
    head = heads("$F_S$ / μW′", "S", "τ₀ by eq. (7)", "integrated", "by time above μW′", "by impulse")
    about = tag(
        "p",
        say(
            "Duration of the triangular pulse of equal peak that slides as far as this history, were the resistance "
            "less or more than it is."
        ),
    )
    return fold(say("Equivalent duration of this history, for other resistances"), about, table(head, rows, "numbers"))
