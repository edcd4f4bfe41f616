// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkSmartPointer.h"

#include <string>

class vtkHighOrderSurface;

namespace pixelexact
{
/// A cut-surface of a file's geometry: triangles and other polygons of .stl and .vtp, Bezier
/// patches of .vtu (vtkHighOrderPatchSurface) and of .vtp without polygons, whose points are 16 by
/// 16 bicubic patches. Throws Error, naming the file, for other suffixes and where nothing can be
/// read.
vtkSmartPointer<vtkHighOrderSurface> SurfaceOfFile(const std::string& file);
} // namespace pixelexact
