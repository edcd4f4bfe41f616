// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/FieldFunction.h"
#include "Core/Element/Mesh.h"
#include "Core/Expression/Graph.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pixelexact
{
/// The value of a leaf Operation::Order in an element. `Needed` has a `field`.
template <class Needed>
[[nodiscard]] int OrderOf(const Graph::Node& leaf, const std::vector<Needed>& fields, int element)
{
  int order = 0;
  for (std::size_t f = 0; f < fields.size(); ++f)
  {
    if (leaf.field < 0 || f == static_cast<std::size_t>(leaf.field))
    {
      const Space& space = fields[f].field->values.SpaceOf(element);
      order = std::max<int>(
        order, leaf.a == 0 ? space.MaxOrder() : space.order[static_cast<std::size_t>(leaf.a - 1)]);
    }
  }
  return order;
}

/// Evaluates a graph's leaves at points of an element: fields and their derivatives by x, with the
/// rounding of the kernels, and coordinates, xi, J^-1 and det J of the map. Second derivatives are
/// computed point by point, not in lanes.
class PointLeaves
{
public:
  /// The largest number of points of one call: their arrays stay in cache.
  static constexpr int kTogether = 128;

  /// `fields` must outlive this. `numbers` are the elements' numbers; where it is empty, elements
  /// count from 0.
  PointLeaves(std::span<const Graph::Node> leaves, std::span<const Field* const> fields,
    std::span<const std::int64_t> numbers);

  /// Scratch memory of Evaluate. Each thread has its own and reuses it.
  struct Scratch
  {
    std::vector<double> storage;
    std::vector<double*> arrays;
    std::vector<const double*> leaves;
  };

  /// Returns an array of points.xi.count <= kTogether values for each leaf, in the order of the
  /// leaves. The arrays lie in `scratch`; those of Behind are `behind`, in the leaves' order.
  [[nodiscard]] std::span<const double* const> Evaluate(const Mesh& mesh, int element,
    const FunctionPoints& points, const double* const* behind, Scratch& scratch) const;

  [[nodiscard]] bool NeedsNormals() const { return OfNormals; }

private:
  /// A field and the highest order of its derivatives that the graph needs; its arrays follow one
  /// another.
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

  std::vector<Graph::Node> Wanted;
  std::vector<NeededField> Fields;
  std::span<const std::int64_t> Numbers;
  bool NeedsMap = false;     ///< Phi and J
  bool NeedsInverse = false; ///< J^-1
  bool OfNormals = false;
  std::size_t Arrays = 0; ///< in the scratch, those of single leaves included
};
} // namespace pixelexact
