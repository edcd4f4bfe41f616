// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/RayBundle.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
void RayBundle::Begin(const RayLanes& rays, int first, int count, int way, const Box3& about)
{
  Size = count;
  Offset = first;
  const int along = way / 2;
  axes = { (along + 1) % 3, (along + 2) % 3, along };
  sign = way % 2 == 1 ? -1.0 : 1.0;
  z0 = 0.5 * about.lower[axes[2]] + 0.5 * about.upper[axes[2]];
  const Vec3 largest = glm::max(glm::abs(about.lower), glm::abs(about.upper));
  const BundleFrame frame{ axes, z0, sign, std::max({ largest.x, largest.y, largest.z }) };
  const BundleColumns columns{ { place[0].data(), place[1].data() },
    { slope[0].data(), slope[1].data() }, slack.data(), near.data(), far.data(), Origin.data(),
    Direction.data() };
  GetBundleKernels().describe(rays, first, count, frame, columns, Ranges);
}

// The same sums as for a ray alone, of numbers that are no larger, or no smaller: rounding is
// monotone, so that no box is left out that one of the rays would not leave out.
bool RayBundle::MayMeet(const Box3& box) const
{
  const double from = box.lower[axes[2]] - z0;
  const double to = box.upper[axes[2]] - z0;
  bool may = std::max(sign * from, sign * to) + Ranges.mostSlack >= Ranges.depth.least &&
    std::min(sign * from, sign * to) - Ranges.mostSlack <= Ranges.depth.most;
  for (std::size_t a = 0; a < 2; ++a)
  {
    const auto [least, most] = std::minmax({ Ranges.slope[a].least * from,
      Ranges.slope[a].least * to, Ranges.slope[a].most * from, Ranges.slope[a].most * to });
    may = may && Ranges.place[a].least + least - Ranges.mostSlack <= box.upper[axes[a]] &&
      Ranges.place[a].most + most + Ranges.mostSlack >= box.lower[axes[a]];
  }
  return may;
}

double RayBundle::DepthOf(const Box3& box) const
{
  return std::min(sign * (box.lower[axes[2]] - z0), sign * (box.upper[axes[2]] - z0)) -
    Ranges.mostSlack;
}

double RayBundle::DepthAt(int i, double t) const
{
  const auto at = static_cast<std::size_t>(i);
  return sign * (Origin[at] + t * Direction[at]);
}

double RayBundle::TimeAt(int i, const Vec3& x) const
{
  const auto at = static_cast<std::size_t>(i);
  return ((x[axes[2]] - z0) - Origin[at]) / Direction[at];
}

void RayBundle::EndAt(int i, double depth)
{
  const auto at = static_cast<std::size_t>(i);
  far[at] = std::min(far[at], depth + slack[at]);
}

void RayBundle::FindFarthest()
{
  Ranges.mostFar = *std::max_element(far.begin(), far.begin() + Size);
}
} // namespace pixelexact
