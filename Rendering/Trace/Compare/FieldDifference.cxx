// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Compare/FieldDifference.h"

#include "Core/Base/Error.h"
#include "Trace/BufferTable.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace pixelexact
{
namespace
{
/// Points that are evaluated together: so many fields' components and bounds fit into memory.
constexpr std::size_t kBlock = std::size_t{ 1 } << 16U;
/// Of a task.
constexpr std::size_t kChunk = 1024;
constexpr std::uint8_t kFirst = 1;
constexpr std::uint8_t kSecond = 2;
constexpr auto kNothing = static_cast<std::uint8_t>(PixelVerdict::Nothing);
constexpr auto kExact = static_cast<std::uint8_t>(PixelVerdict::Exact);
constexpr auto kUnknown = static_cast<std::uint8_t>(PixelVerdict::Unknown);

/// Of one solution at some points, components point by point.
struct PointValues
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
};

/// At points that are to be located.
void Evaluate(const Solution& solution, std::span<const Vec3> points, PointValues& found)
{
  SampleTarget target;
  target.verdict = found.verdict;
  target.value = found.value;
  target.valueLower = found.lower;
  target.valueUpper = found.upper;
  Sample(*solution.locator, solution.field, points, target);
}

/// At points whose places in the mesh are known.
void EvaluateKnown(const Solution& solution, std::span<const Vec3> points,
  std::span<const std::int64_t> elements, std::span<const Vec3> xi, PointValues& found)
{
  std::ranges::fill(found.verdict, Verdict::Inside);
  const Mesh& mesh = solution.locator->GetMesh();
  const auto components = static_cast<std::size_t>(solution.field->values.components);
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
        EvaluateAt(
          mesh, *solution.field, element, xi.subspan(begin, end - begin), part(found.value), {});
        if (!found.lower.empty())
        {
          EncloseAt(mesh, *solution.field, element, xi.subspan(begin, end - begin),
            points.subspan(begin, end - begin), part(found.lower), part(found.upper));
        }
      }
    });
}

/// The norm of so many numbers, or one of them.
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

void RequireComparable(const DifferenceScene& scene)
{
  const int components = scene.first.field->values.components;
  if (const int others = scene.second.field->values.components; others != components)
  {
    throw Error("field '" + scene.first.field->name + "' has " + std::to_string(components) +
      " components and '" + scene.second.field->name + "' of the other solution has " +
      std::to_string(others) + "; compare fields of as many components.");
  }
  if (scene.component < kMagnitude || scene.component >= components)
  {
    throw Error("field '" + scene.first.field->name + "' has " + std::to_string(components) +
      " components, counted from 0.");
  }
}

/// Takes a pixel's entry from another frame of the same buffers.
void TakePixel(SampleBuffers& to, const SampleBuffers& from, std::size_t i)
{
  ForEachBuffer(
    [&](const auto& row)
    {
      auto& buffer = to.*row.member;
      if (!buffer.empty())
      {
        buffer[i] = (from.*row.member)[i];
      }
    });
}

/// Pixels whose fields are to be evaluated, all seen by the same solution's rays.
class Pixels
{
public:
  Pixels(const DifferenceScene& scene, FieldDifference& result)
    : Of(scene)
    , Result(result)
    , Components(static_cast<std::size_t>(scene.first.field->values.components))
  {
  }

  void Add(std::size_t pixel)
  {
    const SampleBuffers& centres = Result.frame.centres;
    Places.push_back(pixel);
    Points.push_back(centres.position[pixel]);
    Elements.push_back(centres.element[pixel]);
    Xis.push_back(centres.xi[pixel]);
  }

  [[nodiscard]] bool IsFull() const { return Places.size() >= kBlock; }

  void Evaluate()
  {
    const bool bounds = !Result.frame.centres.valueLower.empty();
    PointValues first(Places.size(), Components, bounds);
    PointValues second(Places.size(), Components, bounds);
    if (Of.surface->IsOfMesh())
    {
      EvaluateKnown(Of.first, Points, Elements, Xis, first);
    }
    else
    {
      pixelexact::Evaluate(Of.first, Points, first);
    }
    pixelexact::Evaluate(Of.second, Points, second);
    for (std::size_t k = 0; k < Places.size(); ++k)
    {
      Write(k, first, second);
    }
    Places.clear();
    Points.clear();
    Elements.clear();
    Xis.clear();
  }

private:
  void Write(std::size_t k, const PointValues& first, const PointValues& second)
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
    centres.verdict[pixel] = side == DifferenceSide::Both ? kExact : unknown ? kUnknown : kNothing;
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

  const DifferenceScene& Of;
  FieldDifference& Result;
  std::size_t Components;
  std::vector<std::size_t> Places;
  std::vector<Vec3> Points;
  std::vector<std::int64_t> Elements;
  std::vector<Vec3> Xis;
};

Frame TraceSide(const DifferenceScene& scene, const Solution& solution, const Camera& camera,
  Buffer wanted, const Progress& progress)
{
  const Scene one{ solution.locator, { { scene.surface, nullptr } }, scene.kept };
  return Trace(one, camera, {}, { .centres = wanted }, progress);
}

/// The nearer hit of each pixel; at equal depth the first one's, which is then the same point.
void TakeNearest(const Frame& second, FieldDifference& result)
{
  SampleBuffers& centres = result.frame.centres;
  for (std::size_t i = 0; i < centres.Size(); ++i)
  {
    const bool there = i < second.centres.verdict.size() && second.centres.verdict[i] != kNothing;
    if (centres.verdict[i] == kNothing ? there
                                       : there && second.centres.depth[i] < centres.depth[i])
    {
      TakePixel(centres, second.centres, i);
      result.seen[i] = kSecond;
    }
    else if (centres.verdict[i] != kNothing)
    {
      result.seen[i] = kFirst;
    }
  }
}

void Count(FieldDifference& difference)
{
  const DifferenceNumbers numbers = NumbersOf(difference);
  FrameCounters& counters = difference.frame.counters;
  counters.exact = numbers.both;
  counters.unknown = numbers.unknown;
  counters.nothing = numbers.nothing + numbers.onlyFirst + numbers.onlySecond;
  counters.nonFinite = numbers.notFinite;
}
} // namespace

FieldDifference TraceDifference(const DifferenceScene& scene, const Camera& camera, Buffer extra,
  bool bounds, const Progress& progress)
{
  RequireComparable(scene);
  const Buffer wanted = Without(extra, Buffer::Value | Buffer::Enclosure) | Buffer::Verdict |
    Buffer::Position | Buffer::Depth | Buffer::Element | Buffer::Xi;
  bool aborted = false;
  double done = 0.0;
  const auto watched = [&](double share)
  {
    return [&aborted, &progress, from = done, share](double part)
    {
      aborted = aborted || (progress && !progress(from + share * part));
      return !aborted;
    };
  };
  constexpr double kTracing = 0.2;
  FieldDifference result;
  result.frame = TraceSide(scene, scene.first, camera, wanted, watched(kTracing));
  done += kTracing;
  Frame second;
  if (!aborted && !scene.surface->IsOfMesh())
  {
    second = TraceSide(scene, scene.second, camera, wanted, watched(kTracing));
  }
  done += kTracing;
  if (aborted)
  {
    return {};
  }
  SampleBuffers& centres = result.frame.centres;
  const std::size_t count = centres.Size();
  result.seen.assign(count, 0);
  TakeNearest(second, result);
  second = {};
  centres.value.assign(count, kNotANumber);
  centres.valueLower.assign(bounds ? count : 0, kNotANumber);
  centres.valueUpper.assign(bounds ? count : 0, kNotANumber);
  result.first.assign(count, kNotANumber);
  result.second.assign(count, kNotANumber);
  result.side.assign(count, static_cast<std::uint8_t>(DifferenceSide::Nothing));
  Pixels pixels(scene, result);
  const auto report = watched(1.0 - done);
  for (std::size_t i = 0; i < count && !aborted; ++i)
  {
    if (centres.verdict[i] == kUnknown)
    {
      result.side[i] = static_cast<std::uint8_t>(DifferenceSide::Unknown);
    }
    else if (centres.verdict[i] == kExact)
    {
      pixels.Add(i);
    }
    if (pixels.IsFull())
    {
      pixels.Evaluate();
      (void)report(static_cast<double>(i + 1) / static_cast<double>(count));
    }
  }
  if (aborted)
  {
    return {};
  }
  pixels.Evaluate();
  Count(result);
  return result;
}
} // namespace pixelexact
