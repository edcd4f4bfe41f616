// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/InversionNode.h"

#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace pixelexact
{
namespace
{
/// s_d: the extent of the shape that eta_d is relative to.
double Extent(Shape shape, int direction, const Vec3& xi)
{
  if (shape == Shape::Tetrahedron && direction == 0)
  {
    return 0.5 * (-xi.y - xi.z);
  }
  const bool collapses = direction == 0
    ? shape != Shape::Hexahedron
    : direction == 1 && (shape == Shape::Tetrahedron || shape == Shape::Pyramid);
  return collapses ? 0.5 * (1.0 - xi.z) : 1.0;
}

/// 1 + xi_d - (1 + b) s_d: positive beyond the end eta_d = b.
double Beyond(double end, double xi, double extent)
{
  return 1.0 + xi - (1.0 + end) * extent;
}

/// Whether eta_d = 1 is a collapsed edge or vertex.
bool CollapsesAt(Shape shape, int direction)
{
  return shape != Shape::Hexahedron &&
    (direction == 2 || (shape == Shape::Tetrahedron && direction == 1));
}

} // namespace

bool InversionNode::MightHold(Shape shape, const std::array<double, 3>& y) const
{
  for (std::size_t c = 0; c < 3; ++c)
  {
    if (!hull[c].Contains(y[c]))
    {
      return false;
    }
  }
  if (!framed)
  {
    return true;
  }
  const Vec3 root = Root(y); // its rounding is within the deviation
  Vec3 least;
  Vec3 most;
  double size = 0.0;
  for (int d = 0; d < 3; ++d)
  {
    const Interval& around = deviation[static_cast<std::size_t>(d)];
    least[d] = root[d] - around.upper;
    most[d] = root[d] - around.lower;
    size = std::max({ size, std::fabs(least[d]), std::fabs(most[d]) });
  }
  // Of two differences before, an extent of two terms, twice it, and two sums. What is not finite
  // is not beyond.
  const double rounding = kUnitRoundoff * (8.0 + 16.0 * size);
  for (int d = 0; d < 3; ++d)
  {
    // Extents fall as the other coordinates grow.
    if (Beyond(box.upper[d], least[d], Extent(shape, d, least)) > rounding ||
      Beyond(box.lower[d], most[d], Extent(shape, d, most)) < -rounding)
    {
      return false;
    }
  }
  return true;
}

Vec3 InversionNode::Step(const std::array<double, 3>& d) const
{
  Vec3 step(0.0);
  for (std::size_t k = 0; framed && k < 9; ++k)
  {
    step[static_cast<int>(k / 3)] += inverse[k] * d[k % 3];
  }
  return step;
}

Vec3 InversionNode::Root(const std::array<double, 3>& y) const
{
  return centre + Step({ y[0] - origin[0], y[1] - origin[1], y[2] - origin[2] });
}

Vec3 InversionNode::Guess(const std::array<double, 3>& y) const
{
  return glm::clamp(Root(y), Vec3(-1.0), Vec3(1.0));
}

bool InversionNode::IsAffine() const
{
  bool affine = framed;
  for (std::size_t d = 0; d < 3; ++d)
  {
    affine = affine && deviation[d].Width() <= 2.25 * slack[d];
  }
  return affine;
}

bool InversionNode::IsNearlyAffine(double part) const
{
  double largest = 0.0;
  for (std::size_t d = 0; d < 3; ++d)
  {
    largest = std::max(largest, deviation[d].Magnitude());
  }
  return framed &&
    largest <= part *
      std::max({ box.upper.x - box.lower.x, box.upper.y - box.lower.y, box.upper.z - box.lower.z });
}

double ReachOf(const std::array<int, 3>& degree)
{
  return 1.0 / (4.0 * std::max(1, degree[0] + degree[1] + degree[2]));
}

bool IsRegular(const std::array<int, 3>& degree, const BoxCoefficients& slopes)
{
  SmallMatrix middle{};
  std::array<double, 9> magnitude{};
  for (std::size_t f = 0; f < 9; ++f)
  {
    const Interval hull = slopes.HullOf(f);
    if (!hull.IsFinite())
    {
      return false;
    }
    middle[f / 3][f % 3] = hull.Middle();
    magnitude[f] = hull.Magnitude();
  }
  const auto inverse = Inverse(3, middle);
  if (!inverse)
  {
    return false;
  }
  // Bernstein polynomials beyond the box sum in magnitude to less than (1 + 2 reach)^degrees.
  const double growth = std::pow(1.0 + 2.0 * ReachOf(degree), degree[0] + degree[1] + degree[2]);
  // Of the products, not of M times the hulls: whether a box is regular must not depend on how the
  // element is stretched.
  BoxCoefficients row;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const auto& M = (*inverse)[i];
    double diagonal = 0.0;
    double others = 0.0;
    for (std::size_t j = 0; j < 3; ++j)
    {
      row = {};
      row.values.resize(slopes.Of(0).size());
      double slack = 0.0;
      for (std::size_t c = 0; c < 3; ++c)
      {
        const auto slope = slopes.Of(3 * c + j);
        for (std::size_t at = 0; at < slope.size(); ++at)
        {
          row.values[at] += M[c] * slope[at];
        }
        slack += std::fabs(M[c]) * (slopes.error[3 * c + j] + Gamma(4) * magnitude[3 * c + j]);
      }
      row.error = { slack * (1.0 + Gamma(16)) };
      const Interval hull = row.HullOf(0);
      const double around = hull.Middle();
      const double radius = hull.RadiusAround(around) * growth;
      if (i == j)
      {
        diagonal = around - radius;
      }
      else
      {
        others += std::fabs(around) + radius;
      }
    }
    // Far more than the rounding of these sums, and than what the slopes change by over the
    // tolerance of 1e-12 by which a root that counts as in the box may lie beyond it, also on the
    // scale of a pyramid's apex. A NaN is not above.
    if (!(diagonal > others + 1e-4))
    {
      return false;
    }
  }
  return true;
}

bool Reaches(Shape shape, const EtaBox& box, double reach, const Vec3& xi, double tolerance)
{
  for (int d = 0; d < 3; ++d)
  {
    const double margin = reach * (box.upper[d] - box.lower[d]);
    const double lower = box.lower[d] - margin;
    const double upper =
      CollapsesAt(shape, d) ? std::min(1.0, box.upper[d] + margin) : box.upper[d] + margin;
    const double extent = Extent(shape, d, xi);
    if (!(Beyond(upper, xi[d], extent) <= tolerance) ||
      !(Beyond(lower, xi[d], extent) >= -tolerance))
    {
      return false;
    }
  }
  return true;
}
} // namespace pixelexact
