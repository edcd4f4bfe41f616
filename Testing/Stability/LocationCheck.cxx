// SPDX-License-Identifier: BSD-3-Clause
#include "Stability/LocationCheck.h"

#include "Stability/Report.h"
#include "Stability/RoundingTape.h"

#include "Core/Basis/ModeBound.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>

namespace pixelexact::testing
{
namespace
{
/// Entries' sizes, row-major, in double.
using Matrix = std::array<std::array<double, 3>, 3>;

Matrix AbsoluteOf(const QuadMat3& m)
{
  Matrix result;
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      result[i][j] = static_cast<double>(Abs(m[i][j]));
    }
  }
  return result;
}

std::array<double, 3> Times(const Matrix& m, const std::array<double, 3>& v)
{
  std::array<double, 3> result{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      result[i] += m[i][j] * v[j];
    }
  }
  return result;
}

double Largest(const std::array<double, 3>& v)
{
  return std::max({ v[0], v[1], v[2] });
}

/// Skeel's condition number, max norm of |J^-1| |J|.
double Condition(const Matrix& inverse, const Matrix& jacobian)
{
  return Largest(Times(inverse, Times(jacobian, { 1.0, 1.0, 1.0 })));
}
} // namespace

LocationCheck::LocationCheck(const Mesh& mesh, int element, const Box3& box, const Field& field)
  : Elements(mesh)
  , field_(field)
  , MapSpace(mesh.map.SpaceOf(element))
  , Element(element)
  , Box(box)
{
}

const double* LocationCheck::Component(std::size_t c) const
{
  return Elements.map.Coefficients(Element) + c * static_cast<std::size_t>(MapSpace.Modes());
}

/// The rounding of y and of Phi's evaluation.
std::array<double, 3> LocationCheck::Rounding(const Vec3& xi, const QuadVec3& y) const
{
  std::array<double, 3> rounding;
  for (std::size_t c = 0; c < 3; ++c)
  {
    rounding[c] = ValueRounding(MapSpace, Component(c), xi) +
      kUnitRoundoff * std::fabs(static_cast<double>(y[c]));
  }
  return rounding;
}

/// |J^-1| |D^2 Phi|, max norm, by differences.
double LocationCheck::Curvature(const QuadPreimage& at) const
{
  Quad step = 1e-12;
  double apex = 0.0;
  if (MapSpace.shape == Shape::Pyramid)
  {
    // A pyramid's map bends the more the nearer its apex is.
    const Quad distance = Max(Abs(1 - at.xi[2]), Quad(1e-20));
    step = Quad(1e-6) * distance;
    apex = 1.0 / static_cast<double>(distance);
  }
  std::array<double, 3> bend{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    QuadVec3 moved = at.xi;
    moved[k] = moved[k] - step;
    const QuadMat3 jacobian = MapInUnits(Elements, Element, moved).jacobian;
    for (std::size_t c = 0; c < 3; ++c)
    {
      for (std::size_t d = 0; d < 3; ++d)
      {
        bend[c] += static_cast<double>(Abs(jacobian[c][d] - at.jacobian[c][d]) / step);
      }
    }
  }
  return Largest(Times(AbsoluteOf(at.inverse), bend)) + apex;
}

PointErrors LocationCheck::Measure(const Vec3& near, const Vec3& x, const FoundPoint& found) const
{
  const auto reference = FindPreimage(Elements, Element, x, ToQuad(near));
  const Matrix inverse = AbsoluteOf(reference.inverse);
  const Matrix jacobian = AbsoluteOf(reference.jacobian);
  PointErrors errors;
  errors.condition = Condition(inverse, jacobian);
  if (found.verdict != Verdict::Inside)
  {
    return errors;
  }
  const QuadVec3 y = ToUnits(Elements, Element, x);
  const auto rounding = Rounding(found.xi, y);
  const double curvature = Curvature(reference);
  // The remaining share of the last correction, for a Jacobian that is at most one step of 1e-7
  // old.
  const double share = std::min(1.0, 1e-7 * curvature + 16.0 * kUnitRoundoff * errors.condition);
  const auto spread = Times(inverse, rounding);
  const QuadVec3 located = ToQuad(found.xi);
  std::array<double, 3> stored;
  for (std::size_t d = 0; d < 3; ++d)
  {
    stored[d] = kUnitRoundoff * static_cast<double>(Abs(located[d])) + share * found.residual;
    Raise(errors.xiBound, spread[d] + stored[d]);
    Raise(errors.xiError, static_cast<double>(Abs(located[d] - reference.xi[d])));
  }
  errors.firstOrder = reference.lastStep < 1e-20 && curvature * errors.xiBound < 0.25;
  const QuadVec3 continued = Continued(MapSpace.shape, located);
  errors.backwardOverBound = Backward(continued, y, rounding, Times(jacobian, stored));
  MeasureValue(found, errors.firstOrder ? reference.xi : continued, errors);
  return errors;
}

/// |Phi(xi) - y| over what it may be.
double LocationCheck::Backward(
  const QuadVec3& xi, const QuadVec3& y, const Triple& rounding, const Triple& stored) const
{
  const QuadImage image = MapInUnits(Elements, Element, xi);
  double worst = 0.0;
  for (std::size_t c = 0; c < 3; ++c)
  {
    Raise(worst, static_cast<double>(Abs(image.y[c] - y[c])) / (rounding[c] + stored[c]));
  }
  return worst;
}

void LocationCheck::MeasureValue(
  const FoundPoint& found, const QuadVec3& xi, PointErrors& errors) const
{
  const Space& space = field_.values.SpaceOf(Element);
  const double* modes = field_.values.Coefficients(Element);
  const QuadSample sample = Evaluate(space, modes, xi);
  errors.value = static_cast<double>(sample.value);
  errors.valueError = static_cast<double>(Quad(found.value) - sample.value);
  errors.magnitude = static_cast<double>(Magnitude(space, modes, xi));
  errors.valueBound = ValueRounding(space, modes, found.xi);
  if (errors.firstOrder)
  {
    for (const Quad& derivative : sample.gradient)
    {
      // The slope may change by a quarter on the way, as the map's may.
      errors.valueBound += 1.25 * std::fabs(static_cast<double>(derivative)) * errors.xiBound;
    }
  }
}

/// The uncertainty of Phi and y, as in element-tree.md.
std::array<double, 3> LocationCheck::Uncertainty() const
{
  const auto [p, q, r] = MapSpace.order;
  std::array<double, 3> uncertainty;
  for (std::size_t c = 0; c < 3; ++c)
  {
    const auto d = static_cast<int>(c);
    double sum = 0.0;
    ForEachMode(MapSpace,
      [&](int i, int j, int k, int mode)
      { sum += std::fabs(Component(c)[mode]) * ModeBound(MapSpace, i, j, k); });
    const double known =
      4.0 * kUnitRoundoff * std::max(std::fabs(Box.lower[d]), std::fabs(Box.upper[d]));
    uncertainty[c] = (Elements.uncertainty[Element] + known) / Elements.size[Element] +
      Gamma(4 * (p + q + r) + 16) * sum;
  }
  return uncertainty;
}

bool LocationCheck::IsKnownOutside(const Vec3& near, const Vec3& x) const
{
  const auto preimage = FindPreimage(Elements, Element, x, ToQuad(near));
  const auto tolerance = Times(AbsoluteOf(preimage.inverse), Uncertainty());
  const auto margin = static_cast<double>(Margin(MapSpace.shape, preimage.xi));
  return preimage.lastStep < 1e-20 && margin < -2.0 * (tolerance[0] + tolerance[1] + tolerance[2]);
}
} // namespace pixelexact::testing
