// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Expression/Graph.h"

#include <functional>
#include <span>
#include <vector>

namespace pixelexact
{
/// Evaluates some nodes of a graph on arrays of points. Each node that the outputs need is computed
/// once. The result at a point depends on that point alone.
class Program
{
public:
  Program(const Graph& graph, std::vector<int> outputs);

  /// The leaves without the constants. The caller of Run provides their values.
  [[nodiscard]] std::span<const Graph::Node> Leaves() const { return LeafNodes; }
  [[nodiscard]] std::size_t OutputCount() const { return Outputs.size(); }

  /// `leaves[k]` holds the values of leaf k at `count` points, `out[k]` takes those of output k.
  /// `scratch` is a thread's own and keeps its memory.
  void Run(std::span<const double* const> leaves, int count, double* const* out,
    std::vector<double>& scratch) const;

private:
  /// The place of a node's values: a register of the scratch, a leaf's array, or a constant.
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
    std::array<Place, Graph::kMaxArguments> arguments{};
    std::size_t result = 0; ///< a register
  };

  std::vector<Graph::Node> LeafNodes;
  std::vector<double> Constants;
  std::vector<Step> Steps;
  std::vector<Place> Outputs;
  std::size_t Registers = 0;
};
} // namespace pixelexact
