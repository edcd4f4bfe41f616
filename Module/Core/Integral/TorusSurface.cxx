// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Contour/QuadricPolynomial.h"
#include "Core/Integral/BoxRanges.h"
#include "Core/Integral/IntegralCut.h"
#include "Core/Integral/Integrand.h"
#include "Core/Integral/QuadricArithmetic.h"

#include <utility>

namespace pixelexact
{
namespace
{
/// |z|^2 + c: its value.
template <class Number>
Number DistanceForm(const std::array<Number, 3>& z, double c)
{
  return z[0] * z[0] + z[1] * z[1] + z[2] * z[2] + Number(c);
}

/// grad (A^2 - B) = 2 A grad A - grad B with A = |z|^2 + c.
template <class Number>
std::array<Number, 3> TorusGradient(
  const QuadricForm& a, const QuadricForm& b, const std::array<Number, 3>& z)
{
  const Number twice = Scaled(2.0, DistanceForm(z, a.c));
  std::array<Number, 3> gradient = GradientOf(a, z);
  const std::array<Number, 3> less = GradientOf(b, z);
  for (std::size_t d = 0; d < 3; ++d)
  {
    gradient[d] = twice * gradient[d] - less[d];
  }
  return gradient;
}
} // namespace

ScaledCut TorusSurface::Over(ElementFunctions& functions, const PieceBox& box) const
{
  const ScaledCut a = functions.Quadric(Form.a, box);
  const ScaledCut b = functions.Quadric(Form.b, box);
  ScaledQuadric quartic = QuarticOver({ a.s, a.unit }, { b.s, b.unit });
  return { std::move(quartic.s), quartic.unit };
}

double TorusSurface::Uncertainty(ElementFunctions& functions, const PieceBox& box) const
{
  Interval steepest = 0.0;
  for (const Interval& one :
    TorusGradient(Form.a, Form.b, PlaceRange(functions, box, Form.a.origin)))
  {
    steepest += Abs(one);
  }
  const auto e = static_cast<std::size_t>(functions.Element());
  return steepest.upper * functions.Question().mesh.uncertainty[e];
}

CutGradient TorusSurface::Gradient(ElementFunctions& functions, const PieceBox& box,
  const std::array<int, 3>& axes, const PointedModels& place, const SurfaceModels& /*models*/) const
{
  return { TorusGradient(Form.a, Form.b, PlaceModels(functions, box, axes, place, Form.a.origin)) };
}

Interval TorusSurface::Stretch(ElementFunctions& functions, const PieceBox& box) const
{
  return Length(TorusGradient(Form.a, Form.b, PlaceRange(functions, box, Form.a.origin))) *
    Abs(BoxRanges(functions, box).determinant);
}

double TorusSurface::AreaIn(ElementFunctions& functions, const PieceBox& box) const
{
  return (Interval(4.0) * Interval(SidesOf(functions, box))).upper;
}
} // namespace pixelexact
