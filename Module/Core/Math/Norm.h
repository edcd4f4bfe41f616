// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
/// The maximum norm; where a component is NaN anything may come out.
inline double MaxAbs(const Vec3& x)
{
  return std::max({ std::fabs(x.x), std::fabs(x.y), std::fabs(x.z) });
}
} // namespace pixelexact
