#!/usr/bin/python3
"""Meshes of the soil alone for the peers, from upbead's own geometry; they are made beforehand, and this time is not
counted.

usage: meshes.py GEOMETRY.geo OUTPUT [NAME=VALUE ...]

Writes OUTPUT.npz: points, quads, their regions, triangles (two per quad), and edges with the names of their curves;
and OUTPUT.msh: the same for FreeFEM, in triangles, with the edges between soils, which adaptmesh must keep.
NAME=VALUE replaces a parameter of the geometry. The caisson is left out: it is rigid.
"""

import pathlib
import sys

import gmsh
import numpy as np

SOILS = ["seabed", "mound"]  # regions 1 and 2 in FreeFEM
CURVES = ["base", "left", "right", "bed", "mound_surface", "bottom"]  # labels 1 to 6 in FreeFEM
BETWEEN_SOILS = len(CURVES) + 1  # label in FreeFEM
LINE, QUADRILATERAL = 1, 3  # gmsh's element types


def elements(group, dimension, kind):
    """Nodes of the elements of a physical group."""
    found = []
    for entity in gmsh.model.getEntitiesForPhysicalGroup(dimension, group):
        types, _, nodes = gmsh.model.mesh.getElements(dimension, entity)
        for have, of_kind in zip(types, nodes):
            if have == kind:
                found.append(of_kind.reshape(-1, 2 if kind == LINE else 4))
    return np.concatenate(found)


def read_groups():
    """quads and their region, edges and their curve; all in gmsh's node tags."""
    quads, regions, edges, curves = [], [], [], []
    for dimension, group in gmsh.model.getPhysicalGroups():
        name = gmsh.model.getPhysicalName(dimension, group)
        if dimension == 2 and name in SOILS:
            quads.append(elements(group, 2, QUADRILATERAL))
            regions += [SOILS.index(name)] * len(quads[-1])
        elif dimension == 1 and name in CURVES:
            edges.append(elements(group, 1, LINE))
            curves += [CURVES.index(name)] * len(edges[-1])
    return np.concatenate(quads), np.array(regions), np.concatenate(edges), np.array(curves)


def triangles_of(points, quads):
    """Two triangles per quadrilateral, cut along the shorter diagonal; (2n, 3), counter-clockwise like the quads."""
    length = [np.linalg.norm(points[quads[:, i + 2]] - points[quads[:, i]], axis=1) for i in (0, 1)]
    first = length[0] <= length[1] * (1 + 1e-9)
    pairs = np.where(first[:, None, None], quads[:, [[0, 1, 2], [0, 2, 3]]], quads[:, [[0, 1, 3], [1, 2, 3]]])
    return pairs.reshape(-1, 3)


def between_soils(quads, regions):
    """Edges that quads of two regions share."""
    first_seen, found = {}, []
    for quad, region in zip(quads, regions):
        for i in range(4):
            edge = tuple(sorted((quad[i], quad[(i + 1) % 4])))
            if first_seen.setdefault(edge, region) != region:
                found.append(edge)
    return np.array(found, dtype=int).reshape(-1, 2)


def write_freefem(path, mesh):
    """FreeFEM's own format: counts; x y label; triangle region; edge label."""
    points, triangles = mesh["points"], mesh["triangles"]
    inner = between_soils(mesh["quads"], mesh["regions"])
    with path.open("w") as file:
        file.write(f"{len(points)} {len(triangles)} {len(mesh['edges']) + len(inner)}\n")
        np.savetxt(file, np.c_[points, np.zeros(len(points))], "%.17g %.17g %d")
        np.savetxt(file, np.c_[triangles + 1, np.repeat(mesh["regions"], 2) + 1], "%d")
        np.savetxt(file, np.c_[mesh["edges"] + 1, mesh["curves"] + 1], "%d")
        np.savetxt(file, np.c_[inner + 1, np.full(len(inner), BETWEEN_SOILS)], "%d")


def soil_mesh(geometry, parameters):
    """The arrays of the .npz."""
    arguments = ["gmsh", "-v", "0"]
    for name, value in parameters.items():
        arguments += ["-setnumber", name, str(value)]
    gmsh.initialize(arguments, readConfigFiles=False)
    gmsh.open(str(geometry))
    gmsh.model.mesh.generate(2)
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    coordinates = coordinates.reshape(-1, 3)[np.argsort(tags), :2]
    quads, regions, edges, curves = read_groups()
    gmsh.finalize()
    used, quads_local = np.unique(quads, return_inverse=True)
    points = coordinates[np.searchsorted(np.sort(tags), used)]
    quads = quads_local.reshape(quads.shape)
    corners = points[quads]
    one, two = corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]
    clockwise = one[:, 0] * two[:, 1] < one[:, 1] * two[:, 0]
    quads[clockwise] = quads[clockwise][:, ::-1]
    return {"points": points, "quads": quads, "triangles": triangles_of(points, quads), "regions": regions,
            "edges": np.searchsorted(used, edges), "curves": curves, "names": np.array(CURVES)}


def write(geometry, output, parameters):
    """Both files; output is a path without suffix."""
    mesh = soil_mesh(geometry, parameters)
    np.savez(output.with_name(output.name + ".npz"), **mesh)
    write_freefem(output.with_name(output.name + ".msh"), mesh)
    return mesh


if __name__ == "__main__":
    pairs = (text.split("=") for text in sys.argv[3:])
    write(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), {name: float(value) for name, value in pairs})
