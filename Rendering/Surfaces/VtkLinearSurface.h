// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"
#include "Trace/Compare/LinearSurface.h"

#include "vtkType.h"

#include <memory>
#include <string>

class vtkDataArray;
class vtkPolyData;

namespace pixelexact
{
/// A point's component, or with kMagnitude the norm of all, of a single one the value itself.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT double ValueAt(
  vtkDataArray* values, vtkIdType point, int component);

/// The polygons and strips of a surface, as triangles, with the values of a point array at their
/// corners: a component, or kMagnitude. Triangles with a corner whose value is not finite, or
/// whose point is not, are left out: a pipeline shows no value there. Throws Error where there is
/// no such array or component.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::unique_ptr<const LinearSurface> ToLinearSurface(
  vtkPolyData* surface, const std::string& array, int component);
} // namespace pixelexact
