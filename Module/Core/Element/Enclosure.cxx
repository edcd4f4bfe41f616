// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/Enclosure.h"

#include "Core/Element/EnclosureTask.h"

#include <algorithm>

namespace pixelexact
{
void EncloseValues(const Mesh& mesh, const Field& field, int element, const LanePoints& xi,
  const LanePoints& x, double* const* lower, double* const* upper, const EnclosureOptions& options)
{
  const EnclosureProblem problem(
    mesh, field, element, options.meshUncertainty ? mesh.uncertainty[element] : 0.0);
  const int components = field.values.components;
  if (!problem.IsUsable())
  {
    for (int c = 0; c < components; ++c)
    {
      std::fill_n(lower[c], xi.count, Interval::Everything().lower);
      std::fill_n(upper[c], xi.count, Interval::Everything().upper);
    }
    return;
  }
  EncloseInLanes(problem.Task(), xi, x, lower, upper);
  for (int c = 0; c < components; ++c)
  {
    for (int i = 0; i < xi.count; ++i)
    {
      const Interval value = problem.ToWorld(lower[c][i], upper[c][i]);
      lower[c][i] = value.lower;
      upper[c][i] = value.upper;
    }
  }
}
} // namespace pixelexact
