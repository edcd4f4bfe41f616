// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/AffineMap.h"

#include "Trace/Surfaces/Arguments.h"

#include <glm/matrix.hpp>

#include <algorithm>

namespace pixelexact
{
Vec3 AffineMap::Preimage(const Vec3& x, const char* surface) const
{
  const Mat3& M = linear;
  if (!IsFinite(M[0]) || !IsFinite(M[1]) || !IsFinite(M[2]) || !IsFinite(offset))
  {
    Refuse(surface, "a number of its transform is not finite.");
  }
  // Scaled, so that the determinant neither overflows nor underflows.
  const double size = std::max({ LargestOf(M[0]), LargestOf(M[1]), LargestOf(M[2]) });
  const Mat3 inverse = glm::inverse(M / size);
  if (!IsFinite(inverse[0]) || !IsFinite(inverse[1]) || !IsFinite(inverse[2]))
  {
    Refuse(surface, "its transform has no inverse; give one that does not flatten space.");
  }
  return inverse * ((x - offset) / size);
}
} // namespace pixelexact
