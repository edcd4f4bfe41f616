# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces in space: patches of a graph z = g(x, y), with closed forms, as files of several formats."""

import numpy as np

LAGRANGE_TRIANGLE, LAGRANGE_QUADRILATERAL = 69, 70


def quadrilateral(order):
    """The nodes (i, j) of VTK's Lagrange quadrilateral, in its order."""
    p = order
    nodes = [(0, 0), (p, 0), (p, p), (0, p)]
    nodes += [(i, 0) for i in range(1, p)] + [(p, j) for j in range(1, p)]
    nodes += [(i, p) for i in range(1, p)] + [(0, j) for j in range(1, p)]
    return nodes + [(i, j) for j in range(1, p) for i in range(1, p)]


def triangle(order):
    """The nodes (i, j) of VTK's Lagrange triangle, ring by ring."""
    nodes = []
    low, high = 0, order
    while high > low:
        n = high - low
        nodes += [(low, low), (low + n, low), (low, low + n)]
        nodes += [(low + k, low) for k in range(1, n)]
        nodes += [(low + n - k, low + k) for k in range(1, n)]
        nodes += [(low, low + n - k) for k in range(1, n)]
        low, high = low + 1, high - 2
    return nodes + ([(low, low)] if high == low else [])


class Patches:
    """The square [0, 1]^2 in n x n cells, each a quadrilateral or two triangles, lifted to a graph."""

    def __init__(self, order, n, surface, shapes="quadrilaterals"):
        self.points, self.cells = [], []
        for a in range(n):
            for b in range(n):
                corner, size = np.array([a, b]) / n, np.array([1.0, 1.0]) / n
                if shapes == "quadrilaterals" or (shapes == "mixed" and (a + b) % 2 == 0):
                    self.add(LAGRANGE_QUADRILATERAL, quadrilateral(order), order, corner, size, surface)
                    continue
                self.add(LAGRANGE_TRIANGLE, triangle(order), order, corner, size, surface)
                self.add(LAGRANGE_TRIANGLE, triangle(order), order, corner + size, -size, surface)

    def add(self, kind, nodes, order, corner, size, surface):
        first = len(self.points)
        for i, j in nodes:
            self.points.append(surface(*(corner + size * np.array([i, j]) / order)))
        self.cells.append((kind, list(range(first, len(self.points)))))
