// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/BasisFactor.h"
#include "Core/Math/Vec.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

// Arithmetic of LongVec3, for closed forms.
namespace pixelexact::testing
{
inline constexpr double kPi = std::numbers::pi;
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

inline LongVec3 ToLong(const Vec3& x)
{
  return { x.x, x.y, x.z };
}
inline Vec3 ToDouble(const LongVec3& x)
{
  return { static_cast<double>(x[0]), static_cast<double>(x[1]), static_cast<double>(x[2]) };
}

inline LongVec3 Plus(const LongVec3& a, const LongVec3& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

inline LongVec3 Minus(const LongVec3& a, const LongVec3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline LongVec3 Times(long double s, const LongVec3& a)
{
  return { s * a[0], s * a[1], s * a[2] };
}

inline long double Dot(const LongVec3& a, const LongVec3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline LongVec3 Cross(const LongVec3& a, const LongVec3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

inline LongVec3 Unit(const LongVec3& a)
{
  return Times(1.0L / std::sqrt(Dot(a, a)), a);
}

inline LongVec3 Absolute(const LongVec3& a)
{
  return { std::fabs(a[0]), std::fabs(a[1]), std::fabs(a[2]) };
}

/// The largest number's size; NaN where one is.
inline long double Largest(const LongVec3& a)
{
  const long double largest = std::max({ std::fabs(a[0]), std::fabs(a[1]), std::fabs(a[2]) });
  return std::isnan(a[0] + a[1] + a[2]) ? std::numeric_limits<long double>::quiet_NaN() : largest;
}
} // namespace pixelexact::testing
