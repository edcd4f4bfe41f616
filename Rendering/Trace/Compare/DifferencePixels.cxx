// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Compare/DifferencePixels.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace pixelexact
{
namespace
{
/// Points that are evaluated together, limited by the memory of many-component fields and bounds.
constexpr std::size_t kBlock = std::size_t{ 1 } << 16U;
/// Points of a task.
constexpr std::size_t kChunk = 1024;

/// The norm of `components` numbers, or one of them.
template <class Of>
double Reduced(std::size_t components, int component, const Of& of)
{
  if (component != kMagnitude || components == 1)
  {
    return of(static_cast<std::size_t>(std::max(component, 0)));
  }
  double sum = std::fabs(of(0));
  for (std::size_t c = 1; c < components; ++c)
  {
    sum = std::hypot(sum, of(c));
  }
  return sum;
}

template <class Of>
Interval ReducedBounds(std::size_t components, int component, const Of& of)
{
  if (component != kMagnitude || components == 1)
  {
    return of(static_cast<std::size_t>(std::max(component, 0)));
  }
  Interval sum(0.0);
  for (std::size_t c = 0; c < components; ++c)
  {
    sum += Square(of(c));
  }
  return Sqrt(sum);
}
} // namespace

/// Values of one solution at points; components are stored point by point.
struct DifferencePixels::PointValues
{
  std::vector<Verdict> verdict;
  std::vector<double> value;
  std::vector<double> lower;
  std::vector<double> upper;

  PointValues(std::size_t count, std::size_t components, bool bounds)
    : verdict(count)
    , value(count * components)
    , lower(bounds ? count * components : 0)
    , upper(lower.size())
  {
  }

  /// Locates the points in the solution's mesh and evaluates them.
  void Locate(const Solution& solution, std::span<const Vec3> points)
  {
    SampleTarget target;
    target.verdict = verdict;
    target.value = value;
    target.valueLower = lower;
    target.valueUpper = upper;
    Sample(*solution.locator, solution.field, points, target);
  }
};

DifferencePixels::DifferencePixels(const DifferenceScene& scene, FieldDifference& result)
  : Of(scene)
  , Result(result)
  , Components(static_cast<std::size_t>(scene.first.field->values.components))
{
}

void DifferencePixels::Add(std::size_t pixel)
{
  const SampleBuffers& centres = Result.frame.centres;
  Places.push_back(pixel);
  Points.push_back(centres.position[pixel]);
  Elements.push_back(centres.element[pixel]);
  Xis.push_back(centres.xi[pixel]);
}

bool DifferencePixels::IsFull() const
{
  return Places.size() >= kBlock;
}

/// Evaluates the first solution, whose elements and xi are given by the hits.
void DifferencePixels::EvaluateKnown(PointValues& found) const
{
  const Solution& solution = Of.first;
  const std::span<const Vec3> points = Points;
  const std::span<const Vec3> xi = Xis;
  const std::vector<std::int64_t>& elements = Elements;
  std::ranges::fill(found.verdict, Verdict::Inside);
  const Mesh& mesh = solution.locator->GetMesh();
  const std::size_t components = Components;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), kChunk),
    [&](const tbb::blocked_range<std::size_t>& chunk)
    {
      for (std::size_t begin = chunk.begin(), end = begin; begin < chunk.end(); begin = end)
      {
        while (end < chunk.end() && elements[end] == elements[begin])
        {
          ++end;
        }
        const auto part = [&](std::vector<double>& all)
        { return std::span(all).subspan(begin * components, (end - begin) * components); };
        const auto element = static_cast<int>(elements[begin]);
        EvaluateAt(mesh, *solution.field, element, xi.subspan(begin, end - begin),
          part(found.value), {}, { .x = points.subspan(begin, end - begin) });
        if (!found.lower.empty())
        {
          EncloseAt(mesh, *solution.field, element, xi.subspan(begin, end - begin),
            points.subspan(begin, end - begin), part(found.lower), part(found.upper));
        }
      }
    });
}

void DifferencePixels::Evaluate()
{
  const bool bounds = !Result.frame.centres.valueLower.empty();
  PointValues first(Places.size(), Components, bounds);
  PointValues second(Places.size(), Components, bounds);
  if (Of.surface->IsOfMesh())
  {
    EvaluateKnown(first);
  }
  else
  {
    first.Locate(Of.first, Points);
  }
  second.Locate(Of.second, Points);
  for (std::size_t k = 0; k < Places.size(); ++k)
  {
    Write(k, first, second);
  }
  Places.clear();
  Points.clear();
  Elements.clear();
  Xis.clear();
}

void DifferencePixels::Write(std::size_t k, const PointValues& first, const PointValues& second)
{
  const std::size_t pixel = Places[k];
  SampleBuffers& centres = Result.frame.centres;
  const bool inFirst = first.verdict[k] == Verdict::Inside;
  const bool inSecond = second.verdict[k] == Verdict::Inside;
  const auto at = [&](std::size_t c) { return k * Components + c; };
  const auto value = [&](const auto& of) { return Reduced(Components, Of.component, of); };
  if (inFirst)
  {
    Result.first[pixel] = value([&](std::size_t c) { return first.value[at(c)]; });
  }
  if (inSecond)
  {
    Result.second[pixel] = value([&](std::size_t c) { return second.value[at(c)]; });
  }
  const bool unknown =
    first.verdict[k] == Verdict::Unknown || second.verdict[k] == Verdict::Unknown;
  const DifferenceSide side = unknown ? DifferenceSide::Unknown
    : inFirst && inSecond             ? DifferenceSide::Both
    : inFirst                         ? DifferenceSide::First
    : inSecond                        ? DifferenceSide::Second
                                      : DifferenceSide::Nothing;
  Result.side[pixel] = static_cast<std::uint8_t>(side);
  centres.verdict[pixel] = side == DifferenceSide::Both ? kExactPixel
    : unknown                                           ? kUnknownPixel
                                                        : kNothingPixel;
  if (side != DifferenceSide::Both)
  {
    return;
  }
  centres.value[pixel] =
    value([&](std::size_t c) { return first.value[at(c)] - second.value[at(c)]; });
  if (!centres.valueLower.empty())
  {
    const Interval held = ReducedBounds(Components, Of.component,
      [&](std::size_t c)
      {
        return Interval(first.lower[at(c)], first.upper[at(c)]) -
          Interval(second.lower[at(c)], second.upper[at(c)]);
      });
    centres.valueLower[pixel] = held.lower;
    centres.valueUpper[pixel] = held.upper;
  }
}
} // namespace pixelexact
