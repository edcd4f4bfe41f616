// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/EdgePaths.h"

#include "Drawing/PixelPaths.h"
#include "Scene/Shot.h"

#include "Core/Location/Locator.h"
#include "Trace/Frame.h"
#include "Trace/Surfaces/Plane.h"

#include <glm/geometric.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>

namespace pixelexact
{
namespace
{
/// Number of bisections of a crossing, and the distance in pixels by which a line may then miss it.
constexpr int kSubdivisions = 6;
constexpr double kTolerance = 1.0 / 64;
constexpr std::size_t kBatch = 1024;

/// Elements of a batch's points; -1: none or unknown.
class Owners final : public LocationSink
{
public:
  explicit Owners(std::size_t count)
    : Elements(count, -1)
  {
  }
  void Inside(int element, std::span<const int> index, const double* const /*xi*/[3],
    const double* /*residual*/) override
  {
    for (const int i : index)
    {
      Elements[static_cast<std::size_t>(i)] = element;
    }
  }
  void Unknown(int /*index*/, int /*element*/) override {}

  std::vector<std::int64_t> Elements;
};

std::vector<PixelStep> StepsOf(const SampleBuffers& of)
{
  const auto width = static_cast<std::size_t>(of.width);
  const auto differ = [&of](std::size_t p, std::size_t q)
  {
    const auto unknown = static_cast<std::uint8_t>(PixelVerdict::Unknown);
    return of.element[p] != of.element[q] && of.element[p] >= 0 && of.element[q] >= 0 &&
      of.verdict[p] != unknown && of.verdict[q] != unknown;
  };
  std::vector<PixelStep> steps;
  for (int j = 0; j < of.height; ++j)
  {
    for (int i = 0; i < of.width; ++i)
    {
      const std::size_t p = static_cast<std::size_t>(j) * width + static_cast<std::size_t>(i);
      if (i + 1 < of.width && differ(p, p + 1))
      {
        steps.push_back(PixelStep::Right(i, j));
      }
      if (j + 1 < of.height && differ(p, p + width))
      {
        steps.push_back(PixelStep::Up(i, j));
      }
    }
  }
  return steps;
}

/// Bisects the crossings between neighbouring pixels' centres.
class Subdivision
{
public:
  Subdivision(const Shot& shot, const Plane& plane, const SampleBuffers& of)
    : Rays(shot.MakeCamera())
    , Through(plane.Point())
    , Normal(plane.Normal({}))
    , Where(*shot.scene.locator)
    , Of(of)
  {
  }

  void operator()(std::span<PixelStep> steps) const
  {
    std::vector<double> low(steps.size(), 0.0);
    double half = 0.5;
    for (int k = 0; k < kSubdivisions; ++k, half *= 0.5)
    {
      std::vector<Vec3> points;
      points.reserve(steps.size());
      for (std::size_t s = 0; s < steps.size(); ++s)
      {
        points.push_back(PointAt(AtPart(steps[s], low[s] + half)));
      }
      Owners owners(steps.size());
      Where.Locate(points, owners);
      for (std::size_t s = 0; s < steps.size(); ++s)
      {
        low[s] += owners.Elements[s] == FirstOf(steps[s]) ? half : 0.0;
      }
    }
    for (std::size_t s = 0; s < steps.size(); ++s)
    {
      steps[s].at = AtPart(steps[s], low[s] + half);
    }
  }

private:
  static CanvasPoint AtPart(const PixelStep& step, double part)
  {
    return { step.i + 0.5 + (step.across ? part : 0.0), step.j + 0.5 + (step.across ? 0.0 : part) };
  }
  [[nodiscard]] Vec3 PointAt(const CanvasPoint& at) const
  {
    const Ray ray = Rays.At(at[0], at[1]);
    const double t = glm::dot(Through - ray.origin, Normal) / glm::dot(ray.direction, Normal);
    return ray.origin + t * ray.direction;
  }
  [[nodiscard]] std::int64_t FirstOf(const PixelStep& step) const
  {
    return Of.element[static_cast<std::size_t>(step.j) * static_cast<std::size_t>(Of.width) +
      static_cast<std::size_t>(step.i)];
  }

  Camera Rays;
  Vec3 Through;
  Vec3 Normal;
  const Locator& Where;
  const SampleBuffers& Of;
};
} // namespace

std::optional<std::vector<std::vector<CanvasPoint>>> PathsOfEdges(
  const Shot& shot, const Frame& frame)
{
  const auto* plane = dynamic_cast<const Plane*>(shot.scene.layers.front().surface.get());
  if (shot.scene.layers.size() > 1 || plane == nullptr || !shot.scene.kept.empty())
  {
    return std::nullopt;
  }
  std::vector<PixelStep> steps = StepsOf(frame.centres);
  if (static_cast<std::int64_t>(8 * steps.size()) > frame.counters.exact)
  {
    return std::nullopt;
  }
  const Subdivision subdivide(shot, *plane, frame.centres);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, steps.size(), kBatch),
    [&](const tbb::blocked_range<std::size_t>& part)
    { subdivide(std::span(steps).subspan(part.begin(), part.size())); });
  return PathsOf(steps, kTolerance);
}
} // namespace pixelexact
