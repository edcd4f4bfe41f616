// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/CarefulInverse.h"

namespace pixelexact
{
namespace
{
/// Boxes looked at before a point is called unknown.
constexpr int kBudget = 4000;
/// Boxes looked at in the tensor space before the reference space is tried.
constexpr int kFirstBudget = 100;
} // namespace

SubdivisionResult CarefulInverse::Decide(const Vec3& x, const Vec3& knownRoot)
{
  const Shape shape = Elements.ShapeOf(Element);
  const bool twoSpaces = shape == Shape::Prism || shape == Shape::Tetrahedron;
  const SubdivisionResult first = First.Decide(x, knownRoot, twoSpaces ? kFirstBudget : kBudget);
  if (first.verdict != Verdict::Unknown || !twoSpaces)
  {
    return first;
  }
  if (!Second)
  {
    Second.emplace(Elements, Element, Bounds, BoxSpace::Reference);
  }
  return Second->Decide(x, knownRoot, kBudget);
}
} // namespace pixelexact
