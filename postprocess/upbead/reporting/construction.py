"""The stages in which the section was built: settlement, tilt, pressure on the base and strength in each."""

from .language import heads, named, phrase, say
from .markup import Markup, join, table, tag
from .units import percent, quantity

EDGES = ("heel_pressure", "toe_pressure")


def section(summary):
    """An empty text where it was not built in stages."""
    found = summary.get("construction")
    if not found:
        return Markup("")
    return tag(
        "section",
        tag("h2", say("Construction in stages")),
        stages(found["stages"]),
        since_set_down(found.get("caisson")),
        tag("p", phrase("The stage {stage} has no state at rest.", stage=found["falls_in"])) if found.get("falls_in") else "",
        tag("p", say("Each stage is drained. This settlement is not in that of the wave, nor in its limit."), class_="quiet"),
        id="construction",
    )


def stages(rows):
    head = heads(
        "stage", "what appears", "weight in water", "settlement of the ground, largest", "settlement of the caisson",
        "tilt of the caisson", "heel pressure", "toe pressure", "strength mobilised, at most"
    )
    return table(head, [row(stage) for stage in rows], "numbers") if rows else Markup("")


def row(stage):
    caisson = stage.get("caisson") or {}
    return (
        named(stage["name"]),
        ", ".join(named(name) for name in stage["regions"].split(", ")) if stage["regions"] else "",
        quantity(stage["weight"], "N/m"),
        told_where(stage.get("settlement"), "m"),
        told_where(caisson.get("settlement"), "m"),
        told_where(caisson.get("rotation"), "rad"),
        *(told_where(stage.get(edge), "Pa") for edge in EDGES),
        "" if stage.get("mobilised") is None else join([percent(stage["mobilised"]), " (", named(stage["mobilised_in"]), ")"]),
    )


def told_where(value, unit):
    return "" if value is None else quantity(value, unit)


def since_set_down(caisson):
    if not caisson:
        return Markup("")
    text = phrase(
        "Since it was set down the caisson has settled {down} and moved {landward} landward; its tilt is {tilt}.",
        down=quantity(caisson["settlement"], "m"),
        landward=quantity(caisson["displacement_x"], "m"),
        tilt=quantity(caisson["rotation"], "rad"),
    )
    return tag("p", text)
