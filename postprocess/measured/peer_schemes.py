"""Answers of other programs computed again on their cells and with their steps, in one dimension: what is left to the exact answer is theirs."""

import math

import numpy as np

from . import peer_theory


def shapes(order, s):
    """Shape functions of u and their derivatives over a cell of length 1."""
    if order == 1:
        return np.array([-1.0, 1.0])
    return np.array([4 * s - 3, 4 - 8 * s, 4 * s - 1])


class Column:
    """Consolidation in one dimension: u of `order` and linear p on equal cells; M u'' = alpha p', alpha u'_t + S p_t = k p''. u = 0 and no flow at the
    first end, p = 0 at the other. `corners`: the change of the volume is integrated by the ends of cells."""

    def __init__(self, cells, length, order, modulus, mobility, biot=1.0, storage=0.0, corners=False):
        self.n, self.m = order * cells + 1, cells + 1
        h = length / cells
        self.stiff, self.mass, self.flow = np.zeros((self.n, self.n)), np.zeros((self.m, self.m)), np.zeros((self.m, self.m))
        self.couple, self.swell = np.zeros((self.n, self.m)), np.zeros((self.n, self.m))
        self.strain_u, self.strain_p = np.zeros(self.n), np.zeros(self.m)
        points, weights = np.polynomial.legendre.leggauss(3)
        gauss = list(zip((points + 1) / 2, weights / 2, strict=True))
        for cell in range(cells):
            i, j = order * cell + np.arange(order + 1), cell + np.arange(2)
            for s, weight in gauss:
                own, slope, ends = shapes(order, s) / h, np.array([-1, 1]) / h, np.array([1 - s, s])
                self.stiff[np.ix_(i, i)] += weight * h * modulus * np.outer(own, own)
                self.couple[np.ix_(i, j)] += weight * h * biot * np.outer(own, ends)
                self.mass[np.ix_(j, j)] += weight * h * storage * np.outer(ends, ends)
                self.flow[np.ix_(j, j)] += weight * h * mobility * np.outer(slope, slope)
                self.strain_u[i] += weight * h * own
                self.strain_p[j] += weight * h * biot * ends
            for s, weight in ((0.0, 0.5), (1.0, 0.5)) if corners else gauss:
                self.swell[np.ix_(i, j)] += weight * h * biot * np.outer(shapes(order, s) / h, [1 - s, s])

    def march(self, times, theta=1.0, load=0.0, top=None, across=(0.0, lambda time: 0.0)):
        """u and p at each time. load: on the last end; top: its prescribed u over time; across: a modulus, and the strain across over time."""
        n, free = self.n, [*range(1, self.n - (top is not None)), *range(self.n, self.n + self.m - 1)]
        u, p, before, found = np.zeros(n), np.zeros(self.m), 0.0, []
        for time in times:
            step = time - before
            matrix = np.block([[self.stiff, -self.couple], [self.swell.T, self.mass + theta * step * self.flow]])
            given = across[1](time)
            right = np.concatenate([-across[0] * given * self.strain_u, self.swell.T @ u + self.mass @ p - (1 - theta) * step * self.flow @ p])
            right[n:] -= self.strain_p * (given - (across[1](before) if before else 0.0))
            right[n - 1] += load
            known = np.zeros(n + self.m)
            if top is not None:
                known[n - 1] = top(time)
            known[free] = np.linalg.solve(matrix[np.ix_(free, free)], (right - matrix @ known)[free])
            u, p, before = known[:n], known[n:], time
            found.append((time, u.copy(), p.copy()))
        return found


def bar(cells, length, modulus, density):
    """Stiffness and consistent mass of linear cells."""
    stiff, mass, h = np.zeros((cells + 1, cells + 1)), np.zeros((cells + 1, cells + 1)), length / cells
    for cell in range(cells):
        i = np.ix_([cell, cell + 1], [cell, cell + 1])
        stiff[i] += modulus / h * np.array([[1, -1], [-1, 1]])
        mass[i] += density * h / 6 * np.array([[2, 1], [1, 2]])
    return stiff, mass


def newmark(stiff, mass, damp, force, step, number, start):
    """u at the ends of equal steps: constant mean acceleration (Newmark 1959)."""
    u, v = start.copy(), np.zeros_like(start)
    a = np.linalg.solve(mass, force(0.0) - stiff @ u)
    inverse, found = np.linalg.inv(mass + step / 2 * damp + step**2 / 4 * stiff), [u]
    for count in range(1, number + 1):
        ahead, speed = u + step * v + step**2 / 4 * a, v + step / 2 * a
        a = inverse @ (force(count * step) - stiff @ ahead - damp @ speed)
        u, v = ahead + step**2 / 4 * a, speed + step / 2 * a
        found.append(u)
    return np.array(found)


def aster_terzaghi(row):
    """16 cells; theta of 0.57; mass by the corners; its list of steps up to 250 s."""
    times = [0.0]
    for end, number in ((1e-4, 1), (1e-3, 9), (1e-2, 30), (0.1, 40), (1, 50), (10, 45), (100, 47), (1000, 48)):
        times += list(times[-1] + (end - times[-1]) * np.arange(1, number + 1) / number)
    column = Column(16, 10.0, 2, 1e7, 1e-8, corners=True)
    return column.march([time for time in times[1:] if time < 250.1], 0.57, load=-1.0)[-1][2][round(1.6 * row["at"])]


def moose_mandel(row):
    """Ten linear cells; backward Euler, steps of 0.15 t up to 0.01; the exact motion of the plate at its points, straight between them."""
    times = [0.001]
    while times[-1] < row["time"] - 1e-6:
        times.append(times[-1] + min(0.15 * times[-1], 0.01))
    points = [1e-12, 0.002, 0.006, 0.014, *(0.03 + 0.016 * np.arange(25))]
    strains = [10 * peer_theory.mandel("displacement_y", 0.1, time) for time in points]
    column = Column(10, 1.0, 1, 2.0, 1.5, 0.6, 0.1 / 8 + 0.5 * 0.4)
    _, u, p = column.march(times, across=(0.5, lambda time: np.interp(time, points, strains)))[-1]
    return u[-1] if row["reading"].endswith("displacement_x") else p[round(10 * row["at"])]


def ogs_ramp(row):
    """Ten cells, quadratic in u; backward Euler, steps of 5 s."""
    modulus = (1 - 0.1) / ((1 + 0.1) * (1 - 0.2))
    return Column(10, 1.0, 2, modulus, 1e-3).march(np.arange(5.0, row["time"] + 1, 5.0), top=lambda time: -0.05 * time / 100)[-1][2][0]


def kratos_bar(row):
    """Forty linear cells; Newmark, steps of 2.5 ms; Rayleigh's damping."""
    modulus = 5e7 * 0.7 / (1.3 * 0.4)
    stiff, mass = (matrix[1:, 1:] for matrix in bar(40, 10.0, modulus, 1890.0))
    start = -1000 / modulus * np.linspace(0.25, 10, 40)
    return newmark(stiff, mass, 0.02 * mass + 6e-6 * stiff, lambda _: 0 * start, 0.0025, round(row["time"] / 0.0025), start)[-1][19]


def aster_shear(row):
    """Ten linear cells of 5 m; Newmark, steps of 0.8 ms; a dashpot at the base."""
    modulus, density, t_0, s = 4.44e8 / (2 * 1.48), 1900.0, 0.17706, 0.035590
    stiff, mass = bar(10, 50.0, modulus, density)
    end = np.eye(11)[0]
    damp = math.sqrt(modulus * density) * np.outer(end, end)

    def force(time):
        return 2 * math.sqrt(modulus * density) * 1e-3 * (t_0 - time) / s**2 * math.exp(-(((time - t_0) / s) ** 2) / 2) * end

    return newmark(stiff, mass, damp, force, 0.0008, round(row["time"] / 0.0008), 0 * end)[-1][5]


def pylith_terzaghi(row):
    """Fifty cells of 200 m, quadratic in u; backward Euler, twenty steps of 5e4 s."""
    column = Column(50, 1e4, 2, 80e9, 1.5e-10, 0.6, 0.1 / 80e9 + 0.5 / 100e9)
    return column.march(5e4 * np.arange(1, 21), load=-1e4)[-1][2][round(row["at"] / 200)]


UNSTORED = {"pylith-terzaghi": pylith_terzaghi}  # whose answers are not in its repository: its scheme on its mesh stands for them
AGAIN = {"aster-terzaghi": aster_terzaghi, "moose-mandel": moose_mandel, "ogs-ramp": ogs_ramp, "kratos-bar": kratos_bar, "aster-shear": aster_shear}
