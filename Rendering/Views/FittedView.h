// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"
#include "Trace/Camera.h"

#include <array>
#include <functional>
#include <vector>

// Where the camera stands that nobody placed: the same for the command-line program and for
// vtkHighOrderPicture.

class vtkCamera;

namespace pixelexact
{
class Surface;

/// The camera of a filter that needs one. Of null: all of the box, in parallel, along the normal of
/// a flat surface, of others from (1, 1, 1). Throws Error for a box that is empty.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT Camera CameraOfFilter(
  vtkCamera* camera, const Surface& surface, const Box3& box, int width, int height);

/// z points up, as in most drawings of solids, except where one looks along it.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT Vec3 UsualUp(const Vec3& towardsViewer);

/// The small image, of the same shape, in which what is seen is looked for.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::array<int, 2> SmallSize(int width, int height);

/// The points, in world space, that a view shows in a small image; only finite ones.
using SeenFrom = std::function<std::vector<Vec3>(const CameraView&)>;

/// The view moved nearer, or to the side, so that what is seen fills most of an image of width x
/// height pixels; looked for twice, the second time from nearer, where the first saw what is small
/// in a few of its pixels. `keepScale`: a parallel view keeps its scale. Where nothing is seen, or
/// a single point, the view as it was. The view is one that a camera holds (AsHeld).
[[nodiscard]] PIXELEXACTRENDERING_EXPORT CameraView FitView(
  const CameraView& all, int width, int height, bool keepScale, const SeenFrom& seen);
} // namespace pixelexact
