// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/BoxRanges.h"

#include <cmath>

namespace pixelexact
{
BoxRanges::BoxRanges(ElementFunctions& functions, const PieceBox& box)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t d = 0; d < 3; ++d)
    {
      jacobian[i][d] = functions.Slope(box, static_cast<int>(i), static_cast<int>(d)).Hull() *
        Interval(functions.Radius());
    }
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t d = 0; d < 3; ++d)
    {
      const std::size_t k = (i + 1) % 3;
      const std::size_t l = (i + 2) % 3;
      const std::size_t m = (d + 1) % 3;
      const std::size_t n = (d + 2) % 3;
      cofactor[i][d] = jacobian[k][m] * jacobian[l][n] - jacobian[k][n] * jacobian[l][m];
    }
  }
  determinant = jacobian[0][0] * cofactor[0][0] + jacobian[0][1] * cofactor[0][1] +
    jacobian[0][2] * cofactor[0][2];
}

Interval FieldRange(ElementFunctions& functions, const PieceBox& box, int component)
{
  const std::vector<Interval> ranges = functions.ValueRanges(box);
  const auto values = [&](int c)
  {
    return ranges[static_cast<std::size_t>(c)] *
      Interval(std::ldexp(1.0, functions.FieldExponent()));
  };
  const Mapping mapping = functions.Question().field->mapping;
  if (mapping == Mapping::Identity)
  {
    return values(component);
  }
  const BoxRanges map(functions, box);
  if (mapping == Mapping::Density)
  {
    return values(component) / map.determinant;
  }
  const auto& matrix = mapping == Mapping::Contravariant ? map.jacobian : map.cofactor;
  Interval sum = 0.0;
  for (int d = 0; d < 3; ++d)
  {
    sum += matrix[static_cast<std::size_t>(component)][static_cast<std::size_t>(d)] * values(d);
  }
  return sum / map.determinant;
}

std::array<Interval, 3> PlaceRange(
  ElementFunctions& functions, const PieceBox& box, const Vec3& origin)
{
  std::array<Interval, 3> z;
  for (int d = 0; d < 3; ++d)
  {
    z[static_cast<std::size_t>(d)] =
      functions.Shift(origin, d) + functions.Map3(box, d).Hull() * Interval(functions.Radius());
  }
  return z;
}

Interval Length(const std::array<Interval, 3>& v)
{
  return Sqrt(Square(v[0]) + Square(v[1]) + Square(v[2]));
}

double SidesOf(ElementFunctions& functions, const PieceBox& box)
{
  std::array<Interval, 3> side;
  for (int d = 0; d < 3; ++d)
  {
    side[static_cast<std::size_t>(d)] =
      Interval(functions.Map3(box, d).Hull().Width()) * Interval(functions.Radius());
  }
  return (side[0] * side[1] + side[1] * side[2] + side[2] * side[0]).upper;
}
} // namespace pixelexact
