// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surface.h"

#include <algorithm>

namespace pixelexact
{
Hit NextHitOf(const Surface& surface, const Ray& ray, double tMin)
{
  double lanes[11][kLanePadding];
  for (int d = 0; d < 3; ++d)
  {
    std::fill_n(lanes[d], kLanePadding, ray.origin[d]);
    std::fill_n(lanes[3 + d], kLanePadding, ray.direction[d]);
  }
  std::fill_n(lanes[6], kLanePadding, tMin);
  surface.NextHit({ { lanes[0], lanes[1], lanes[2] }, { lanes[3], lanes[4], lanes[5] }, 1 },
    lanes[6], { lanes[7], { lanes[8], lanes[9], lanes[10] } });
  return { lanes[7][0], { lanes[8][0], lanes[9][0], lanes[10][0] } };
}
} // namespace pixelexact
