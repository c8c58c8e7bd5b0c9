#!/usr/bin/python3
"""Every warning of the sources stands in the table of `explain --warnings` (src/cli/known_warnings.cc), and nothing else does.

    warnings_known.py FOLDER_OF_THE_PROJECT

A warning is {"name", value, limit, "unit", "what is wrong" ... in a file that speaks of NumberedWarning, or a name handed to a function
that makes one.
"""

import pathlib
import re
import sys

UNITS = r'"(?:1|m|s|Pa|N/m|N s/m|m2|kg/m3|deg|degrees|)"'
MADE = re.compile(r'\{\s*"([a-z]+_\w+)",[^;{}"]*,[^;{}"]*,\s*(?:' + UNITS + r'|[a-z][\w.]*(?:\(\))?(?: \? "[^"]*" : "[^"]*")?),')
ROW = re.compile(r'^    \{"(\w+)",', re.MULTILINE)
TABLE = "src/cli/known_warnings.cc"


def main():
    root = pathlib.Path(sys.argv[1])
    known = set(ROW.findall((root / TABLE).read_text(encoding="utf-8")))
    made, everything = {}, ""
    for path in sorted((root / "src").rglob("*.cc")):
        text = path.read_text(encoding="utf-8")
        if str(path.relative_to(root)) == TABLE:
            continue
        everything += text
        if "NumberedWarning" in text:
            made.update({name: path.relative_to(root) for name in MADE.findall(text)})
    wrong = [f"{made[name]}: the warning {name} is not in {TABLE}" for name in sorted(set(made) - known)]
    wrong += [f"{TABLE}: no source gives the warning {name}" for name in sorted(known) if f'"{name}"' not in everything]
    print("\n".join(wrong) or f"warnings: {len(known)} in the table, {len(made)} of them found where they are made")
    return bool(wrong) or len(made) < 60


if __name__ == "__main__":
    sys.exit(main())
