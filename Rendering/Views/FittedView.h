// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"
#include "Trace/Camera.h"

#include <array>
#include <functional>
#include <vector>

// The default camera, equal for the command-line program and for vtkHighOrderPicture.

class vtkCamera;

namespace pixelexact
{
class Surface;

/// The camera of a filter. If `camera` is null: a parallel view of the whole box, along the normal
/// of a flat surface, or from (1, 1, 1) for other surfaces. Throws Error for an empty box.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT Camera CameraOfFilter(
  vtkCamera* camera, const Surface& surface, const Box3& box, int width, int height);

/// The direction from a plane to the viewer that is the default: the normal. A plane across y is
/// seen from below y, so that x points to the right.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT Vec3 SideOfPlane(const Vec3& normal);

/// The default view-up: z, unless the camera looks along z.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT Vec3 UsualUp(const Vec3& towardsViewer);

/// Size of the small image, with the same aspect ratio, in which the visible points are found.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::array<int, 2> SmallSize(int width, int height);

/// The finite points, in world space, that a view shows in a small image.
using SeenFrom = std::function<std::vector<Vec3>(const CameraView&)>;

/// Moves the view nearer, or sideways, so that the visible points fill most of an image of width x
/// height pixels. Uses two passes, and up to five for surfaces in a few pixels: each resolves
/// points that the one before showed coarsely. `keepScale`: a parallel view keeps its scale.
/// Without visible points, or with a single one, returns the view unchanged. The view is one that a
/// vtkCamera can hold (AsHeld).
[[nodiscard]] PIXELEXACTRENDERING_EXPORT CameraView FitView(
  const CameraView& all, int width, int height, bool keepScale, const SeenFrom& seen);
} // namespace pixelexact
