"""The generated reference in docs/reference: a page of keys for each kind of file, and a page of the summary for each command, each
below a text of its own."""

import re

from upbead.errors import UserError
from upbead.program import call

KEYS = {  # page: commands that print the same keys
    "case.md": ["explain"],
    "design.md": ["waves", "expected", "calibrate", "reliability"],
    "study.md": ["study"],
}
PRINTED = {"warnings.md": "--warnings", "exclusions.md": "--exclusions"}  # page: option of explain
LINK = re.compile(r"\]\((?!\.\./|https?:|#)")  # the program's links are relative to docs


def keys(program, commands):
    """The keys as the program prints them; an error if the commands print different keys."""
    found = {call([command, "--keys"], program) for command in commands}
    if len(found) > 1:
        raise UserError(f"the keys of {', '.join(commands)} differ; give each a page of its own")
    return found.pop()


def from_reference(printed):
    """What the program prints, with its links as they are seen from docs/reference."""
    return LINK.sub("](../", printed)


def renewed(text, printed):
    """The page: its own text and what is printed below."""
    printed = from_reference(printed)
    first = printed.splitlines()[0]
    head, found, _ = text.partition(f"\n{first}\n")
    if not found:
        raise UserError(f"the page has no line '{first}', below which the program's own text is printed")
    return head + "\n" + printed


def pages(program, docs):
    """{path: (present text, correct text)}"""
    folder, found = docs / "reference", {}
    printed = {name: keys(program, commands) for name, commands in KEYS.items()}
    printed |= {name: call(["explain", option], program) for name, option in PRINTED.items()}
    for name, tables in printed.items():
        text = (folder / name).read_text(encoding="utf-8")
        found[folder / name] = text, renewed(text, tables)
    return found


def write(program, docs):
    for path, (_, text) in pages(program, docs).items():
        path.write_text(text, encoding="utf-8")
        print(path)


def check(program, docs):
    """The pages that differ from the output of the program."""
    found = pages(program, docs)
    return [f"'{path}' is not what the program prints" for path, (old, new) in found.items() if old != new]
