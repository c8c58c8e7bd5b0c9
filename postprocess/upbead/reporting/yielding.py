"""Soil that yields: residual displacement of the caisson, energy taken by the soil, where it has yielded, and how
certain that is."""

from . import numbers, zones
from .language import heads, phrase, say, told
from .markup import Markup, join, table, tag
from .measures import at
from .units import percent, quantity
from ..errors import UserError

MOVED = [  # key, what, unit
    ("displacement_x", "displacement of the caisson, landward", "m"),
    ("displacement_y", "its rise; settlement is negative", "m"),
    ("rotation", "its tilt, landward positive", "rad"),
    ("pore_pressure", "largest excess pore pressure left", "Pa"),
]
ENERGY = [
    ("work", "work of the loads"),
    ("plastic", "taken by soil that yields"),
    ("drag", "taken by flow through the pores"),
    ("damping", "taken by material damping"),
    ("radiated", "gone through absorbing sides"),
    ("friction", "taken by friction at the bottom"),
    ("scheme", "taken by the time scheme"),
    ("kinetic", "still in motion"),
    ("strain", "stored by strain"),
    ("fluid", "stored by compressed water"),
    ("lifted", "stored by an open bottom"),
]


def section(result, window):
    """`window`: (x0, x1) near the caisson; an empty text if no soil yields."""
    summary = result.summary
    if not summary.get("nonlinear"):
        return at_rest(summary)
    return tag(
        "section",
        tag("h2", say("Soil that yields")),
        stands(summary),
        residual(summary),
        slide(summary),
        strength(summary),
        energy(summary),
        drawn(result.folder, window),
        id="yielding",
    )


def at_rest(summary):
    """The section of ground whose strength was reduced, though nothing yields under the wave."""
    found = stands(summary)
    return tag("section", tag("h2", say("Ground at rest")), found, id="yielding") if found else Markup("")


def stands(summary):
    """All that is told of the state at rest: by how much the strength may be divided, and how it was found."""
    parts = [numbers.alone(summary.get("safety"), ("safety",), "run"), numbers.alone(at(summary, "nonlinear.rest"), ("nonlinear", "rest"), "run")]
    return join([tag("h3", say("State at rest")), *parts]) if any(parts) else Markup("")


def residual(summary):
    """Residual displacements, by the start of this run and by the other starts."""
    own = summary.get("residual")
    if not own:
        return Markup("")
    nonlinear = summary["nonlinear"]
    ratio = at(summary, "response.shear_to_force_ratio")
    starts = [(nonlinear["start"], ratio, own)]
    starts += [(b["start"], b["shear_to_force_ratio"], b["residual"]) for b in nonlinear["bounds"]]
    head = [say("at the end of the run"), *(say("start {name}", name=name) for name, _, _ in starts)]
    rows = [
        (say(what), *(quantity(r.get(key), unit) for _, _, r in starts))
        for key, what, unit in MOVED
        if own.get(key) is not None
    ]
    rows.append((phrase("peak $F_T$ over peak $P$"), *(percent(value) for _, value, _ in starts)))
    note = say("What the soil bore before the wave is not known of hysteretic soil: the other starts are the bounds.")
    return join([table(head, rows, "numbers"), tag("p", note, class_="quiet") if len(starts) > 1 else ""])


def slide(summary):
    """Explains the different values of S."""
    design, moved = at(summary, "sliding.design"), at(summary, "residual.displacement_x")
    if not design or moved is None:
        return Markup("")
    text = phrase(
        "Two distances stand beside each other: the ground carries the bonded caisson {moved} landward (residual "
        "displacement), and a block on friction under this shear force slips {slip} over the mound ($S$). Neither counts "
        "in the other; the check of the displacement with the ground adds them.",
        moved=quantity(moved, "m"),
        slip=quantity(design["value"], "m"),
    )
    return tag("p", text)


def strength(summary):
    rows = [
        (
            row["region"],
            told(row["law"].replace("_", "-")),
            percent(row["initial"]),
            percent(row["largest"]),
            percent(row["initial_share"]),
            percent(row["share"]),
        )
        for row in summary["nonlinear"].get("regions") or []
    ]
    head = heads("region", "law", "mobilised at rest, at most", "at any time", "area with all of it, at rest", "at any time")
    return join([tag("h3", say("Strength mobilised")), table(head, rows, "numbers")]) if rows else Markup("")


def energy(summary):
    found = summary.get("energy")
    if not found:
        return Markup("")
    work = found["work"]
    rows = [
        (say(what), quantity(found[key], "J/m"), percent(found[key] / work) if work else "")
        for key, what in ENERGY
        if found.get(key)
    ]
    parts = [tag("h3", say("Energy at the end")), table(heads("", "", "of the work"), rows, "numbers")]
    if found.get("strain", 0) < 0:
        why = say("Stored by strain is negative: stresses at rest and weights have given, so that the soil may take more than the loads.")
        parts.append(tag("p", why, class_="quiet"))
    return join(parts)


def drawn(folder, window):
    pvd = folder / "fields.pvd"
    if not pvd.is_file():
        return tag("p", phrase("Where the soil has yielded is drawn of a run with `[output] fields`."), class_="quiet")
    try:
        found = zones.read(pvd, window)
    except UserError as error:
        return tag("p", say("Not drawn: {why}.", why=error), class_="quiet")
    return join([tag("h3", say("Where it has yielded")), zones.figures(found)]) if found else Markup("")
