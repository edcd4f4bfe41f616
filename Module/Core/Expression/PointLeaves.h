// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/FieldFunction.h"
#include "Core/Element/Mesh.h"
#include "Core/Expression/Graph.h"

#include <cstdint>
#include <span>
#include <vector>

namespace pixelexact
{
/// Values of a graph's leaves at points of an element: fields and their derivatives by x, as exact
/// as the kernels are, and what is known of the map. Second derivatives are made point by point.
class PointLeaves
{
public:
  /// At most so many points at a time: what is known of them stays in cache.
  static constexpr int kTogether = 128;

  /// `fields` must outlive it; `numbers`: of elements, else they count from 0.
  PointLeaves(std::span<const Graph::Node> leaves, std::span<const Field* const> fields,
    std::span<const std::int64_t> numbers);

  /// What Evaluate works in: a thread's own, which keeps its memory.
  struct Scratch
  {
    std::vector<double> storage;
    std::vector<double*> arrays;
    std::vector<const double*> leaves;
  };

  /// An array for each leaf, in their order, of xi.count <= kTogether points; they lie in
  /// `scratch`.
  [[nodiscard]] std::span<const double* const> Evaluate(const Mesh& mesh, int element,
    const LanePoints& xi, const double* const* normal, Scratch& scratch) const;

  [[nodiscard]] bool NeedsNormals() const { return OfNormals; }

private:
  /// What is needed of a field, by the order of the derivative; its arrays follow one another.
  struct NeededField
  {
    const Field* field;
    int derivatives = -1; ///< the highest that is needed; -1: the field is not evaluated
    std::size_t first = 0;
  };

  void EvaluateMap(const Mesh& mesh, int element, const LanePoints& xi, double* const* out) const;
  void EvaluateField(const Mesh& mesh, int element, const LanePoints& xi, const NeededField& needed,
    double* const* map, double* const* out) const;
  void Curve(const Mesh& mesh, int element, const LanePoints& xi, const Field& field,
    double* const* map, double* const* out) const;
  void Fill(const Mesh& mesh, int element, const LanePoints& xi, const Graph::Node& leaf,
    double* const* map, double* out) const;
  [[nodiscard]] std::size_t ArrayOf(const Graph::Node& leaf) const;
  [[nodiscard]] double OrderIn(int element, int field) const;

  std::vector<Graph::Node> Wanted;
  std::vector<NeededField> Fields;
  std::span<const std::int64_t> Numbers;
  bool NeedsMap = false;     ///< Phi and J
  bool NeedsInverse = false; ///< J^-1
  bool OfNormals = false;
  std::size_t Arrays = 0; ///< in the scratch, those of single leaves included
};
} // namespace pixelexact
