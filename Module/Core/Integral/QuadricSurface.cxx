// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/BoxRanges.h"
#include "Core/Integral/IntegralCut.h"
#include "Core/Integral/Integrand.h"
#include "Core/Integral/QuadricArithmetic.h"

namespace pixelexact
{
ScaledCut QuadricSurface::Over(ElementFunctions& functions, const PieceBox& box) const
{
  return functions.Quadric(Form, box);
}

double QuadricSurface::Uncertainty(ElementFunctions& functions, const PieceBox& box) const
{
  Interval steepest = 0.0;
  for (const Interval& one : GradientOf(Form, PlaceRange(functions, box, Form.origin)))
  {
    steepest += Abs(one);
  }
  const auto e = static_cast<std::size_t>(functions.Element());
  return steepest.upper * functions.Question().mesh.uncertainty[e];
}

CutGradient QuadricSurface::Gradient(ElementFunctions& functions, const PieceBox& box,
  const std::array<int, 3>& axes, const PointedModels& place, const SurfaceModels& /*models*/) const
{
  if (Form.IsPlane())
  {
    return { { Form.g.x, Form.g.y, Form.g.z }, false, true };
  }
  return { GradientOf(Form, PlaceModels(functions, box, axes, place, Form.origin)) };
}

Interval QuadricSurface::Stretch(ElementFunctions& functions, const PieceBox& box) const
{
  return Length(GradientOf(Form, PlaceRange(functions, box, Form.origin))) *
    Abs(BoxRanges(functions, box).determinant);
}

double QuadricSurface::AreaIn(ElementFunctions& functions, const PieceBox& box) const
{
  return (Interval(Form.IsPlane() ? 1.0 : 2.0) * Interval(SidesOf(functions, box))).upper;
}
} // namespace pixelexact
