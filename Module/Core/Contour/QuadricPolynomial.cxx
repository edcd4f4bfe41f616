// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Contour/QuadricPolynomial.h"

#include "Core/Bernstein/BoxAlgebra.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pixelexact
{
BoxPolynomial ValuesOver(const ScaledModes& modes, int component, int level, const Box3& box)
{
  const PieceForm::Piece piece = PieceAt(box, level);
  return RangeIngredient{ &modes, component, Part::Value }.Over(
    level, piece, PartInPiece(box, level, piece));
}

ScaledQuadric QuadricOver(const Mesh& mesh, int element, const ScaledModes& map,
  const QuadricForm& form, int level, const Box3& box)
{
  // z = z0 + r y, y the map in its modes' units and r a power of two:
  // S = r^2 y Q y + r (2 Q z0 + g) y + S(z0).
  const auto e = static_cast<std::size_t>(element);
  const double r = std::ldexp(mesh.size[e], map.exponent);
  std::array<Interval, 3> z;
  std::array<BoxPolynomial, 3> y;
  for (std::size_t d = 0; d < 3; ++d)
  {
    z[d] = Interval(mesh.centre[3 * e + d]) - Interval(form.origin[static_cast<int>(d)]);
    y[d] = ValuesOver(map, static_cast<int>(d), level, box);
  }
  constexpr std::array<std::array<std::size_t, 2>, 6> kPairs{ { { 0, 0 }, { 1, 1 }, { 2, 2 },
    { 0, 1 }, { 1, 2 }, { 0, 2 } } };
  std::array<Interval, 3> linear{ form.g.x, form.g.y, form.g.z };
  Interval constant = form.c;
  for (std::size_t d = 0; d < 3; ++d)
  {
    constant += linear[d] * z[d];
  }
  double largest = 0.0;
  for (std::size_t k = 0; k < 6; ++k)
  {
    const auto [a, b] = kPairs[k];
    const Interval q = form.q[k];
    constant += q * (z[a] * z[b]);
    linear[a] += q * z[b];
    linear[b] += q * z[a];
    largest = std::max(largest, std::fabs(r * r * form.q[k]));
  }
  for (const Interval& one : linear)
  {
    largest = std::max(largest, r * one.Magnitude());
  }
  const double unit = largest > 0.0 ? std::ldexp(1.0, -std::ilogb(largest)) : 1.0;

  // Factors that are not exact move the sum by their radius times the polynomial.
  BoxPolynomial s{ y[0].degree, std::vector<double>(y[0].b.size(), 0.0), 0.0 };
  for (std::size_t d = 0; d < 3; ++d)
  {
    const Interval factor = linear[d] * Interval(r * unit);
    const double middle = factor.Middle();
    s = Combine(1.0, s, middle, y[d]);
    s.error = rounding::Above(
      s.error + rounding::Above(factor.RadiusAround(middle) * y[d].Hull().Magnitude()));
  }
  if (!form.IsPlane())
  {
    const BoxPolynomial one{ s.degree, std::vector<double>(s.b.size(), 1.0), 0.0 };
    s = Multiply(s, one);
    for (std::size_t k = 0; k < 6; ++k)
    {
      if (form.q[k] != 0.0)
      {
        const Interval factor = Interval(form.q[k]) * Interval(r * r * unit);
        const double middle = factor.Middle();
        const BoxPolynomial product = Multiply(y[kPairs[k][0]], y[kPairs[k][1]]);
        s = Combine(1.0, s, middle, product);
        s.error = rounding::Above(
          s.error + rounding::Above(factor.RadiusAround(middle) * product.Hull().Magnitude()));
      }
    }
  }
  Add(constant * Interval(unit), s);
  return { std::move(s), unit };
}
} // namespace pixelexact
