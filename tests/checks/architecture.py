#!/usr/bin/python3
"""The picture of the layers in docs/architecture.md, made of what the code includes.

usage: architecture.py ROOT [--write]     without --write it fails where the page shows another picture
"""

import pathlib
import re
import sys

from layers import ALLOWED, INCLUDE

BLOCK = re.compile(r"```mermaid\n.*?```\n", re.DOTALL)


def included(root):
    """By layer: the layers that its files include."""
    found = {layer: set() for layer in ALLOWED}
    for folder in ("include/upbead", "src"):
        for path in (root / folder).rglob("*"):
            layer = path.relative_to(root / folder).parts[0]
            if path.suffix not in (".h", ".cc") or layer not in ALLOWED:
                continue
            names = (INCLUDE.match(line) for line in path.read_text().splitlines())
            found[layer] |= {name.group(1) for name in names if name and name.group(1) in ALLOWED} - {layer}
    return found


def reached(graph, layer):
    below = set(graph[layer])
    return below.union(*(reached(graph, other) for other in below)) if below else below


def picture(graph):
    """Arrows that follow from others are left out."""
    lines = ["```mermaid", "flowchart RL"]
    for layer, others in graph.items():
        indirect = set().union(*(reached(graph, other) for other in others)) if others else set()
        lines += [f"  {layer} --> {other}" for other in sorted(others - indirect)]
    return "\n".join([*lines, "```", ""])


def main():
    root = pathlib.Path(sys.argv[1])
    page = root / "docs/architecture.md"
    text = page.read_text()
    made = BLOCK.sub(lambda _: picture(included(root)), text)
    if "--write" in sys.argv:
        page.write_text(made)
    elif made != text:
        sys.exit(f"{page}:1: the code includes other layers than the picture shows; run {sys.argv[0]} {root} --write")


if __name__ == "__main__":
    main()
