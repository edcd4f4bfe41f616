// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"
#include "Trace/Camera.h"

class vtkCamera;

namespace pixelexact
{
class Surface;

/// The camera of a filter that needs one. Of null: all of the box, in parallel, along the normal of
/// a flat surface, of others from (1, 1, 1). Throws Error for a box that is empty.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT Camera CameraOfFilter(
  vtkCamera* camera, const Surface& surface, const Box3& box, int width, int height);
} // namespace pixelexact
