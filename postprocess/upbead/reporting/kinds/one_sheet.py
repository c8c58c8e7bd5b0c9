"""The document of a sheet: all checks by the way to fail, where measures disagree, what is not looked at."""

from ..head import card
from .frame import result_section
from ..language import heads, phrase, say
from ..language import told as words_of
from ..markup import join, prose, table, tag
from ..sheet import row
from ... import told

COMMAND = "sheet"
KIND = "Sheet of a section by upbead"
QUESTION = "Does the section hold in every way that the program looks at, and what governs each?"


def verdict(found):
    checks = told.checks(found)
    modes = list(dict.fromkeys(check["mode"] for check in found["checks"]))
    failing = [mode for mode in modes if any(told.fails(check) for check in checks if check["mode"] == mode)]
    cards = [
        card(say("ways to fail that were looked at"), str(len(modes)), ""),
        card(say("of them beyond their limit"), str(len(failing)), ", ".join(words_of(mode) for mode in failing)),
    ]
    return [], cards


def sections(found):
    return [
        result_section("What governs", "governs", governing(found["checks"])),
        result_section("Measures that disagree", "disagree", *disagreements(found)),
        result_section("Not looked at", "missing", missing(found)),
    ]


def governing(checks):
    """Of each way to fail the check that governs it, or why none does."""
    head = heads("way to fail", "check", "demand", "capacity", "margin", "result", "measure and assumption")
    rows, modes = [], dict.fromkeys(check["mode"] for check in checks)
    for mode in modes:
        of_mode = [check for check in checks if check["mode"] == mode]
        worst = next((check for check in of_mode if check["governs"]), of_mode[0])
        rows.append((prose(words_of(mode)), *row(worst)))
    return table(head, rows, "numbers wide sheet")


def disagreements(found):
    if not found["disagreements"]:
        return []
    items = [
        tag("li", phrase("{mode}: {fails}; but it holds by {holds}.", mode=prose(words_of(one["mode"])), fails=one["fails"], holds=", ".join(one["holds"])))
        for one in found["disagreements"]
    ]
    return [tag("p", say("Both stand, and the worse governs.")), tag("ul", *items)]


def missing(found):
    """What the file does not ask for, and what the program does not look at."""
    parts = [tag("li", prose(f"{part['name']}: {part['why_not']}")) for part in found["parts"] if part["why_not"]]
    return tag("ul", join([*parts, *(tag("li", prose(words_of(one))) for one in found["not_covered"])]))
