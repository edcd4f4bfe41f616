# SPDX-License-Identifier: BSD-3-Clause
"""Expressions in Python: as a field's name, and as fields of a grid."""

import json
import math
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

import pixelexact

TORUS = Path(os.environ["PIXELEXACT_DATA_DIR"]) / "toroid_hex_g3_p6.vtu"
POINTS = np.array([[0.9, 0.1, 0.05], [1.0, -0.2, -0.1], [-0.7, 0.7, 0.0]])


class Calculate(unittest.TestCase):
    def setUp(self):
        self.grid = pixelexact.read(TORUS)
        self.u = pixelexact.probe(self.grid, "u", POINTS, gradients=True)
        self.assertTrue(self.u.inside.all())

    def test_names_are_expressions(self):
        found = pixelexact.probe(self.grid, "mag(grad(u))", POINTS, enclosures=True)
        slope = np.linalg.norm(self.u.gradients, axis=1)
        np.testing.assert_allclose(found.values, slope, rtol=1e-13)
        self.assertTrue((found.lower <= slope).all() and (slope <= found.upper).all())
        picture = pixelexact.render(self.grid, "u - x", normal="z", size=(60, 40))
        inside = picture.verdicts == 1
        values = pixelexact.probe(self.grid, "u", picture.positions[inside]).values
        np.testing.assert_allclose(
            picture.values[inside], values - picture.positions[inside][:, 0], atol=1e-13)

    def test_grids_carry_definitions(self):
        grid = pixelexact.calculate(self.grid, slope="mag(grad(u))", twice="2*slope")
        self.assertIsInstance(grid, pixelexact.vtkHighOrderGrid)
        slope = np.linalg.norm(self.u.gradients, axis=1)
        with tempfile.TemporaryDirectory() as folder:
            writer = vtkXMLUnstructuredGridWriter()
            writer.SetFileName(f"{folder}/saved.vtu")
            writer.SetInputData(grid)
            writer.Write()
            for one in [grid, pixelexact.read(f"{folder}/saved.vtu")]:
                found = pixelexact.probe(one, "twice", POINTS)
                np.testing.assert_allclose(found.values, 2 * slope, rtol=1e-13)
            told = subprocess.run(
                [os.environ["PIXELEXACT_TOOL"], "info", f"{folder}/saved.vtu", "--json"],
                capture_output=True, check=True, text=True)
            self.assertEqual(
                json.loads(told.stdout)["defined"], {"slope": "mag(grad(u))", "twice": "2*slope"})
        self.assertIsNotNone(grid.GetPointData().GetArray("twice"))
        self.assertIsNone(self.grid.GetPointData().GetArray("twice"))
        bare = pixelexact.calculate(self.grid, point_values=False, slope="mag(grad(u))")
        self.assertIsNone(bare.GetPointData().GetArray("slope"))

    def test_functions_become_expressions(self):
        def oracle(u, x, y, z):
            inner = np.hypot(x, y) - np.where((u > 0.1) & (z < 0.2), u**2, -1e-3 / (2 + np.abs(u)))
            return np.maximum(inner, np.arctan2(y, x)) + 2 * np.sin(np.pi * z) - (-u) / 3

        values = oracle(self.u.values, *POINTS.T)
        found = pixelexact.probe(self.grid, oracle, POINTS)
        np.testing.assert_allclose(found.values, values, rtol=1e-14)
        grid = pixelexact.calculate(
            self.grid, twice=lambda u, factor=2.0: factor * u, point=lambda x, z: (x[0] - x, x[1], z),
            g="grad(u)", steep=lambda g: np.linalg.norm(g) + 0 * np.dot(g, np.array([1, 2, 3.5])))
        np.testing.assert_array_equal(
            pixelexact.probe(grid, "twice", POINTS).values, 2 * self.u.values)
        point = pixelexact.probe(grid, "point", POINTS).values
        np.testing.assert_array_equal(point, POINTS * [0, 1, 1])
        slope = np.linalg.norm(self.u.gradients, axis=1)
        np.testing.assert_allclose(pixelexact.probe(grid, "steep", POINTS).values, slope, rtol=1e-13)
        picture = pixelexact.render(self.grid, lambda u, x: u - x, normal="z", size=(60, 40))
        text = pixelexact.render(self.grid, "u - x", normal="z", size=(60, 40))
        np.testing.assert_array_equal(picture.values, text.values)

    def test_functions_mean_what_numpy_means(self):
        grid = pixelexact.calculate(
            self.grid, m="outer(vec(u,x,1), vec(y,2,z))", v="vec(u, x-0.3, y)", µ="2*u")
        u, (x, y, z) = self.u.values, POINTS.T
        m = np.einsum("ip,jp->pij", [u, x, np.ones(3)], [y, 2 + 0 * y, z])
        v = np.array([u, x - 0.3, y]).T

        def found(function):
            values = pixelexact.probe(grid, function, POINTS).values
            return values.reshape(3, 3, 3) if values.ndim > 1 and values.shape[1] == 9 else values

        for function, exact in [
            (lambda m, v: m @ v, np.einsum("pij,pj->pi", m, v)),
            (lambda m: m @ m, m @ m),
            (lambda v: v @ v, (v * v).sum(axis=1)),
            (lambda m, u: u * m + m.T, u[:, None, None] * m + m.transpose(0, 2, 1)),
            (lambda m: m[0, 1] - m[2][0], m[:, 0, 1] - m[:, 2, 0]),
            (lambda v: v.x - v[1] * v.z, v[:, 0] - v[:, 1] * v[:, 2]),
            (lambda u, grad: np.linalg.norm(grad(u)), np.linalg.norm(self.u.gradients, axis=1)),
            # There are none inside of elements.
            (lambda u, jump, grad: jump(u) + np.linalg.norm(jump(grad(u))), np.full(3, np.nan)),
            (lambda µ: µ / -0.0, -np.sign(u) * np.inf),
            (lambda u: np.arctan2(-0.0 * np.abs(u), -1), np.full(3, -np.pi)),
            (lambda u, x: 1 - (u - x) - u / (x / 2) / 3 * 2, 1 - (u - x) - u / (x / 2) / 3 * 2),
            (lambda u, x: -u ** 2 + 2 ** -u ** 2 - (x + 1) * (u + 1),
             -u ** 2 + 2 ** -u ** 2 - (x + 1) * (u + 1)),
            (lambda u: np.clip(u, None, 0.05), np.clip(u, None, 0.05)),
            (lambda u: sum(u * k for k in range(100)), 4950 * u),
        ]:
            with np.errstate(divide="ignore"):
                np.testing.assert_allclose(found(function), exact, rtol=1e-13, atol=1e-300)
        # A field goes before what the language means by the name.
        named = pixelexact.calculate(self.grid, x="vec(u, 2*u, 3*u)")
        np.testing.assert_array_equal(
            pixelexact.probe(named, lambda x: x[1] - x[0], POINTS).values, u)
        for function, message in [
            (lambda m: m * m, "products of matrices"),
            (lambda m, v: m * v, "products of matrices"),
            (lambda m: np.dot(m, m), "dot of matrices"),
            (lambda u: u[-1], "numbers from 0"),
            (lambda v: v[0:2], "numbers from 0"),
            (lambda u: (u > 0) & 2, "comparisons alone"),
            (lambda u: ~u, "comparisons alone"),
            (lambda u: u % 2, "no mod"),
            (lambda u: u + 10**400, "finite"),
            (lambda u: u + np.ma.masked, "masks"),
            (lambda u: [[u, u], [u, u]], "numpy.outer"),
            (lambda v: v(2), "no function"),
            (np.sin, "have no names"),
        ]:
            with self.assertRaisesRegex((TypeError, ValueError), message):
                found(function)

        def doubled(u):
            for _ in range(40):
                u = u * (1 - u)
            return u

        with self.assertRaisesRegex(TypeError, "longer than 4096"):
            found(doubled)

    def test_functions_that_are_no_expressions(self):
        for function, message in [
            (lambda u: u if u > 0 else -u, "numpy.where"),
            (lambda u: max(u, 0), "numpy.maximum"),
            (lambda u: math.sin(u), "NumPy's functions"),
            (lambda u: np.sinc(u) + np.mod(u, 2), "have no"),
            (lambda u: np.add.reduce(u), "these options"),
            (lambda u: "u", "neither a number"),
            (lambda u: u + float("nan"), "finite"),
            (lambda u: list(u), "one by one"),
            (lambda *fields: fields[0], "name each argument"),
            (3, "not 3"),
        ]:
            with self.assertRaisesRegex((TypeError, ValueError), message):
                pixelexact.probe(self.grid, function, POINTS)
        with self.assertRaisesRegex(pixelexact.Error, "nothing is named 'w'"):
            pixelexact.calculate(self.grid, e=lambda w: 2 * w)
        with self.assertRaisesRegex(TypeError, "longer than 4096"):
            pixelexact.calculate(self.grid, e=lambda u: sum(u * k for k in range(1000)))

    def test_refused(self):
        for name, text, message in [
            ("e", "u +", r"something is missing at the end\n  u \+\n     \^"),
            ("u", "2*u", "the grid has a field 'u'"),
            ("e", "2*e", "nothing is named 'e'"),
            ("e", "2µ", "'µ' is not expected here"),
            ("e", "2*µ", "nothing is named 'µ'"),
        ]:
            with self.assertRaisesRegex(pixelexact.Error, message):
                pixelexact.calculate(self.grid, **{name: text})
        with self.assertRaisesRegex(pixelexact.Error, "the grid has a field 'a'"):
            pixelexact.calculate(pixelexact.calculate(self.grid, a="u"), a="2*u")
        with self.assertRaisesRegex(pixelexact.Error, "could not be bounded"):
            pixelexact.render(self.grid, "1/u", clim="field", size=(40, 30))
        with self.assertRaisesRegex(TypeError, "not 3"):
            pixelexact.calculate(self.grid, e=3)
        with self.assertRaisesRegex(TypeError, "name a field"):
            pixelexact.calculate(self.grid)
        with self.assertRaisesRegex(pixelexact.Error, "nothing is named 'w'"):
            pixelexact.render(self.grid, "u + w")
        with self.assertRaisesRegex(pixelexact.Error, "not available for expressions"):
            pixelexact.contours(self.grid, "2*u", values=[0.5])


if __name__ == "__main__":
    unittest.main()
