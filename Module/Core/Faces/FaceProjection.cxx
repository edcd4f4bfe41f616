// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Faces/FaceProjection.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
constexpr int kMaxSteps = 20;
/// After a step smaller than this, relative to the face, the next one is of rounding size.
constexpr double kSmallStep = 1e-10;

/// One over the tolerance, per coordinate: distances count in tolerances, so that thin faces are
/// not lost in the rounding of their length.
Vec3 Weights(const Vec3& tolerance)
{
  constexpr double kMinPart = 1e-8; // a coordinate may be known exactly, as 0
  const double largest = std::max({ tolerance.x, tolerance.y, tolerance.z });
  return largest / glm::max(tolerance, Vec3(kMinPart * largest));
}

/// One step towards the point of the tangent plane that is nearest to x; not finite where the
/// tangents are parallel.
FacePoint Step(const FaceSample& sample, const Vec3& towards, const Vec3& weights)
{
  const Vec3 first = weights * sample.first;
  const Vec3 second = weights * sample.second;
  const Vec3 rest = weights * towards;
  const double a = glm::dot(first, first);
  const double b = glm::dot(first, second);
  const double c = glm::dot(second, second);
  const double u = glm::dot(first, rest);
  const double v = glm::dot(second, rest);
  const double determinant = a * c - b * b;
  return { (c * u - b * v) / determinant, (a * v - b * u) / determinant };
}

bool AreOpposite(const Vec3& a, const Vec3& b)
{
  return glm::dot(a, b) < kOpposite * glm::length(a) * glm::length(b);
}
} // namespace

void FaceProjection::Find(int element, int face, std::span<const FaceSample> points,
  const Vec3& tolerance, std::vector<char>& found)
{
  const Space& space = mesh_.map.SpaceOf(element);
  const ReferenceFace& reference = ReferenceFaceOf(space.shape, face);
  const auto grid = Grids.Closed(reference.corners, space.MaxOrder());
  Sampler.Sample(element, face, grid, Samples);
  const Vec3 weights = Weights(tolerance);
  At.clear();
  for (const FaceSample& point : points)
  {
    const auto nearest = std::ranges::min_element(Samples, {},
      [&](const FaceSample& sample) { return glm::length(weights * (sample.x - point.x)); });
    // Off the grid's corners, where triangles' tangents may vanish.
    FacePoint start = grid[static_cast<std::size_t>(nearest - Samples.begin())];
    for (double& part : start)
    {
      part += 1e-3 * (1.0 / 3.0 - part);
    }
    At.push_back(start);
  }
  found.assign(points.size(), 0);
  Left.assign(points.size(), kMaxSteps);
  for (bool open = true; open;)
  {
    Sampler.Sample(element, face, At, Samples);
    open = false;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const Vec3 towards = points[i].x - Samples[i].x;
      if (found[i] == 0 && glm::all(glm::lessThanEqual(glm::abs(towards), tolerance)))
      {
        found[i] = AreOpposite(Samples[i].normal, points[i].normal) ? 1 : 0;
        Left[i] = 0;
      }
      if (Left[i] == 0)
      {
        continue;
      }
      const FacePoint by = Step(Samples[i], towards / mesh_.size[element], weights);
      const FacePoint next = reference.Nearest({ At[i][0] + by[0], At[i][1] + by[1] });
      const double moved = std::max(std::fabs(next[0] - At[i][0]), std::fabs(next[1] - At[i][1]));
      // Written so that a step that is not a number is the last.
      Left[i] = moved > kSmallStep ? Left[i] - 1
        : moved <= kSmallStep      ? std::min(Left[i] - 1, 1)
                                   : 0;
      if (Left[i] > 0)
      {
        At[i] = next;
        open = true;
      }
    }
  }
}
} // namespace pixelexact
