// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Contour/SeedList.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace pixelexact
{
namespace
{
/// Seeds nearer to each other than this in xi are one.
constexpr double kSameSeed = 1e-11;
} // namespace

double CurvePart::Between(std::size_t direction, double t) const
{
  const auto d = static_cast<int>(direction);
  return std::clamp(box.lower[d] + t * (box.upper[d] - box.lower[d]), -1.0, 1.0);
}

Parameters MiddleOf(const ParameterBox& box)
{
  Parameters middle{};
  for (std::size_t d = 0; d < 3; ++d)
  {
    middle[d] = (box.lower[d] + box.upper[d]) / 2.0;
  }
  return middle;
}

Parameters MiddleOf(const ParameterIntervals& box)
{
  return { box[0].Middle(), box[1].Middle(), box[2].Middle() };
}

void SeedList::AddRoot(const std::optional<CurvePoint>& point, unsigned faces)
{
  result.complete = result.complete && point.has_value();
  // A root beyond the end of a face, or of the cube, by less than its enclosure is on it.
  if (point && Margin(shape_, point->xi) >= kOutside)
  {
    Add(*point, faces, Exact);
  }
}

void SeedList::AddUndecided(const std::optional<CurvePoint>& point, unsigned faces, const Vec3& xi)
{
  result.complete = false;
  if (!IsFull())
  {
    result.open.push_back({ xi, faces });
  }
  if (point && Margin(shape_, point->xi) >= kOutside)
  {
    Add(*point, faces, false);
  }
}

void SeedList::Add(const CurvePoint& point, unsigned faces, bool certain)
{
  for (ContourSeed& known : result.seeds)
  {
    if (glm::length(known.point.xi - point.xi) <= kSameSeed)
    {
      known.faces |= faces;
      known.onBoundary = known.faces != 0;
      known.certain = known.certain || certain;
      return;
    }
  }
  if (!point.IsRegular())
  {
    // A contour that crosses itself, a touched value, or a plateau: nothing is followed from there.
    result.complete = false;
    if (!IsFull())
    {
      result.open.push_back({ point.xi, faces });
    }
    return;
  }
  result.seeds.push_back({ point, faces, faces != 0, certain });
}
} // namespace pixelexact
