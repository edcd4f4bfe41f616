// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/Enclosure.h"

#include "Core/Element/EnclosureTask.h"
#include "Core/Element/FieldFunction.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
void ProveNothing(int arrays, int count, const BoundArrays& bounds)
{
  for (int k = 0; k < arrays; ++k)
  {
    std::fill_n(bounds.lower[k], count, Interval::Everything().lower);
    std::fill_n(bounds.upper[k], count, Interval::Everything().upper);
  }
}

/// Converts in place: the middles become lower bounds, the radii upper ones.
void ToBounds(const EnclosureProblem& problem, int arrays, int count, bool areDerivatives,
  const BoundArrays& bounds)
{
  for (int k = 0; k < arrays; ++k)
  {
    for (int i = 0; i < count; ++i)
    {
      const Interval value =
        problem.ToWorld(bounds.lower[k][i], bounds.upper[k][i], areDerivatives);
      bounds.lower[k][i] = value.lower;
      bounds.upper[k][i] = value.upper;
    }
  }
}

void Enclose(const Mesh& mesh, const Field& field, int element, const LanePoints& xi,
  const LanePoints& x, const BoundArrays& values, const BoundArrays* gradients,
  const EnclosureOptions& options)
{
  const int components = field.values.components;
  const EnclosureProblem problem(
    mesh, field, element, options.meshUncertainty ? mesh.uncertainty[element] : 0.0);
  const bool differentiate = gradients != nullptr && field.mapping == Mapping::Identity;
  if (gradients != nullptr && (!differentiate || !problem.IsUsable()))
  {
    ProveNothing(3 * components, xi.count, *gradients);
  }
  if (!problem.IsUsable())
  {
    ProveNothing(components, xi.count, values);
    return;
  }
  EncloseInLanes(problem.Task(), xi, x, { values.lower, values.upper },
    differentiate ? BallArrays{ gradients->lower, gradients->upper } : BallArrays{});
  ToBounds(problem, components, xi.count, false, values);
  if (differentiate)
  {
    ToBounds(problem, 3 * components, xi.count, true, *gradients);
  }
}
} // namespace

void EncloseValues(const Mesh& mesh, const Field& field, int element, const LanePoints& xi,
  const LanePoints& x, const BoundArrays& values, const EnclosureOptions& options)
{
  if (field.function != nullptr)
  {
    field.function->Enclose(mesh, element, xi, x, values);
    return;
  }
  Enclose(mesh, field, element, xi, x, values, nullptr, options);
}

void EncloseGradients(const Mesh& mesh, const Field& field, int element, const LanePoints& xi,
  const LanePoints& x, const BoundArrays& values, const BoundArrays& gradients)
{
  Enclose(mesh, field, element, xi, x, values, &gradients, {});
}
} // namespace pixelexact
