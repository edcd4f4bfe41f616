# SPDX-License-Identifier: BSD-3-Clause
"""Implicit functions that are written in Python, against the same functions of VTK."""

import os
import signal
import threading
import time
import unittest
import warnings

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonDataModel import (
    vtkImplicitBoolean,
    vtkImplicitSum,
    vtkPlane,
    vtkSphere,
    vtkSuperquadric,
)
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer, vtkRenderWindow

import pixelexact

DATA = os.environ["PIXELEXACT_DATA_DIR"]
CENTRE = np.array([0.9, 0.1, 0.05])
RADIUS = 0.55


def ball(x):
    return np.sum((x - CENTRE) ** 2, axis=1) - RADIUS**2


def ball_gradient(x):
    return 2 * (x - CENTRE)


def vtk_ball():
    sphere = vtkSphere()
    sphere.SetCenter(CENTRE)
    sphere.SetRadius(RADIUS)
    return sphere


class Scene:
    """A cut through a torus in an off-screen window."""

    def __init__(self, function):
        self.errors = []
        self.reader = vtkXMLUnstructuredGridReader()
        self.reader.SetFileName(os.path.join(DATA, "toroid_hex_g3_p6.vtu"))
        self.converter = pixelexact.vtkUnstructuredGridToHighOrderGrid()
        self.converter.SetInputConnection(self.reader.GetOutputPort())
        self.mapper = pixelexact.vtkHighOrderMapper()
        self.mapper.SetInputConnection(self.converter.GetOutputPort())
        self.mapper.SetFieldName("u")
        self.mapper.SetCutFunction(function)

        @calldata_type(VTK_STRING)
        def failed(_object, _event, text):
            self.errors.append(text)

        self.mapper.AddObserver("ErrorEvent", failed)
        self.actor = vtkActor()
        self.actor.SetMapper(self.mapper)
        self.renderer = vtkRenderer()
        self.renderer.AddActor(self.actor)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetSize(100, 80)
        self.window.AddRenderer(self.renderer)
        self.renderer.GetActiveCamera().SetPosition(3.0, -4.0, 3.0)
        self.renderer.ResetCamera()

    def buffers(self):
        self.window.Render()
        data = self.mapper.GetBuffers()
        if data is None:
            return None
        points = data.GetPointData()
        return {
            points.GetArrayName(i): vtk_to_numpy(points.GetArray(i))
            for i in range(points.GetNumberOfArrays())
        }

    def error(self):
        """Of a picture that fails."""
        self.errors.clear()
        self.window.Render()
        assert self.mapper.GetBuffers() is None
        return "\n".join(self.errors)


class Pictures(unittest.TestCase):
    def compare(self, function, known, normals):
        """Both show the same, but where a ray meets an outline."""
        ours, theirs = Scene(function).buffers(), Scene(known).buffers()
        same = ours["Verdict"] == theirs["Verdict"]
        self.assertLess((~same).sum(), 4)
        both = (ours["Verdict"] == 1) & (theirs["Verdict"] == 1)
        both &= np.abs(ours["Depth"] - theirs["Depth"]) < 1e-3
        self.assertGreater(both.sum(), 100)
        self.assertGreater(both.sum(), (theirs["Verdict"] == 1).sum() - 4)
        # On either side.
        dots = np.sum(ours["Normal"] * theirs["Normal"], axis=1)
        ours["Normal"] = ours["Normal"] * np.sign(dots)[:, None]
        for name, tolerance in {"Depth": 1e-9, "Value": 1e-9, "Normal": normals}.items():
            difference = np.abs(ours[name][both] - theirs[name][both])
            self.assertLess(difference.max(), tolerance, name)

    def test_normals_by_differences(self):
        self.compare(pixelexact.implicit_function(ball), vtk_ball(), 1e-8)

    def test_normals_by_the_gradient(self):
        calls = []

        def gradient(x):
            calls.append(len(x))
            return ball_gradient(x)

        self.compare(pixelexact.implicit_function(ball, gradient), vtk_ball(), 1e-9)
        # Not pixel by pixel.
        self.assertGreater(sum(calls), 200)
        self.assertLess(len(calls), 40)

    def test_transforms(self):
        transform = vtkTransform()
        transform.Translate(-0.2, 0.1, 0.0)
        transform.Scale(1.2, 0.8, 1.0)
        for gradient in [None, ball_gradient]:
            functions = [pixelexact.implicit_function(ball, gradient), vtk_ball()]
            for function in functions:
                function.SetTransform(transform)
            self.compare(*functions, 1e-8)

    def test_booleans(self):
        def combine(first, operation):
            plane = vtkPlane()
            plane.SetOrigin(0.9, 0, 0)
            plane.SetNormal(1, 0.2, 0.3)
            boolean = vtkImplicitBoolean()
            boolean.SetOperationType(operation)
            boolean.AddFunction(first)
            boolean.AddFunction(plane)
            return boolean

        for operation in range(3):
            function = pixelexact.implicit_function(ball, ball_gradient)
            self.compare(combine(function, operation), combine(vtk_ball(), operation), 1e-8)

    def test_batches_are_large(self):
        sizes = []

        def counted(x):
            self.assertEqual(x.shape[1], 3)
            self.assertTrue(x.flags.owndata)
            self.assertIs(threading.current_thread(), threading.main_thread())
            sizes.append(len(x))
            return ball(x)

        scene = Scene(pixelexact.implicit_function(counted))
        scene.buffers()
        self.assertEqual(scene.errors, [])
        # 128 samples on each of 128 rays, where all of them meet the mesh's box.
        self.assertGreater(max(sizes), 128 * 50)
        self.assertLessEqual(max(sizes), 128 * 128)

    def test_modified(self):
        radius = [RADIUS]
        function = pixelexact.implicit_function(
            lambda x: np.sum((x - CENTRE) ** 2, axis=1) - radius[0] ** 2
        )
        scene = Scene(function)
        before = (scene.buffers()["Verdict"] == 1).sum()
        radius[0] = 0.2
        self.assertEqual((scene.buffers()["Verdict"] == 1).sum(), before)
        function.Modified()
        self.assertLess((scene.buffers()["Verdict"] == 1).sum(), before)


class Failures(unittest.TestCase):
    def expect(self, function, *parts, gradient=None):
        error = Scene(pixelexact.implicit_function(function, gradient)).error()
        for part in ["vtkImplicitCallback", *parts]:
            self.assertIn(part, error)

    def test_exceptions(self):
        def missing(x):
            raise KeyError("no such thing")

        self.expect(missing, "KeyError: 'no such thing'")
        self.expect(lambda x: 1 / 0, "ZeroDivisionError: division by zero")
        self.expect(lambda: 0, "TypeError: ")
        self.expect(ball, "KeyError: 'no such thing'", gradient=missing)

    def test_shapes_and_types(self):
        self.expect(lambda x: 1.0, "ValueError: shape ()", "was returned, not (")
        self.expect(lambda x: x, "ValueError: shape (", ", 3)")
        self.expect(lambda x: ball(x)[1:], "ValueError: shape")
        self.expect(lambda x: None, "shape ()")
        self.expect(lambda x: ball(x).astype(complex), "TypeError: complex128")
        self.expect(ball, "ValueError: shape", gradient=ball)

    def test_numbers_that_are_not_finite(self):
        self.expect(lambda x: np.where(x[:, 0] > 0.5, np.nan, ball(x)), "its value at (", "is nan")
        self.expect(lambda x: np.where(x[:, 0] > 0.5, np.inf, ball(x)), "is inf; give a finite")
        self.expect(ball, "its gradient at (", gradient=lambda x: x * np.nan)

    def test_the_next_picture_is_sound_again(self):
        good = [False]
        function = pixelexact.implicit_function(lambda x: ball(x) if good[0] else None)
        scene = Scene(function)
        self.assertIn("shape ()", scene.error())
        good[0] = True
        self.assertGreater((scene.buffers()["Verdict"] == 1).sum(), 100)

    def test_within_what_is_not_known_to_hold_it(self):
        # Not a hang: threads that trace wait for the interpreter that the renderer holds.
        whole = vtkImplicitSum()
        whole.AddFunction(pixelexact.implicit_function(ball))
        scene = Scene(whole)
        shown = scene.buffers()
        if scene.errors:
            self.assertIn("asked by another thread", scene.errors[0])
        else:
            # The calling thread was there before all others.
            self.assertGreater((shown["Verdict"] == 1).sum(), 100)

    def test_keyboard_interrupt(self):
        def interrupted(x):
            signal.raise_signal(signal.SIGINT)
            return ball(x)

        scene = Scene(pixelexact.implicit_function(interrupted))
        with self.assertRaises(KeyboardInterrupt):
            self.assertIn("KeyboardInterrupt", scene.error())
            time.sleep(5)


class OtherUses(unittest.TestCase):
    def test_points_one_by_one(self):
        function = pixelexact.implicit_function(ball)
        for x in [(0.3, 0.2, 0.1), (2.0, 0.0, 0.0)]:
            self.assertAlmostEqual(function.FunctionValue(x), vtk_ball().FunctionValue(x), 12)
            gradient = [0.0] * 3
            function.FunctionGradient(x, gradient)
            np.testing.assert_allclose(gradient, ball_gradient(np.array(x)), rtol=0, atol=1e-8)

    def expect(self, function, *parts):
        grid = pixelexact.read(os.path.join(DATA, "toroid_hex_g3_p6.vtu"))
        with self.assertRaises(pixelexact.Error) as raised:
            pixelexact.contours(grid, "u", [0.0], surface=function)
        for part in ["vtkImplicitCallback: ", *parts]:
            self.assertIn(part, str(raised.exception))

    def test_contours_of_functions_that_fail(self):
        def fails(x):
            return 1 / 0

        whole = vtkImplicitBoolean()
        whole.AddFunction(vtk_ball())
        whole.AddFunction(pixelexact.implicit_function(fails))
        self.expect(fails, "ZeroDivisionError: division by zero")
        self.expect(whole, "ZeroDivisionError: division by zero")
        self.expect(lambda x: np.where(x[:, 0] > 0.5, np.nan, ball(x)), "its value at (", "is nan")

    def test_contours_of_functions_that_fail_later(self):
        asked = [0]

        def fails(x):
            asked[0] += len(x) == 6  # a gradient by differences
            if asked[0] > 20:  # when curves are followed
                raise RuntimeError("no more")
            return ball(x)

        self.expect(fails, "RuntimeError: no more")

    def test_within_sums(self):
        """They are evaluated point by point, and their messages are reported all the same."""

        def fails(x):
            return 1 / 0

        whole = vtkImplicitSum()
        whole.AddFunction(pixelexact.implicit_function(fails))
        self.expect(whole, "ZeroDivisionError: division by zero")

    def triangles(self, function, resolution=64):
        cut = pixelexact.vtkHighOrderLinearCut()
        cut.SetInputData(pixelexact.read(os.path.join(DATA, "toroid_hex_g3_p6.vtu")))
        cut.SetCutFunction(function)
        cut.SetResolution(resolution)
        errors = []

        @calldata_type(VTK_STRING)
        def failed(_object, _event, text):
            errors.append(text)

        for speaker in [cut, function]:
            speaker.AddObserver("ErrorEvent", failed)
        cut.Update()
        self.assertEqual(cut.GetNumberOfPointsOffSurface(), 0)
        return cut.GetOutput(), errors

    def test_triangles_of_functions_that_fail(self):
        output, errors = self.triangles(pixelexact.implicit_function(lambda x: 1 / 0))
        self.assertEqual(len(errors), 1)
        self.assertIn("vtkImplicitCallback: ZeroDivisionError: division by zero", errors[0])
        self.assertEqual(output.GetNumberOfCells(), 0)

    def test_triangles_and_lines_ask_for_many_points(self):
        sizes = []

        def counted(x):
            self.assertIs(threading.current_thread(), threading.main_thread())
            sizes.append(len(x))
            return ball(x)

        expected = vtk_to_numpy(self.triangles(vtk_ball())[0].GetPoints().GetData())
        # vtkSuperquadric says that its gradient is 0.
        same = vtkSuperquadric()
        same.SetCenter(CENTRE)
        same.SetScale(3 * [2 * RADIUS])
        half = vtkImplicitBoolean()
        half.AddFunction(same)
        half.AddFunction(pixelexact.implicit_function(counted))
        for function in [pixelexact.implicit_function(counted, ball_gradient), half]:
            sizes.clear()
            output, errors = self.triangles(function)
            self.assertEqual(errors, [])
            found = vtk_to_numpy(output.GetPoints().GetData())
            np.testing.assert_allclose(ball(found), 0, atol=1e-12)
            if function is not half:
                np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12)
            self.assertGreater(max(sizes), 5000)
            self.assertGreater(sum(sizes), 100 * len(sizes))

        grid = pixelexact.read(os.path.join(DATA, "toroid_hex_g3_p6.vtu"))
        lines = []
        for function in [vtk_ball(), counted]:
            sizes.clear()
            with warnings.catch_warnings(record=True):
                found = pixelexact.contours(grid, "u", [-0.3, 0.0, 0.3], surface=function)
            lines.append(np.array(vtk_to_numpy(found.GetPoints().GetData())))
        self.assertGreater(max(sizes), 100)
        np.testing.assert_allclose(ball(lines[1]), 0, atol=1e-12)
        values = pixelexact.probe(grid, "u", lines[1]).values
        off = np.abs(values.reshape(-1, 1) - [-0.3, 0.0, 0.3]).min(axis=1)
        self.assertLess(off.max(), 1e-12)
        # Steps along a curve need not be the same: each point is near one of the other's.
        between = np.linalg.norm(lines[0][:, None] - lines[1][None], axis=2)
        self.assertLess(max(between.min(axis=0).max(), between.min(axis=1).max()), 0.05)

    def test_unions_of_magnitudes_are_those_of_vtk(self):
        """They are negative nowhere, so that of a union with them the ball is left."""
        other = vtkPlane()
        other.SetNormal(0.1, 0.2, 1.0)
        normal = np.array(other.GetNormal())
        points = []
        for part in [pixelexact.implicit_function(lambda x: x @ normal), other]:
            magnitudes = vtkImplicitBoolean()
            magnitudes.SetOperationTypeToUnionOfMagnitudes()
            magnitudes.AddFunction(vtk_ball())
            magnitudes.AddFunction(part)
            whole = vtkImplicitBoolean()
            whole.AddFunction(vtk_ball())
            whole.AddFunction(magnitudes)
            output, errors = self.triangles(whole, 32)
            self.assertEqual(errors, [])
            self.assertGreater(output.GetNumberOfCells(), 100)
            points.append(np.array(vtk_to_numpy(output.GetPoints().GetData())))
        np.testing.assert_allclose(points[0], points[1], rtol=0, atol=1e-12)


if __name__ == "__main__":
    unittest.main()
