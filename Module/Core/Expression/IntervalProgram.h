// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/FieldFunction.h"
#include "Core/Element/Mesh.h"
#include "Core/Expression/NodeList.h"
#include "Core/Math/Interval.h"

#include <cstdint>
#include <span>
#include <vector>

namespace pixelexact
{
/// Evaluates nodes of a graph in interval arithmetic: bounds that hold at a point, from the
/// enclosures of the fields and of their first derivatives there (EncloseGradients). Arithmetic is
/// rounded outwards. Functions of the C library (sin, exp, pow, ...) are assumed to be off by 16
/// units in the last place at most (glibc states 1 to 4). The interval is everything, -inf to inf,
/// for second derivatives and leaves of the map, and where a function is not defined on all of its
/// argument.
class IntervalProgram
{
public:
  IntervalProgram(const Graph& graph, std::span<const int> outputs,
    std::span<const Field* const> fields, std::span<const std::int64_t> numbers);

  /// The same as FieldFunction::Enclose, for the outputs.
  void Enclose(const Mesh& mesh, int element, const LanePoints& xi, const LanePoints& x,
    const BoundArrays& out) const;

private:
  struct FieldBounds;
  [[nodiscard]] Interval LeafAt(const Graph::Node& leaf, int element, const LanePoints& x, int at,
    std::span<const FieldBounds> bounds) const;

  NodeList List;
  std::vector<const Field*> Fields;
  std::vector<int> Derivatives; ///< of each field: the highest that is needed; -1: none
  std::span<const std::int64_t> Numbers;
};
} // namespace pixelexact
