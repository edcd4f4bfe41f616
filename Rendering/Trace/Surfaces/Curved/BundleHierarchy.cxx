// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/BundleHierarchy.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>

namespace pixelexact
{
namespace
{
/// Largest size of the stack; billions of boxes need an eighth of it.
constexpr std::size_t kMaxStack = 128;

Vec3 MiddleOf(const Box3& box)
{
  return 0.5 * box.lower + 0.5 * box.upper;
}

/// A range of indices in the order, which a node splits.
struct Group
{
  int first;
  int count;
};

/// Splits a group along its longest side: `group` keeps the lower half, and the upper half is
/// returned.
Group Subdivide(std::span<std::int32_t> order, std::span<const Box3> boxes, Group& group)
{
  const auto places =
    order.subspan(static_cast<std::size_t>(group.first), static_cast<std::size_t>(group.count));
  Box3 middles{ Vec3(INFINITY), Vec3(-INFINITY) };
  for (const int k : places)
  {
    const Vec3 middle = MiddleOf(boxes[static_cast<std::size_t>(k)]);
    middles = { glm::min(middles.lower, middle), glm::max(middles.upper, middle) };
  }
  const Vec3 size = middles.upper - middles.lower;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const int half = (group.count + 1) / 2;
  std::ranges::nth_element(places, places.begin() + half, {},
    [&](int k) { return MiddleOf(boxes[static_cast<std::size_t>(k)])[axis]; });
  const Group upper{ group.first + half, group.count - half };
  group.count = half;
  return upper;
}
} // namespace

BundleHierarchy::BundleHierarchy(std::span<const Box3> boxes)
  : Order(boxes.size())
  , bounds_(boxes.front())
{
  for (const Box3& box : boxes)
  {
    bounds_ = { glm::min(bounds_.lower, box.lower), glm::max(bounds_.upper, box.upper) };
  }
  std::iota(Order.begin(), Order.end(), 0);
  Build(boxes, 0, static_cast<int>(boxes.size()));
  Boxes.reserve(boxes.size());
  for (const int k : Order)
  {
    Boxes.push_back(boxes[static_cast<std::size_t>(k)]);
  }
}

std::int32_t BundleHierarchy::Build(std::span<const Box3> boxes, int first, int count)
{
  std::array<Group, EightBoxes::kMax> groups{ Group{ first, count } };
  std::size_t size = 1;
  while (size < groups.size())
  {
    const auto largest = std::max_element(groups.begin(), groups.begin() + size,
      [](const Group& a, const Group& b) { return a.count < b.count; });
    if (largest->count == 1)
    {
      break;
    }
    groups[size++] = Subdivide(Order, boxes, *largest);
  }
  const std::size_t at = Nodes.size();
  Nodes.emplace_back().boxes.count = static_cast<int>(size);
  for (std::size_t k = 0; k < size; ++k)
  {
    const Group& group = groups[k];
    Box3 bounds{ Vec3(INFINITY), Vec3(-INFINITY) };
    for (int i = group.first; i < group.first + group.count; ++i)
    {
      const Box3& box = boxes[static_cast<std::size_t>(Order[static_cast<std::size_t>(i)])];
      bounds = { glm::min(bounds.lower, box.lower), glm::max(bounds.upper, box.upper) };
    }
    Nodes[at].boxes.Set(k, bounds);
    const std::int32_t below =
      group.count == 1 ? -1 - group.first : Build(boxes, group.first, group.count);
    Nodes[at].below[k] = below;
  }
  return static_cast<std::int32_t>(at);
}

void BundleHierarchy::ForEach(
  const RayBundle& bundle, const std::function<void(int, const Box3&)>& visit) const
{
  struct Ahead
  {
    double depth;
    std::int32_t below;
  };
  std::array<Ahead, kMaxStack> stack;
  std::size_t size = 0;
  const auto open = [&](const Node& node)
  {
    std::array<double, EightBoxes::kMax> depth;
    const std::size_t begin = size;
    for (unsigned met = bundle.MayMeet(node.boxes, depth); met != 0; met &= met - 1)
    {
      const auto k = static_cast<std::size_t>(std::countr_zero(met));
      // The nearest box is stored last, so it is visited first.
      std::size_t place = size++;
      for (; place > begin && stack[place - 1].depth < depth[k]; --place)
      {
        stack[place] = stack[place - 1];
      }
      stack[place] = { depth[k], node.below[k] };
    }
  };
  open(Nodes.front());
  while (size > 0)
  {
    const Ahead next = stack[--size];
    if (next.depth > bundle.Farthest())
    {
      continue;
    }
    if (next.below >= 0)
    {
      open(Nodes[static_cast<std::size_t>(next.below)]);
      continue;
    }
    const auto at = static_cast<std::size_t>(-1 - next.below);
    visit(Order[at], Boxes[at]);
  }
}
} // namespace pixelexact
