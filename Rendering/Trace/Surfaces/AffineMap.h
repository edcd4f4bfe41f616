// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Mat.h"

namespace pixelexact
{
/// x -> linear x + offset, from the world to the space in which a surface is described.
struct AffineMap
{
  Mat3 linear{ 1.0 };
  Vec3 offset{ 0.0 };

  [[nodiscard]] bool IsIdentity() const { return linear == Mat3(1.0) && offset == Vec3(0.0); }
  /// The approximate preimage of x. Throws Error, which begins with the surface's name, if the map
  /// has no inverse or a number is not finite.
  [[nodiscard]] Vec3 Preimage(const Vec3& x, const char* surface) const;
};
} // namespace pixelexact
