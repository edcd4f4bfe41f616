// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Questions/MeshMiss.h"

#include "Core/Math/Rounding.h"
#include "Core/Questions/SegmentFrame.h"

#include <glm/common.hpp>

#include <cmath>
#include <vector>

namespace pixelexact
{
namespace
{
/// Down to where nodes miss the segment; `left` counts those that may still be looked at.
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
