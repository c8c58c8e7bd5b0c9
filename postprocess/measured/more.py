"""What docs/validation.md says of the measurements in more.md: rows of the overview, numbers and tables of the sections."""

from . import choices, forces, quay, spectrum, tsunami
from .runs import CASES

STEPS = {"tsunami": tsunami.shares, "quay": quay.numbers, "forces": forces.numbers, "spectrum": spectrum.against_theirs, "choices": choices.of_slip}
TEXT = CASES.parents[1] / "postprocess/measured/more.md"
SHORT = {"seaward": "seaward (m)", "down": "down (m)", "tilt": "tilt (degrees)"}
MIDDLE = {"seaward": 4.5, "down": 2.0, "tilt": 4.0}


def percent(share):
    return f"{100 * share:.0f} %"


def overview(now):
    (wall, pressed, _), slid, said = now["quay"].values(), now["tsunami"], now["spectrum"]
    narrow, low, wide = (slid[name] for name in (list(tsunami.GROUPS)[0], list(tsunami.GROUPS)[1], list(tsunami.GROUPS)[3]))
    return [
        ("[beach](#the-same-beach-at-other-frequencies), 0.05 to 0.3 Hz, 15 to 50 cm: lag", f"{min(said['lags']):.0f} to {max(said['lags']):.0f} degrees", "within 10 % of another theory", f"{said['lag']:.2f}", "yes; through that theory"),
        ("the same: variance ratio", f"{said['variance']:.2f} of that theory's", "within 10 % of it", f"{said['variance']:.2f}", "yes; through that theory"),
        ("[quay wall in Kobe](#a-quay-wall-in-the-earthquake-of-kobe): displacement seaward", f"{wall['seaward']:.1f} m, without pore pressure", "4 to 5 m", f"{wall['seaward'] / 4.5:.2f}", "no"),
        ("the same, pore pressure of half the stress assumed", f"{pressed['seaward']:.1f} m", "4 to 5 m", f"{pressed['seaward'] / 4.5:.2f}", "no"),
        ("the same, without: settlement; tilt", f"{wall['down']:.1f} m; {wall['tilt']:.0f} degrees", "about 2 m; about 4 degrees", f"{wall['down'] / 2:.2f}; {wall['tilt'] / 4:.1f}", "no"),
        ("[tsunami of 2011](#breakwaters-in-the-tsunami-of-2011), narrower than 8 m, above 14 m: slid", percent(narrow), "all", f"{narrow:.2f}", "no; nothing fitted"),
        ("the same: below 6 m", percent(low), "not greatly damaged", "", "no; nothing fitted"),
        ("the same: wider than 14 m, above 6 m", percent(wide), "not greatly damaged", "", "no; nothing fitted"),
        ("[crown walls](#crown-walls): slide by the one-dimensional model over that on ground that answers", f"{one_dimension(now):.2f}, in case W", "about 3", f"{one_dimension(now) / 3:.2f}", "no; another section"),
        ("[forces in nine projects](#forces-over-godas): P", "Goda's", "0.90 of it, scatter 0.25", f"{1 / forces.MEAN:.2f}", "no"),
    ]  # fmt: skip


def one_dimension(now):
    """Slip of a rigid block on rigid ground over that node by node, of case W."""
    return now["flume"]["formula, triangle, exact"] / now["flume"]["node by node, triangle"]


def quay_rows(now):
    rows = [("measured", *(quay.MEASURED[name] for name in SHORT), "")]
    for name, values in now["quay"].items():
        falls = values["tilt"] > 30  # of small displacements no more
        rows.append((name, *("falls over" if falls else f"{values[number]:.2f} ({values[number] / MIDDLE[number]:.2f})" for number in SHORT), "" if falls else f"{values['slip']:.2f}"))
    return rows


def tsunami_rows(now):
    return [(name, "all" if known else "not greatly", percent(now["tsunami"][name]), "yes" if abs(now["tsunami"][name] - known) < 0.2 else "no") for name, (_, _, known) in tsunami.GROUPS.items()]


def text(now, table):
    """The sections of more.md with numbers and tables in place."""
    wall, heights = now["quay"]["with a backfill that holds"], now["tsunami"]["threshold"]
    parts = {
        "quay": "\n".join(table(("", *SHORT.values(), "slip on its mound (m)"), quay_rows(now))),
        "tsunami": "\n".join(table(("said of", "damaged", "slide by the formula", "agrees"), tsunami_rows(now))),
        "ground": percent(1 - wall["slip"] / wall["seaward"]),
        "pressed": f"{list(now['quay'].values())[1]['seaward']:.1f}",
        "half": f"{wall['seaward'] / (quay.INERTIA * 4.5):.2f}",
        "eight": f"{heights['8']:.1f}",
        "fourteen": f"{heights['14']:.1f}",
        "filled": percent(now["tsunami"]["filled"]),
        "risen": percent(now["tsunami"]["not filled"]),
        "one": f"{one_dimension(now):.2f}",
        "life": f"{now['forces']['E']:.2f}",
        "less": f"{now['forces']['E, 0.90 of P']:.2f}",
        "lag over theirs": f"{now['spectrum']['lag']:.2f}",
        "variance over theirs": f"{now['spectrum']['variance']:.2f}",
        "own share": percent(now["spectrum"]["own share"]),
    }
    found = TEXT.read_text(encoding="utf-8")
    for name, part in parts.items():
        found = found.replace("{{" + name + "}}", part)
    return found
