"""A small reader of gmsh meshes (.msh 2.2 and 4.1, text): the corners of cells and lines, with the names of their
groups."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from .errors import UserError

# lines, triangles and quadrilaterals of first to third order (gmsh's manual: MSH file format): number of corners
CORNERS = {1: 2, 8: 2, 26: 2, 2: 3, 9: 3, 20: 3, 21: 3, 3: 4, 10: 4, 16: 4, 36: 4, 39: 4}
DIMENSION = {kind: 1 if corners == 2 else 2 for kind, corners in CORNERS.items()}


@dataclass
class Mesh:
    """Corners of a mesh, m, and by name of the surface or curve the nodes of each cell or line."""

    points: dict[int, tuple[float, float]] = field(default_factory=dict)  # node: (x, y)
    surfaces: dict[str, list[list[int]]] = field(default_factory=lambda: defaultdict(list))  # name: [three or four nodes]
    curves: dict[str, list[list[int]]] = field(default_factory=lambda: defaultdict(list))  # name: [two nodes]

    def add(self, kind: int, name: str, nodes: list[int]) -> None:
        """Adds a cell or a line of one of gmsh's kinds."""
        (self.curves if DIMENSION[kind] == 1 else self.surfaces)[name].append(nodes[: CORNERS[kind]])


def sections(text: str) -> dict[str, list[str]]:
    """{name: lines} of a .msh."""
    found: dict[str, list[str]] = {}
    name: str | None = None
    for line in text.splitlines():
        if line.startswith("$End"):
            name = None
        elif line.startswith("$"):
            name = line[1:].strip()
            found[name] = []
        elif name:
            found[name].append(line)
    return found


def names_of(lines: list[str]) -> dict[tuple[int, int], str]:
    """{(dimension, number): name}"""
    names = {}
    for line in lines[1:]:
        dimension, number, name = line.split(maxsplit=2)
        names[int(dimension), int(number)] = name.strip().strip('"')
    return names


def read_22(parts: Mapping[str, list[str]], names: Mapping[tuple[int, int], str], mesh: Mesh) -> None:
    for line in parts["Nodes"][1:]:
        node, x, y, _ = line.split()
        mesh.points[int(node)] = (float(x), float(y))
    for line in parts["Elements"][1:]:
        _, kind, tags, group, *rest = map(int, line.split())
        if kind in DIMENSION:
            mesh.add(kind, names.get((DIMENSION[kind], group), str(group)), rest[tags - 1 :])


def groups_of_entities(lines: list[str]) -> dict[tuple[int, int], int]:
    """{(dimension, entity): its first physical group}, from $Entities of 4.1."""
    groups = {}
    counts = list(map(int, lines[0].split()))
    rows = iter(lines[1:])
    for dimension, count in enumerate(counts):
        first = 4 if dimension == 0 else 7  # after the number and the coordinates or the box
        for _ in range(count):
            words = next(rows).split()
            if int(words[first]) > 0:
                groups[dimension, int(words[0])] = abs(int(words[first + 1]))
    return groups


def read_41(parts: Mapping[str, list[str]], names: Mapping[tuple[int, int], str], mesh: Mesh) -> None:
    groups = groups_of_entities(parts["Entities"])
    rows = iter(parts["Nodes"][1:])
    for head in rows:
        nodes = [int(next(rows)) for _ in range(int(head.split()[3]))]
        for node in nodes:
            x, y, *_ = map(float, next(rows).split())
            mesh.points[node] = (x, y)
    rows = iter(parts["Elements"][1:])
    for head in rows:
        dimension, entity, kind, count = map(int, head.split())
        group = groups.get((dimension, entity))
        for _ in range(count):
            nodes = list(map(int, next(rows).split()[1:]))
            if kind in DIMENSION and group is not None:
                mesh.add(kind, names.get((dimension, group), str(group)), nodes)


def read(path: Path) -> Mesh:
    """The Mesh of a file; raises UserError if it is no mesh."""
    try:
        text = path.read_text(encoding="latin-1")
    except OSError as error:
        raise UserError(f"cannot read '{path}': {error.strerror}") from error
    parts = sections(text)
    version, binary, _ = (parts.get("MeshFormat") or ["? 0 0"])[0].split()
    readers = {"2.2": read_22, "4.1": read_41}
    if version not in readers or binary != "0":
        raise UserError(f"'{path}' is no gmsh mesh of version 2.2 or 4.1 in text; save it again from gmsh")
    mesh = Mesh()
    try:
        readers[version](parts, names_of(parts.get("PhysicalNames", ["0"])), mesh)
    except (KeyError, ValueError, IndexError, StopIteration, RuntimeError) as error:
        raise UserError(f"'{path}' is cut short or broken ({error!r})") from error
    if not mesh.surfaces:
        raise UserError(f"'{path}' has no cells on named surfaces")
    return mesh
