"""The document of a run: sections in the order in which a client reads them, and behind them those on the
solution."""

from . import (
    animation,
    assumptions,
    author,
    base,
    circle,
    construction,
    drawing,
    geometry,
    head,
    input_tables,
    inputs,
    loads,
    measured,
    numbers,
    quality,
    response,
    run,
    sensitivity,
    sheet,
    sliding,
    source_case,
    verdict,
    whatif,
    yielding,
)
from .document import document
from .figure import of_drawing
from .language import named, say, speaking
from .markup import Markup, join, tag
from .. import told as told_of
from ..errors import UserError


def build(result, case_file=None, language=None):
    """The HTML of a result; `case_file` is the case as its author wrote it, searched for if not given.

    `language` takes precedence over that of the case.
    """
    source = author_case(result.case, result.folder, case_file)
    words = author.read(result.case, source, result.folder / "case.toml")
    with speaking(language or words.language):
        return document(result.title, body(result, source, words), told_of.is_all_void(result.summary))


def body(result, source, words):
    outline, drawn = section_drawing(result)
    rows = inputs.rows(result.case, source, source_case.units(result.folder / "case.toml"))
    return join(
        [
            tag(
                "header",
                head.title(words, "Report of a run of upbead", result.title),
                head.question(words, verdict.question(result)),
                verdict.section(result),
            ),
            drawn,
            loads.section(result),
            response.section(result, measured.by_reading(result)),
            base.section(result),
            sliding.section(result),
            construction.section(result.summary),
            yielding.section(result, near(outline, result.case)),
            circle.section(result, outline),
            whatif.section(result),
            animation.section(result, near(outline, result.case)),
            measured.section(result),
            sheet.section(result.summary),
            quality.section(result.summary),
            sensitivity.section(result),
            assumptions.section(result.summary, rows, source),
            head.appendix(
                run.section(result),
                sheet.formulas(result),
                numbers.all_of(result.summary, "run"),
                quality.skipped(result.summary),
                input_section(rows),
                run.case_text(result.folder, source),
            ),
        ]
    )


def author_case(case, folder, path):
    if path is None:
        return source_case.find(case, folder)
    try:
        return source_case.read(path)
    except OSError as error:
        raise UserError(f"cannot read '{path}': {error.strerror}") from error
    except ValueError as error:
        raise UserError(f"'{path}' is no case: {error}") from error


def section_drawing(result):
    """(Section or None, HTML)."""
    title, case = tag("h2", say("Section")), result.case
    try:
        outline = geometry.section(case, result.folder, result.file)
    except UserError as error:
        told = tag("p", say("Not drawn: {why}.", why=error), class_="quiet")
        return None, tag("section", title, told, sheet.levels(case, None), id="section")
    caption = say("The section to scale, the sea on the left.") if "caisson" in outline.regions else say("The section to scale.")
    points = "; ".join(f"{number} {named(name)}" for number, name in enumerate(case.get("probes", {}), 1))
    if points:
        caption = join([caption, " ", tag("span", say("Points read: {points}.", points=points), class_="written")])
    drawn = of_drawing("drawing", drawing.draw(outline, case, result.summary), caption)
    return outline, tag("section", title, drawn, sheet.levels(case, outline), id="section")


def near(outline, case):
    """The window of the animation: the mound and the part of the seabed that is in the drawing."""
    if outline is None:
        return float("-inf"), float("inf")
    return drawing.near(outline, case)[:2] if drawing.body_of(outline) else outline.box()[:2]


def input_section(rows):
    return tag("section", tag("h2", say("Inputs")), input_tables.tables(rows), id="inputs") if rows else Markup("")
