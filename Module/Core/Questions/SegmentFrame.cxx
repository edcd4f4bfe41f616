// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Questions/SegmentFrame.h"

#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace pixelexact
{
namespace
{

/// Of [0,1] and `t`, what is left where start + t along meets a range.
Interval Meet(
  const Interval& t, const Interval& start, const Interval& along, const Interval& range)
{
  if (Intersect(start + t * along, range).IsEmpty())
  {
    return { 1.0, 0.0 };
  }
  // Everything, where `along` may be zero.
  return Intersect(t, (range - start) / along);
}

/// A coordinate of an end that may be off by `slack`.
Interval EndOf(double at, double slack)
{
  return slack == 0.0 ? Interval(at) : Interval(at) + Interval(-slack, slack);
}

/// TensorToReference of a box. Each eta appears once in a product of factors that are not negative:
/// nothing is lost.
std::array<Interval, 3> XiOf(Shape shape, const EtaBox& box)
{
  std::array<Interval, 3> eta;
  std::array<Interval, 3> h;
  for (std::size_t d = 0; d < 3; ++d)
  {
    eta[d] = { box.lower[static_cast<int>(d)], box.upper[static_cast<int>(d)] };
    h[d] = (Interval(1.0) - eta[d]) * Interval(0.5);
  }
  const auto collapse = [&](std::size_t d, const Interval& by)
  { return (Interval(1.0) + eta[d]) * by - Interval(1.0); };
  switch (shape)
  {
    case Shape::Prism:
      return { collapse(0, h[2]), eta[1], eta[2] };
    case Shape::Tetrahedron:
      return { collapse(0, h[1] * h[2]), collapse(1, h[2]), eta[2] };
    case Shape::Pyramid:
      return { collapse(0, h[2]), collapse(1, h[2]), eta[2] };
    default:
      return eta;
  }
}
} // namespace

SegmentFrame::SegmentFrame(const InverseProblem& problem, const Segment& segment)
{
  double longest = -1.0;
  bool finite = true;
  for (std::size_t c = 0; c < 3; ++c)
  {
    const auto at = static_cast<int>(c);
    // The inverse size is a power of two.
    const Interval scale(problem.inverseSize);
    const Interval from = EndOf(segment.from[at], segment.slack);
    const Interval to = EndOf(segment.to[at], segment.slack);
    // Where from is a NaN, so are the ends, and nothing is excluded.
    const bool sound = from.IsFinite() && to.IsFinite();
    Start[c] = sound ? (from - Interval(problem.centre[c])) * scale : Interval::Everything();
    Along[c] = sound ? (to - from) * scale : Interval::Everything();
    finite = finite && Start[c].IsFinite() && Along[c].IsFinite();
    const double length = Along[c].Mignitude();
    if (length > longest)
    {
      longest = length;
      Longest = static_cast<int>(c);
    }
  }
  Directed = finite && longest > 0.0;
}

Interval SegmentFrame::Clip(Shape shape, const NodeFrame& node) const
{
  Interval t{ 0.0, 1.0 };
  for (std::size_t c = 0; c < 3; ++c)
  {
    t = Meet(t, Start[c], Along[c], node.hull[c]);
    if (t.IsEmpty())
    {
      return t;
    }
  }
  if (!node.framed)
  {
    return t;
  }
  // What is left of t where base + weights . (y - origin) lies in a range.
  const auto meet = [&](double base, std::span<const double, 3> weights, const Interval& range)
  {
    Interval start(base);
    Interval along;
    for (std::size_t c = 0; c < 3; ++c)
    {
      const Interval factor(weights[c]);
      start += factor * (Start[c] - Interval(node.origin[c]));
      along += factor * Along[c];
    }
    t = Meet(t, start, along, range);
    return !t.IsEmpty();
  };
  // Every xi of the node with Phi(xi) = y is xi_0 - T, xi_0 affine in y, hence in t.
  const auto xi = XiOf(shape, node.box);
  for (std::size_t d = 0; d < 3; ++d)
  {
    const std::span<const double, 3> row(&node.inverse[3 * d], 3);
    if (!meet(node.centre[static_cast<int>(d)], row, xi[d] + node.deviation[d]))
    {
      return t;
    }
  }
  for (const ImagePlane& end : node.plane)
  {
    if (!meet(0.0, end.normal, { -kInfinity, end.outer }))
    {
      return t;
    }
  }
  return t;
}

std::array<TensorPolynomial, 2> SegmentFrame::Eliminate(std::span<const BoxPolynomial, 3> y) const
{
  const auto k = static_cast<std::size_t>(Longest);
  const double startK = Start[k].Middle();
  const double radiusK = Start[k].RadiusAround(startK);
  std::array<TensorPolynomial, 2> result;
  for (std::size_t i = 0; i < 2; ++i)
  {
    const std::size_t a = (k + 1 + i) % 3;
    const double startA = Start[a].Middle();
    const Interval ratio = Along[a] / Along[k];
    const double q = ratio.Middle();
    double left = 0.0;
    double right = 0.0;
    result[i].degree = y[a].degree;
    for (std::size_t at = 0; at < y[a].b.size(); ++at)
    {
      const double fromA = y[a].b[at] - startA;
      const double fromK = y[k].b[at] - startK;
      left = std::max(left, std::fabs(fromA));
      right = std::max(right, std::fabs(fromK));
      result[i].coefficients.push_back(fromA - q * fromK);
    }
    // The coefficients', the start's and the ratio's errors; two roundings of the first term, three
    // of the second.
    const double error = y[a].error + Start[a].RadiusAround(startA) +
      ratio.Magnitude() * (y[k].error + radiusK) + ratio.RadiusAround(q) * right +
      Gamma(4) * (left + ratio.Magnitude() * right);
    // A NaN comes from what overflows.
    result[i].error = error < kInfinity ? error * (1.0 + Gamma(32)) + 0x1p-1000 : kInfinity;
  }
  return result;
}

Interval SegmentFrame::ParameterOf(const Interval& y) const
{
  const auto k = static_cast<std::size_t>(Longest);
  return (y - Start[k]) / Along[k];
}
} // namespace pixelexact
