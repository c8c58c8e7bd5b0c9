"""Writes FOLDER/0.cpp, 1.cpp ... (or .c, .cc), each of which includes several sources, so that a compiler reads the headers
of a library once for all of them. Sources that name anything alike at file scope come into different ones, and macros of a
source end with it.

usage: unity.py ROOT LARGEST FOLDER < list of sources below ROOT
"""

import re
import sys
from pathlib import Path

# the last word before the first of ( [ = ; { , on a line that begins at the margin and names no class by ::
OWN = re.compile(r"^(?:\} *|[A-Za-z_][^(\[=;{:\n]*?)?(\w+) *(?:[(\[=;{,]|$)", re.M)
POINTER = re.compile(r"^static [^;{\n]*\(\*(\w+)\)", re.M)
UNNAMED = re.compile(r"^namespace *\{(.*?)^\}", re.M | re.S)
KEYWORDS = {"return", "else", "if", "for", "while", "switch", "namespace", "break", "extern", "struct", "enum", "union"}
COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*|\\\n", re.S)
MACRO = re.compile(r"^ *# *define +(\w+)", re.M)
TAKEN_BACK = re.compile(r"^ *# *undef +(\w+)", re.M)
INCLUDE = re.compile(r'^ *# *include *["<]([^">]+)[">]', re.M)
GUARD = re.compile(r"# *pragma +once|# *if(?:ndef| *!defined) *\(?(\w+)\)?\s+# *define +\1")


def names(text):
    text = COMMENT.sub("", text).replace("std::", "")
    inside = "\n".join(re.sub("^ +", "", part, flags=re.M) for part in UNNAMED.findall(text))
    return set(OWN.findall(text + inside) + POINTER.findall(text)) - KEYWORDS


def own_names(text, headers):
    """With those of headers that have no guard, which are a part of the source."""
    own = names(text)
    for header in INCLUDE.findall(text):
        inside = [path.read_text(errors="replace") for path in headers.get(Path(header).name, [])]
        if inside and not any(map(GUARD.search, inside)):
            own |= set().union(*map(names, inside)) | {"header " + header}
    return own


def main():
    root, largest, folder = Path(sys.argv[1]).resolve(), int(sys.argv[2]), Path(sys.argv[3])
    folder.mkdir(exist_ok=True)
    headers = {}
    for path in root.rglob("*.h"):
        headers.setdefault(path.name, []).append(path)
    of_headers = {macro for paths in headers.values() for path in paths for macro in MACRO.findall(path.read_text(errors="replace"))}
    groups = []
    for source in sys.stdin.read().split():
        text = (root / source).read_text(errors="replace")
        own, macros = own_names(text, headers), set(MACRO.findall(text))
        group = next((group for group in groups if group["n"] < largest and not own & group["own"]), None)
        alters = macros & of_headers & set(TAKEN_BACK.findall(text))  # a macro of a header, so that it comes alone
        if group is None or alters:
            groups.append(group := {"n": largest if alters else 0, "own": set(), "text": ""})
        group["n"] += 1
        group["own"] |= own
        group["text"] += f'#include "{root / source}"\n' + "".join(f"#undef {macro}\n" for macro in sorted(macros))
        group["ending"] = Path(source).suffix
    for i, group in enumerate(groups):
        (folder / f"{i}{group['ending']}").write_text(group["text"])


if __name__ == "__main__":
    main()
