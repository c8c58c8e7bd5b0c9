#!/usr/bin/python3
"""A layer includes only what stands left of it; any other #include of a layer is an error. Public headers (include/upbead)
are few, as each is a promise to C++ users, and include no private one, which is not installed."""

import pathlib
import re
import sys

FEM = ["base", "material", "model", "algebra", "mesh", "system"]
RUN = FEM + ["waves", "fem", "dynamics", "response", "sliding", "rupture", "expected", "output"]
ALLOWED = {
    "base": [],
    "input": ["base"],
    "material": ["base"],
    "model": ["base", "material"],
    "waves": ["base"],
    "algebra": ["base"],
    "mesh": ["base"],
    "system": ["base", "algebra"],
    "fem": FEM,
    "dynamics": ["base", "algebra", "system"],
    "response": FEM + ["fem", "dynamics"],
    "sliding": ["base", "algebra", "system", "dynamics", "waves"],
    "rupture": ["base", "dynamics"],
    "expected": ["base", "algebra", "system", "dynamics", "waves", "sliding", "rupture"],
    "output": FEM + ["fem", "dynamics", "response", "waves", "sliding", "rupture"],
    "run": RUN,
    "findings": RUN + ["run"],
    "case": RUN + ["input", "run", "findings"],
    "soils": RUN + ["input", "run", "findings", "case"],
    "respond": RUN + ["input", "run", "findings", "case", "soils"],
    "design": RUN + ["input", "run", "findings", "case", "soils"],
    "study": RUN + ["input", "run", "findings", "case", "soils"],
    "reliability": RUN + ["input", "run", "findings", "case", "soils", "design"],
    "cli": RUN + ["input", "run", "findings", "case", "soils", "respond", "design", "study", "reliability"],
}
INCLUDE = re.compile(r'^\s*#\s*include\s+"(?:upbead/)?([^/"]+)/')
PRIVATE = re.compile(r'^\s*#\s*include\s+"(?!upbead/)')
MOST_PUBLIC = 60


def violations(root):
    for folder in ("include/upbead", "src"):
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in (".h", ".cc"):
                continue
            parts = path.relative_to(root / folder).parts
            if len(parts) == 1:  # main.cc may include every layer
                continue
            layer = parts[0]
            if layer not in ALLOWED:
                yield f"{path}:1: the folder '{layer}' is no layer; add it to {__file__} where it belongs"
                continue
            for number, line in enumerate(path.read_text().splitlines(), 1):
                match = INCLUDE.match(line)
                of_layer = match and match.group(1) in ALLOWED
                if of_layer and match.group(1) != layer and match.group(1) not in ALLOWED[layer]:
                    yield f"{path}:{number}: {layer} must not include {match.group(1)}"


def public_mistakes(root):
    headers = sorted((root / "include" / "upbead").rglob("*.h"))
    if len(headers) > MOST_PUBLIC:
        yield f"{root / 'include'}: {len(headers)} public headers, more than {MOST_PUBLIC}; leave what no C++ user needs in src"
    for path in headers:
        for number, line in enumerate(path.read_text().splitlines(), 1):
            if PRIVATE.match(line):
                yield f"{path}:{number}: a public header must not include a private one"


def main():
    root = pathlib.Path(sys.argv[1])
    found = [*violations(root), *public_mistakes(root)]
    print("\n".join(found) or "layers: every include points left, public headers are few and include no private ones")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main())
