#!/usr/bin/python3
"""The peers' scene in FEniCSx: Taylor-Hood elements, a rigid caisson, all matrices assembled and factorised once.

usage: fenicsx.py MESH.npz [--triangles] [--degree 2] [--rho 1] [--step S] [--solver amd | nd | mumps]
                  -o OUTPUT.npz

MESH.npz comes from meshes.py. Unknowns and signs as in docs/theory.md: displacement u, time integral phi of the
pressure, and the caisson's three coordinates; generalised-alpha with spectral radius rho (1: the trapezoidal rule).
"""

import argparse
import json
import pathlib
import time

begin = time.perf_counter()
import numpy as np  # noqa: E402
import scipy.sparse as sp  # noqa: E402
import ufl  # noqa: E402
from dolfinx import cpp, fem, mesh  # noqa: E402
from dolfinx.fem import petsc as assembly  # noqa: E402
from mpi4py import MPI  # noqa: E402

import scene as scenes  # noqa: E402
from march import march  # noqa: E402


def read_mesh(path, triangles):
    """The domain, the region of each of its cells, and the tags of its facets."""
    data = np.load(path)
    regions = data["regions"]
    if triangles:
        shape, cells, regions = "triangle", data["triangles"], np.repeat(regions, 2)
    else:
        shape, cells = "quadrilateral", data["quads"][:, [0, 1, 3, 2]]  # tensor order
    element = ufl.Mesh(ufl.VectorElement("Lagrange", shape, 1))
    domain = mesh.create_mesh(MPI.COMM_WORLD, cells.astype(np.int64), data["points"], element)
    domain.topology.create_connectivity(1, 2)
    edges, curves = cpp.io.distribute_entity_data(domain._mesh, 1, data["edges"].astype(np.int64),
                                                  data["curves"].astype(np.int32))
    tags = mesh.meshtags_from_entities(domain, 1, cpp.graph.AdjacencyList_int32(edges), curves)
    names = list(data["names"])
    return domain, regions[domain.topology.original_cell_index], lambda name: tags.find(names.index(name))


def matrices(scene, domain, regions, degree):
    """The spaces and the blocks Muu, Kuu, Cup, Mpp, Cpp, as scipy matrices."""
    V = fem.VectorFunctionSpace(domain, ("Lagrange", degree))
    Q = fem.FunctionSpace(domain, ("Lagrange", degree - 1))
    D = fem.FunctionSpace(domain, ("DG", 0))
    soils = list(scene.soils.values())

    def coefficient(name):
        function = fem.Function(D)
        function.x.array[:] = np.array([getattr(soil, name) for soil in soils])[regions]
        return function

    u, du, phi, dphi = ufl.TrialFunction(V), ufl.TestFunction(V), ufl.TrialFunction(Q), ufl.TestFunction(Q)
    dx = ufl.dx(metadata={"quadrature_degree": 2 * degree})
    eps = ufl.sym(ufl.grad(u))
    stress = 2 * coefficient("G") * eps + coefficient("lame") * ufl.tr(eps) * ufl.Identity(2)
    forms = [coefficient("rho") * ufl.dot(u, du) * dx, ufl.inner(stress, ufl.sym(ufl.grad(du))) * dx,
             -ufl.div(du) * phi * dx, -coefficient("storage") * phi * dphi * dx,
             -coefficient("mobility") * ufl.dot(ufl.grad(phi), ufl.grad(dphi)) * dx]
    blocks = []
    for form in forms:
        A = assembly.assemble_matrix(fem.form(form))
        A.assemble()
        indptr, indices, values = A.getValuesCSR()
        blocks.append(sp.csr_matrix((values, indices, indptr), shape=A.getSize()))
    return V, Q, blocks


def dofs_on(space, facets):
    return fem.locate_dofs_topological(space, 1, facets)


def kept(size, dropped):
    """The matrix that maps the unknowns that are not dropped to all unknowns."""
    keep = np.setdiff1d(np.arange(size), dropped)
    return sp.csr_matrix((np.ones(len(keep)), (keep, np.arange(len(keep)))), shape=(size, len(keep)))


def spreading(scene, V, Q, on):
    """T: (u, phi) of all nodes from the free unknowns and, last, the caisson's coordinates (x_G, y_G, rotation)."""
    base, bottom = dofs_on(V, on("base")), dofs_on(V, on("bottom"))
    sides = np.concatenate([dofs_on(V, on("left")), dofs_on(V, on("right"))])
    n = 2 * V.dofmap.index_map.size_local
    free_u = kept(n, np.concatenate([2 * base, 2 * base + 1, 2 * sides, 2 * bottom, 2 * bottom + 1]))
    surface = np.concatenate([dofs_on(Q, on("bed")), dofs_on(Q, on("mound_surface"))])
    free_p = kept(Q.dofmap.index_map.size_local, surface)
    arm = V.tabulate_dof_coordinates()[bottom, :2] - scene.centre
    one = np.ones(len(bottom))
    rigid = sp.csr_matrix((np.concatenate([one, one, -arm[:, 1], arm[:, 0]]),
                           (np.concatenate([2 * bottom, 2 * bottom + 1, 2 * bottom, 2 * bottom + 1]),
                            np.repeat([0, 1, 2, 2], len(bottom)))), shape=(n, 3))
    return sp.bmat([[free_u, None, rigid], [None, free_p, None]], format="csr")


def system(scene, path, triangles, degree):
    """M, C, K of the free unknowns; the last three are the caisson's coordinates."""
    domain, regions, on = read_mesh(path, triangles)
    V, Q, (Muu, Kuu, Cup, Mpp, Cpp) = matrices(scene, domain, regions, degree)
    T = spreading(scene, V, Q, on)
    soil = next(iter(scene.soils.values()))
    assert all((s.mass_damping, s.stiffness_damping) == (soil.mass_damping, soil.stiffness_damping)
               for s in scene.soils.values()), "Rayleigh damping is the same in both soils"
    Cuu = soil.mass_damping * Muu + soil.stiffness_damping * Kuu
    blocks = [[[Muu, None], [None, Mpp]], [[Cuu, Cup], [Cup.T, Cpp]], [[Kuu, None], [None, 0 * Mpp]]]
    M, C, K = (T.T @ sp.bmat(block, format="csr") @ T for block in blocks)
    caisson = np.zeros(T.shape[1])
    caisson[-3:] = scene.mass, scene.mass, scene.inertia
    return M + sp.diags(caisson), C, K


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh", type=pathlib.Path)
    parser.add_argument("--triangles", action="store_true")
    parser.add_argument("--degree", type=int, default=2, help="of the displacement; the pressure has one less")
    parser.add_argument("--rho", type=float, default=1.0)
    parser.add_argument("--step", type=float, default=0.002)
    parser.add_argument("--solver", choices=["amd", "nd", "mumps"], default="amd")
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True)
    arguments = parser.parse_args()
    imported = time.perf_counter()
    scene = scenes.read()
    M, C, K = system(scene, arguments.mesh, arguments.triangles, arguments.degree)
    compiled = time.perf_counter()
    times, shear, factorise = march(scene, (M, C, K), arguments.rho, arguments.step, arguments.solver)
    done = time.perf_counter()
    np.savez(arguments.output, time=times, shear=shear)
    print(json.dumps({"unknowns": M.shape[0], "solves": len(times) - 1, "import": imported - begin,
                      "compile": compiled - imported, "factorise": factorise, "march": done - compiled - factorise}))


if __name__ == "__main__":
    main()
