"""Writes docs/reference/reliability.md from the facts that each of the checks left in docs/reliability/*.json.

    /usr/bin/python3 postprocess/reliability.py docs
"""

import argparse
import json
from pathlib import Path

from common import UserError

HEAD = """# Reliability

What was tried to make the program fail, how often, and what came out. Made by

    /usr/bin/python3 postprocess/reliability.py docs

from docs/reliability/*.json, which the programs and scripts named below have written. Whether the equations are solved right
is another page, [verification](verification.md); what the program says where its own assumptions fail, [warnings](../warnings.md).
"""
ORDER = ["stability", "ladder", "long_time", "warnings", "faults", "property", "fuzzing", "sanitizers", "static_analysis",
         "coverage", "mutation"]
KEYS = {"title", "text", "command", "figure", "rows"}


def read(folder):
    """The facts by name, in the order of the page; those that are not in ORDER come last."""
    paths = sorted(folder.glob("*.json"), key=lambda path: (ORDER.index(path.stem) if path.stem in ORDER else 99, path.stem))
    if not paths:
        raise UserError(f"'{folder}' holds no facts")
    facts = {path: json.loads(path.read_text()) for path in paths}
    for path, fact in facts.items():
        if set(fact) != KEYS or any(set(row) != {"what", "tried", "came_out"} for row in fact["rows"]):
            raise UserError(f"'{path}' does not hold {', '.join(sorted(KEYS))} with rows of what, tried, came_out")
    return list(facts.values())


def cell(text):
    return str(text).replace("|", "/").replace("\n", " ")


def section(fact):
    lines = [f"## {fact['title']}", "", fact["text"], "", f"    {fact['command']}", ""]
    if fact["figure"]:
        lines += [f"![{fact['title']}](../figures/{fact['figure']})", ""]
    lines += ["| what | tried | came out |", "|---|---|---|"]
    return lines + [f"| {cell(row['what'])} | {cell(row['tried'])} | {cell(row['came_out'])} |" for row in fact["rows"]] + [""]


def page(docs):
    lines = [HEAD]
    for fact in read(docs / "reliability"):
        if fact["figure"] and not (docs / "figures" / fact["figure"]).is_file():
            raise UserError(f"there is no figure '{docs / 'figures' / fact['figure']}'")
        lines += section(fact)
    return "\n".join(lines).rstrip() + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("docs", type=Path, help="the folder docs")
    parser.add_argument("--check", action="store_true", help="write nothing; fail where the page is not current")
    arguments = parser.parse_args()
    path = arguments.docs / "reference/reliability.md"
    text = page(arguments.docs)
    if not arguments.check:
        path.write_text(text)
        print(path)
    elif not path.is_file() or path.read_text() != text:
        raise UserError(f"'{path}' is not what docs/reliability/*.json say; make it anew, without --check")


if __name__ == "__main__":
    main()
