// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Contours/EdgeBeam.h"

#include "Core/Math/Rounding.h"
#include "Trace/Contours/EdgeClassifier.h"
#include "Trace/Surfaces/Surface.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace pixelexact
{
namespace
{
/// Limits for a beam: parts that are tested, subdivisions before a part is tested, and subdivisions
/// at most. kBeamCost estimates the cost in nanoseconds, without subdivision of nodes.
constexpr int kBeamParts = 512;
constexpr int kLongParts = 3;
constexpr int kBeamSubdivisions = 20;
constexpr std::int64_t kBeamCost = 200000;
/// A part that meets more elements is subdivided without a test, up to kShortParts subdivisions:
/// most of these elements are hidden.
constexpr std::ptrdiff_t kBeamElements = 12;
constexpr int kShortParts = 8;
/// Limits for the nodes that a part meets.
constexpr EdgeEffort kEffort{ 12, 0 };
} // namespace

EdgeBeam::EdgeBeam(const Ray& a, const Ray& b, const Box3& box)
  : A(a)
  , B(b)
  , Near(std::numeric_limits<double>::infinity())
  , Far(-Near)
{
  // A depth is a distance along both rays. `along` times it is the distance along a + b.
  const Vec3 sum = a.direction + b.direction;
  const double length = glm::length(sum);
  const Vec3 direction = sum / length;
  const double along = 0.5 * length;
  const double ahead = glm::dot(A.origin - B.origin, direction) / along;
  B.origin += ahead * B.direction;
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vec3 x((corner & 1) != 0 ? box.upper.x : box.lower.x,
      (corner & 2) != 0 ? box.upper.y : box.lower.y, (corner & 4) != 0 ? box.upper.z : box.lower.z);
    const double depth = glm::dot(x - A.origin, direction) / along;
    Near = std::min(Near, depth);
    Far = std::max(Far, depth);
  }
  Rounding = 32.0 * kUnitRoundoff *
    (glm::length(A.origin) + glm::length(B.origin) + std::max(std::fabs(Near), std::fabs(Far)));
  // Rays see nothing before their origins.
  Near = std::max(Near - Rounding, std::min(0.0, -ahead));
  Far += Rounding;
}

Outline EdgeBeam::Part(double from, double to) const
{
  return Outline(std::array{ A.origin + from * A.direction, B.origin + from * B.direction,
    B.origin + to * B.direction, A.origin + to * A.direction });
}

bool EdgeClassifier::StaysBetween(const Surface& surface, const EdgeBeam& beam) const
{
  struct Stretch
  {
    double from;
    double to;
    int subdivisions;
  };
  if (!Affords(kBeamCost))
  {
    return false;
  }
  const auto staysOn = [&](const WideOutline& region, int subdivisions)
  {
    const std::span<const Element> elements = ElementsAt(region);
    return (subdivisions >= kShortParts || std::ssize(elements) <= kBeamElements) &&
      StaysOn(kNoSide, elements, region, With(kEffort));
  };
  // The nearest part is on top.
  std::vector<Stretch> open{ { beam.Nearest(), beam.Farthest(), 0 } };
  for (int left = kBeamParts; !open.empty() && left > 0; --left)
  {
    const Stretch part = open.back();
    open.pop_back();
    const WideOutline region{ beam.Part(part.from, part.to), beam.Slack() };
    if (part.subdivisions >= kLongParts &&
      (!surface.MayMeet(region.outline, region.slack, Work) || staysOn(region, part.subdivisions)))
    {
      continue;
    }
    if (part.subdivisions == kBeamSubdivisions)
    {
      return false;
    }
    const double middle = 0.5 * (part.from + part.to);
    open.push_back({ middle, part.to, part.subdivisions + 1 });
    open.push_back({ part.from, middle, part.subdivisions + 1 });
  }
  return open.empty();
}
} // namespace pixelexact
