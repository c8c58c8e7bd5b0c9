"""The generated reference of keys: pages with a text of their own, followed by the keys as the program prints
them."""

from upbead.errors import UserError
from upbead.program import call

PAGES = {  # page: commands that print the same keys
    "case.md": ["explain"],
    "design.md": ["waves", "expected", "calibrate", "reliability"],
    "study.md": ["study"],
}


def keys(program, commands):
    """The keys as the program prints them; an error if the commands print different keys."""
    found = {call([command, "--keys"], program) for command in commands}
    if len(found) > 1:
        raise UserError(f"the keys of {', '.join(commands)} differ; give each a page of its own")
    return found.pop()


def renewed(text, printed):
    """The page: its own text and the printed keys below."""
    first = printed.splitlines()[0]
    head, found, _ = text.partition(f"\n{first}\n")
    if not found:
        raise UserError(f"the page has no line '{first}', below which the keys are printed")
    return head + "\n" + printed


def pages(program, docs):
    """{path: (present text, correct text)}"""
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
    """The pages that differ from the output of the program."""
    found = pages(program, docs)
    return [f"'{path}' is not what the program prints" for path, (old, new) in found.items() if old != new]
