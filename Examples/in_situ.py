#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A solver whose coefficients ParaView draws at each step, without files and without copies.

build-paraview/with-paraview.sh pvbatch Examples/in_situ.py FOLDER [PICTURES [STEPS]]

PICTURES (4 by default) are written, with STEPS (100) of the solver before each.

The solver advects u0(x) = x^2 + y z with velocity a: u(x, t) = u0(x - a t). It keeps u and
v = a grad u as coefficients on the elements of Data/toroid_hex_g3_p6.vtu, whose order holds both
exactly, and steps du/dt = -v, dv/dt = -(a grad)^2 u0 by Heun's method. ParaView reads the solver's
array of u as a field of its grid; an extractor writes a picture of each step to FOLDER.
"""

import os
import sys
import time
from pathlib import Path

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

MESH = Path(__file__).resolve().parent.parent / "Data" / "toroid_hex_g3_p6.vtu"
VELOCITY = numpy.array([0.4, 0.2, 0.1])


def initial(x):
    return x[:, 0] ** 2 + x[:, 1] * x[:, 2]


def exact(x, t):
    return initial(numpy.asarray(x) - VELOCITY * t)


class Solver:
    """The coefficients of u, v = a grad u and w = a grad v, and their steps in time."""

    def __init__(self):
        x, (a, b, c) = self.read_mesh(), VELOCITY
        values = {
            "u": initial(x),
            "v": 2 * a * x[:, 0] + b * x[:, 2] + c * x[:, 1],
            "w": numpy.full(len(x), 2 * a * a + 2 * b * c),
        }
        self.grid, found = self.project(values)
        self.u, self.v, self.w = (found[name] for name in "uvw")
        # The one place where VTK gets the solver's array: it points to the same memory.
        self.array = numpy_to_vtk(self.u, deep=False)
        self.array.SetName("PixelExact.Field.u.Coefficients")
        self.grid.GetFieldData().AddArray(self.array)
        self.time = 0.0

    def read_mesh(self):
        reader = simple.XMLUnstructuredGridReader(FileName=[str(MESH)])
        reader.UpdatePipeline()
        self.source = servermanager.Fetch(reader)
        simple.Delete(reader)
        return vtk_to_numpy(self.source.GetPoints().GetData()).astype(float)

    def project(self, values):
        """The mesh with the coefficients of u, and those of all fields with these values at the nodes."""
        data = self.source.GetPointData()
        data.Initialize()
        for name, at_nodes in values.items():
            array = numpy_to_vtk(at_nodes, deep=True)
            array.SetName(name)
            data.AddArray(array)
        convert = simple.PixelExactConvert(Input=producer_of(self.source))
        convert.UpdatePipeline()
        grid = self.source.NewInstance()
        grid.ShallowCopy(convert.GetClientSideObject().GetOutputDataObject(0))
        fields = grid.GetFieldData()
        found = {
            name: vtk_to_numpy(fields.GetArray(f"PixelExact.Field.{name}.Coefficients")).copy() for name in values
        }
        # Values at nodes would stay those of time 0, so that other filters would show these.
        grid.GetPointData().Initialize()
        for i in range(fields.GetNumberOfArrays() - 1, -1, -1):
            name = fields.GetArrayName(i)
            is_other = name.startswith("PixelExact.Field.") and not name.startswith("PixelExact.Field.u.")
            if is_other or name == "PixelExact.Field.u.Fingerprint":
                fields.RemoveArray(name)
        origin = numpy_to_vtk(numpy.zeros(1, dtype=numpy.uint8), deep=True)  # coefficients alone
        origin.SetName("PixelExact.Field.u.Origin")
        fields.AddArray(origin)
        return grid, found

    def step(self, dt):
        """Heun's method, in place."""
        v_end = self.v - dt * self.w
        self.u -= 0.5 * dt * (self.v + v_end)
        self.v[:] = v_end
        self.time += dt

    def show(self, producer):
        """States that the coefficients have changed."""
        self.array.Modified()
        self.grid.Modified()
        producer.MarkModified(producer.SMProxy)


def producer_of(data):
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    producer.MarkModified(producer.SMProxy)
    return producer


class Pictures:
    """A slice of the solver's grid, and the extractor that writes its picture."""

    def __init__(self, solver, folder, size=(640, 480)):
        self.producer = producer_of(solver.grid)
        self.cut = simple.PixelExactSlice(Input=self.producer)
        self.cut.SliceType.Origin, self.cut.SliceType.Normal = [0, 0, 0.1], [0, 0, 1]
        self.view = simple.CreateView("RenderView")
        self.view.ViewSize, self.view.UseFXAA, self.view.OrientationAxesVisibility = list(size), 0, 0
        self.shown = simple.Show(self.cut, self.view)
        self.shown.ColorArrayName = ["POINTS", "u"]
        self.shown.LookupTable = simple.GetColorTransferFunction("u")
        self.shown.LookupTable.RescaleTransferFunction(-0.5, 2.5)
        self.view.CameraPosition, self.view.CameraFocalPoint = [0, 0, 6], [0, 0, 0]
        picture = simple.CreateExtractor("PNG", self.view)
        picture.Writer.FileName = "step_{timestep:03d}.png"
        picture.Writer.ImageResolution = list(size)
        self.controller = servermanager.vtkSMExtractsController()
        self.controller.SetExtractsOutputDirectory(str(folder))

    def write(self, solver, number):
        """Writes the step's picture; returns the number of its pixels that are undecided."""
        solver.show(self.producer)
        self.view.ViewTime = solver.time
        self.controller.SetTimeStep(number)
        self.controller.SetTime(solver.time)
        self.controller.Extract()
        self.shown.UpdatePropertyInformation()
        return int(self.shown.GetProperty("UnknownPixels").GetData())


def main(folder, count=4, steps=100):
    solver = Solver()
    os.makedirs(folder, exist_ok=True)
    pictures = Pictures(solver, folder)
    for number in range(count):
        begin = time.perf_counter()
        for _ in range(steps):
            solver.step(0.1 / steps)
        middle = time.perf_counter()
        missing = pictures.write(solver, number)
        end = time.perf_counter()
        print(
            f"picture {number}: t = {solver.time:.1f}, solver {middle - begin:.4f} s, picture {end - middle:.4f} s, "
            f"{100 * (end - middle) / (end - begin):.1f} % of both, {missing} pixels missing"
        )
    return solver, pictures


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(Path(sys.argv[1]), *map(int, sys.argv[2:4]))
