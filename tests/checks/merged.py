#!/usr/bin/python3
"""No file contains a conflict marker of a merge, and each line of packages.txt names one package and at most one job
of ./bootstrap, because a fresh machine installs every name in that file.

    merged.py FOLDER_OF_THE_PROJECT
"""

import pathlib
import re
import sys

MARK = re.compile(r"^(<{7}|>{7}|\|{7})( |$)|^={7}$", re.MULTILINE)
FOLDERS = (".ci", "cases", "docs", "include", "meshes", "packaging", "postprocess", "src", "tests")
PACKAGE = re.compile(r"^(#.*|[a-z0-9][a-z0-9.+-]+(  # (tests|nightly|cfd|package|peers))?)$")


def texts(root):
    paths = [*root.glob("*"), *(path for folder in FOLDERS for path in (root / folder).rglob("*"))]
    for path in paths:
        if not path.is_file() or "__pycache__" in path.parts:
            continue
        try:
            yield path.relative_to(root), path.read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue  # a picture


def main():
    root = pathlib.Path(sys.argv[1])
    found, n = [], 0
    for path, text in texts(root):
        n += 1
        found += [f"{path}:{text.count(chr(10), 0, match.start()) + 1}: a merge was left here" for match in MARK.finditer(text)]
    lines = (root / "packages.txt").read_text(encoding="utf-8").splitlines()
    found += [f"packages.txt:{number}: '{line}' is not a package with at most one job" for number, line in enumerate(lines, 1)
              if not PACKAGE.match(line)]
    print("\n".join(found) or f"merged: {n} files without a mark, {len(lines)} lines of packages.txt")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main())
