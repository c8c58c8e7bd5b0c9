"""Shared by the documents of a study, a life, a calibration and waves: their order, checks, warnings, assumptions and
appendix."""

from .. import assumptions, author, head, input_tables, inputs, judged, numbers, page, quality, reference, run, sheet, source_case
from ..document import document
from ..language import say, sentences, speaking
from ..markup import Markup, join, tag
from ... import places
from ... import told as told_of
from ...results import read_case, read_summary


def build(folder, found, kind, case_file, language):
    """The HTML; `kind` is a module with COMMAND, KIND, QUESTION, verdict(found) and sections(found)."""
    summary, case = read_summary(folder), read_case(folder)
    if "parts" in summary:  # a sheet: its parts have documents of their own
        summary = {key: value for key, value in summary.items() if key not in ("waves", "run", "expected")}
    heading = summary.get("title") or folder.resolve().name
    source = page.author_case(case or {"title": heading}, folder, case_file)
    words = author.read(case, source, folder / "case.toml")
    with speaking(language or words.language):
        rows = inputs.rows(case, source, source_case.units(folder / "case.toml"), reference.read(places.docs() / "reference/design.md"))
        return document(heading, body(found, kind, words, summary, rows, source, folder, heading), told_of.is_all_void(summary))


def body(found, kind, words, summary, rows, source, folder, heading):
    title = head.title(words, kind.KIND, heading)
    return join(
        [
            tag("header", title, head.question(words, say(kind.QUESTION)), verdict_section(kind.verdict(found), summary)),
            sheet.section(summary),
            *kind.sections(found),
            quality.section(summary),
            assumptions.section(summary, rows, source),
            head.appendix(
                run.section_of(summary),
                numbers.all_of(summary, kind.COMMAND),
                quality.skipped(summary),
                tag("section", tag("h2", say("Inputs")), input_tables.tables(rows), id="inputs") if rows else "",
                run.case_text(folder, source),
            ),
        ]
    )


def verdict_section(told, summary):
    """`told`: (sentences, cards)."""
    words, cards = told
    boxes = tag("div", *cards, class_="cards") if cards else ""
    trust = head.trust(len(told_of.warnings(summary)))
    return tag("section", tag("h2", say("Verdict")), judged.verdict(summary), judged.unreliable(summary), tag("p", sentences(words)), boxes, trust, id="verdict")


def result_section(title, name, *parts):
    inside = [part for part in parts if part]
    return tag("section", tag("h2", say(title)), *inside, id=name) if inside else Markup("")
