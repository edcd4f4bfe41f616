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
/// Copies the Bezier patches of VTK's data. The patches are its cells, which must all be
/// VTK_BEZIER_QUADRILATERAL (u is their first parametric direction). Degrees come from the cell
/// array HigherOrderDegrees, or else from the number of points. If there are only vertices or no
/// cells, each 16 points form a bicubic patch, in rows of u.
///
/// Throws Error, naming the cell or patch, for numbers of points that do not match a patch and for
/// points that are not finite. Throws Unsupported for cells of other types and for rational weights
/// that differ inside a cell.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::vector<BezierPatch> ToPatches(vtkPointSet* data);

/// The surface of the patches. Throws Error.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::shared_ptr<const Surface> SurfaceOf(
  const std::vector<BezierPatch>& patches);
} // namespace pixelexact
