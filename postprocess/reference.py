#!/usr/bin/python3
"""Writes the reference of all keys into docs/reference/{case,design,study}.md, and the tables of all warnings and
exclusions into docs/reference/{warnings,exclusions}.md, below the text of each page.

    /usr/bin/python3 postprocess/reference.py build/upbead docs
    /usr/bin/python3 postprocess/reference.py build/upbead docs --check    # writes nothing
"""

import argparse
from pathlib import Path

from common import UserError
from pages import reference


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path, help="the program: build/upbead")
    parser.add_argument("docs", type=Path, help="folder of the pages: docs")
    parser.add_argument("--check", action="store_true", help="write nothing; fail where a page is not current")
    arguments = parser.parse_args()
    if not arguments.check:
        reference.write(arguments.program, arguments.docs)
    elif wrong := reference.check(arguments.program, arguments.docs):
        raise UserError("make the pages anew, without --check\n  " + "\n  ".join(wrong))


if __name__ == "__main__":
    main()
