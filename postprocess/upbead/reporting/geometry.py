"""The outlines of a section: from the parameters of a shipped geometry, else from the mesh that the case names."""

import math
import re
from collections import Counter, defaultdict
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from .. import geo, msh, places
from ..errors import UserError

# `name = value,  // unit: meaning` within DefineConstant[ ... ]
PARAMETER = re.compile(r"^\s*(\w+)\s*=\s*([-+.\deE]+)\s*,?\s*//\s*([^:]*):\s*(.*)$", re.MULTILINE)


@dataclass
class Section:
    """Loops of points (m) by the region's name, and the parameters of a shipped geometry."""

    regions: dict
    parameters: dict = field(default_factory=dict)

    def box(self, name=None):
        """(x0, x1, y0, y1) of a region, or of all regions."""
        loops = self.regions[name] if name else [loop for loops in self.regions.values() for loop in loops]
        x, y = [p[0] for loop in loops for p in loop], [p[1] for loop in loops for p in loop]
        return min(x), max(x), min(y), max(y)


def folder():
    return places.meshes()


def declared(geometry):
    """{parameter: (default, unit, meaning)} of a shipped geometry; empty where its script is not found."""
    script = folder() / f"{geometry}.geo"
    if not script.is_file():
        return {}
    text = script.read_text(encoding="utf-8", errors="replace")
    head = text.partition("DefineConstant[")[2].partition("]")[0]
    return {name: (float(value), unit.strip(), what.strip()) for name, value, unit, what in PARAMETER.findall(head)}


def section(case, base, results=None):
    """The Section of a case (a dict), whose paths are relative to the folder `base`; that of an own mesh is read from its
    `results` (the open results.h5), where they have it.

    Raises UserError, which names what is missing, if there is no outline.
    """
    mesh = case.get("mesh", {})
    name, given = mesh.get("geometry"), mesh.get("parameters", {})
    if name:
        parameters = {key: default for key, (default, _, _) in declared(name).items()} | given
        drawn = {"composite": composite, "column": column}.get(name)
        try:
            return Section(drawn(parameters), parameters) if drawn else of_mesh(folder() / f"{name}.geo", parameters)
        except KeyError as error:
            raise UserError(
                f"the parameter {error} of '{name}' is not known: '{folder()}' has no {name}.geo"
            ) from error
    if results is not None and "section" in results:
        return of_results(results["section"])
    if "file" not in mesh:
        raise UserError("the case names no geometry")
    return of_mesh(Path(base) / mesh["file"], given)


def of_results(group):
    """The Section of the sides of cells in a results.h5, x and y of their ends in a row."""
    regions, digits = {}, None

    def add(name, table):
        nonlocal digits
        sides = table[()]
        extent = np.ptp(sides.reshape(-1, 2), axis=0).max()  # of an axis: x of a survey is far from y
        digits = 6 - int(math.floor(math.log10(extent or 1.0))) if digits is None else digits
        regions[name] = chained({tuple(tuple(map(float, end)) for end in np.round(row.reshape(2, 2), digits)) for row in sides})

    group.visititems(lambda name, item: add(name, item) if hasattr(item, "shape") else None)
    return Section(regions)


def of_mesh(path, parameters):
    made = geo.mesh_of_script(path, parameters) if path.suffix == ".geo" else msh.read(path)
    return Section({name: outline(cells, made.points) for name, cells in made.surfaces.items()})


def outline(cells, points):
    """The loops around cells, in either direction of numbering: edges that belong to one cell only, in order."""
    edges = Counter(frozenset((cell[i], cell[(i + 1) % len(cell)])) for cell in cells for i in range(len(cell)))
    return [[points[n] for n in loop] for loop in chained(edge for edge, count in edges.items() if count == 1)]


def chained(edges):
    """The loops of edges, pairs of ends in any order."""
    beside = defaultdict(set)
    for a, b in edges:
        beside[a].add(b)
        beside[b].add(a)
    loops = []
    for start in list(beside):
        loop, node = [], start
        while beside[node]:
            loop.append(node)
            after = beside[node].pop()
            beside[after].remove(node)
            node = after
        if loop:
            loops.append(loop)
    return loops


def column(p):
    return {"soil": [[(0, 0), (p["width"], 0), (p["width"], p["height"]), (0, p["height"])]]}


def of_side(p, name, side):
    """A parameter of composite.geo for a side (-1 seaward, 1 landward); if that of the side is 0, the one for both
    sides."""
    return p.get(f"{name}_{'front' if side < 0 else 'back'}") or p[name]


def toes(p):
    """x of the mound's toes, {side: x}."""
    crest = {-1: p["mound_crest_front"], 1: p["mound_crest_back"]}
    return {side: side * (crest[side] + of_side(p, "mound_slope", side) * p["mound_height"]) for side in crest}


def floors(p):
    """Heights of the ground's layers, from the seabed's surface down."""
    seabed, subsoil = -p["seabed_depth"], p.get("subsoil_depth") or 0
    return [0, seabed, seabed - subsoil] if subsoil else [0, seabed]


def composite(p):
    """The outlines of meshes/composite.geo, whose origin is the caisson's middle on the seabed's surface."""
    height, wall, toe = p["mound_height"], p["caisson_width"] / 2, toes(p)
    crest = {-1: -p["mound_crest_front"], 1: p["mound_crest_back"]}
    end = {-1: toe[-1] - p["seabed_front"], 1: toe[1] + p["seabed_back"]}
    top, levels = height + p["caisson_height"], floors(p)
    layers = zip(("seabed", "subsoil"), levels[:-1], levels[1:])
    regions = {
        **{name: [[(end[-1], low), (end[1], low), (end[1], high), (end[-1], high)]] for name, high, low in layers},
        "mound": [[(toe[-1], 0), (toe[1], 0), (crest[1], height), (crest[-1], height)]],
        "caisson": [[(-wall, height), (wall, height), (wall, top), (-wall, top)]],
    }
    for side, name in ((-1, "sea_front"), (1, "sea_back")):
        if p[name] > 0:
            level, at = of_side(p, "water_depth", side), side * wall
            far = side * min(wall + p[name] * level, abs(end[side]))
            regions[name] = [[(at, height), (crest[side], height), (toe[side], 0), (far, 0), (far, level), (at, level)]]
    return regions
