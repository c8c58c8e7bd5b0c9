"""The whole page: sections in the order in which a client reads, style and script within."""

from pathlib import Path

from report import (
    animation,
    base,
    drawing,
    geometry,
    head,
    input_tables,
    inputs,
    measured,
    quality,
    response,
    run,
    sheet,
    sliding,
    source_case,
    whatif,
    yielding,
)
from report.figure import of_drawing
from report.markup import Markup, join, prose, tag
from upbead.errors import UserError

HERE = Path(__file__).parent
SCRIPTS = ("clock.js", "plot.js", "raster.js", "deformed.js", "animation.js")


def build(result, case_file=None):
    """The HTML of a result; `case_file` is the case as its author wrote it, looked for where not given."""
    case = result.case
    source = author_case(case, result.folder, case_file)
    outline, drawn = section_drawing(result, case)
    sections = [
        head.head(result),
        sheet.section(result, outline),
        drawn,
        input_section(case, source, result.folder),
        response.section(result, measured.by_reading(result)),
        base.section(result),
        sliding.section(result),
        yielding.section(result, near(outline)),
        whatif.section(result),
        animation.section(result, near(outline)),
        measured.section(result),
        quality.section(result),
        sheet.formulas(result),
        run.section(result),
        run.case_text(result.folder, source),
    ]
    return document(result.title, join(sections))


def document(title, body):
    style = tag("style", Markup((HERE / "page.css").read_text(encoding="utf-8")))
    scripts = (tag("script", Markup((HERE / name).read_text(encoding="utf-8"))) for name in SCRIPTS)
    meta = (
        tag("meta", charset="utf-8"),
        tag("meta", name="viewport", content="width=device-width, initial-scale=1"),
        tag("link", rel="icon", href="data:,"),
    )
    return (
        "<!DOCTYPE html>\n"
        + tag(
            "html", tag("head", *meta, tag("title", title), style), tag("body", tag("main", body), *scripts), lang="en"
        )
        + "\n"
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


def section_drawing(result, case):
    """(Section or None, HTML)."""
    title = tag("h2", "Section")
    try:
        outline = geometry.section(case, result.folder)
    except UserError as error:
        return None, tag("section", title, tag("p", f"Not drawn: {error}.", class_="quiet"), id="section")
    points = "; ".join(f"{number} {name.replace('_', ' ')}" for number, name in enumerate(case.get("probes", {}), 1))
    seaward = ", the sea on the left" if "caisson" in outline.regions else ""
    caption = f"The section to scale{seaward}." + (f" Points read: {points}." if points else "")
    drawn = of_drawing("drawing", drawing.draw(outline, case, result.summary), caption)
    return outline, tag("section", title, drawn, id="section")


def near(outline):
    """The window of the animation: the mound and as much of the seabed as the drawing shows."""
    if outline is None:
        return float("-inf"), float("inf")
    p = outline.parameters
    return drawing.near(outline, p)[:2] if "mound_slope" in p else outline.box()[:2]


def input_section(case, source, folder):
    found = inputs.rows(case, source, source_case.units(folder / "case.toml"))
    if not found:
        return Markup("")
    if source is None:
        told = tag(
            "p",
            "The case as its author wrote it was not found: what was given is distinguished from the defaults by comparison, and what is "
            "assumed or calibrated is not known. Give it by ",
            tag("code", "--case"),
            ".",
            class_="quiet",
        )
    else:
        told = (
            tag("blockquote", prose(" ".join(source.head.split())), tag("footer", f"at the head of {source.path.name}"))
            if source.head
            else Markup("")
        )
    return tag("section", tag("h2", "Inputs"), told, input_tables.tables(found), id="inputs")
