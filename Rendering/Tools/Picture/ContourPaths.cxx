// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/ContourPaths.h"

#include "Picture/ContourFile.h"
#include "Scene/Shot.h"

#include "Core/Contour/Contour.h"
#include "Trace/Projection.h"
#include "Trace/Surfaces/Plane.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

namespace pixelexact
{
namespace
{
/// Tolerance of paths, in pixels.
constexpr double kExactness = 0.1;

/// The smallest length in the mesh's box that a pixel covers.
double SmallestPixel(const Projection& projection, const CameraView& view, const Box3& box)
{
  const Vec3 nearest = glm::clamp(view.position, box.lower, box.upper);
  return projection.PixelAt(glm::distance(nearest, view.position));
}
} // namespace

std::optional<std::vector<ContourPath>> PathsOfContours(
  const Shot& shot, const std::vector<double>& values)
{
  const Layer& layer = shot.scene.layers.front();
  if (shot.scene.layers.size() > 1 || !shot.scene.kept.empty() || layer.field == nullptr ||
    dynamic_cast<const Plane*>(layer.surface.get()) == nullptr ||
    layer.field->mapping != Mapping::Identity)
  {
    return std::nullopt;
  }
  const Projection projection(shot.view, shot.size.width, shot.size.height);
  const Box3 box = shot.scene.locator->Bounds();
  const double diagonal = glm::length(box.upper - box.lower);
  const double tolerance =
    std::max(kExactness * SmallestPixel(projection, shot.view, box), 1e-8 * diagonal);
  const ContourSet set = ContoursOfLayer(shot, 0, values, tolerance);
  const ContourReport& report = set.report;
  if (report.undecided + report.unproven + report.lost + report.tooHigh + report.constant > 0)
  {
    return std::nullopt;
  }
  std::vector<ContourPath> paths;
  for (const ContourLine& line : set.lines)
  {
    paths.push_back({ {}, line.value });
    for (const std::int64_t id : line.vertices)
    {
      const auto seen = projection.Of(set.vertices[static_cast<std::size_t>(id)].x);
      if (!seen)
      {
        // The point is behind the viewer. The part in front of the viewer becomes another path.
        paths.push_back({ {}, line.value });
        continue;
      }
      paths.back().points.push_back(seen->at);
    }
  }
  return paths;
}
} // namespace pixelexact
