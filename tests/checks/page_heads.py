#!/usr/bin/python3
"""A page says on top whom it is for and what one can do after it, and all pages that people read fit a head.

    page_heads.py FOLDER_OF_THE_PROJECT

Pages of docs/reference are looked up and not read, and docs/decisions has its own bound: their words do not count. validation.md is made by
postprocess/validation.py.
"""

import pathlib
import sys

MOST = 45_000  # words of README and docs, without what is made by the program
MADE = {"validation.md"}


def main():
    root = pathlib.Path(sys.argv[1])
    pages = sorted(path for path in (root / "docs").glob("*.md") if path.name not in MADE)
    wrong = [f"{path.relative_to(root)}: say in the first lines whom it is for, and what one can do 'After this page'"
             for path in pages if "After this page" not in path.read_text(encoding="utf-8")[:1000] and path.name != "README.md"]
    words = {path: len(path.read_text(encoding="utf-8").split()) for path in [root / "README.md", *pages]}
    if sum(words.values()) > MOST:
        longest = ", ".join(f"{path.name} {n}" for path, n in sorted(words.items(), key=lambda item: -item[1])[:8])
        wrong.append(f"the pages have {sum(words.values())} words, more than {MOST}; the longest: {longest}")
    print("\n".join(wrong) or f"pages: {len(words)} with {sum(words.values())} words")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
