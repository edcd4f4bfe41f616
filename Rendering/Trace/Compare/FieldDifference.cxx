// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Compare/FieldDifference.h"

#include "Core/Base/Error.h"
#include "Trace/BufferTable.h"
#include "Trace/Compare/DifferencePixels.h"

#include <string>

namespace pixelexact
{
namespace
{
constexpr std::uint8_t kFirst = 1;
constexpr std::uint8_t kSecond = 2;

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

/// Copies a pixel's entries from another frame with the same buffers.
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

Frame TraceSide(const DifferenceScene& scene, const Solution& solution, const Camera& camera,
  Buffer wanted, const Progress& progress)
{
  const Scene one{ solution.locator, { { scene.surface, nullptr } }, scene.kept };
  return Trace(one, camera, {}, { .centres = wanted }, progress);
}

/// Takes the nearer hit of each pixel; at equal depth the first solution's, which is the same
/// point.
void TakeNearest(const Frame& second, FieldDifference& result)
{
  SampleBuffers& centres = result.frame.centres;
  for (std::size_t i = 0; i < centres.Size(); ++i)
  {
    const bool there =
      i < second.centres.verdict.size() && second.centres.verdict[i] != kNothingPixel;
    if (centres.verdict[i] == kNothingPixel ? there
                                            : there && second.centres.depth[i] < centres.depth[i])
    {
      TakePixel(centres, second.centres, i);
      result.seen[i] = kSecond;
    }
    else if (centres.verdict[i] != kNothingPixel)
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
  DifferencePixels pixels(scene, result);
  const auto report = watched(1.0 - done);
  for (std::size_t i = 0; i < count && !aborted; ++i)
  {
    if (centres.verdict[i] == kUnknownPixel)
    {
      result.side[i] = static_cast<std::uint8_t>(DifferenceSide::Unknown);
    }
    else if (centres.verdict[i] == kExactPixel)
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
