"""The generated reference of keys: pages that end with what the program prints of them, below a head of their own."""

from upbead.errors import UserError
from upbead.program import call

PAGES = {  # page: commands that print the same keys
    "case.md": ["explain"],
    "design.md": ["waves", "expected", "calibrate"],
    "study.md": ["study"],
}


def keys(program, commands):
    """What the program prints; an error where its commands do not agree."""
    found = {call([command, "--keys"], program) for command in commands}
    if len(found) > 1:
        raise UserError(f"the keys of {', '.join(commands)} differ; give each a page of its own")
    return found.pop()


def renewed(text, printed):
    """The page with its own head, and the printed keys below it."""
    first = printed.splitlines()[0]
    head, found, _ = text.partition(f"\n{first}\n")
    if not found:
        raise UserError(f"the page has no line '{first}', below which the keys are printed")
    return head + "\n" + printed


def pages(program, docs):
    """{path: (text that is there, text as it should be)}"""
    found = {}
    for name, commands in PAGES.items():
        text = (docs / name).read_text(encoding="utf-8")
        found[docs / name] = text, renewed(text, keys(program, commands))
    return found


def write(program, docs):
    for path, (_, text) in pages(program, docs).items():
        path.write_text(text, encoding="utf-8")
        print(path)


def check(program, docs):
    """Which pages are not what the program prints."""
    found = pages(program, docs)
    return [f"'{path}' is not what the program prints" for path, (old, new) in found.items() if old != new]
