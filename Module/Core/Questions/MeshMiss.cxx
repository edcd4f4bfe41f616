// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Questions/MeshMiss.h"

#include "Core/Math/Interval.h"
#include "Core/Math/Rounding.h"

#include <glm/common.hpp>

#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace pixelexact
{
namespace
{
/// The part of `t` where start + t along meets a range.
Interval Meet(
  const Interval& t, const Interval& start, const Interval& along, const Interval& range)
{
  if (Intersect(start + t * along, range).IsEmpty())
  {
    return { 1.0, 0.0 };
  }
  // The quotient is -inf to inf where `along` may be zero.
  return Intersect(t, (range - start) / along);
}

/// The enclosure of a coordinate of an end that may be off by `slack`.
Interval EndOf(double at, double slack)
{
  return slack == 0.0 ? Interval(at) : Interval(at) + Interval(-slack, slack);
}

/// TensorToReference of a box. Each eta appears once in a product of factors that are not negative,
/// so the enclosure is exact up to rounding.
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

/// A segment in an element's units: start + t along, t in [0,1], rounding included.
class SegmentFrame
{
public:
  SegmentFrame(const InverseProblem& problem, const Segment& segment);

  /// Encloses all t of [0,1] where the segment may lie in the node, by its hull, its frame and the
  /// planes at its ends. Empty where it misses the node.
  [[nodiscard]] Interval Clip(Shape shape, const NodeFrame& node) const;

private:
  std::array<Interval, 3> Start;
  std::array<Interval, 3> Along;
};

SegmentFrame::SegmentFrame(const InverseProblem& problem, const Segment& segment)
{
  for (std::size_t c = 0; c < 3; ++c)
  {
    const auto at = static_cast<int>(c);
    // The inverse size is a power of two.
    const Interval scale(problem.inverseSize);
    const Interval from = EndOf(segment.from[at], segment.slack);
    const Interval to = EndOf(segment.to[at], segment.slack);
    // A NaN in `from` makes the ends NaN, and nothing is excluded.
    const bool sound = from.IsFinite() && to.IsFinite();
    Start[c] = sound ? (from - Interval(problem.centre[c])) * scale : Interval::Everything();
    Along[c] = sound ? (to - from) * scale : Interval::Everything();
  }
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
  // Restricts t to where base + weights . (y - origin) lies in a range.
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

/// Subdivides the element until its nodes miss the segment. `left` is the remaining number of
/// visits.
bool MissesElement(const ElementIndex& index, int element, const Segment& segment, int& left)
{
  const auto tree = index.TreeOf(element);
  const SegmentFrame line(tree->Problem(), segment);
  const Shape shape = tree->Problem().space.shape;
  std::vector<ElementTree::Node*> open;
  for (const auto& piece : tree->Pieces())
  {
    open.push_back(piece.get());
  }
  while (!open.empty())
  {
    ElementTree::Node* const node = open.back();
    open.pop_back();
    if (--left < 0)
    {
      return false;
    }
    if (line.Clip(shape, node->Frame()).IsEmpty())
    {
      continue;
    }
    if (!tree->Split(*node))
    {
      return false;
    }
    open.push_back(&node->Child(0));
    open.push_back(&node->Child(1));
  }
  return true;
}
} // namespace

bool MissesMesh(const ElementIndex& index, const Segment& segment, int effort)
{
  const Vec3 sum = segment.from + segment.to;
  if (!std::isfinite(sum.x + sum.y + sum.z + segment.slack))
  {
    return false;
  }
  const Vec3 rounding = Vec3(segment.slack) +
    8.0 * kUnitRoundoff * glm::max(glm::abs(segment.from), glm::abs(segment.to));
  std::vector<int> elements;
  index.FindNear({ glm::min(segment.from, segment.to) - rounding,
                   glm::max(segment.from, segment.to) + rounding },
    elements);
  int left = effort;
  for (const int element : elements)
  {
    if (!MissesElement(index, element, segment, left))
    {
      return false;
    }
  }
  return true;
}
} // namespace pixelexact
