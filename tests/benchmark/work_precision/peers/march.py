"""Generalised-alpha (Chung and Hulbert 1993) with PETSc in equal steps: one factorisation, vectors reused."""

import time

import numpy as np
import scipy.sparse as sp
from petsc4py import PETSc


def petsc(A):
    A = sp.csr_matrix(A)
    A.eliminate_zeros()
    return PETSc.Mat().createAIJ(A.shape, csr=(A.indptr, A.indices, A.data))


def factorised(A, solver):
    """A solver for the symmetric quasi-definite A: no pivoting needed, as it is equilibrated (Vanderbei 1995)."""
    matrix = petsc(A)
    matrix.setOption(PETSc.Mat.Option.SYMMETRIC, True)
    ksp = PETSc.KSP().create()
    ksp.setOperators(matrix)
    ksp.setType("preonly")
    pc = ksp.getPC()
    pc.setType("cholesky")
    options = PETSc.Options()
    if solver == "mumps":
        pc.setFactorSolverType("mumps")
        options["mat_mumps_icntl_7"] = 5  # METIS
        options["mat_mumps_icntl_14"] = 50  # per cent of additional work space
        options["mat_mumps_cntl_1"] = 0.0  # no pivoting
    else:
        pc.setFactorSolverType("petsc")
        options["pc_factor_mat_ordering_type"] = solver
    ksp.setFromOptions()
    ksp.setUp()
    return ksp


def march(scene, matrices, rho, step, solver):
    """Times, the shear force at them, and the seconds spent on factorising.

    F_T = P - m x_G'' is taken where the scheme satisfies the equation, at t_(n+1-alpha_f): second order there.
    """
    begin = time.perf_counter()
    af, am = rho / (1 + rho), (2 * rho - 1) / (1 + rho)
    if rho == 1:
        af = am = 0.0  # the trapezoidal rule in Newmark's form
    gamma = 0.5 - am + af
    beta = 0.25 * (1 - am + af) ** 2
    h = step
    A = (1 - am) * matrices[0] + (1 - af) * (gamma * h * matrices[1] + beta * h * h * matrices[2])
    scale = 1 / np.sqrt(abs(A.diagonal()))
    D = sp.diags(scale)
    ksp = factorised(D @ A @ D, solver)
    M, C, K = (petsc(D @ matrix @ D) for matrix in matrices)
    factorise = time.perf_counter() - begin

    n = len(scale)
    x, v, a, mid, rhs, new = (np.zeros(n) for _ in range(6))
    mid_, rhs_, a_, new_ = (PETSc.Vec().createWithArray(array) for array in (mid, rhs, a, new))
    steps = round(scene.end / h)
    times, shear = np.zeros(steps + 1), np.zeros(steps + 1)
    for i in range(steps):
        # rhs = -C v_mid - K x_mid - am M a with the known parts of the values
        np.multiply(a, (1 - af) * (1 - gamma) * h, out=mid)
        mid += v
        C.mult(mid_, rhs_)
        np.multiply(a, (1 - af) * (0.5 - beta) * h * h, out=mid)
        mid += x
        if af:
            mid += (1 - af) * h * v
        else:
            mid += h * v
        K.multAdd(mid_, rhs_, rhs_)
        if am:
            np.multiply(a, am, out=mid)
            M.multAdd(mid_, rhs_, rhs_)
        np.negative(rhs, out=rhs)
        force = (1 - af) * scene.force((i + 1) * h) + af * scene.force(i * h)
        rhs[n - 3] += scale[n - 3] * force
        ksp.solve(rhs_, new_)
        shear[i + 1] = force - scene.mass * scale[n - 3] * ((1 - am) * new[n - 3] + am * a[n - 3])
        times[i + 1] = (i + 1 - af) * h
        x += h * v + h * h * ((0.5 - beta) * a + beta * new)
        v += h * ((1 - gamma) * a + gamma * new)
        a[:] = new
    return times, shear, factorise
