// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Questions/NodePart.h"

#include <algorithm>

namespace pixelexact
{
NodePart::NodePart(const ElementTree::Node& node, const ShapeFace* face)
  : Part(node.Frame().box)
  , Face(face)
  , Empty(false)
{
  if (Face)
  {
    double& lower = Part.lower[Face->direction];
    double& upper = Part.upper[Face->direction];
    Empty = Face->upper ? upper < 1.0 : lower > -1.0;
    (Face->upper ? lower : upper) = Face->upper ? 1.0 : -1.0;
  }
}

BoxPolynomial NodePart::Over(const BoxPolynomial& polynomial) const
{
  if (!Face)
  {
    return polynomial;
  }
  BoxPolynomial slice = polynomial.AtEnd(Face->direction, Face->upper);
  std::rotate(slice.degree.begin() + Face->direction, slice.degree.begin() + Face->direction + 1,
    slice.degree.end());
  return slice;
}

std::size_t NodePart::DirectionOf(std::size_t parameter) const
{
  return Face && parameter >= static_cast<std::size_t>(Face->direction) ? parameter + 1 : parameter;
}

Interval NodePart::At(std::size_t direction, double parameter) const
{
  const auto d = static_cast<int>(direction);
  // The ends are multiples of 2^-50: their difference is exact.
  return Interval(Part.lower[d]) + Interval(Part.upper[d] - Part.lower[d]) * Interval(parameter);
}

std::array<Interval, 3> NodePart::Ends() const
{
  return { Interval(Part.lower.x, Part.upper.x), Interval(Part.lower.y, Part.upper.y),
    Interval(Part.lower.z, Part.upper.z) };
}

std::array<Interval, 3> NodePart::Outer(const ParameterIntervals& box) const
{
  std::array<Interval, 3> eta = Ends();
  for (std::size_t v = 0; v < static_cast<std::size_t>(Variables()); ++v)
  {
    const std::size_t d = DirectionOf(v);
    eta[d] = { At(d, box[v].lower).lower, At(d, box[v].upper).upper };
  }
  return eta;
}

EtaBox NodePart::Outer(const ParameterBox& box) const
{
  ParameterIntervals intervals;
  for (std::size_t v = 0; v < 3; ++v)
  {
    intervals[v] = { box.lower[v], box.upper[v] };
  }
  const auto eta = Outer(intervals);
  return { { eta[0].lower, eta[1].lower, eta[2].lower },
    { eta[0].upper, eta[1].upper, eta[2].upper } };
}

std::array<Interval, 3> NodePart::Inner(const ParameterIntervals& box) const
{
  std::array<Interval, 3> eta = Ends();
  for (std::size_t v = 0; v < static_cast<std::size_t>(Variables()); ++v)
  {
    const std::size_t d = DirectionOf(v);
    eta[d] = { At(d, box[v].lower).upper, At(d, box[v].upper).lower };
  }
  return eta;
}

bool NodePart::IsInside(const std::array<Interval, 3>& eta) const
{
  bool inside = true;
  for (std::size_t v = 0; v < static_cast<std::size_t>(Variables()); ++v)
  {
    inside = inside && Interval(-1.0, 1.0).ContainsInside(eta[DirectionOf(v)]);
  }
  return inside;
}

Interval ValueOver(const BoxPolynomial& polynomial, const ParameterIntervals& box)
{
  Parameters m{};
  double reach = 0.0;
  for (std::size_t d = 0; d < 3; ++d)
  {
    m[d] = std::clamp(box[d].Middle(), 0.0, 1.0);
    reach = std::max({ reach, -box[d].lower, rounding::Above(box[d].upper - 1.0) });
  }
  Interval value = EncloseValue(polynomial.degree, polynomial.b, polynomial.error, m);
  for (std::size_t d = 0; d < 3; ++d)
  {
    value += EncloseDerivative(
               polynomial.degree, static_cast<int>(d), polynomial.b, polynomial.error, reach) *
      (box[d] - Interval(m[d]));
  }
  return value;
}

Interval HullOver(BoxPolynomial polynomial, const ParameterBox& box)
{
  for (std::size_t d = 0; d < 3; ++d)
  {
    if (polynomial.degree[d] > 0)
    {
      polynomial.Restrict(static_cast<int>(d), 2.0 * box.lower[d] - 1.0, 2.0 * box.upper[d] - 1.0);
    }
  }
  return polynomial.Hull();
}
} // namespace pixelexact
