// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/HessianFunction.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
/// Places in the list of polynomials (HessianFunction::Polynomials).
constexpr std::size_t kSecond = 12;
constexpr std::size_t kE1 = kSecond + 4 * 6;
constexpr std::size_t kE2 = kE1 + 1;
constexpr std::size_t kH2 = kE2 + 1;
constexpr std::size_t kH3 = kH2 + 1;

/// The symmetric matrix of second derivatives by xi: 11, 12, 13, 22, 23, 33.
std::array<Interval, 6> ByXi(Shape shape, std::span<const Interval> p, std::size_t function,
  const Interval& r3, const Interval& r23)
{
  const auto second = p.subspan(kSecond + 6 * function, 6);
  const auto over = [](const Interval& v, const Interval& r, bool divided)
  { return divided ? v * r : v; };
  const bool curved1 = shape != Shape::Hexahedron;
  const bool curved2 = HessianFunction::IsDivided(shape, 1, 2);
  std::array<Interval, 6> result;
  result[0] = over(second[0], r23, curved1);
  result[1] = over(second[1], r23, curved1);
  result[2] = over(second[3], r23, curved1);
  result[3] = over(second[2], r3, curved2);
  const Interval by2 = over(second[4], r3, curved2);
  result[4] = by2;
  result[5] = second[5];
  if (shape == Shape::Tetrahedron)
  {
    result[3] = result[3] + p[kE1] * result[1];
    result[4] = result[4] + p[kE1] * result[2];
  }
  if (curved1)
  {
    result[5] = result[5] + p[kE1] * result[2];
  }
  if (curved2)
  {
    result[5] = result[5] + p[kE2] * by2;
  }
  return result;
}
} // namespace

bool HessianFunction::IsDivided(Shape shape, int derivative, int direction)
{
  switch (shape)
  {
    case Shape::Prism:
      return derivative == 0 && direction == 2;
    case Shape::Tetrahedron:
      return derivative < direction;
    case Shape::Pyramid:
      return derivative < 2 && direction == 2;
    default:
      return false;
  }
}

std::array<HessianFunction::XiRanges, 4> HessianFunction::RangesByXi(
  Shape shape, std::span<const Interval> hulls)
{
  const Interval r3 = Interval(1.0) / hulls[kH3];
  const Interval r23 = shape == Shape::Tetrahedron ? r3 / hulls[kH2] : r3;
  std::array<XiRanges, 4> ranges;
  for (std::size_t f = 0; f < 4; ++f)
  {
    std::copy_n(hulls.begin() + static_cast<std::ptrdiff_t>(3 * f), 3, ranges[f].first.begin());
    ranges[f].second = ByXi(shape, hulls, f, r3, r23);
  }
  return ranges;
}
} // namespace pixelexact
