// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Arguments.h"

#include "Core/Base/Error.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace pixelexact
{
namespace
{
Vec3 TimesPowerOfTwo(const Vec3& x, int exponent)
{
  return { std::ldexp(x.x, exponent), std::ldexp(x.y, exponent), std::ldexp(x.z, exponent) };
}
} // namespace

void Refuse(const char* surface, const char* why)
{
  throw Error(std::string(surface) + ": " + why);
}

bool IsFinite(const Vec3& x)
{
  return std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z);
}

double LargestOf(const Vec3& x)
{
  return std::max({ std::fabs(x.x), std::fabs(x.y), std::fabs(x.z) });
}

void CheckPosition(const Vec3& position, const char* surface)
{
  if (!IsFinite(position))
  {
    Refuse(surface, "a coordinate of its position is not a finite number.");
  }
}

void CheckRadius(double radius, const char* surface)
{
  if (!(radius > 0.0))
  {
    Refuse(surface, "its radius is not positive; give one that is.");
  }
  if (!(radius >= 1e-100 && radius <= 1e100))
  {
    Refuse(surface, "its radius is out of range; give one between 1e-100 and 1e100.");
  }
}

Vec3 ScaledDirection(const Vec3& direction, const char* surface, const char* name)
{
  if (!IsFinite(direction))
  {
    throw Error(
      std::string(surface) + ": a coordinate of its " + name + " is not a finite number.");
  }
  const double largest = LargestOf(direction);
  if (!(largest > 0.0))
  {
    throw Error(std::string(surface) + ": its " + name + " is zero; give a direction.");
  }
  return TimesPowerOfTwo(direction, -(std::ilogb(largest) + 1));
}

Vec3 UnitDirection(const Vec3& direction)
{
  return glm::normalize(TimesPowerOfTwo(direction, -std::ilogb(LargestOf(direction))));
}

Vec3 UnitOrZero(const Vec3& direction)
{
  const double size = LargestOf(direction);
  return size > 0.0 && std::isfinite(size) ? glm::normalize(direction / size) : Vec3(0.0);
}
} // namespace pixelexact
