"""The paragraph of a case: its leading comment, or a section of a README."""

import itertools
import os
import re
import textwrap

from upbead.errors import UserError


def leading_comment(path):
    """The comment before the first line of TOML, as Markdown; indented lines are code."""
    lines = []
    for line in path.read_text(encoding="utf-8").splitlines():
        if not line.startswith("#"):
            break
        lines.append(line[1:].removeprefix(" "))
    blocks = []
    for is_code, group in itertools.groupby(lines, lambda line: line.startswith("  ")):
        blocks.append("\n".join("    " + line.strip() for line in group) if is_code else " ".join(group))
    return "\n\n".join(blocks)


def section_of(path, heading):
    """The text below '## heading' of a Markdown file."""
    parts = re.split(r"^## (.+)$", path.read_text(encoding="utf-8"), flags=re.MULTILINE)
    sections = dict(zip(parts[1::2], parts[2::2]))
    if heading not in sections:
        raise UserError(f"'{path}' has no section '## {heading}'")
    return sections[heading].strip()


def with_links(text, folder, cases, docs):
    """Turns names of existing .md and .toml files into links relative to docs; lines are wrapped again."""

    def link(match):
        places = [base / match.group(0) for base in (folder, cases, cases.parent)]
        target = next((place.resolve() for place in places if place.is_file()), None)
        if target is None:
            return match.group(0)
        return f"[{target.relative_to(cases.resolve().parent)}]({os.path.relpath(target, docs.resolve())})"

    def renewed(block):
        if block.startswith("    "):
            return block
        linked = re.sub(r"(?<![\w(\[/])[\w./-]+\.(?:md|toml)\b", link, " ".join(block.split()))
        return textwrap.fill(linked, 118, break_long_words=False, break_on_hyphens=False)

    return "\n\n".join(map(renewed, text.split("\n\n")))


def paragraph(cases, entry, docs):
    """The paragraph of an entry of the gallery; cases: the folder of the shipped cases."""
    if entry.text:
        name, heading = entry.text.split("#")
        return with_links(section_of(cases / name, heading), (cases / name).parent, cases, docs)
    path = cases / entry.cases[0]
    text = leading_comment(path)
    if not text:
        raise UserError(f"'{path}' has no leading comment; say there what it shows")
    return with_links(text, path.parent, cases, docs)
