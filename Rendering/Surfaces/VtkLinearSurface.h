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
/// A component of a point's value or, with kMagnitude, the norm of all; for one component, its
/// signed value.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT double ValueAt(
  vtkDataArray* values, vtkIdType point, int component);

/// Triangulates the polygons and strips of a surface, with the values of a point array at the
/// corners: a component, or kMagnitude. Triangles with a corner whose value or point is not finite
/// are omitted, as a pipeline shows no value there. Throws Error if the array or component does not
/// exist.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::unique_ptr<const LinearSurface> ToLinearSurface(
  vtkPolyData* surface, const std::string& array, int component);
} // namespace pixelexact
