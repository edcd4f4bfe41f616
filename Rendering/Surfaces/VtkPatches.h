// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"
#include "Trace/Surfaces/BezierPatch.h"
#include "Trace/Surfaces/Surface.h"

#include <memory>
#include <vector>

class vtkPointSet;

namespace pixelexact
{
/// The Bezier patches of VTK's data, as copies: its cells, all of which are
/// VTK_BEZIER_QUADRILATERAL (u is their first parametric direction), with degrees by the cell array
/// HigherOrderDegrees, else by the number of points; or, where there are no cells but vertices, its
/// points, 16 of which are a bicubic patch, rows of u.
///
/// Throws Error, naming the cell or patch, for numbers of points that are no patch's and for points
/// that are not finite; Unsupported for cells of other types and for rational weights that differ
/// within a cell.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::vector<BezierPatch> ToPatches(vtkPointSet* data);

/// Where rays meet patches. Throws Error.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::shared_ptr<const Surface> SurfaceOf(
  const std::vector<BezierPatch>& patches);
} // namespace pixelexact
