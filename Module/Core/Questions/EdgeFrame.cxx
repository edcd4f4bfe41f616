// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Math/Rounding.h"
#include "Core/Questions/EdgeArithmetic.h"
#include "Core/Questions/EdgeMeeting.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace pixelexact
{
using namespace edges;

Box3 BoxOf(const WideOutline& region)
{
  Box3 box{ Vec3(kInfinity), Vec3(-kInfinity) };
  for (const Vec3& corner : region.outline.Corners())
  {
    box.lower = glm::min(box.lower, corner - region.slack);
    box.upper = glm::max(box.upper, corner + region.slack);
  }
  return box;
}

EdgeFrame::EdgeFrame(Shape shape, const ElementBounds& bounds)
  : Known(bounds.framed)
  , Start(Centre(shape))
  , Origin(bounds.origin[0], bounds.origin[1], bounds.origin[2])
  , Inverse(0.0)
  , Ends(EndsOf(shape, {}))
{
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      Inverse[j][i] = bounds.inverse[3 * i + j];
    }
  }
  for (EdgeNodeEnd& end : Ends)
  {
    // Preimages are what the affine map says less the deviation.
    for (std::size_t k = 0; k < 3; ++k)
    {
      end.offset += std::max(end.normal[k] * bounds.lower[k], end.normal[k] * bounds.upper[k]);
    }
  }
}

bool EdgeFrame::Misses(const EdgeFunctions& functions, const WideOutline& region) const
{
  if (!Known)
  {
    return false;
  }
  const auto corners = region.outline.Corners();
  std::array<Vec3, Outline::kMaxCorners> places;
  Vec3 unsure(0.0);
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Vec3 y = functions.InUnits(corners[i]);
    places[i] = Start + Inverse * (y - Origin);
    unsure = glm::max(unsure,
      functions.RoundingInUnits(corners[i]) + kRoundoffs * (glm::abs(y) + glm::abs(Origin)));
  }
  unsure += Vec3(region.slack / functions.Size());
  double off[3];
  for (std::size_t k = 0; k < 3; ++k)
  {
    const int d = static_cast<int>(k);
    off[k] = kBeside;
    for (int j = 0; j < 3; ++j)
    {
      off[k] += std::fabs(Inverse[j][d]) * unsure[j];
    }
  }
  return std::ranges::any_of(Ends,
    [&](const EdgeNodeEnd& end)
    {
      const double wider = end.Across(off) * kUp;
      return std::ranges::all_of(std::span(places).first(corners.size()),
        [&](const Vec3& xi) { return end.DepthOf(xi) + wider < 0.0; });
    });
}
} // namespace pixelexact
