# SPDX-License-Identifier: BSD-3-Clause
"""The elements of collapsed.py, with 60 digits: polynomials in eta, their canonical modes, their
preimages. The maps can be solved one variable after the other.
"""
import math
from fractions import Fraction
from functools import cache

from mpmath import matrix, mp, mpf

from adversary_maps import HEXAHEDRON, PRISM, PYRAMID, U, real_roots

SHAPES = [HEXAHEDRON, PRISM, "tetrahedron", PYRAMID]  # as Shape.h counts them
HALF = Fraction(1, 2)


class Eta:
    """A polynomial in eta: {exponents: Fraction}."""

    def __init__(self, terms):
        self.terms = {e: Fraction(c) for e, c in terms.items() if c}

    def __add__(self, other):
        other = other if isinstance(other, Eta) else Eta({(0, 0, 0): other})
        return Eta({e: self.terms.get(e, 0) + other.terms.get(e, 0)
                    for e in self.terms.keys() | other.terms.keys()})

    def __mul__(self, other):
        if not isinstance(other, Eta):
            return Eta({e: c * other for e, c in self.terms.items()})
        product = {}
        for e, c in self.terms.items():
            for f, d in other.terms.items():
                at = (e[0] + f[0], e[1] + f[1], e[2] + f[2])
                product[at] = product.get(at, 0) + c * d
        return Eta(product)

    def __pow__(self, n):
        return self * self ** (n - 1) if n > 1 else self

    __radd__, __rmul__ = __add__, __mul__

    def __sub__(self, other):
        return self + other * -1

    def __rsub__(self, other):
        return self * -1 + other

    def value(self, eta):
        return sum(mpf(c.numerator) / c.denominator * math.prod(t ** n for t, n in zip(eta, e) if n)
                   for e, c in self.terms.items())

    def slope(self, d):
        return Eta({tuple(n - (k == d) for k, n in enumerate(e)): c * e[d]
                    for e, c in self.terms.items() if e[d]})


E1, E2, E3 = Eta({(1, 0, 0): 1}), Eta({(0, 1, 0): 1}), Eta({(0, 0, 1): 1})
H = (1 - E3) * HALF


def to_xi(shape, eta):
    h = (1 - eta[2]) / 2
    return [eta[0] if shape == HEXAHEDRON else (1 + eta[0]) * h - 1,
            (1 + eta[1]) * h - 1 if shape == PYRAMID else eta[1], eta[2]]


def to_eta(shape, xi):
    h = (1 - xi[2]) / 2

    def open_up(t):
        return (1 + t) / h - 1 if h else mpf(-1)
    return [xi[0] if shape == HEXAHEDRON else open_up(xi[0]),
            open_up(xi[1]) if shape == PYRAMID else xi[1], xi[2]]


# The canonical modes (Space.h) as polynomials of one eta each, lowest power first.
@cache
def jacobi(n, alpha):
    """P_n^(alpha, 0)."""
    row = [Fraction(0)] * (n + 1)
    for s in range(n + 1):
        factor = Fraction(math.comb(n + alpha, n) * math.comb(n, s) * math.comb(n + alpha + s, s),
                          math.comb(alpha + s, s) * 2 ** s)
        for k in range(s + 1):  # ((x - 1) / 2)^s
            row[k] += factor * math.comb(s, k) * (-1) ** (s - k)
    return row


def expand(row, basis):
    """The coefficients of a polynomial in polynomials of degree 0, 1, ..."""
    row, found = list(row), []
    for poly in reversed(basis[:len(row)]):
        c = row[-1] / poly[-1]
        row = [r - c * p for r, p in zip(row, poly)][:-1]
        found.append(c)
    return found[::-1]


def last(shape, n, p, q):
    return n - {HEXAHEDRON: 0, PRISM: p, PYRAMID: max(p, q)}[shape]


def axis(shape, p, q):
    """m and alpha of a mode's h^m P_r^alpha(eta_3)."""
    m = {HEXAHEDRON: 0, PRISM: p, PYRAMID: max(p, q)}[shape]
    return m, {HEXAHEDRON: 0, PRISM: 2 * m + 1, PYRAMID: 2 * m + 2}[shape]


def modes(shape, n, part):
    """The coefficients of a part, in the order of storage; None if it is not in the space."""
    rows = {}
    for (i, j, k), c in part.terms.items():
        rows.setdefault((i, j), {})[k] = c
    legendre = [jacobi(p, 0) for p in range(n + 1)]
    thirds = {}
    for (i, j), row in rows.items():
        for p, x in enumerate(expand([0] * i + [Fraction(1)], legendre[:i + 1])):
            for q, y in enumerate(expand([0] * j + [Fraction(1)], legendre[:j + 1])):
                for k, c in row.items():
                    third = thirds.setdefault((p, q), {})
                    third[k] = third.get(k, 0) + x * y * c
    found = []
    for p in range(n + 1):
        for q in range(n + 1):
            third = thirds.pop((p, q), {})
            m, alpha = axis(shape, p, q)
            row = [third.get(k, Fraction(0)) for k in range(max(third, default=0) + 1)]
            for _ in range(m):  # by h = (1 - t) / 2, exactly
                left, quotient = Fraction(0), []
                for c in row:
                    left += 2 * c
                    quotient.append(left)
                if quotient.pop() != 0:
                    return None
                row = quotient or [Fraction(0)]
            count = last(shape, n, p, q) + 1
            while len(row) > max(count, 1) and row[-1] == 0:
                row.pop()
            if len(row) > count and any(row):
                return None
            cs = expand(row, [jacobi(r, alpha) for r in range(len(row))])
            found += (cs + [Fraction(0)] * count)[:count]
    return None if any(any(t.values()) for t in thirds.values()) else found


@cache
def mode_bounds(shape, n):
    """Of |mode|: Legendre's are at most 1, the third factor is sampled."""
    found = []
    for p in range(n + 1):
        for q in range(n + 1):
            m, alpha = axis(shape, p, q)
            for r in range(last(shape, n, p, q) + 1):
                row = [float(c) for c in jacobi(r, alpha)]
                found.append(max(abs(sum(c * t ** k for k, c in enumerate(row)))
                                 * ((1 - t) / 2) ** m for t in (s / 50 - 1 for s in range(101))))
    return found


def roots_of(powers):
    """(root, is exact) of a polynomial, highest power first, and None: every number is a root."""
    largest = max(abs(c) for c in powers[:-1])
    if largest < mpf(10) ** -45:
        return [(None, True)] if abs(powers[-1]) < mpf(10) ** -45 else []
    while abs(powers[0]) < largest * mpf(10) ** -40:
        powers = powers[1:]  # its root is beyond all shapes
    if len(powers) == 2:
        return [(-powers[1] / powers[0], True)]
    return real_roots(powers)


class Element:
    """`parts`: x, y, z in eta; `solved`: which is solved for which eta, in order."""

    def __init__(self, shape, order, parts, solved, shear, rounded):
        self.shape, self.order, self.solved = shape, order, solved
        self.shear = [[Fraction(v) for v in row] for row in shear]
        mixed = [sum((p * w for p, w in zip(parts, row)), Eta({})) for row in self.shear]
        exact = [modes(shape, order, part) for part in mixed]
        assert None not in exact, "not in the space"
        # Doubles hold the multiple without odd denominators; of a third of it they are rounded.
        odd = math.lcm(*(c.denominator // (c.denominator & -c.denominator)
                         for row in exact for c in row))
        scale = Fraction(odd, 2 ** odd.bit_length()) / (3 if rounded else 1)
        self.plain = [part * scale for part in parts]
        self.parts = [part * scale for part in mixed]
        self.modes = [[float(c * scale) for c in row] for row in exact]
        apart = [sum(abs(Fraction(f) - c * scale) * Fraction(b)
                     for f, c, b in zip(row, wanted, mode_bounds(shape, order)))
                 for row, wanted in zip(self.modes, exact)]
        assert rounded or not any(apart), "the modes are not exact"
        self.apart = float(max(apart)) * (1 + 1e-9)
        self.slopes = [[part.slope(d) for d in range(3)] for part in self.parts]
        unshear = matrix([[mpf(v.numerator) / v.denominator for v in row] for row in self.shear])
        self.unshear = unshear ** -1
        n = 12 * order + 16
        gamma = n * U / (1 - n * U)
        sizes = [sum(abs(c) * b for c, b in zip(row, mode_bounds(shape, order)))
                 for row in self.modes]
        # element-tree.md's u_j; a coordinate is at most the sum of its modes.
        self.uncertainty = [self.apart + (4 * U + gamma) * size for size in sizes]

    def value_at(self, eta):
        return [part.value(eta) for part in self.parts]

    def value(self, xi):
        return self.value_at(to_eta(self.shape, xi))

    def tolerance(self, xi):
        """Of the faces, max norm; infinite where the map is singular."""
        eta = to_eta(self.shape, xi)
        h = (1 - eta[2]) / 2
        if h == 0 and self.shape != HEXAHEDRON:
            return mpf("inf")
        by_eta = matrix([[slope.value(eta) for slope in row] for row in self.slopes])
        by_xi = mp.eye(3)
        if self.shape != HEXAHEDRON:
            by_xi[0, 0], by_xi[0, 2] = 1 / h, (1 + eta[0]) / (2 * h)
        if self.shape == PYRAMID:
            by_xi[1, 1], by_xi[1, 2] = 1 / h, (1 + eta[1]) / (2 * h)
        j = by_eta * by_xi
        # The rows of the inverse, times det J.
        rows = [[j[(c + 1) % 3, (d + 1) % 3] * j[(c + 2) % 3, (d + 2) % 3]
                 - j[(c + 1) % 3, (d + 2) % 3] * j[(c + 2) % 3, (d + 1) % 3] for c in range(3)]
                for d in range(3)]
        det = sum(rows[0][c] * j[c, 0] for c in range(3))
        if det == 0:
            return mpf("inf")
        return max(sum(abs(v / det) * u for v, u in zip(row, self.uncertainty)) for row in rows)

    def preimages(self, x):
        """(xi, is exact); of the many on what is collapsed, some."""
        plain = list(self.unshear * matrix(x))
        found = [([None] * 3, True)]
        for part, variable in self.solved:
            more = []
            for eta, exact in found:
                powers = [mpf(0)] * 8
                for e, c in self.plain[part].terms.items():
                    factor = math.prod(eta[n] ** e[n] for n in range(3) if n != variable and e[n])
                    powers[7 - e[variable]] += mpf(c.numerator) / c.denominator * factor
                powers[7] -= plain[part]
                for root, real in roots_of(powers):
                    for t in ([mpf(-1), mpf(0), mpf(1)] if root is None else [root]):
                        more.append((eta[:variable] + [t] + eta[variable + 1:], exact and real))
            found = more
        return [(to_xi(self.shape, eta), exact) for eta, exact in found]


class Kind:
    """A way to collapse: what becomes what, and the eta where it does.

    `ends`: {direction: end} of eta; `along`: the eta along the edge that is left, None for a point.
    `make(n, bend)`: the parts, bent by `bend` times powers n.
    """

    def __init__(self, shape, name, least, ends, along, solved, make):
        self.shape, self.name, self.least, self.ends, self.along = shape, name, least, ends, along
        self.solved, self.make = solved, make


def hexahedron_kinds():
    b, c, s, t = E2, E3, (1 + E1) * HALF, (1 + E2) * HALF
    yield Kind(HEXAHEDRON, "face to edge", 1, {0: -1}, 2, ((2, 2), (0, 0), (1, 1)),
               lambda n, e: [s + e * s ** n + e * c ** n, s * (b + e * b ** n) + e * c ** n,
                             c + e * c ** n])
    yield Kind(HEXAHEDRON, "edge to vertex", 1, {0: -1, 1: -1}, None, ((0, 0), (1, 1), (2, 2)),
               lambda n, e: [s + e * s ** n, t + e * t ** n + e * s ** n,
                             (c + e * c ** n) * (s + t - s * t)])
    yield Kind(HEXAHEDRON, "face to vertex", 1, {0: -1}, None, ((2, 0), (0, 1), (1, 2)),
               lambda n, e: [s * (b + e * b ** n), s * (c + e * c ** n + e * b ** n),
                             s + e * s ** n])


def prism_kinds():
    a, b, c, t = (1 + E1) * H, E2, (1 + E3) * HALF, (1 - E2) * HALF
    yield Kind(PRISM, "face to edge", 1, {2: -1}, 0, ((2, 2), (0, 0), (1, 1)),
               lambda n, e: [a + e * a ** n, c * (b + (e * b ** n)) + e * a ** n, c + e * c ** n])
    yield Kind(PRISM, "edge to vertex", 1, {0: -1, 2: -1}, None, ((2, 2), (0, 0), (1, 1)),
               lambda n, e: [a + e * a ** n, (b + e * b ** n) * (a * HALF + c), c + e * c ** n])
    yield Kind(PRISM, "end to edge", 1, {1: 1}, 0, ((1, 1), (2, 2), (0, 0)),
               lambda n, e: [a + e * a ** n, b + e * b ** n, t * (c + e * c ** n)])
    yield Kind(PRISM, "end to vertex", 1, {1: 1}, None, ((1, 1), (2, 2), (0, 0)),
               lambda n, e: [t * (a + e * a ** n), b + e * b ** n, t * (c + e * c ** n)])


def pyramid_kinds():
    a, b, c, s = (1 + E1) * H, (1 + E2) * H, E3, (1 + E3) * HALF
    patch = (1 + E1) * (1 + E2) * H * HALF
    yield Kind(PYRAMID, "edge to vertex", 1, {0: -1}, 2, ((2, 2), (0, 0), (1, 1)),
               lambda n, e: [a + e * a ** n, patch + e * a ** n, c + e * c ** n])
    yield Kind(PYRAMID, "base to edge", 2, {2: -1}, 0, ((2, 2), (0, 0), (1, 1)),
               lambda n, e: [a + e * a ** n, s * b + e * a ** n, s + e * s ** n])


def kinds():
    yield from hexahedron_kinds()
    yield from prism_kinds()
    yield from pyramid_kinds()
