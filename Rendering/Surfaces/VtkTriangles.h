// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"
#include "Trace/Surfaces/Triangles.h"

#include <memory>

class vtkPolyData;

namespace pixelexact
{
/// The polygons and strips of a surface, as triangles; its vertices and lines are left out. A copy.
/// Throws Error where there are none, and as Triangles.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::shared_ptr<const Triangles> ToTriangles(
  vtkPolyData* surface);
} // namespace pixelexact
