#!/usr/bin/python3
"""Draws the picture of the layers, docs/figures/architecture.svg, from the #include lines of the code.

usage: architecture.py ROOT [--write]     without --write it fails if the file differs from the new picture
"""

import pathlib
import sys

from layers import ALLOWED, INCLUDE

WIDE, HIGH, ACROSS, DOWN, AIR = 92, 30, 132, 54, 14  # px: size of a box, distance from box to box, margin


def included(root):
    """{layer: the layers that its files include}"""
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


def direct(graph):
    """The graph without arrows that follow from other arrows."""
    return {layer: sorted(others - set().union(*(reached(graph, other) for other in others))) for layer, others in graph.items()}


def places(graph):
    """Position of each layer: one column left of the leftmost layer that includes it, so that lines are short; `base`
    at the left."""
    column, rows = {}, {}
    for layer in reversed(graph):  # each layer before the layers that it includes
        column[layer] = min((column[user] - 1 for user in graph if layer in graph[user]), default=0)
    least = min(column.values())
    for layer in graph:
        rows.setdefault(column[layer] - least, []).append(layer)
    most = max(map(len, rows.values()))
    return {layer: (AIR + ACROSS * x, AIR + DOWN * (i + (most - len(row)) / 2)) for x, row in rows.items() for i, layer in enumerate(row)}


def picture(graph):
    at = places(graph)
    width, height = (max(place[i] for place in at.values()) + size + AIR for i, size in ((0, WIDE), (1, HIGH)))
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height:g}" font-family="sans-serif" font-size="14">',
             "<title>The layers of the code: each includes what its lines lead to on its left</title>",
             f'<rect width="{width}" height="{height:g}" fill="#ffffff"/>']
    for layer, others in direct(graph).items():
        for other in others:
            (x, y), (x1, y1) = at[layer], at[other]
            a, b = x1 + WIDE, y1 + HIGH / 2
            lines.append(f'<path d="M{x} {y + HIGH / 2:g}C{x - 20} {y + HIGH / 2:g} {a + 20} {b:g} {a} {b:g}" '
                         'fill="none" stroke="#6b7684" stroke-width="1.5"/>')
    for layer, (x, y) in at.items():
        lines += [f'<rect x="{x}" y="{y:g}" width="{WIDE}" height="{HIGH}" rx="5" fill="#eaf1f8" stroke="#39424e"/>',
                  f'<text x="{x + WIDE / 2:g}" y="{y + 20:g}" text-anchor="middle" fill="#1b2430">{layer}</text>']
    return "\n".join([*lines, "</svg>", ""])


def main():
    root = pathlib.Path(sys.argv[1])
    file, made = root / "docs/figures/architecture.svg", picture(included(root))
    if "--write" in sys.argv:
        file.write_text(made)
    elif made != file.read_text():
        sys.exit(f"{file}:1: the code includes other layers than the picture shows; run {sys.argv[0]} {root} --write")


if __name__ == "__main__":
    main()
