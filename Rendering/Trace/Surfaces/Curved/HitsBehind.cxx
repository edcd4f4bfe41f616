// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/HitsBehind.h"

namespace pixelexact
{
std::vector<BehindFace> HitsBehind(const Locator& locator, const CurvedPart& part,
  const std::vector<CurvedHit>& hits, std::size_t first)
{
  std::vector<Vec3> xi;
  std::vector<Vec3> x;
  for (std::size_t k = first; k < hits.size(); ++k)
  {
    xi.push_back(hits[k].xi);
    x.push_back(hits[k].position);
  }
  std::vector<BehindFace> behind(xi.size());
  FindBehind(locator, { part.element, part.face }, xi, x, behind);
  return behind;
}
} // namespace pixelexact
