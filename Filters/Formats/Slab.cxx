// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Slab.h"

#include "Core/Base/Error.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// The thickness is 2^-kThinner of the power of two below the shorter side.
constexpr int kThinner = 5;

/// The direction of xi that leads across a slab.
std::size_t Across(Shape shape)
{
  return shape == Shape::Prism ? 1 : 2;
}

std::string Text(double number)
{
  std::string text = std::to_string(number);
  text.erase(std::max(text.find_last_not_of('0'), text.find('.') + 1) + 1);
  return text;
}
} // namespace

const char* PlaneName(Shape solid)
{
  return solid == Shape::Prism ? "triangle" : "quadrilateral";
}

Slab MakeSlab(const Vec3& low, const Vec3& high, double roundings)
{
  const double largest = std::max({ std::fabs(low.x), std::fabs(low.y), std::fabs(low.z),
    std::fabs(high.x), std::fabs(high.y), std::fabs(high.z) });
  if (high.z - low.z > roundings * largest)
  {
    throw Unsupported(
      "its elements are triangles and quadrilaterals on a surface in space (z from " + Text(low.z) +
      " to " + Text(high.z) + "); of surfaces only those in a plane z = const are read.");
  }
  const auto [shorter, longer] = std::minmax({ high.x - low.x, high.y - low.y });
  const double side = shorter > 0.0 ? shorter : longer;
  Slab slab;
  slab.middle = low.z + (high.z - low.z) / 2;
  if (std::isnormal(side))
  {
    slab.thickness = std::ldexp(1.0, std::ilogb(side) - kThinner);
  }
  if (std::fabs(slab.middle) <= roundings * slab.thickness)
  {
    slab.middle = 0.0; // files hold 1e-310 where they mean 0
  }
  return slab;
}

Space Lifted(const Space& plane)
{
  Space space = plane;
  space.order[Across(plane.shape)] = 1;
  return space;
}

void LiftMap(const Space& plane, std::span<const double> modes, double middle, double half,
  std::span<double> lifted)
{
  const Space space = Lifted(plane);
  const auto count = static_cast<std::size_t>(space.Modes());
  const std::size_t across = Across(plane.shape);
  std::ranges::fill(lifted, 0.0);
  std::size_t planar = 0;
  ForEachMode(space,
    [&](int p, int q, int r, int mode)
    {
      const std::array<int, 3> order{ p, q, r };
      const auto at = static_cast<std::size_t>(mode);
      if (order[across] == 0)
      {
        lifted[at] = modes[planar];
        lifted[count + at] = modes[modes.size() / 2 + planar];
        lifted[2 * count + at] = p + r + q == 0 ? middle : 0.0;
        ++planar;
      }
      else if (p + q + r == 1)
      {
        // A prism's (xi1, xi3) is x and y: xi2 runs downwards, for the sign of the determinant.
        lifted[2 * count + at] = plane.shape == Shape::Prism ? -half : half;
      }
    });
}
} // namespace pixelexact
