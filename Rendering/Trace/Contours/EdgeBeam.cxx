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
/// Of a beam: parts that are looked at, how often they are halved before and at most, and about
/// what it costs beside halving nodes, in nanoseconds.
constexpr int kBeamParts = 512;
constexpr int kLongParts = 3;
constexpr int kBeamSubdivisions = 20;
constexpr std::int64_t kBeamCost = 200000;
/// Elements beyond which parts are halved at once, unless they have been halved so often: nobody
/// sees most of these.
constexpr std::ptrdiff_t kBeamElements = 12;
constexpr int kShortParts = 8;
/// Of nodes, in these parts.
constexpr EdgeEffort kEffort{ 12, 0 };
} // namespace

EdgeBeam::EdgeBeam(const Ray& a, const Ray& b, const Box3& box)
  : A(a)
  , B(b)
  , Near(std::numeric_limits<double>::infinity())
  , Far(-Near)
{
  // Depths are ways along both rays from one depth on, `along` times which are ways along a + b.
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
  // Nothing is seen behind where rays start.
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
  // Nearest first.
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
