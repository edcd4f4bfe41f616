"""A solver's loop (Examples/in_situ.py): each picture has the solver's values, from the solver's memory."""

import importlib.util
import os
import unittest

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import pictures
import scene

EXAMPLE = os.path.join(os.path.dirname(__file__), "..", "..", "Examples", "in_situ.py")


def example():
    spec = importlib.util.spec_from_file_location("in_situ", EXAMPLE)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class InSitu(unittest.TestCase):
    def tearDown(self):
        simple.ResetSession()

    def test_loop(self):
        in_situ = example()
        folder = os.path.join(scene.PICTURES, "in_situ")
        with scene.messages() as heard:
            solver = in_situ.Solver()
            drawn = in_situ.Pictures(solver, folder, scene.SIZE)
            scene.make_plain(drawn.view)
            drawn.view.CameraParallelProjection, drawn.view.CameraParallelScale = 1, 1.6
            drawn.shown.Ambient, drawn.shown.Diffuse = 1.0, 0.0
            drawn.shown.SetScalarBarVisibility(drawn.view, False)
            for number in range(3):
                for _ in range(50):
                    solver.step(0.004)
                self.assertEqual(drawn.write(solver, number), 0)
                self.check_picture(in_situ, solver, drawn, os.path.join(folder, f"step_{number:03d}.png"))
                self.check_memory(solver, drawn)
        self.assertEqual(heard, [""])

    def check_picture(self, in_situ, solver, drawn, name):
        """Pixels have the colours of the closed form u0(x - a t)."""
        image = pictures.read(name)[:, :3].reshape(scene.SIZE[1], scene.SIZE[0], 3)
        rows, columns = numpy.mgrid[4:236:8, 4:316:8]
        places = numpy.stack([columns.ravel(), rows.ravel()], axis=1)
        eyes, ahead = scene.rays(drawn.view, places)
        x = eyes + ((0.1 - eyes[:, 2]) / ahead[2])[:, None] * ahead
        colors = image[places[:, 1], places[:, 0]]
        hit = ~scene.is_background(colors)
        self.assertGreater(hit.sum(), 200)
        off = numpy.abs(colors[hit] - scene.mapped("u", in_situ.exact(x[hit], solver.time)))
        self.assertLessEqual(numpy.percentile(off.max(axis=1), 98), 1)
        found = scene.probe(drawn.producer, x[hit])
        inside = found["Verdict"] == 1
        self.assertLess(numpy.abs(found["u"] - in_situ.exact(x[hit], solver.time))[inside].max(), 1e-11)

    def check_memory(self, solver, drawn):
        """What is drawn points to the solver's array."""
        data = drawn.cut.GetClientSideObject().GetOutputDataObject(0)
        array = vtk_to_numpy(data.GetFieldData().GetArray("PixelExact.Field.u.Coefficients"))
        self.assertEqual(
            array.__array_interface__["data"][0], solver.u.__array_interface__["data"][0]
        )


if __name__ == "__main__":
    scene.main()
