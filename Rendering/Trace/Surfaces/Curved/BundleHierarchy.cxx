// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/BundleHierarchy.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <numeric>

namespace pixelexact
{
namespace
{
constexpr int kInLeaf = 2;
/// Halving billions of boxes goes no deeper than half of this.
constexpr std::size_t kDeepest = 128;

Vec3 MiddleOf(const Box3& box)
{
  return 0.5 * box.lower + 0.5 * box.upper;
}
} // namespace

BundleHierarchy::BundleHierarchy(std::span<const Box3> boxes)
  : Order(boxes.size())
{
  std::iota(Order.begin(), Order.end(), 0);
  Nodes.reserve(boxes.size() + 1);
  Nodes.emplace_back();
  Build(0, boxes, 0, static_cast<int>(boxes.size()));
  Boxes.reserve(boxes.size());
  for (const int k : Order)
  {
    Boxes.push_back(boxes[static_cast<std::size_t>(k)]);
  }
}

void BundleHierarchy::Build(std::size_t node, std::span<const Box3> boxes, int first, int count)
{
  const auto order =
    std::span(Order).subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(count));
  Box3 bounds{ Vec3(INFINITY), Vec3(-INFINITY) };
  Box3 middles = bounds;
  for (const int k : order)
  {
    const Box3& box = boxes[static_cast<std::size_t>(k)];
    bounds = { glm::min(bounds.lower, box.lower), glm::max(bounds.upper, box.upper) };
    const Vec3 middle = MiddleOf(box);
    middles = { glm::min(middles.lower, middle), glm::max(middles.upper, middle) };
  }
  Nodes[node].bounds = bounds;
  if (count <= kInLeaf)
  {
    Nodes[node].first = first;
    Nodes[node].count = count;
    return;
  }
  const Vec3 size = middles.upper - middles.lower;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const int half = count / 2;
  std::ranges::nth_element(order, order.begin() + half, {},
    [&](int k) { return MiddleOf(boxes[static_cast<std::size_t>(k)])[axis]; });
  const std::size_t child = Nodes.size();
  Nodes[node].child = static_cast<std::int32_t>(child);
  Nodes.resize(child + 2);
  Build(child, boxes, first, half);
  Build(child + 1, boxes, first + half, count - half);
}

void BundleHierarchy::ForEach(
  const RayBundle& bundle, const std::function<void(int, const Box3&)>& visit) const
{
  std::array<std::int32_t, kDeepest> stack{};
  std::size_t size = 1;
  while (size > 0)
  {
    const Node& node = Nodes[static_cast<std::size_t>(stack[--size])];
    if (!bundle.MayMeet(node.bounds) || bundle.DepthOf(node.bounds) > bundle.Farthest())
    {
      continue;
    }
    if (node.child < 0)
    {
      for (std::int32_t k = node.first; k < node.first + node.count; ++k)
      {
        const auto at = static_cast<std::size_t>(k);
        if (bundle.MayMeet(Boxes[at]))
        {
          visit(Order[at], Boxes[at]);
        }
      }
      continue;
    }
    const auto child = static_cast<std::size_t>(node.child);
    const bool lowerFirst =
      bundle.DepthOf(Nodes[child].bounds) <= bundle.DepthOf(Nodes[child + 1].bounds);
    stack[size++] = node.child + (lowerFirst ? 1 : 0);
    stack[size++] = node.child + (lowerFirst ? 0 : 1);
  }
}
} // namespace pixelexact
