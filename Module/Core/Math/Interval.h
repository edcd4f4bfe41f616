// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace rounding
{
/// A number not above (not below) the exact result of which `v` is the rounding to nearest; at most
/// two ulps away, without a change of the rounding mode (S. Rump, P. Zimmermann, S. Boldo,
/// G. Melquiond, Computing predecessor and successor in rounding to nearest, BIT 49, 2009,
/// algorithm 1). Below, from -inf, comes -inf; from +inf, the largest finite number, for an
/// overflow may have rounded up to it.
inline constexpr double kPhi = 0x1p-53 * (1.0 + 0x1p-51);
inline constexpr double kEta = std::numeric_limits<double>::denorm_min();

inline double Below(double v)
{
  return v == kInfinity ? std::numeric_limits<double>::max()
    : v == -kInfinity   ? v
                        : v - (kPhi * std::fabs(v) + kEta);
}
inline double Above(double v)
{
  return -Below(-v);
}
} // namespace rounding

/// All real numbers from `lower` to `upper`, both may be infinite. Every operation encloses the
/// exact results of all its operands' members. An operation whose result is not bounded, or with a
/// NaN operand, gives -inf to inf. Assumes rounding to nearest, the default.
struct Interval
{
  double lower = 0.0;
  double upper = 0.0;

  constexpr Interval() = default;
  /// A number, exactly.
  // NOLINTNEXTLINE(google-explicit-constructor): a number is an interval of width zero.
  constexpr Interval(double v)
    : lower(v)
    , upper(v)
  {
  }
  constexpr Interval(double from, double to)
    : lower(from)
    , upper(to)
  {
  }

  static constexpr Interval Everything()
  {
    return { -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity() };
  }
  /// middle - radius to middle + radius, outwards.
  static Interval Around(double middle, double radius)
  {
    return { rounding::Below(middle - radius), rounding::Above(middle + radius) };
  }

  [[nodiscard]] constexpr bool Contains(double v) const { return v >= lower && v <= upper; }
  [[nodiscard]] constexpr bool Contains(const Interval& other) const
  {
    return other.lower >= lower && other.upper <= upper;
  }
  /// Whether the other interval is contained without touching the ends.
  [[nodiscard]] constexpr bool ContainsInside(const Interval& other) const
  {
    return other.lower > lower && other.upper < upper;
  }
  [[nodiscard]] constexpr bool IsEmpty() const { return !(lower <= upper); }
  [[nodiscard]] bool IsFinite() const { return std::isfinite(lower) && std::isfinite(upper); }
  /// A member near the middle, for finite intervals.
  [[nodiscard]] double Middle() const { return std::clamp(lower / 2 + upper / 2, lower, upper); }
  /// Upper bounds of the width and of the largest distance from a member.
  [[nodiscard]] double Width() const { return rounding::Above(upper - lower); }
  [[nodiscard]] double RadiusAround(double member) const
  {
    return rounding::Above(std::max(upper - member, member - lower));
  }
  /// The largest and the smallest magnitude of a member.
  [[nodiscard]] double Magnitude() const { return std::max(std::fabs(lower), std::fabs(upper)); }
  [[nodiscard]] double Mignitude() const
  {
    return Contains(0.0) ? 0.0 : std::min(std::fabs(lower), std::fabs(upper));
  }
};

namespace rounding
{
inline Interval Outward(double lower, double upper)
{
  // The comparison is written so that a NaN gives -inf to inf.
  const double below = Below(lower);
  const double above = Above(upper);
  return { below <= lower ? below : -std::numeric_limits<double>::infinity(),
    above >= upper ? above : std::numeric_limits<double>::infinity() };
}
} // namespace rounding

inline Interval operator-(const Interval& a)
{
  return { -a.upper, -a.lower };
}
inline Interval operator+(const Interval& a, const Interval& b)
{
  return rounding::Outward(a.lower + b.lower, a.upper + b.upper);
}
inline Interval operator-(const Interval& a, const Interval& b)
{
  return rounding::Outward(a.lower - b.upper, a.upper - b.lower);
}
inline Interval operator*(const Interval& a, const Interval& b)
{
  const double p = a.lower * b.lower;
  const double q = a.lower * b.upper;
  const double r = a.upper * b.lower;
  const double s = a.upper * b.upper;
  // 0 * infinity: a zero times any finite number is zero, but then the other products bound
  // nothing.
  if (std::isnan(p + q + r + s))
  {
    return Interval::Everything();
  }
  return rounding::Outward(
    std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)));
}
inline Interval operator/(const Interval& a, const Interval& b)
{
  if (b.Contains(0.0) || !(b.lower <= b.upper))
  {
    return Interval::Everything();
  }
  const double p = a.lower / b.lower;
  const double q = a.lower / b.upper;
  const double r = a.upper / b.lower;
  const double s = a.upper / b.upper;
  if (std::isnan(p + q + r + s))
  {
    return Interval::Everything();
  }
  return rounding::Outward(
    std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)));
}
inline Interval& operator+=(Interval& a, const Interval& b)
{
  return a = a + b;
}
inline Interval& operator-=(Interval& a, const Interval& b)
{
  return a = a - b;
}
inline Interval& operator*=(Interval& a, const Interval& b)
{
  return a = a * b;
}

inline Interval Abs(const Interval& a)
{
  return { a.Mignitude(), a.Magnitude() };
}
inline Interval Square(const Interval& a)
{
  const Interval m = Abs(a);
  const Interval s = rounding::Outward(m.lower * m.lower, m.upper * m.upper);
  return { std::max(s.lower, 0.0), s.upper };
}
/// The square roots of the members that are not negative.
inline Interval Sqrt(const Interval& a)
{
  const Interval s =
    rounding::Outward(std::sqrt(std::max(a.lower, 0.0)), std::sqrt(std::max(a.upper, 0.0)));
  return { std::max(s.lower, 0.0), s.upper };
}
inline Interval Join(const Interval& a, const Interval& b)
{
  return { std::min(a.lower, b.lower), std::max(a.upper, b.upper) };
}
/// The intersection; empty where the intervals do not meet.
inline Interval Intersect(const Interval& a, const Interval& b)
{
  return { std::max(a.lower, b.lower), std::min(a.upper, b.upper) };
}
} // namespace pixelexact
