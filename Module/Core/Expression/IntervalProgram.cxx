// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/IntervalProgram.h"

#include "Core/Element/Enclosure.h"
#include "Core/Expression/IntervalOperations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace pixelexact
{
/// A field's values and slopes over the points of a call.
struct IntervalProgram::FieldBounds
{
  std::vector<double> storage;
  std::vector<double*> lower; ///< components, then three slopes of each
  std::vector<double*> upper;

  void Resize(std::size_t arrays, std::size_t stride)
  {
    storage.resize(2 * arrays * stride);
    for (std::size_t k = 0; k < arrays; ++k)
    {
      lower.push_back(&storage[2 * k * stride]);
      upper.push_back(&storage[(2 * k + 1) * stride]);
    }
  }
};

IntervalProgram::IntervalProgram(const Graph& graph, std::span<const int> outputs,
  std::span<const Field* const> fields, std::span<const std::int64_t> numbers)
  : List(graph, outputs)
  , Fields(fields.begin(), fields.end())
  , Derivatives(fields.size(), -1)
  , Numbers(numbers)
{
  for (const Graph::Node& leaf : List.leaves)
  {
    if (leaf.operation == Operation::Value || leaf.operation == Operation::Slope)
    {
      int& derivative = Derivatives[static_cast<std::size_t>(leaf.field)];
      derivative = std::max(derivative, leaf.operation == Operation::Slope ? 1 : 0);
    }
  }
}

Interval IntervalProgram::LeafAt(const Graph::Node& leaf, int element, const LanePoints& x, int at,
  std::span<const FieldBounds> bounds) const
{
  const auto of = [&](std::size_t array)
  {
    const FieldBounds& field = bounds[static_cast<std::size_t>(leaf.field)];
    return Interval(field.lower[array][at], field.upper[array][at]);
  };
  const auto component = static_cast<std::size_t>(leaf.component);
  switch (leaf.operation)
  {
    case Operation::Constant:
      return std::isnan(leaf.constant) ? Interval::Everything() : Interval(leaf.constant);
    case Operation::Pi:
      return Interval::Around(std::numbers::pi, 2e-16);
    case Operation::Coordinate:
      return x.x[leaf.a][at];
    case Operation::ElementNumber:
      return static_cast<double>(
        Numbers.empty() ? element : Numbers[static_cast<std::size_t>(element)]);
    case Operation::Value:
      return of(component);
    case Operation::Slope:
    {
      const auto components =
        static_cast<std::size_t>(Fields[static_cast<std::size_t>(leaf.field)]->values.components);
      return of(components + 3 * component + static_cast<std::size_t>(leaf.a));
    }
    default:
      return Interval::Everything();
  }
}

void IntervalProgram::Enclose(const Mesh& mesh, int element, const LanePoints& xi,
  const LanePoints& x, const BoundArrays& out) const
{
  const auto stride = static_cast<std::size_t>(PaddedCount(xi.count));
  std::vector<FieldBounds> bounds(Fields.size());
  for (std::size_t f = 0; f < Fields.size(); ++f)
  {
    const auto components = static_cast<std::size_t>(Fields[f]->values.components);
    if (Derivatives[f] < 0)
    {
      continue;
    }
    FieldBounds& of = bounds[f];
    of.Resize(components * (Derivatives[f] > 0 ? 4 : 1), stride);
    const BoundArrays values{ of.lower.data(), of.upper.data() };
    if (Derivatives[f] > 0)
    {
      EncloseGradients(mesh, *Fields[f], element, xi, x, values,
        { of.lower.data() + components, of.upper.data() + components });
    }
    else
    {
      EncloseValues(mesh, *Fields[f], element, xi, x, values);
    }
  }
  std::vector<KnownInterval> known;
  for (int i = 0; i < xi.count; ++i)
  {
    const auto leafAt = [&](std::size_t k) -> KnownInterval
    {
      const Interval leaf = LeafAt(List.leaves[k], element, x, i, bounds);
      return { leaf, !leaf.IsFinite() };
    };
    List.Compute(
      leafAt,
      [](const Graph::Node& node, std::span<const KnownInterval> values)
      { return ApplyToIntervals(node, NodeArguments(node, values).Span()); },
      known);
    for (std::size_t k = 0; k < List.outputs.size(); ++k)
    {
      const KnownInterval& output = known[List.outputs[k]];
      const Interval value = output.mayBeNaN ? Interval::Everything() : output.value;
      out.lower[k][i] = value.lower;
      out.upper[k][i] = value.upper;
    }
  }
}
} // namespace pixelexact
