// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Contour/ArcProof.h"

#include "Core/Bernstein/BoxAlgebra.h"
#include "Core/Bernstein/TensorPolynomial.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
constexpr int kBudget = 20000; ///< tubes tried in an element
constexpr int kMaxArcDepth = 14;
} // namespace

ArcProof::ArcProof(const CurveEquations& equations, CurveEvaluator& evaluator, Shape shape,
  double value, std::vector<Vec3> crossings)
  : Evaluator(evaluator)
  , shape_(shape)
  , Crossings(std::move(crossings))
  , Left(kBudget)
{
  const Box3 whole{ Vec3(-1.0), Vec3(1.0) };
  F = equations.FieldOver(0, whole, value);
  S = equations.CutOver(0, whole);
}

bool ArcProof::Holds(std::span<const CurvePoint> points)
{
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    if (!HoldsBetween(points[i], points[i + 1], 0))
    {
      return false;
    }
  }
  return true;
}

bool ArcProof::HoldsBetween(const CurvePoint& from, const CurvePoint& to, int depth)
{
  if (IsTube(ReferenceToTensor(shape_, from.xi), ReferenceToTensor(shape_, to.xi)))
  {
    return true;
  }
  if (depth == kMaxArcDepth || --Left < 0)
  {
    return false;
  }
  const Vec3 chord = to.xi - from.xi;
  const Vec3 middle = (from.xi + to.xi) / 2.0;
  const auto between =
    Evaluator.InPlane(middle, { chord, glm::dot(chord, middle) }, glm::length(chord));
  return between && HoldsBetween(from, *between, depth + 1) &&
    HoldsBetween(*between, to, depth + 1);
}

bool ArcProof::IsTube(const Vec3& from, const Vec3& to) const
{
  const Vec3 step = glm::abs(to - from);
  const int along = step.x >= step.y && step.x >= step.z ? 0 : step.y >= step.z ? 1 : 2;
  return IsTube(from, to, along, 0.3) || IsTube(from, to, along, 0.05);
}

bool ArcProof::IsCrossedElsewhere(const Box3& box, const Vec3& from, const Vec3& to) const
{
  return std::ranges::any_of(Crossings,
    [&](const Vec3& crossing)
    {
      // An arc's own ends are the same to the bit.
      return box.Contains(crossing) && crossing != from && crossing != to;
    });
}

bool ArcProof::IsTube(const Vec3& from, const Vec3& to, int along, double room) const
{
  const double length = std::fabs(to[along] - from[along]);
  const int cross[2] = { (along + 1) % 3, (along + 2) % 3 };
  Box3 box{ glm::min(from, to), glm::max(from, to) };
  for (const int d : cross)
  {
    const double pad = 0.25 * std::fabs(to[d] - from[d]) + room * length;
    box.lower[d] = std::max(box.lower[d] - pad, -1.0);
    box.upper[d] = std::min(box.upper[d] + pad, 1.0);
  }
  if (!(length > 0.0))
  {
    return false;
  }
  CurvePolynomials over{ F, S };
  RestrictTo(box, over.f);
  RestrictTo(box, over.s);
  // The Jacobian by the box's own coordinates at its middle.
  const Jet f = EvaluateJet(over.f.degree, over.f.b, { 0.5, 0.5, 0.5 });
  const Jet s = EvaluateJet(over.s.degree, over.s.b, { 0.5, 0.5, 0.5 });
  const auto i = static_cast<std::size_t>(cross[0]);
  const auto j = static_cast<std::size_t>(cross[1]);
  const double determinant = f.gradient[i] * s.gradient[j] - f.gradient[j] * s.gradient[i];
  if (!(std::fabs(determinant) > 0.0))
  {
    return false;
  }
  // Both in the same degrees, in which they can be combined.
  Degrees degree{};
  for (std::size_t d = 0; d < 3; ++d)
  {
    degree[d] = std::max(over.f.degree[d], over.s.degree[d]);
  }
  for (BoxPolynomial* one : { &over.f, &over.s })
  {
    BoxPolynomial raised{ degree, std::vector<double>(CoefficientCount(degree)), 0.0 };
    Elevate(one->degree, degree, one->b, raised.b);
    raised.error = rounding::Above(one->error + ElevationError(degree, LargestMagnitude(one->b)));
    *one = std::move(raised);
  }
  const BoxPolynomial parted[2] = { Combine(s.gradient[j] / determinant, over.f,
                                      -f.gradient[j] / determinant, over.s),
    Combine(-s.gradient[i] / determinant, over.f, f.gradient[i] / determinant, over.s) };
  for (int k = 0; k < 2; ++k)
  {
    const BoxPolynomial& p = parted[k];
    const auto slope = [&](int d) { return EncloseDerivative(p.degree, d, p.b, p.error, 0.0); };
    if (!(slope(cross[k]).lower > slope(cross[1 - k]).Magnitude()))
    {
      return false;
    }
    for (const bool upper : { false, true })
    {
      const Interval side = p.AtEnd(cross[k], upper).Hull();
      if (upper ? side.lower > 0.0 : side.upper < 0.0)
      {
        continue;
      }
      const bool isFace = upper ? box.upper[cross[k]] == 1.0 : box.lower[cross[k]] == -1.0;
      if (!isFace || IsCrossedElsewhere(box, from, to))
      {
        return false;
      }
    }
  }
  return true;
}
} // namespace pixelexact
