// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Contour/ElementPolynomial.h"

#include "Core/Bernstein/BoxAlgebra.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pixelexact
{
namespace
{
/// A power of two that brings S to about 1 over an element about `centre`.
double UnitOf(const QuadraticPolynomial& form, const std::array<Interval, 3>& centre, double radius)
{
  double largest = 0.0;
  for (const double q : form.q)
  {
    largest = std::max(largest, std::fabs(radius * radius * q));
  }
  for (const Interval& one : form.GradientAt(centre))
  {
    largest = std::max(largest, radius * one.Magnitude());
  }
  return largest > 0.0 ? std::ldexp(1.0, -std::ilogb(largest)) : 1.0;
}

/// A quadratic polynomial in z = x - origin over a box. `centre`: z at the element's centre.
ScaledPolynomial QuadraticOf(const std::array<Interval, 3>& centre, double radius,
  const QuadraticPolynomial& form, std::array<BoxPolynomial, 3> y, bool isLocal)
{
  // z = m + r y, m a point of the box's image and r a power of two:
  // S = r^2 y Q y + r (2 Q m + g) y + S(m).
  const double r = radius;
  constexpr auto kPairs = QuadraticPolynomial::kPairs;
  std::array<Interval, 3> m = centre;
  for (std::size_t d = 0; d < 3; ++d)
  {
    if (isLocal)
    {
      const double middle = 0.5 * (y[d].b.front() + y[d].b.back());
      m[d] += Interval(r) * Interval(middle);
      Add(-middle, y[d]);
    }
  }
  const double unit = UnitOf(form, centre, r);
  const std::array<Interval, 3> linear = form.GradientAt(m);
  Interval constant = form.c;
  for (std::size_t d = 0; d < 3; ++d)
  {
    constant += Interval(form.g[static_cast<int>(d)]) * m[d];
  }
  for (std::size_t k = 0; k < 6; ++k)
  {
    constant += Interval(form.q[k]) * (m[kPairs[k][0]] * m[kPairs[k][1]]);
  }

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
  if (!form.IsLinear())
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
} // namespace

BoxPolynomial ValuesOver(const ScaledModes& modes, int component, int level, const Box3& box)
{
  const PieceForm::Piece piece = PieceAt(box, level);
  return RangeIngredient{ &modes, component, Part::Value }.Over(
    level, piece, PartInPiece(box, level, piece));
}

ScaledPolynomial PolynomialOver(const Mesh& mesh, int element, const ScaledModes& map,
  const ImplicitPolynomial& surface, int level, const Box3& box)
{
  const double radius = std::ldexp(mesh.size[static_cast<std::size_t>(element)], map.exponent);
  return PolynomialOf(mesh, element, radius, surface,
    { ValuesOver(map, 0, level, box), ValuesOver(map, 1, level, box),
      ValuesOver(map, 2, level, box) },
    false);
}

ScaledPolynomial PolynomialOf(const Mesh& mesh, int element, double radius,
  const ImplicitPolynomial& surface, std::array<BoxPolynomial, 3> y, bool isLocal)
{
  std::array<Interval, 3> centre;
  for (std::size_t d = 0; d < 3; ++d)
  {
    centre[d] = Interval(mesh.centre[3 * static_cast<std::size_t>(element) + d]) -
      Interval(surface.origin[static_cast<int>(d)]);
  }
  if (!surface.b)
  {
    return QuadraticOf(centre, radius, surface.a, std::move(y), isLocal);
  }
  const ScaledPolynomial a = QuadraticOf(centre, radius, surface.a, y, isLocal);
  const ScaledPolynomial b = QuadraticOf(centre, radius, *surface.b, std::move(y), isLocal);
  const double unit = a.unit * a.unit;
  const BoxPolynomial one{ b.s.degree, std::vector<double>(b.s.b.size(), 1.0), 0.0 };
  return { Combine(1.0, Multiply(a.s, a.s), -unit / b.unit, Multiply(b.s, one)), unit };
}
} // namespace pixelexact
