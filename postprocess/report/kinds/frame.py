"""Shared by the documents of a study, a life, a calibration and waves: their order, warnings, assumptions and
appendix."""

from pathlib import Path

from report import assumptions, author, head, input_tables, inputs, page, quality, reference, run, source_case
from report.document import document
from report.language import named, say, sentences, spaced, speaking
from report.markup import Markup, join, prose, tag
from upbead.results import read_case, read_summary

DOCS = Path(__file__).parents[3] / "docs"


def build(folder, found, kind, case_file, language):
    """The HTML; `kind` is a module with KIND, QUESTION, verdict(found) and sections(found)."""
    summary, case = read_summary(folder), read_case(folder)
    heading = summary.get("title") or folder.resolve().name
    source = page.author_case(case or {"title": heading}, folder, case_file)
    words = author.read(case, source, folder / "case.toml")
    with speaking(language or words.language):
        rows = inputs.rows(case, source, source_case.units(folder / "case.toml"), reference.read(DOCS / "design.md"))
        return document(heading, body(found, kind, words, summary, rows, source, folder, heading))


def body(found, kind, words, summary, rows, source, folder, heading):
    told = warnings_of(summary)
    title = head.title(words, kind.KIND, heading)
    verdict = verdict_section(kind.verdict(found), told)
    return join(
        [
            tag("header", title, head.question(words, say(kind.QUESTION)), verdict),
            *kind.sections(found),
            warning_section(told),
            assumptions.section(summary, rows, source),
            head.appendix(
                run.section_of(summary),
                quality.skipped(summary),
                tag("section", tag("h2", say("Inputs")), input_tables.tables(rows), id="inputs") if rows else "",
                run.case_text(folder, source),
            ),
        ]
    )


def verdict_section(told, warnings):
    """`told`: (sentences, cards)."""
    words, cards = told
    if warnings:
        words = [*words, say("The program warns of what stands below; all numbers here stand under these warnings.")]
    boxes = tag("div", *cards, class_="cards") if cards else ""
    return tag("section", tag("h2", say("Verdict")), tag("p", sentences(words)), boxes, head.trust(None if warnings is None else len(warnings)), id="verdict")


def warnings_of(summary):
    """[(name of the wave or "", name, text)] of the warnings of the summary and of each of its waves; None if these
    results have no list of warnings."""
    waves = {name: wave for name, wave in (summary.get("waves") or {}).items() if isinstance(wave, dict)}
    kept = [(name, found["warnings"]) for name, found in {"": summary, **waves}.items() if "warnings" in found]
    if not kept:
        return None
    return [(name, warning["name"], warning["text"]) for name, warnings in kept for warning in warnings or []]


def warning_section(found):
    if not found:
        words = "The program found nothing to warn of."
        if found is None:
            words = "These results keep no warnings: what the program warned of stood on the terminal alone."
        nothing = tag("p", say(words))
        return tag("section", tag("h2", say("How far to trust these numbers")), nothing, id="quality")
    items = [
        tag("li", f"{spaced(of)}: " if of else "", tag("strong", named(name), class_=None), ": ", prose(text))
        for of, name, text in found
    ]
    parts = tag("h3", say("Warnings")), quality.in_english(), tag("ul", *items, class_="warnings")
    return tag("section", tag("h2", say("How far to trust these numbers")), *parts, id="quality")


def result_section(title, name, *parts):
    inside = [part for part in parts if part]
    return tag("section", tag("h2", say(title)), *inside, id=name) if inside else Markup("")
