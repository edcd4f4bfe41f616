// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Gmsh/Basis.h"

#include "Core/Base/Error.h"
#include "Formats/Slab.h"

#include <algorithm>
#include <cstdlib>

namespace pixelexact::gmsh
{
namespace
{
/// Hexahedra of order 9, the largest that Gmsh has; twice as many take ten times as long.
constexpr int kMostDenseModes = 1000;

/// Gmsh's u, v, w.
LongVec3 FromXi(int dimension, Shape shape, const LongVec3& xi)
{
  const auto half = [&xi](int d) { return (1 + xi[d]) / 2; };
  if (dimension == 2)
  {
    return shape == Shape::Prism ? LongVec3{ half(0), half(2), 0 } : LongVec3{ xi[0], xi[1], 0 };
  }
  switch (shape)
  {
    case Shape::Hexahedron:
      return xi;
    case Shape::Tetrahedron:
      return { half(0), half(1), half(2) };
    case Shape::Prism:
      return { half(0), half(2), -xi[1] };
    default:
      return { xi[0] + half(2), xi[1] + half(2), half(2) };
  }
}

long double Power(long double x, int exponent)
{
  long double power = 1.0L;
  for (int i = 0; i < std::abs(exponent); ++i)
  {
    power *= x;
  }
  return exponent < 0 ? 1 / power : power;
}

long double Monomial(Shape shape, const LongVec3& x, const int* e)
{
  const long double product = Power(x[0], e[0]) * Power(x[1], e[1]) * Power(x[2], e[2]);
  return shape == Shape::Pyramid ? product * Power(1 - x[2], std::max(e[0], e[1]) - e[0] - e[1])
                                 : product;
}

/// The smallest space that holds the monomials.
Space SpaceOf(int dimension, Shape shape, const Interpolation& interpolation)
{
  std::array<int, 3> order{ 0, 0, 0 };
  for (int j = 0; j < interpolation.functions; ++j)
  {
    const int* e = &interpolation.exponents[3 * static_cast<std::size_t>(j)];
    const int sum = e[0] + e[1] + e[2];
    const std::array<int, 3> needed = shape == Shape::Hexahedron
      ? std::array<int, 3>{ e[0], e[1], e[2] }
      : shape == Shape::Tetrahedron ? std::array<int, 3>{ sum, sum, sum }
      : shape == Shape::Prism       ? std::array<int, 3>{ e[0] + e[1], e[2], e[0] + e[1] }
                                    : std::array<int, 3>{ std::max(e[0], e[1]) + e[2],
                                        std::max(e[0], e[1]) + e[2], std::max(e[0], e[1]) + e[2] };
    std::ranges::transform(
      order, needed, order.begin(), [](int a, int b) { return std::max(a, b); });
  }
  if (dimension == 2 && shape == Shape::Prism)
  {
    order[1] = 0; // across
  }
  Space space = UniformSpace(shape, 0);
  for (int d = 0; d < 3; ++d)
  {
    space.order[d] = static_cast<std::uint8_t>(std::min(order[d], kMaxOrder + 1));
  }
  // Incomplete hexahedra of order 9 leave out most; who leaves out more has a time in no proportion
  // to what the file says.
  const int most = std::min(kMostDenseModes, 100 + 10 * interpolation.functions);
  if (!space.IsValid() || space.Modes() > most)
  {
    throw Unsupported(std::to_string(interpolation.functions) + " functions on a " +
      (dimension == 2 ? PlaneName(shape) : Name(shape)) + " are of orders " +
      std::to_string(order[0]) + ", " + std::to_string(order[1]) + ", " + std::to_string(order[2]) +
      "; so many are read where the complete space of these orders has no "
      "more than " +
      std::to_string(most) + ".");
  }
  return space;
}
} // namespace

ElementBasis InterpolationBasis(int dimension, Shape shape, const Interpolation& interpolation)
{
  const Space space = SpaceOf(dimension, shape, interpolation);
  return OnePart(ChangeOfBasis::FromFunctions(space, interpolation.functions,
    [dimension, shape, interpolation](const LongVec3& xi, long double* values)
    {
      const auto n = static_cast<std::size_t>(interpolation.functions);
      const LongVec3 x = FromXi(dimension, shape, xi);
      std::vector<long double> monomial(n);
      for (std::size_t j = 0; j < n; ++j)
      {
        monomial[j] = Monomial(shape, x, &interpolation.exponents[3 * j]);
      }
      for (std::size_t i = 0; i < n; ++i)
      {
        values[i] = 0.0L;
        for (std::size_t j = 0; j < n; ++j)
        {
          values[i] += interpolation.coefficients[i * n + j] * monomial[j];
        }
      }
    }));
}
} // namespace pixelexact::gmsh
