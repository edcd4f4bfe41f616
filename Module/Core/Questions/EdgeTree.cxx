// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Questions/EdgeTree.h"

#include <algorithm>
#include <memory>

namespace pixelexact
{
const EdgeNode& EdgeTree::Whole() const
{
  if (!HasRoot.load(std::memory_order_acquire))
  {
    const std::scoped_lock lock(Growing);
    if (!HasRoot.load(std::memory_order_relaxed))
    {
      Root.Describe(Functions, Functions.Values());
      HasRoot.store(true, std::memory_order_release);
    }
  }
  return Root;
}

const std::array<EdgeNode, 2>& EdgeTree::Split(const EdgeNode& node) const
{
  if (const auto* made = node.children.load(std::memory_order_acquire))
  {
    return *made;
  }
  const std::scoped_lock lock(Growing);
  if (const auto* made = node.children.load(std::memory_order_acquire))
  {
    return *made;
  }
  const int direction = node.direction;
  const double middle = 0.5 * (node.box.lower[direction] + node.box.upper[direction]);
  auto children = std::make_unique<std::array<EdgeNode, 2>>();
  for (std::size_t k = 0; k < 2; ++k)
  {
    EdgeNode& half = (*children)[k];
    half.box = node.box;
    (k == 0 ? half.box.upper : half.box.lower)[direction] = middle;
    half.subdivisions = node.subdivisions + 1;
    half.Describe(Functions, node.values);
  }
  node.children.store(children.get(), std::memory_order_release);
  return *children.release();
}

bool EdgeTree::Affords(const EdgeNode& node, EdgeWork& work) const
{
  if (node.subdivisions < Functions.FreeSubdivisions())
  {
    return work.IsLeft();
  }
  const Vec3 sides = node.bounds.upper - node.bounds.lower;
  const double cost = work.PartOf({ sides.x, sides.y, sides.z }) *
    static_cast<double>(Functions.SubdivisionCost(node.wide));
  return work.Affords(node, static_cast<std::int64_t>(cost));
}

const EdgeNode* EdgeTree::SmallerWith(
  const EdgeNode& node, std::span<const Vec3> etas, EdgeWork* work) const
{
  if (!CanSplit(node, work))
  {
    return nullptr;
  }
  for (const EdgeNode& half : Split(node))
  {
    if (half.regular &&
      std::ranges::all_of(etas, [&half](const Vec3& eta) { return half.wide.Holds(eta); }))
    {
      return &half;
    }
  }
  return nullptr;
}

const EdgeNode& EdgeTree::LeafAt(const Vec3& eta, EdgeWork* work, bool straight) const
{
  const EdgeNode* node = &Whole();
  while (!(straight ? node->straight : node->regular) && CanSplit(*node, work))
  {
    if (work)
    {
      work->Spend(kCostOfLook);
    }
    const auto& children = Split(*node);
    const int d = node->direction;
    node = &children[eta[d] <= children[0].box.upper[d] ? 0 : 1];
  }
  return *node;
}
} // namespace pixelexact
