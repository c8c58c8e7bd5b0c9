"""The page docs/reference/gallery.md: its sections, and whether it is up to date."""

import io
import tomllib

from PIL import Image

from upbead.errors import UserError
from upbead.figures.style import render

from . import numbers, text

LARGEST = 60_000  # bytes of a figure
HEAD = """# Gallery

Every shipped case: what it is, what it shows, its numbers. The page is made by

    /usr/bin/python3 postprocess/gallery.py build/upbead docs

which solves every case. Forces and moments are per metre of breakwater. A row of a study has the least, the median and the
largest value over all its runs. What is assumed and what is calibrated: [cases](../../cases/README.md).
"""


def save_small(figure, path):
    """Writes a .png of at most LARGEST bytes: with fewer colours, then with fewer pixels."""
    for dpi in (110, 100, 90, 80, 70, 60):
        picture = Image.open(io.BytesIO(render(figure, dpi))).convert("RGB")
        for colours in (256, 128):
            buffer = io.BytesIO()
            picture.quantize(colours).save(buffer, "PNG", optimize=True)
            if buffer.tell() <= LARGEST:
                path.write_bytes(buffer.getvalue())
                return
    raise UserError(f"'{path}' cannot be made smaller than {LARGEST} bytes")


def command_line(entry, case):
    setting = "".join(f" --set {key}={value}" for key, value in entry.setting.items())
    return f"    build/upbead {entry.command} cases/{case}{setting}"


def table_lines(entry, opened):
    heads = numbers.heads(entry.command, entry.cases, opened)
    lines = ["| | " + " | ".join(heads) + " |", "|---|" + "---:|" * len(heads)]
    return lines + ["| " + " | ".join(row) + " |" for row in numbers.table(entry.command, opened)]


def heading_of(cases, entry):
    return entry.title or tomllib.loads((cases / entry.cases[0]).read_text(encoding="utf-8"))["title"]


def section(cases, entry, opened, docs):
    """Writes the entry's figure, and returns the lines of its section."""
    figure = docs / "figures/gallery" / f"{entry.name}.png"
    figure.parent.mkdir(parents=True, exist_ok=True)
    save_small(entry.draw(opened), figure)
    heading = heading_of(cases, entry)
    files = ", ".join(f"[{case}](../../cases/{case})" for case in entry.cases)
    lines = [f"## {heading}", "", files, "", text.paragraph(cases, entry, docs / "reference"), ""]
    lines += [f"![{heading}](../figures/gallery/{entry.name}.png)", ""]
    lines += [*table_lines(entry, opened), ""]
    lines += [*(command_line(entry, case) for case in entry.cases), ""]
    return lines + ([entry.note, ""] if entry.note else [])


def anchor(heading):
    """The anchor that GitHub makes of a heading."""
    return "".join(c for c in heading.lower() if c.isalnum() or c in " -_").replace(" ", "-")


def contents(cases, entries):
    headings = [heading_of(cases, entry) for entry in entries]
    return [f"- [{heading}](#{anchor(heading)})" for heading in headings] + [""]


def check(cases, entries, docs):
    """Faults of the page, found without solving: cases that are left out or do not exist, missing figures, old
    paragraphs."""
    shipped = {str(path.relative_to(cases)) for path in cases.rglob("*.toml")}
    known = {case for entry in entries for case in entry.cases}
    page = docs / "reference/gallery.md"
    lines = page.read_text(encoding="utf-8") if page.is_file() else ""
    wrong = [f"there is no cases/{case}" for case in sorted(known - shipped)]
    wrong += [f"cases/{case} is not on the page" for case in sorted(known) if f"](../../cases/{case})" not in lines]
    for entry in entries:
        figure = docs / "figures/gallery" / f"{entry.name}.png"
        if not figure.is_file() or f"](../figures/gallery/{entry.name}.png)" not in lines:
            wrong.append(f"the figure {entry.name}.png is missing")
        elif figure.stat().st_size > LARGEST:
            wrong.append(f"the figure {entry.name}.png has more than {LARGEST} bytes")
        if set(entry.cases) <= shipped and text.paragraph(cases, entry, docs / "reference") not in lines:
            wrong.append(f"the paragraph of {entry.name} is an older one")
    return wrong
