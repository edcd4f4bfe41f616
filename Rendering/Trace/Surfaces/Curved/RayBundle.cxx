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

void RayBundle::FindFarthest()
{
  Ranges.mostFar = *std::max_element(far.begin(), far.begin() + Size);
}
} // namespace pixelexact
