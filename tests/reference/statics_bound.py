#!/usr/bin/python3
"""A lower bound of the factor of strength reduction at the peak of the wave, by statics: stresses linear on triangles, in
equilibrium, within a polygon inside the strength, under the resultants of the base (after Lysmer 1970 and Sloan 1988). The least D of
c + D by linear programming; the ground bears a factor where D is 0 or less. Of the section below, in still water's pore pressure; some
minutes a factor. docs/peak-strength.md has what it found.

usage: statics_bound.py SUMMARY FACTOR ...   SUMMARY: of a run of tests/support/section.toml with limits.peak_safety
"""

import json
import math
import sys

import numpy as np
from scipy.optimize import linprog
from scipy.sparse import coo_matrix

HALF, HEIGHT, CREST, TOE, REACH, DEPTH = 9.0, 6.0, 16.0, 28.0, 70.0, 15.0  # m: caisson, mound, seabed
WEIGHT = 0.6 * (2650 - 1030) * 9.81  # submerged, N/m3
SOILS = {"seabed": (0.0, 60e3), "mound": (40.0, 20e3)}  # phi' (degrees), c' (Pa)
SIDES = 16  # of the polygon
UNIT = 1e4  # Pa, of the stresses that are sought


def height(x):
    return max(0.0, min(HEIGHT, (TOE - abs(x)) / 2))


def verticals():
    marks, parts = [-REACH, -TOE, -CREST, -HALF, HALF, CREST, TOE, REACH], [3, 3, 2, 6, 3, 4, 4]
    ends = zip(marks[:-1], marks[1:], parts)
    return [-REACH] + [a + (b - a) * k / n for a, b, n in ends for k in range(1, n + 1)]


def triangles(layers=3, below=5):
    """[(three points, region)]: four in each quadrilateral."""
    found = []

    def divide(corners, region):
        middle = tuple(np.mean(corners, axis=0))
        for a, b in zip(corners, corners[1:] + corners[:1]):
            if math.dist(a, b) > 1e-9:
                found.append(((a, b, middle), region))

    levels = [-DEPTH * (k / below) ** 1.5 for k in range(below + 1)]
    x = verticals()
    for a, b in zip(x[:-1], x[1:]):
        for high, low in zip(levels[:-1], levels[1:]):
            divide([(a, low), (b, low), (b, high), (a, high)], "seabed")
        for k in range(layers if height(a) + height(b) > 0 else 0):
            low, high = k / layers, (k + 1) / layers
            divide([(a, height(a) * low), (b, height(b) * low), (b, height(b) * high), (a, height(a) * high)], "mound")
    return found


class Rows:
    """Rows of a sparse matrix, and what stands on their right."""

    def __init__(self):
        self.entries, self.right = [], []

    def add(self, terms, right):
        self.entries += [(len(self.right), column, value) for column, value in terms]
        self.right.append(right)

    def matrix(self, columns):
        row, column, value = zip(*self.entries)
        return coo_matrix((value, (row, column)), shape=(len(self.right), columns)).tocsr()


class Statics:
    """Unknown: (xx, yy, xy) at the three corners of each triangle, then D."""

    def __init__(self, base):
        self.cells, self.equal = triangles(), Rows()
        self.D = 9 * len(self.cells)
        self.resultants = ([], [], [])
        edges = {}
        for t, (points, _) in enumerate(self.cells):
            self.balance(t, points)
            for i in range(3):
                ends = tuple(sorted(tuple(np.round(points[j], 6)) for j in (i, (i + 1) % 3)))
                edges.setdefault(ends, []).append((t, i))
        for owners in edges.values():
            self.edge(owners)
        for terms, value in zip(self.resultants, (base["shear"], -base["force"], -base["moment"])):
            self.equal.add(terms, value / UNIT)

    def traction(self, t, k, normal):
        (nx, ny), first = normal, 9 * t + 3 * k
        return [(first, nx), (first + 2, ny)], [(first + 2, nx), (first + 1, ny)]

    def balance(self, t, points):
        """d xx/dx + d xy/dy = 0, d xy/dx + d yy/dy = weight."""
        slope = np.linalg.inv(np.array([[1, x, y] for x, y in points]))
        at = [9 * t + 3 * k for k in range(3)]
        self.equal.add([(a, slope[1, k]) for k, a in enumerate(at)] + [(a + 2, slope[2, k]) for k, a in enumerate(at)], 0.0)
        self.equal.add([(a + 2, slope[1, k]) for k, a in enumerate(at)] + [(a + 1, slope[2, k]) for k, a in enumerate(at)], WEIGHT / UNIT)

    def edge(self, owners):
        """Tractions pass from triangle to triangle; none on the surface; the base's have its resultants."""
        t, i = owners[0]
        points = self.cells[t][0]
        a, b = points[i], points[(i + 1) % 3]
        normal, middle = np.array([b[1] - a[1], a[0] - b[0]]) / math.dist(a, b), np.mean([a, b], axis=0)
        normal *= math.copysign(1, normal @ (middle - np.mean(points, axis=0)))
        for k, other in ((i, (i + 1) % 3), ((i + 1) % 3, i)):
            along, up = self.traction(t, k, normal)
            if len(owners) == 2:
                second = owners[1][0]
                same = min(range(3), key=lambda m: math.dist(self.cells[second][0][m], points[k]))
                for one, two in zip((along, up), self.traction(second, same, normal)):
                    self.equal.add(one + [(column, -value) for column, value in two], 0.0)
            elif abs(middle[1] - HEIGHT) < 1e-6 and abs(middle[0]) < HALF:
                self.base(along, up, math.dist(a, b), points[k][0], points[other][0])
            elif abs(abs(middle[0]) - REACH) < 1e-6:  # smooth sides
                self.equal.add(up, 0.0)
            elif abs(middle[1] + DEPTH) > 1e-6:  # the rough bottom bears anything
                self.equal.add(along, 0.0)
                self.equal.add(up, 0.0)

    def base(self, along, up, length, x, other):
        for sums, terms, weight in zip(self.resultants, (along, up, up), (length / 2, length / 2, length * (2 * x + other) / 6)):
            sums += [(column, weight * value) for column, value in terms]

    def within(self, factor):
        """(xx - yy) cos + 2 xy sin <= cos(pi/sides) (2 c cos phi + 2 D - (xx + yy) sin phi), and the same without tension."""
        rows, inside = Rows(), math.cos(math.pi / SIDES)
        for t, (_, region) in enumerate(self.cells):
            phi, c = math.atan(math.tan(math.radians(SOILS[region][0])) / factor), SOILS[region][1] / factor
            for first in (9 * t, 9 * t + 3, 9 * t + 6):
                for angle in 2 * math.pi * np.arange(SIDES) / SIDES:
                    for sine, limit in ((math.sin(phi), 2 * c * math.cos(phi)), (1.0, 0.0)):
                        terms = [(first, math.cos(angle) + inside * sine), (first + 1, -math.cos(angle) + inside * sine),
                                 (first + 2, 2 * math.sin(angle)), (self.D, -2 * inside)]  # fmt: skip
                        rows.add(terms, inside * limit / UNIT)
        return rows

    def least(self, factor):
        """(status of the solver, D in Pa)."""
        rows, n = self.within(factor), self.D + 1
        cost = np.zeros(n)
        cost[self.D] = 1.0
        bounds = [(None, None)] * self.D + [(-100.0, None)]
        found = linprog(cost, rows.matrix(n), rows.right, self.equal.matrix(n), self.equal.right, bounds, method="highs-ipm")
        return found.status, found.x[self.D] * UNIT if found.x is not None else math.nan


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as file:
        statics = Statics(json.load(file)["peak_safety"])
    for factor in map(float, sys.argv[2:]):
        print("{} triangles, factor {:g}: status {}, D {:.4g} Pa".format(len(statics.cells), factor, *statics.least(factor)), flush=True)
