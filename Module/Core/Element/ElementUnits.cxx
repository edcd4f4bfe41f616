// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/ElementUnits.h"

#include "Core/Base/Error.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
constexpr int kLargestExponent = 1000;
constexpr int kSmallestExponent = -900;
} // namespace

ElementUnits MakeElementUnits(const Vec3& low, const Vec3& high)
{
  ElementUnits units;
  double half = 0.0;
  for (int d = 0; d < 3; ++d)
  {
    // Subdivided before they are added: the sum may overflow.
    units.centre[d] = low[d] / 2 + high[d] / 2;
    units.largest = std::max({ units.largest, std::fabs(low[d]), std::fabs(high[d]) });
    half = std::max({ half, high[d] - units.centre[d], units.centre[d] - low[d] });
  }
  if (half > 0.0)
  {
    std::frexp(half, &units.exponent);
  }
  else
  {
    // A cell shrunk to a point: the resolution of its coordinates stands for its size.
    units.exponent = units.largest > 0.0 ? std::ilogb(units.largest) - 52 : kSmallestExponent;
  }
  if (units.exponent > kLargestExponent)
  {
    throw InvalidData("is too large for double arithmetic; give the coordinates in larger units.");
  }
  units.exponent = std::max(units.exponent, kSmallestExponent);
  return units;
}
} // namespace pixelexact
