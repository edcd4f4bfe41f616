// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/BoxRanges.h"
#include "Core/Integral/IntegralCut.h"
#include "Core/Integral/Integrand.h"

namespace pixelexact
{
ScaledPolynomial PolynomialSurface::Over(ElementFunctions& functions, const PieceBox& box) const
{
  return functions.Over(Polynomial, box);
}

double PolynomialSurface::Uncertainty(ElementFunctions& functions, const PieceBox& box) const
{
  Interval steepest = 0.0;
  for (const Interval& one :
    Polynomial.GradientAround(PlaceRange(functions, box, Polynomial.origin)))
  {
    steepest += Abs(one);
  }
  const auto e = static_cast<std::size_t>(functions.Element());
  return steepest.upper * functions.Question().mesh.uncertainty[e];
}

CutGradient PolynomialSurface::Gradient(ElementFunctions& functions, const PieceBox& box,
  const std::array<int, 3>& axes, const PointedModels& place, const SurfaceModels& /*models*/) const
{
  if (Polynomial.IsPlane())
  {
    const Vec3& g = Polynomial.a.g;
    return { { g.x, g.y, g.z }, false, true };
  }
  return { Polynomial.GradientAround(PlaceModels(functions, box, axes, place, Polynomial.origin)) };
}

Interval PolynomialSurface::Stretch(ElementFunctions& functions, const PieceBox& box) const
{
  return Length(Polynomial.GradientAround(PlaceRange(functions, box, Polynomial.origin))) *
    Abs(BoxRanges(functions, box).determinant);
}

double PolynomialSurface::AreaIn(ElementFunctions& functions, const PieceBox& box) const
{
  return (Interval(Polynomial.Degree()) * Interval(SidesOf(functions, box))).upper;
}
} // namespace pixelexact
