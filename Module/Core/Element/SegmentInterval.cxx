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

/// A preimage within this many tolerances of the faces counts as inside: an end may be off by one
/// tolerance, and the points between by another one.
constexpr double kTolerances = 2.0;

/// The smallest margin of all xi within `stray` of this one. As faces are planes, a corner of the
/// box attains it.
double LeastMargin(Shape shape, const Vec3& xi, const Vec3& stray)
{
  double least = std::numeric_limits<double>::infinity();
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    const Vec3 sign{ corner & 1U ? 1.0 : -1.0, corner & 2U ? 1.0 : -1.0, corner & 4U ? 1.0 : -1.0 };
    const double margin = Margin(shape, xi + sign * stray);
    // The comparison keeps a NaN.
    least = margin >= least ? least : margin;
  }
  return least;
}

/// The task of one component, for a mapping that does not mix components.
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
  std::vector<double> lanes((2 * components + 4) * stride);
  std::vector<double*> middle;
  std::vector<double*> radius;
  for (std::size_t c = 0; c < components; ++c)
  {
    middle.push_back(&lanes[2 * c * stride]);
    radius.push_back(&lanes[(2 * c + 1) * stride]);
  }
  double* const rest = &lanes[2 * components * stride];
  const SegmentsInLanes found{ middle.data(), radius.data(),
    { rest, rest + stride, rest + 2 * stride }, rest + 3 * stride };
  EncloseSegmentsInLanes(task, segments, found);
  const Shape shape = mesh.ShapeOf(element);
  std::vector<Interval> values(components);
  for (int i = 0; i < count; ++i)
  {
    const Vec3 stray{ found.stray[0][i], found.stray[1][i], found.stray[2][i] };
    const double margin = std::min(LeastMargin(shape, At(segments.xiFrom, i), stray),
      LeastMargin(shape, At(segments.xiTo, i), stray));
    // The comparison is written so that a NaN proves nothing.
    if (margin >= -kTolerances * found.tolerance[i])
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
