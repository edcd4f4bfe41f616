// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/FieldFunction.h"
#include "Core/Expression/PointLeaves.h"
#include "Core/Expression/Program.h"
#include "Core/Location/Locator.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace pixelexact
{
/// Returns the locator of a mesh; empty: there is none.
using LocatorSource = std::function<const Locator&()>;

/// Nodes of a graph as a program, and the leaves that it needs: computes them at points of an
/// element. What jumps need of the elements behind its faces is a program of its own.
class CompiledGraph
{
public:
  /// `outputs`: the nodes. Throws Unsupported for derivatives that fields do not have, and for
  /// jumps without a locator.
  CompiledGraph(const Graph& graph, std::vector<int> outputs, std::span<const Field* const> fields,
    std::span<const std::int64_t> numbers, const LocatorSource& locator);

  /// `out`: an array for each output. Safe to call from several threads.
  void Evaluate(const Mesh& mesh, int element, const FunctionPoints& points,
    std::span<double* const> out) const;

  [[nodiscard]] bool NeedsNormals() const
  {
    return Leaves.NeedsNormals() || (Behind != nullptr && Behind->NeedsNormals());
  }
  [[nodiscard]] bool NeedsNeighbours() const { return Behind != nullptr; }
  [[nodiscard]] const Program& GetProgram() const { return Code; }

private:
  void EvaluateBehind(const Mesh& mesh, int element, const FunctionPoints& points,
    std::span<double* const> out) const;

  Program Code;
  PointLeaves Leaves;
  std::unique_ptr<const CompiledGraph> Behind; ///< its outputs are the leaves of Behind, in order
  const Locator* Places = nullptr;
};
} // namespace pixelexact
