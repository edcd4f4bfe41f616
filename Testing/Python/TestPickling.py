# SPDX-License-Identifier: BSD-3-Clause
"""Pictures are pickled and copied whole; cuts say why they are not."""

import copy
import os
import pickle
import tempfile
import unittest
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import numpy as np
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkRenderingCore import vtkCamera

import pixelexact

TORUS = Path(os.environ["PIXELEXACT_DATA_DIR"]) / "toroid_hex_g3_p6.vtu"
NAMES = ("Value", "Verdict", "Element", "Xi", "Position", "Normal", "Contour", "Color")


def matrices_of(camera):
    """What a camera does to points, of a view of this shape."""
    found = camera.GetCompositeProjectionTransformMatrix(1.25, -1.0, 1.0)
    return [found.GetElement(i, j) for i in range(4) for j in range(4)]


def picture_of(height):
    """In another process."""
    return pixelexact.render(TORUS, "u", origin=height, size=(40, 30))


class Pickling(unittest.TestCase):
    def same(self, other, picture):
        np.testing.assert_array_equal(other.image, picture.image)
        for name in NAMES:
            self.assertEqual(other.array(name).dtype, picture.array(name).dtype)
            np.testing.assert_array_equal(other.array(name), picture.array(name), name)
        self.assertEqual(other.range, picture.range)
        self.assertEqual(repr(other), repr(picture))
        self.assertEqual(other._repr_png_(), picture._repr_png_())
        self.assertEqual(matrices_of(other.camera), matrices_of(picture.camera))

    def test_pictures(self):
        for background in ("white", None):
            picture = pixelexact.render(
                TORUS, "u", size=(50, 40), contours=4, background=background
            )
            picture.note = "mine"
            for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
                other = pickle.loads(pickle.dumps(picture, protocol))
                self.same(other, picture)
                self.assertEqual(other.note, "mine")
            # As files, too, and once more.
            with tempfile.TemporaryDirectory() as folder:
                for file, one in (("a.vti", picture), ("b.vti", other)):
                    one.save(Path(folder) / file)
                texts = [(Path(folder) / file).read_bytes() for file in ("a.vti", "b.vti")]
                self.assertEqual(*texts)
            self.same(pickle.loads(pickle.dumps(other)), picture)
            with self.assertRaisesRegex(pixelexact.Error, "Cut of 'u' by vtkPlane.*again"):
                other.cut

    def test_cameras(self):
        turned = vtkTransform()
        turned.RotateZ(20)
        plain = vtkCamera()
        plain.SetPosition(3, 2, 1)
        plain.SetWindowCenter(0.2, -0.1)
        plain.SetViewAngle(47)
        moved = vtkCamera()
        moved.DeepCopy(plain)
        moved.SetUserTransform(turned)
        moved.SetUserViewTransform(turned)
        model = vtkMatrix4x4()
        model.SetElement(0, 3, 0.25)
        moved.SetModelTransformMatrix(model)
        parallel = vtkCamera()
        parallel.SetPosition(0, 0, 5)
        parallel.ParallelProjectionOn()
        parallel.SetParallelScale(0.7)
        cut = pixelexact.cut(TORUS, "u")
        for camera in (plain, moved, parallel):
            picture = cut.render(size=(50, 40), camera=camera)
            other = pickle.loads(pickle.dumps(picture))
            self.assertEqual(matrices_of(other.camera), matrices_of(camera))
            # It makes the same picture.
            again = cut.render(size=(50, 40), camera=other.camera)
            np.testing.assert_array_equal(again.image, picture.image)
            self.assertGreater((picture.verdicts == 1).sum(), 20)

    def test_copies(self):
        picture = pixelexact.render(TORUS, "u", size=(50, 40), contours=4)
        for other in (copy.copy(picture), copy.deepcopy(picture)):
            self.same(other, picture)
            self.assertIs(other.cut, picture.cut)
        self.assertIs(copy.copy(picture).image, picture.image)
        other.image[:] = 0
        other.values[:] = 0
        self.assertTrue(picture.image.any())
        self.assertTrue(np.nanmax(picture.values) > 0)

    def test_other_processes(self):
        with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool:
            pictures = list(pool.map(picture_of, (0.0, 0.05)))
        for picture, height in zip(pictures, (0.0, 0.05)):
            expected = picture_of(height)
            np.testing.assert_array_equal(picture.image, expected.image)
            np.testing.assert_array_equal(picture.positions, expected.positions)

    def test_probed(self):
        found = pixelexact.probe(TORUS, "u", [[1.0, 0.0, 0.0], [9.0, 0.0, 0.0]])
        for other in (pickle.loads(pickle.dumps(found)), copy.deepcopy(found)):
            self.assertEqual(repr(other), repr(found))
            np.testing.assert_array_equal(other.values, found.values)

    def test_cuts(self):
        cut = pixelexact.cut(TORUS, "u")
        with self.assertRaisesRegex(TypeError, "Cut cannot be pickled.*render"):
            pickle.dumps(cut)
        with self.assertRaisesRegex(TypeError, "Cut cannot be copied.*pixelexact.cut"):
            copy.deepcopy(cut)
        self.assertIs(copy.copy(cut).actor, cut.actor)


if __name__ == "__main__":
    unittest.main()
