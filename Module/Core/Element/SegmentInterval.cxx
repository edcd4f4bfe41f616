// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/SegmentInterval.h"

#include "Core/Shape/Shape.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace pixelexact
{
namespace
{
Vec3 At(const LanePoints& points, int i)
{
  return { points.x[0][i], points.x[1][i], points.x[2][i] };
}

/// The task of one component, where the mapping does not mix them.
EnclosureTask TaskOf(const EnclosureProblem& problem, int component)
{
  EnclosureTask task = problem.Task();
  if (component != kNormOfAll &&
    (task.mapping == Mapping::Identity || task.mapping == Mapping::Density))
  {
    task.coefficients += static_cast<std::ptrdiff_t>(component) * task.space.Modes();
    task.components = 1;
  }
  return task;
}

Interval Norm(std::span<const Interval> components)
{
  if (components.size() == 1)
  {
    return components.front();
  }
  Interval sum;
  for (const Interval& c : components)
  {
    sum += Square(c);
  }
  return Sqrt(sum);
}
} // namespace

void SegmentIntervals(const Mesh& mesh, const Field& field, int component, int element,
  const ElementSegments& segments, std::span<Interval> intervals)
{
  const EnclosureProblem problem(mesh, field, element, mesh.uncertainty[element]);
  std::ranges::fill(intervals, Interval::Everything());
  if (!problem.IsUsable())
  {
    return;
  }
  const EnclosureTask task = TaskOf(problem, component);
  const auto components = static_cast<std::size_t>(task.components);
  const int count = segments.from.count;
  const auto stride = static_cast<std::size_t>(PaddedCount(count));
  std::vector<double> lanes((2 * components + 1) * stride);
  std::vector<double*> middle;
  std::vector<double*> radius;
  for (std::size_t c = 0; c < components; ++c)
  {
    middle.push_back(&lanes[2 * c * stride]);
    radius.push_back(&lanes[(2 * c + 1) * stride]);
  }
  double* const margin = &lanes[2 * components * stride];
  EncloseSegmentsInLanes(task, segments, { middle.data(), radius.data(), margin });
  const Shape shape = mesh.ShapeOf(element);
  std::vector<Interval> values(components);
  for (int i = 0; i < count; ++i)
  {
    // Written so that a NaN proves nothing.
    if (std::min(Margin(shape, At(segments.xiFrom, i)), Margin(shape, At(segments.xiTo, i))) >=
      margin[i])
    {
      for (std::size_t c = 0; c < components; ++c)
      {
        values[c] = problem.ToWorld(middle[c][i], radius[c][i]);
      }
      const bool chosen = component != kNormOfAll && components > 1;
      intervals[static_cast<std::size_t>(i)] =
        chosen ? values[static_cast<std::size_t>(component)] : Norm(values);
    }
  }
}
} // namespace pixelexact
