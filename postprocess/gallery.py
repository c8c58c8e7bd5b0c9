#!/usr/bin/python3
"""Solves every shipped case and writes docs/reference/gallery.md: a paragraph, a picture and the numbers of each.

    /usr/bin/python3 postprocess/gallery.py build/upbead docs            # some minutes
    /usr/bin/python3 postprocess/gallery.py build/upbead docs --check    # a second; solves nothing

Also writes the reference of all keys (reference.py).
"""

import argparse
import tempfile
from pathlib import Path

from common import UserError
from pages import page, reference
from pages.cases import ROOT, entries, solve


def write(docs, folder, arguments):
    cases, known = ROOT / "cases", entries()
    lines = [page.HEAD, *page.contents(cases, known)]
    for entry in known:
        print(entry.name, flush=True)
        opened = solve(entry, folder, arguments.program, arguments.jobs, arguments.results is not None)
        lines += page.section(cases, entry, opened, docs)
    (docs / "reference/gallery.md").write_text("\n".join(lines).rstrip() + "\n", encoding="utf-8")
    print(docs / "reference/gallery.md")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path, help="the program: build/upbead")
    parser.add_argument("docs", type=Path, help="folder to write to: docs")
    parser.add_argument("--check", action="store_true", help="write nothing; fail where a page is not current")
    parser.add_argument("--jobs", type=int, help="runs of a study at once (default: one per core)")
    parser.add_argument("--results", type=Path, help="folder that keeps the results; what is there is not solved again")
    arguments = parser.parse_args()
    if arguments.check:
        wrong = page.check(ROOT / "cases", entries(), arguments.docs)
        wrong += reference.check(arguments.program, arguments.docs)
        if wrong:
            raise UserError("make the pages anew, without --check\n  " + "\n  ".join(wrong))
        return
    reference.write(arguments.program, arguments.docs)
    with tempfile.TemporaryDirectory() as temporary:
        write(arguments.docs, arguments.results or Path(temporary), arguments)


if __name__ == "__main__":
    main()
