// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/View.h"

#include "Trace/Appearance/Painter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace pixelexact
{
bool HaveSameRays(const View& a, const View& b)
{
  return a.data == b.data && a.scene == b.scene && a.camera == b.camera && a.stride == b.stride;
}

void SetTranslucency(View& view, bool all)
{
  std::vector<Layer>& layers = view.scene.layers;
  const bool onePlane = layers.size() == 1 && layers.front().surface->IsPlane();
  for (std::size_t k = 0; k < layers.size(); ++k)
  {
    layers[k].translucent = !onePlane && (all || !view.appearance.layers[k].IsOpaque());
  }
}

Frame Trace(const View& view, Buffer centres, const Progress& progress)
{
  const Buffer wanted = centres | NeedsOf(view);
  return view.stride > 1
    ? TraceStrided(view.scene, view.camera.Make(), wanted, view.stride, progress)
    : Trace(view.scene, view.camera.Make(), {}, { .centres = wanted }, progress);
}

std::vector<Vec3> SeenPoints(const Scene& scene, const CameraSetup& camera)
{
  Scene opaque = scene;
  for (Layer& layer : opaque.layers)
  {
    layer.translucent = false; // what lies behind is within the outline of what is in front
  }
  const Frame frame = Trace(opaque, camera.Make(), {}, { .centres = Buffer::Position });
  std::vector<Vec3> points;
  std::ranges::copy_if(frame.centres.position, std::back_inserter(points),
    [](const Vec3& x) { return std::isfinite(x.x + x.y + x.z); });
  return points;
}
} // namespace pixelexact
