#!/usr/bin/python3
"""Names that files keep to themselves differ within a layer, as all files of a layer may be compiled as one.

usage: names.py FOLDER_OF_THE_PROJECT

Of unnamed namespaces: constants, types and functions. Aliases of one type may be alike, and functions of other parameters.
"""

import re
import sys
from functools import partial
from pathlib import Path

COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*")
UNNAMED = re.compile(r"^namespace \{\n(.*?)^\}  // namespace$", re.M | re.S)
TYPE = re.compile(r"^(?:struct|class|enum|enum class) (\w+)(?= [:{])", re.M)
ALIAS = re.compile(r"^using (\w+) = ([^;]*);", re.M)
CONSTANTS = re.compile(r"^(?:constexpr|const) ([^;()]*);", re.M)
INITIALISER = re.compile(r"\{[^{}]*\}")
CONSTANT = re.compile(r"(\w+)(?:\[\w*\])? ?(?:=|\{\})")
FUNCTION = re.compile(r"^(?! |template|using)[\w:<>,&* ]+?[ &*](\w+)(\([^;{]*\))(?: const)? \{", re.M)
PARAMETER = re.compile(r"[ &*]\w+(?= *(?:=[^,()]*)?[,)])|\s+")


def own(text):
    """(name, its kind) of each; names of one kind may be alike"""
    for part in map(partial(COMMENT.sub, ""), UNNAMED.findall(text)):
        yield from ((name, None) for name in TYPE.findall(part))
        yield from ALIAS.findall(part)
        for line in CONSTANTS.findall(part):
            yield from ((name, None) for name in CONSTANT.findall(INITIALISER.sub("{}", INITIALISER.sub("{}", line))))
        yield from ((name, "function of " + PARAMETER.sub("", parameters)) for name, parameters in FUNCTION.findall(part))


def clash(a, b):
    if a and b and a.startswith("function") and b.startswith("function"):
        return a == b
    return a is None or a != b


def main():
    root, bad = Path(sys.argv[1]) / "src", []
    for layer in sorted(path for path in root.iterdir() if path.is_dir()):
        seen = {}
        for path in sorted(layer.rglob("*.cc")):
            mine = set(own(path.read_text()))
            bad += [f"{path}: `{name}` is also a name of {other}" for name, kind in sorted(mine, key=str)
                    for other, theirs in seen.get(name, []) if clash(kind, theirs)]
            for name, kind in mine:
                seen.setdefault(name, []).append((path.name, kind))
    print("\n".join(bad), end="\n" if bad else "")
    sys.exit(bool(bad))


if __name__ == "__main__":
    main()
