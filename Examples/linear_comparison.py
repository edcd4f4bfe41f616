#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Exact beside linear: one cut, pixel by pixel, and what each way of linearising it costs.

The linear baselines are the field resampled to n^3 nodes and cut by vtkCutter, and vtkCutter on the
file itself, which takes high-order cells for VTK's own linear pieces of them. Each triangle's value
at a pixel's centre is compared with the exact one there. Nothing is drawn with OpenGL.

Usage: linear_comparison.py [IMAGE.png [SIZE [N1,N2,...]]]
Prints errors relative to the range of the exact values on the cut, over the pixels that both cover,
and the pixels that only one of the two covers, relative to those of the exact cut.
"""

import sys
from pathlib import Path

import numpy as np
import vtkmodules.vtkRenderingFreeType  # noqa: F401, draws the letters
from pixelexact import (
    vtkHighOrderLinearResample,
    vtkHighOrderProbe,
    vtkUnstructuredGridToHighOrderGrid,
)
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPlane, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCutter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkTextProperty, vtkTextRenderer

MESH = Path(__file__).resolve().parent.parent / "Data" / "toroid_hex_g3_p6.vtu"
FIELD = "u"
# The plane z = HEIGHT, seen from above: image axes are x and y.
HEIGHT = 0.05
CENTRE, HALF = np.array([-0.05, 0.0]), 1.42
# Decades of the error that the lower row shows.
ERROR_DECADES = (-5, -1)

COOL_TO_WARM = ("diverging", [(0.230, 0.299, 0.754), (0.706, 0.016, 0.150)])
INFERNO = ("lab", [(0, 0, 0.01), (0.47, 0.11, 0.43), (0.93, 0.41, 0.15), (0.99, 1, 0.64)])


def pixel_axes(size):
    """x and y of the pixels' centres."""
    offset = HALF * (2 * (np.arange(size) + 0.5) / size - 1)
    return CENTRE[0] + offset, CENTRE[1] + offset


def exact_values(grid, size):
    """The field at the pixels' centres, NaN outside of the mesh."""
    x, y = (axis.ravel() for axis in np.meshgrid(*pixel_axes(size)))
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.stack([x, y, np.full_like(x, HEIGHT)], axis=1), deep=True))
    pixels = vtkPolyData()
    pixels.SetPoints(points)
    probe = vtkHighOrderProbe()
    probe.SetInputData(pixels)
    probe.SetSourceData(grid)
    probe.AddField(FIELD)
    probe.Update()
    return vtk_to_numpy(probe.GetOutput().GetPointData().GetArray(FIELD)).reshape(size, size)


def cut(data):
    """Triangles of vtkCutter: x, y and value of their corners, as (n, 3, 3)."""
    plane = vtkPlane()
    plane.SetOrigin(0, 0, HEIGHT)
    plane.SetNormal(0, 0, 1)
    cutter = vtkCutter()
    cutter.SetInputData(data)
    cutter.SetCutFunction(plane)
    cutter.GenerateTrianglesOn()
    cutter.Update()
    output = cutter.GetOutput()
    if output.GetNumberOfPolys() == 0:
        return np.empty((0, 3, 3))
    corners = vtk_to_numpy(output.GetPoints().GetData()).astype(float)
    corners[:, 2] = vtk_to_numpy(output.GetPointData().GetArray(FIELD))
    return corners[vtk_to_numpy(output.GetPolys().GetConnectivityArray()).reshape(-1, 3)]


def rasterise(triangles, size):
    """The triangles' values at the pixels' centres, NaN where there is none."""
    axes = pixel_axes(size)
    values = np.full((size, size), np.nan)
    for triangle in triangles:
        low, high = triangle[:, :2].min(axis=0), triangle[:, :2].max(axis=0)
        i0, i1 = np.searchsorted(axes[0], (low[0], high[0]))
        j0, j1 = np.searchsorted(axes[1], (low[1], high[1]))
        if i0 == i1 or j0 == j1:
            continue
        x, y = np.meshgrid(axes[0][i0:i1] - triangle[0, 0], axes[1][j0:j1] - triangle[0, 1])
        (ax, ay, du), (bx, by, dv) = triangle[1:] - triangle[0]
        area = ax * by - ay * bx
        if area == 0:
            continue
        s, t = (x * by - y * bx) / area, (ax * y - ay * x) / area
        inside = (s >= -1e-9) & (t >= -1e-9) & (s + t <= 1 + 1e-9)
        target = values[j0:j1, i0:i1]
        target[inside] = (triangle[0, 2] + s * du + t * dv)[inside]
    return values


def resampled(grid, n):
    resample = vtkHighOrderLinearResample()
    resample.SetInputData(grid)
    resample.SetDimensions(n, n, n)
    resample.AddField(FIELD)
    resample.Update()
    resample.GetOutput().GetPointData().SetActiveScalars(FIELD)
    return resample.GetOutput()


def relative_error(values, exact):
    return np.abs(values - exact) / (np.nanmax(exact) - np.nanmin(exact))


def report(name, values, exact):
    error = relative_error(values, exact)
    covered = np.isfinite(exact).sum()
    missing = (np.isfinite(exact) & ~np.isfinite(values)).sum() / covered
    extra = (~np.isfinite(exact) & np.isfinite(values)).sum() / covered
    print(
        f"{name:22}  max {np.nanmax(error):8.2e}  mean {np.nanmean(error):8.2e}"
        f"  missing {missing:7.2%}  extra {extra:7.2%}"
    )


def paint(values, colors, low, high):
    """RGB bytes; what is no number is white."""
    space, stops = colors
    table = vtkColorTransferFunction()
    if space == "diverging":
        table.SetColorSpaceToDiverging()
    else:
        table.SetColorSpaceToLab()
    for position, color in zip(np.linspace(low, high, len(stops)), stops):
        table.AddRGBPoint(position, *color)
    table.SetNanColor(1, 1, 1)
    flat = numpy_to_vtk(np.ascontiguousarray(values).ravel(), deep=True)
    rgba = table.MapScalars(flat, 0, -1)
    return vtk_to_numpy(rgba)[:, :3].reshape(values.shape + (3,)).copy()


def label(picture, text, x, y, size):
    """Writes black letters, their lower left corner at pixel (x, y)."""
    if not text:
        return
    style = vtkTextProperty()
    style.SetFontSize(size)
    style.SetColor(0, 0, 0)
    image = vtkImageData()
    box = [0, 0]
    vtkTextRenderer.GetInstance().RenderString(style, text, image, box, 72)
    width, height, _ = image.GetDimensions()
    rgba = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)
    target = picture[y : y + height, x : x + width]
    rgba = rgba[: target.shape[0], : target.shape[1]].astype(float)
    alpha = rgba[..., 3:] / 255
    target[:] = np.rint(alpha * rgba[..., :3] + (1 - alpha) * target)


def color_bar(height, colors, texts):
    bar = np.full((height, height // 3, 3), 255, np.uint8)
    margin, letters = height // 8, height // 18
    ramp = np.repeat(np.linspace(0, 1, height - 2 * margin)[:, None], letters, axis=1)
    bar[margin : height - margin, :letters] = paint(ramp, colors, 0, 1)
    for i, text in enumerate(texts):
        y = margin + (height - 2 * margin) * i // (len(texts) - 1) - letters // 2
        label(bar, text, letters + letters // 2, y, letters)
    return bar


def titled(picture, text):
    """The picture with a line of text above it."""
    letters = picture.shape[0] // 16
    strip = np.full((2 * letters, picture.shape[1], 3), 255, np.uint8)
    label(strip, text, letters // 2, letters // 2, letters)
    return np.concatenate([picture, strip])


def compose(exact, panels):
    """Values above, errors below, one column for each way of cutting."""
    bound = np.nanmax(np.abs(exact))
    size = exact.shape[0]
    upper, lower = [], []
    for name, values in panels:
        upper.append(titled(paint(values, COOL_TO_WARM, -bound, bound), name))
        if values is exact:
            blank = np.full((size, size, 3), 255, np.uint8)
            label(blank, "right: |error| / range of u", size // 32, size // 2, size // 16)
            label(blank, "blue: only one covers", size // 32, size // 2 - size // 8, size // 16)
            lower.append(titled(blank, ""))
            continue
        with np.errstate(divide="ignore"):
            error = np.log10(relative_error(values, exact))
        picture = paint(np.clip(error, *ERROR_DECADES), INFERNO, *ERROR_DECADES)
        picture[np.isfinite(values) != np.isfinite(exact)] = (90, 160, 220)
        lower.append(titled(picture, "error, " + name))
    decades = range(ERROR_DECADES[0], ERROR_DECADES[1] + 1)
    bounds = [f"{v:.2f}" for v in (-bound, 0, bound)]
    upper.append(titled(color_bar(size, COOL_TO_WARM, bounds), FIELD))
    lower.append(titled(color_bar(size, INFERNO, [f"1e{d}" for d in decades]), ""))
    return np.concatenate([np.concatenate(lower, axis=1), np.concatenate(upper, axis=1)])


def write(path, picture):
    image = vtkImageData()
    image.SetDimensions(picture.shape[1], picture.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(picture.reshape(-1, 3), deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputData(image)
    writer.Write()


def main():
    path = sys.argv[1] if len(sys.argv) > 1 else "linear_comparison.png"
    size = int(sys.argv[2]) if len(sys.argv) > 2 else 400
    numbers = [int(n) for n in (sys.argv[3] if len(sys.argv) > 3 else "32,64,128").split(",")]

    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(MESH))
    convert = vtkUnstructuredGridToHighOrderGrid()
    convert.SetInputConnection(reader.GetOutputPort())
    convert.Update()
    grid = convert.GetOutput()
    reader.GetOutput().GetPointData().SetActiveScalars(FIELD)

    exact = exact_values(grid, size)
    panels = [("exact", exact), ("vtkCutter on the file", rasterise(cut(reader.GetOutput()), size))]
    for n in numbers:
        panels.append((f"resampled, {n}^3", rasterise(cut(resampled(grid, n)), size)))
    print(f"{MESH.name}, field {FIELD}, plane z = {HEIGHT}, {np.isfinite(exact).sum()} pixels")
    for name, values in panels[1:]:
        report(name, values, exact)
    write(path, compose(exact, panels))
    print("wrote", path)


if __name__ == "__main__":
    main()
