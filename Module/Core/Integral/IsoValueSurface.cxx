// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/Error.h"
#include "Core/Bernstein/BoxAlgebra.h"
#include "Core/Integral/BoxRanges.h"
#include "Core/Integral/IntegralCut.h"
#include "Core/Integral/Integrand.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace pixelexact
{
namespace
{
/// The error of the field's coefficients, in roundings of the field's size.
constexpr double kRoundings = 128.0;
/// Values from here on, in units of an element's modes, are far above all of the field's.
constexpr double kBeyondValues = 1e100;

/// A value in units of 2^exponent.
double Scaled(double value, int exponent)
{
  return std::clamp(std::ldexp(value, -exponent), -kBeyondValues, kBeyondValues);
}

/// Bounds how often a line along a direction meets the surface in a box.
int MostRoots(BoxPolynomial cut, int direction)
{
  const int degree = cut.degree[static_cast<std::size_t>(direction)];
  for (int k = 0; k < degree; ++k)
  {
    if (!cut.Hull().Contains(0.0))
    {
      return k;
    }
    cut = Derivative(cut, direction);
  }
  return degree;
}
} // namespace

IsoValueSurface::IsoValueSurface(const Field& field, int component, double value)
  : field_(&field)
  , First(component == kOfMagnitude ? 0 : component)
  , Last(component == kOfMagnitude ? field.values.components - 1 : component)
  , Value(value)
{
  RequirePolynomials(field, "integrals over iso-surfaces");
  if (field.mapping != Mapping::Identity)
  {
    throw Unsupported("the field '" + field.name +
      "' is mapped (H(curl), H(div) or density): there are no integrals over its iso-surfaces.");
  }
  if (First < 0 || Last >= field.values.components)
  {
    throw InvalidData("the field '" + field.name + "' has no component " +
      std::to_string(component) + "; it has " + std::to_string(field.values.components) + ".");
  }
  if (!std::isfinite(value))
  {
    throw InvalidData("the value of an iso-surface must be finite.");
  }
  if (First != Last && !(value > 0.0))
  {
    throw InvalidData("the value of an iso-surface of a magnitude must be greater than 0.");
  }
}

ScaledPolynomial IsoValueSurface::Over(ElementFunctions& functions, const PieceBox& box) const
{
  const int exponent = functions.CutExponent();
  const Interval value(Scaled(Value, exponent));
  if (First == Last)
  {
    BoxPolynomial s = functions.CutValues(box, First);
    Add(-value, s);
    return { std::move(s), std::ldexp(1.0, -exponent) };
  }
  BoxPolynomial sum;
  for (int c = First; c <= Last; ++c)
  {
    const BoxPolynomial one = functions.CutValues(box, c);
    BoxPolynomial square = Multiply(one, one);
    sum = c == First ? std::move(square) : Combine(1.0, sum, 1.0, square);
  }
  Add(-Square(value), sum);
  return { std::move(sum), std::ldexp(1.0, -2 * exponent) };
}

double IsoValueSurface::Uncertainty(ElementFunctions& functions, const PieceBox& box) const
{
  double largest = 0.0;
  for (int c = First; c <= Last; ++c)
  {
    largest = std::max(largest, functions.CutValues(box, c).Hull().Magnitude());
  }
  largest = std::max(std::ldexp(largest, functions.CutExponent()), std::fabs(Value));
  const double off = kRoundings * kUnitRoundoff * largest;
  return First == Last ? off : 2.0 * (Last - First + 1) * largest * off;
}

CutGradient IsoValueSurface::Gradient(ElementFunctions& functions, const PieceBox& box,
  const std::array<int, 3>& axes, const PointedModels& place, const SurfaceModels& models) const
{
  std::array<ChebyshevModel, 3> byXi;
  const double unit = std::ldexp(1.0, functions.CutExponent());
  for (int c = First; c <= Last; ++c)
  {
    ChebyshevModel factor(unit);
    if (First != Last)
    {
      factor =
        2.0 * unit * unit * place.Of(BoxModel(functions.CutValues(box, c), axes, place.IsWideB()));
    }
    for (std::size_t d = 0; d < 3; ++d)
    {
      byXi[d] = byXi[d] +
        factor *
          place.Of(
            BoxModel(functions.CutSlope(box, c, static_cast<int>(d)), axes, place.IsWideB()));
    }
  }
  CutGradient result{ {}, true, false };
  for (std::size_t i = 0; i < 3; ++i)
  {
    result.gradient[i] = Dot(Cofactors(models.jacobian, i), byXi);
  }
  return result;
}

Interval IsoValueSurface::Stretch(ElementFunctions& functions, const PieceBox& box) const
{
  const BoxRanges ranges(functions, box);
  const Interval unit(std::ldexp(1.0, functions.CutExponent()));
  std::array<Interval, 3> byXi;
  for (int c = First; c <= Last; ++c)
  {
    const Interval factor =
      First == Last ? unit : Interval(2.0) * unit * unit * functions.CutValues(box, c).Hull();
    for (std::size_t d = 0; d < 3; ++d)
    {
      byXi[d] += factor * functions.CutSlope(box, c, static_cast<int>(d)).Hull();
    }
  }
  std::array<Interval, 3> gradient;
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t d = 0; d < 3; ++d)
    {
      gradient[i] += ranges.cofactor[i][d] * byXi[d];
    }
  }
  return Length(gradient);
}

double IsoValueSurface::AreaIn(ElementFunctions& functions, const PieceBox& box) const
{
  // In the box's own coordinates from 0 to 1, its faces have the area 1.
  const BoxPolynomial cut = functions.Cut(box);
  std::array<std::array<Interval, 3>, 3> tangent; // [direction][component]
  for (std::size_t i = 0; i < 3; ++i)
  {
    const BoxPolynomial map = functions.Map3(box, static_cast<int>(i));
    for (std::size_t d = 0; d < 3; ++d)
    {
      tangent[d][i] = Derivative(map, static_cast<int>(d)).Hull() * Interval(functions.Radius());
    }
  }
  Interval area = 0.0;
  for (std::size_t d = 0; d < 3; ++d)
  {
    const auto& a = tangent[(d + 1) % 3];
    const auto& b = tangent[(d + 2) % 3];
    const Interval product =
      Length({ a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] });
    area += Interval(MostRoots(cut, static_cast<int>(d))) * product;
  }
  return area.upper;
}
} // namespace pixelexact
