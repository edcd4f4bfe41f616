// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Expression/Graph.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace pixelexact
{
/// Nodes of a graph that are wanted, and all that they are computed from.
struct NodeList
{
  NodeList(const Graph& graph, std::span<const int> wanted);

  /// Computes the wanted nodes in any type: `leafAt(k)` is the value of leaf k, and
  /// `apply(node, arguments)` that of a node. `room` keeps its memory between calls.
  template <class T, class LeafAt, class Apply>
  void Compute(const LeafAt& leafAt, const Apply& apply, std::vector<T>& room) const;

  std::vector<Graph::Node> nodes;   ///< arguments are places in this list, and come first
  std::vector<Graph::Node> leaves;  ///< those without arguments, in their order
  std::vector<std::size_t> outputs; ///< places of the wanted nodes
};

template <class T, class LeafAt, class Apply>
void NodeList::Compute(const LeafAt& leafAt, const Apply& apply, std::vector<T>& room) const
{
  room.resize(nodes.size());
  std::array<T, Graph::kMaxArguments> arguments;
  std::size_t leaf = 0;
  for (std::size_t k = 0; k < nodes.size(); ++k)
  {
    const Graph::Node& node = nodes[k];
    std::size_t count = 0;
    while (count < arguments.size() && node.arguments[count] >= 0)
    {
      arguments[count] = room[static_cast<std::size_t>(node.arguments[count])];
      ++count;
    }
    room[k] = count == 0 ? leafAt(leaf++) : apply(node, std::span(arguments).first(count));
  }
}
} // namespace pixelexact
