# SPDX-License-Identifier: BSD-3-Clause
"""The elements of adversary.py and all that is known of them, with 60 digits and from nothing of
PixelExact's: their maps, Jacobians and preimages, VTK's nodes, the tolerance at faces.
"""
import math

from mpmath import binomial, matrix, mp, mpf, polyroots

mp.dps = 60
U = 2.0 ** -53
HEXAHEDRON, PRISM, TETRAHEDRON, PYRAMID = "hexahedron", "prism", "tetrahedron", "pyramid"


def margin(shape, xi):
    a, b, c = xi
    return min([1 + a, 1 + b, 1 + c] + {
        HEXAHEDRON: [1 - a, 1 - b, 1 - c], PRISM: [1 - b, -a - c],
        TETRAHEDRON: [-1 - a - b - c], PYRAMID: [-a - c, -b - c]}[shape])


def real_roots(coefficients):
    """(root, is exact) of a polynomial, highest power first; nearly real pairs are not exact."""
    while coefficients[0] == 0:
        coefficients = coefficients[1:]
    found = polyroots(coefficients, maxsteps=2000, extraprec=600)
    return [(r.real, abs(r.imag) < mpf(10) ** -25) for r in found if abs(r.imag) < 1e-5]


# What is known of a map: its value, its Jacobian as rows, and its preimages.
class Polynomial:
    """A polynomial map that is solved one variable after the other, then sheared.

    `parts`: x, y, z as {(i, j, k): coefficient}; `order`: which variable which part is solved for.
    """

    def __init__(self, parts, order, shear):
        self.parts, self.order = parts, order
        self.shear = matrix(shear)
        self.unshear = self.shear ** -1

    def value(self, xi):
        plain = [sum(mpf(c) * xi[0] ** i * xi[1] ** j * xi[2] ** k for (i, j, k), c in p.items())
                 for p in self.parts]
        return list(self.shear * matrix(plain))

    def jacobian(self, xi):
        def slope(part, d):
            return sum(mpf(c) * e[d] * math.prod(xi[n] ** (e[n] - (n == d)) for n in range(3))
                       for e, c in part.items() if e[d] > 0)
        return self.shear * matrix([[slope(p, d) for d in range(3)] for p in self.parts])

    def preimages(self, x):
        plain = list(self.unshear * matrix(x))
        found = [([None] * 3, True)]
        for part, variable in self.order:
            more = []
            for xi, exact in found:
                powers = [mpf(0)] * 6
                for e, c in self.parts[part].items():
                    factor = math.prod(xi[n] ** e[n] for n in range(3) if n != variable and e[n])
                    powers[5 - e[variable]] += mpf(c) * factor
                powers[5] -= plain[part]
                if any(powers[:5]):
                    for root, real in real_roots(powers):
                        more.append((xi[:variable] + [root] + xi[variable + 1:], exact and real))
            found = more
        return found


class Cone:
    """VTK's linear pyramid: straight from its apex to the bilinear patch over its base."""

    def __init__(self, base, apex):
        b = [[mpf(v) for v in corner] for corner in base]
        self.apex = [mpf(v) for v in apex]
        self.rays = []  # of each component: 1, u, v, u v
        for c in range(3):
            p00, p10, p11, p01 = (corner[c] - self.apex[c] for corner in b)
            self.rays.append([(p00 + p10 + p11 + p01) / 4, (p10 + p11 - p00 - p01) / 4,
                              (p11 + p01 - p00 - p10) / 4, (p00 + p11 - p10 - p01) / 4])

    @staticmethod
    def collapse(xi):
        h = (1 - xi[2]) / 2
        return h, ((1 + xi[0]) / h - 1 if h else mpf(0)), ((1 + xi[1]) / h - 1 if h else mpf(0))

    def value(self, xi):
        h, u, v = self.collapse(xi)
        return [self.apex[c] + h * (r[0] + r[1] * u + r[2] * v + r[3] * u * v)
                for c, r in enumerate(self.rays)]

    def jacobian(self, xi):
        _, u, v = self.collapse(xi)
        rows = []
        for r in self.rays:
            by_u, by_v = r[1] + r[3] * v, r[2] + r[3] * u
            ray = r[0] + r[1] * u + r[2] * v + r[3] * u * v
            rows.append([by_u, by_v, (by_u * (1 + u) + by_v * (1 + v) - ray) / 2])
        return matrix(rows)

    def preimages(self, x):
        d = [mpf(x[c]) - self.apex[c] for c in range(3)]
        if not any(d):
            return [([mpf(-1), mpf(-1), mpf(1)], True)]
        k = max(range(3), key=lambda c: abs(d[c]))
        # Two planes through the ray, and the bilinear forms that vanish on it: v from the first.
        f, g = ([d[k] * self.rays[c][n] - d[c] * self.rays[k][n] for n in range(4)]
                for c in range(3) if c != k)
        # (f0 + f1 u)(g2 + g3 u) = (g0 + g1 u)(f2 + f3 u)
        found = []
        for u, exact in real_roots([f[1] * g[3] - g[1] * f[3],
                                    f[0] * g[3] + f[1] * g[2] - g[0] * f[3] - g[1] * f[2],
                                    f[0] * g[2] - g[0] * f[2]]):
            form = max(f, g, key=lambda w: abs(w[2] + w[3] * u))
            v = -(form[0] + form[1] * u) / (form[2] + form[3] * u)
            r = self.rays[k]
            h = d[k] / (r[0] + r[1] * u + r[2] * v + r[3] * u * v)
            found.append(([(1 + u) * h - 1, (1 + v) * h - 1, 1 - 2 * h], exact))
        return found


class Noise:
    """A hexahedron of Bezier control points, in integers of 2^-BITS: mpf is too slow for 33^3."""
    BITS = 200

    def __init__(self, order, controls):
        self.order = order
        self.controls = [[[[int(mpf(v) * 2 ** self.BITS) for v in row] for row in plane]
                          for plane in part] for part in controls]

    def weights(self, t, slope):
        n, s = self.order, (1 + t) / 2

        def bernstein(n, i):
            return binomial(n, i) * s ** i * (1 - s) ** (n - i) if 0 <= i <= n else mpf(0)
        values = [n * (bernstein(n - 1, i - 1) - bernstein(n - 1, i)) / 2 if slope
                  else bernstein(n, i) for i in range(n + 1)]
        return [int(v * 2 ** self.BITS) for v in values]

    def contract(self, weights):
        def dot(row, w):
            return sum(map(int.__mul__, row, w)) >> self.BITS
        return [mpf(dot([dot([dot(row, weights[2]) for row in plane], weights[1])
                         for plane in part], weights[0])) / 2 ** self.BITS
                for part in self.controls]

    def value(self, xi):
        return self.contract([self.weights(t, False) for t in xi])

    def jacobian(self, xi):
        flat, steep = ([self.weights(t, slope) for t in xi] for slope in (False, True))
        columns = [self.contract([steep[n] if n == d else flat[n] for n in range(3)])
                   for d in range(3)]
        return matrix(columns).T

    def refine(self, xi, x):
        for _ in range(4):
            step = matrix(x) - matrix(self.value(xi))
            xi = list(matrix(xi) + self.jacobian(xi) ** -1 * step)
        return xi


# Cells: VTK's type, its degrees or none, and the reference coordinates of its nodes.
def hexahedron_index(ijk, n):
    """vtkHigherOrderHexahedron::PointIndexFromIJK."""
    i, j, k = ijk
    inner = n - 1
    ends = [m in (0, n) for m in ijk]
    if sum(ends) == 3:
        return ((2 if j else 1) if i else (3 if j else 0)) + (4 if k else 0)
    if sum(ends) == 2:
        if not ends[0]:
            return 8 + i - 1 + (2 * inner if j else 0) + (4 * inner if k else 0)
        if not ends[1]:
            return 8 + j - 1 + (inner if i else 3 * inner) + (4 * inner if k else 0)
        return 8 + 8 * inner + k - 1 + inner * ((2 if j else 1) if i else (3 if j else 0))
    at = 8 + 12 * inner
    if sum(ends) == 1:
        across = [m for m, end in zip(ijk, ends) if not end]
        which = ends.index(True)
        return at + inner * inner * (2 * which + (1 if ijk[which] else 0)) + \
            across[0] - 1 + inner * (across[1] - 1)
    return at + 6 * inner * inner + i - 1 + inner * (j - 1 + inner * (k - 1))


def hexahedron_nodes(n):
    nodes = [None] * (n + 1) ** 3
    for i in range(n + 1):
        for j in range(n + 1):
            for k in range(n + 1):
                nodes[hexahedron_index((i, j, k), n)] = (i, j, k)
    return nodes


def edge_middles(vertices, edges):
    return vertices + [tuple((a + b) / 2 for a, b in zip(vertices[i], vertices[j]))
                       for i, j in edges]


PRISM_NODES = edge_middles([(-1, 1, -1), (1, 1, -1), (-1, 1, 1), (-1, -1, -1), (1, -1, -1),
                            (-1, -1, 1)],
                           [(0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3), (0, 3), (1, 4), (2, 5)])
PRISM_NODES += [tuple((a + b) / 2 for a, b in zip(PRISM_NODES[i], PRISM_NODES[i + 3]))
                for i in (6, 7, 8)]
TETRAHEDRON_NODES = edge_middles([(-1, -1, -1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)],
                                 [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)])
LAGRANGE, BEZIER, WEDGE18, TETRA10, PYRAMID5 = 72, 79, 32, 24, 14


class Cell:
    def __init__(self, shape, vtk_type, order, known, nodes, injective=False):
        self.shape, self.type, self.known, self.nodes = shape, vtk_type, known, nodes
        self.injective = injective
        largest = max(abs(v) for node in nodes for v in node)
        # Of the change of basis: the sum of |entry| |mode|; hexahedra's is the product of lines'.
        if shape != HEXAHEDRON:
            change = 10.0 if shape == PYRAMID else 60.0
        elif vtk_type == BEZIER:
            change = float(order + 1) ** 3 / 4
        else:
            change = {1: 2.0, 2: 10 / 3, 4: 7.6}[order] ** 3
        # The nodes' rounding as it is told from any other's, the point's, and the evaluation's.
        self.uncertainty = largest * U * (4 * change + 4 + (12 * order + 16) * min(change, 40.0))

    def tolerance(self, xi):
        """Of the faces, max norm; infinite where the map is singular."""
        try:
            inverse = self.known.jacobian(xi) ** -1
        except ZeroDivisionError:
            return mpf("inf")
        return max(sum(abs(inverse[d, c]) for c in range(3)) for d in range(3)) * self.uncertainty


def polynomial_cell(shape, order, parts, solved, shear):
    known = Polynomial(parts, solved, shear)
    if shape == HEXAHEDRON:
        at = [tuple(mpf(2 * m) / order - 1 for m in node) for node in hexahedron_nodes(order)]
        kind = LAGRANGE
    else:
        at, kind = {PRISM: (PRISM_NODES, WEDGE18), TETRAHEDRON: (TETRAHEDRON_NODES, TETRA10)}[shape]
    nodes = [known.value([mpf(v) for v in xi]) for xi in at]
    assert all(mpf(float(v)) == v for node in nodes for v in node), "the nodes are not exact"
    return Cell(shape, kind, order, known, [[float(v) for v in node] for node in nodes])


def noise_cell(order, amplitude, chance):
    controls = [[[[0.0] * (order + 1) for _ in range(order + 1)] for _ in range(order + 1)]
                for _ in range(3)]
    nodes = []
    for index in hexahedron_nodes(order):
        i, j, k = index
        node = [round((2 * index[c] / order - 1 + amplitude * chance.uniform(-1, 1)) * 2 ** 40)
                / 2 ** 40 for c in range(3)]
        for c in range(3):
            controls[c][i][j][k] = node[c]
        nodes.append(node)
    # Control points apart by at most 2 amplitude: slopes of at most order amplitude each.
    return Cell(HEXAHEDRON, BEZIER, order, Noise(order, controls), nodes,
                3 * order * amplitude < 1)
