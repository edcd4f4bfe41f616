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
  /// `apply(node, values)` that of a node, from the values of the nodes before it, in their order.
  /// `room` keeps its memory between calls.
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
  std::size_t leaf = 0;
  for (std::size_t k = 0; k < nodes.size(); ++k)
  {
    const Graph::Node& node = nodes[k];
    room[k] =
      node.arguments[0] < 0 ? leafAt(leaf++) : apply(node, std::span<const T>(room).first(k));
  }
}

/// The arguments of a node, from values that its arguments are places of.
template <class T>
class NodeArguments
{
public:
  NodeArguments(const Graph::Node& node, std::span<const T> values)
  {
    while (Count < Arguments.size() && node.arguments[Count] >= 0)
    {
      Arguments[Count] = values[static_cast<std::size_t>(node.arguments[Count])];
      ++Count;
    }
  }
  [[nodiscard]] std::span<const T> Span() const { return std::span(Arguments).first(Count); }

private:
  std::array<T, Graph::kMaxArguments> Arguments;
  std::size_t Count = 0;
};

/// Computes a node from values that its arguments are places of: sums, differences, products and
/// squares by T's operations, other nodes by `function(node, arguments)`.
template <class T, class Function>
T ApplyNode(const Graph::Node& node, std::span<const T> values, const Function& function)
{
  const auto argument = [&](std::size_t k) -> const T&
  { return values[static_cast<std::size_t>(node.arguments[k])]; };
  switch (node.operation)
  {
    case Operation::Add:
      return argument(0) + argument(1);
    case Operation::Subtract:
      return argument(0) - argument(1);
    case Operation::Multiply:
      return node.arguments[0] == node.arguments[1] ? Square(argument(0))
                                                    : argument(0) * argument(1);
    default:
      return function(node, NodeArguments<T>(node, values).Span());
  }
}
} // namespace pixelexact
