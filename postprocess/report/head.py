"""The head of the page: what was asked, and the three numbers that matter."""

from report.figure import words
from report.markup import Markup, join, tag
from report.measures import best
from report.units import percent, quantity


def head(result):
    summary = result.summary
    return tag(
        "header",
        tag("p", "Report of a run of upbead", class_="kind"),
        tag("h1", result.title),
        tag("p", asked(result), class_="asked"),
        tag("div", *cards(result), class_="cards"),
        verdict(summary),
    )


def asked(result):
    """One line: the question of this run."""
    if not result.has_caisson:
        return "How does this section respond to its loads? It has no caisson, so there is no shear force to tell."
    question = "How much of the wave's horizontal force reaches the caisson's bottom as shear force"
    return question + (", and how far does the caisson slide?" if result.summary.get("sliding") else "?")


def cards(result):
    response = result.summary.get("response") or {}
    if not result.has_caisson or not response:
        return [card("length of the run", quantity(float(result.time[-1]), "s"), "no shear force without a caisson")]
    seaward = abs(response.get("peak_force_seaward") or 0.0) > abs(response.get("peak_force") or 0.0)
    key, way = ("peak_shear_seaward", "seaward") if seaward else ("peak_shear", "landward")
    when = words("largest shear force at the bottom, ", way, ", at ", quantity(response.get(key + "_time"), "s"))
    found = [card(words("peak ", ("F_T",)), quantity(response.get(key), "N/m"), when)]
    peak = response.get("peak_force_seaward" if seaward else "peak_force")
    ratio = response.get("shear_to_force_ratio")
    found.append(
        card(
            words("peak ", ("F_T",), " / peak ", ("P",)),
            "none" if ratio is None else tag("data", f"{ratio:.3f}", value=repr(ratio)),
            words("of the wave's peak force ", ("P",), " = ", quantity(peak, "N/m")),
        )
    )
    found.append(sliding_card(result.summary))
    return found


def sliding_card(summary):
    measure = best(summary)
    name = words("sliding distance ", ("S",))
    if measure is None:
        return card(name, "not asked", "the case has no table [sliding]")
    sliding = summary.get("sliding") or {}
    if measure.value == 0 and (sliding.get("ratio") or 0) > 0:
        return card(
            name,
            quantity(measure.value, "m"),
            join(["friction holds: the sliding force is ", percent(sliding["ratio"]), " of the resistance"]),
        )
    return card(name, quantity(measure.value, "m"), measure.short)


def card(name, value, below):
    return tag(
        "div",
        tag("div", name, class_="name"),
        tag("div", value, class_="value"),
        tag("div", below, class_="below"),
        class_="card",
    )


def verdict(summary):
    """One line on how far to trust these numbers, with links."""
    count = len(summary.get("warnings") or [])
    error = (summary.get("response") or {}).get("error_estimate")
    told = f"{count} warning{'s' if count != 1 else ''}" if count else "no warnings"
    parts = [tag("a", told, href="#quality", class_="warned" if count else None)]
    if error is not None:
        parts.append(join(["estimated error of peak ", words(("F_T",)), ": ", percent(error)]))
    elif summary.get("response"):
        parts.append(Markup("error of peak <i>F</i><sub>T</sub> not estimated in this run"))
    return tag("p", join(parts, " · "), class_="verdict")
