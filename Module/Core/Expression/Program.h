// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Expression/Graph.h"

#include <functional>
#include <span>
#include <vector>

namespace pixelexact
{
/// Nodes of a graph in an order in which they can be computed, those that some outputs need alone,
/// each once. Works on arrays of points; what a point gets depends on that point alone.
class Program
{
public:
  Program(const Graph& graph, std::vector<int> outputs);

  /// The leaves but constants: whoever runs the program has their values.
  [[nodiscard]] std::span<const Graph::Node> Leaves() const { return LeafNodes; }

  /// `leaves[k]` holds the values of leaf k at `count` points, `out[k]` takes those of output k.
  /// `scratch` is a thread's own and keeps its memory.
  void Run(std::span<const double* const> leaves, int count, double* const* out,
    std::vector<double>& scratch) const;

private:
  /// Where a node's values are: in a register of the scratch, in a leaf's array, or a constant.
  struct Place
  {
    enum class Kind : std::uint8_t
    {
      Register,
      Leaf,
      Constant
    };
    Kind kind = Kind::Register;
    std::size_t index = 0;
  };
  struct Step
  {
    Operation operation = Operation::Constant;
    int a = 0; ///< Node::a and b
    int b = 0;
    std::array<Place, Graph::kMostArguments> arguments{};
    std::size_t result = 0; ///< a register
  };

  std::vector<Graph::Node> LeafNodes;
  std::vector<double> Constants;
  std::vector<Step> Steps;
  std::vector<Place> Outputs;
  std::size_t Registers = 0;
};
} // namespace pixelexact
