// SPDX-License-Identifier: BSD-3-Clause
#include "Views/CameraOfFilter.h"

#include "Trace/Surfaces/Surface.h"
#include "Views/VtkCamera.h"

namespace pixelexact
{
Camera CameraOfFilter(
  vtkCamera* camera, const Surface& surface, const Box3& box, int width, int height)
{
  if (camera != nullptr)
  {
    return SetupOf(camera, width, height).Make();
  }
  const Vec3 towards =
    surface.IsFlat() ? surface.Normal({ 0.5 * (box.lower + box.upper) }) : Vec3(1.0);
  return { ViewOfBox(box, towards, width, height, Vec3(0.0, 1.0, 0.0), true), width, height };
}
} // namespace pixelexact
