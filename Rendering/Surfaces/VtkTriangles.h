// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"
#include "Trace/Surfaces/Triangles.h"

#include <memory>

class vtkPolyData;

namespace pixelexact
{
/// Copies the polygons and strips of a surface as triangles; vertices and lines are omitted. Throws
/// Error without triangles, and as Triangles does.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::shared_ptr<const Triangles> ToTriangles(
  vtkPolyData* surface);
} // namespace pixelexact
