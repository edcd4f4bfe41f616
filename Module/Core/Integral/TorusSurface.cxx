// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/Error.h"
#include "Core/Bernstein/BoxAlgebra.h"
#include "Core/Integral/BoxRanges.h"
#include "Core/Integral/IntegralCut.h"
#include "Core/Integral/Integrand.h"
#include "Core/Integral/QuadricArithmetic.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
bool IsFinite(const Vec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

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

TorusSurface::TorusSurface(const Vec3& centre, const Vec3& axis, double R, double r)
{
  if (!(IsFinite(centre) && IsFinite(axis) && glm::length(axis) > 0.0))
  {
    throw InvalidData("the centre and the axis of a torus must be finite, and the axis not zero.");
  }
  if (!(R > 0.0 && r > 0.0 && std::isfinite(R) && std::isfinite(r)))
  {
    throw InvalidData("the radii of a torus must be greater than 0 and finite.");
  }
  const Vec3 n = glm::normalize(axis);
  A.origin = centre;
  A.q = { 1.0, 1.0, 1.0, 0.0, 0.0, 0.0 };
  A.c = (R - r) * (R + r);
  B.origin = centre;
  B.q = { 1.0 - n.x * n.x, 1.0 - n.y * n.y, 1.0 - n.z * n.z, -2.0 * n.x * n.y, -2.0 * n.y * n.z,
    -2.0 * n.x * n.z };
  for (double& q : B.q)
  {
    q *= 4.0 * R * R;
  }
}

ScaledCut TorusSurface::Over(ElementFunctions& functions, const PieceForm::Piece& piece) const
{
  const ScaledCut a = functions.Quadric(A, piece);
  const ScaledCut b = functions.Quadric(B, piece);
  const double unit = a.unit * a.unit;
  const BoxPolynomial one{ b.s.degree, std::vector<double>(b.s.b.size(), 1.0), 0.0 };
  return { Combine(1.0, Multiply(a.s, a.s), -unit / b.unit, Multiply(b.s, one)), unit };
}

double TorusSurface::Uncertainty(ElementFunctions& functions, const PieceBox& box) const
{
  Interval steepest = 0.0;
  for (const Interval& one : TorusGradient(A, B, PlaceRange(functions, box, A.origin)))
  {
    steepest += Abs(one);
  }
  const auto e = static_cast<std::size_t>(functions.Element());
  return steepest.upper * functions.Question().mesh.uncertainty[e];
}

CutGradient TorusSurface::Gradient(ElementFunctions& functions, const PieceBox& box,
  const std::array<int, 3>& axes, const PointedModels& place, const SurfaceModels& /*models*/) const
{
  return { TorusGradient(A, B, PlaceModels(functions, box, axes, place, A.origin)) };
}

Interval TorusSurface::Stretch(ElementFunctions& functions, const PieceBox& box) const
{
  return Length(TorusGradient(A, B, PlaceRange(functions, box, A.origin))) *
    Abs(BoxRanges(functions, box).determinant);
}

double TorusSurface::AreaIn(ElementFunctions& functions, const PieceBox& box) const
{
  return (Interval(4.0) * Interval(SidesOf(functions, box))).upper;
}
} // namespace pixelexact
