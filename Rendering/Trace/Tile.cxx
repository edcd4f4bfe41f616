// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Tile.h"

#include "Core/Base/CheckedOut.h"
#include "Core/Base/StageClock.h"
#include "Core/Location/Owners.h"
#include "Core/Location/Sample.h"
#include "Core/Math/Interval.h"
#include "Trace/RayKernels.h"
#include "Trace/SampleWriter.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pixelexact
{
namespace
{
/// The arrays of a tile.
struct Scratch
{
  TileSamples samples;
  SampleWriter writer;
  std::vector<std::int32_t> element;
  std::vector<Verdict> verdicts;
  std::vector<Vec3> xi;
  std::vector<double> values;
  std::vector<double> lower;
  std::vector<double> upper;
  std::vector<Vec3> positions;
  std::vector<Owners> owners;
};

/// The first `size` entries; the vector grows to hold them.
template <class T>
std::span<T> Room(std::vector<T>& of, std::size_t size)
{
  if (of.size() < size)
  {
    of.resize(size);
  }
  return std::span(of).first(size);
}

class TileWork
{
public:
  TileWork(const Scene& scene, SampleBuffers& buffers, FrameCounters& counters)
    : TheScene(scene)
    , Buffers(buffers)
    , Counters(counters)
    , Work(*Lease)
    , Samples(Work.samples)
  {
  }

  void Run(const Camera& camera, const TileArea& area, const SampleLattice& lattice)
  {
    std::int64_t rounds = 0;
    for (const auto& surface : TheScene.surfaces)
    {
      rounds += surface->MostHits();
    }
    {
      const StageScope scope(Stage::Rays);
      Samples.Begin(camera, area, lattice, Buffers.width);
      if (rounds == 1)
      {
        Samples.Meet(camera, *TheScene.surfaces[0]);
        std::fill_n(Samples.surface.begin(), Samples.Count(), 0);
      }
      else
      {
        Samples.Cast(camera);
      }
    }
    Counters.rays += Samples.Count();
    // Each round takes every ray to its next hit; rays whose hit is outside of the mesh go on.
    for (bool met = rounds == 1; Samples.Count() > 0 && rounds-- > 0; met = false)
    {
      if (!met)
      {
        FindNearest();
      }
      DropMisses();
      Evaluate();
      if (rounds > 0)
      {
        KeepOutside();
      }
    }
  }

private:
  void FindNearest()
  {
    const StageScope scope(Stage::Rays);
    const int count = Samples.Count();
    const HitLanes nearest = Samples.Hits();
    TheScene.surfaces[0]->NextHit(Samples.Rays(), Samples.TMin(), nearest);
    std::fill_n(Samples.surface.begin(), count, 0);
    for (std::size_t s = 1; s < TheScene.surfaces.size(); ++s)
    {
      const HitLanes next = Samples.OtherHits();
      TheScene.surfaces[s]->NextHit(Samples.Rays(), Samples.TMin(), next);
      for (int i = 0; i < count; ++i)
      {
        if (next.t[i] < nearest.t[i])
        {
          nearest.t[i] = next.t[i];
          for (int d = 0; d < 3; ++d)
          {
            nearest.position[d][i] = next.position[d][i];
          }
          Samples.surface[static_cast<std::size_t>(i)] = static_cast<int>(s);
        }
      }
    }
  }

  void DropMisses()
  {
    const double* t = Samples.T();
    const int hits = GetRayKernels().countHits(t, Samples.Count());
    Counters.surfaceHits += hits;
    if (hits < Samples.Count())
    {
      Samples.Filter([&](int i) { return t[i] < kNoHit; });
    }
  }

  void Evaluate()
  {
    const auto count = static_cast<std::size_t>(Samples.Count());
    const auto components = static_cast<std::size_t>(TheScene.field->values.components);
    const auto sizeIf = [&](bool wanted, std::size_t each) { return wanted ? count * each : 0; };
    Element = Room(Work.element, sizeIf(!Buffers.element.empty(), 1));
    Verdicts = Room(Work.verdicts, count);
    Xi = Room(Work.xi, sizeIf(!Buffers.xi.empty(), 1));
    Values = Room(Work.values, sizeIf(!Buffers.value.empty(), components));
    Lower = Room(Work.lower, sizeIf(!Buffers.valueLower.empty(), components));
    Upper = Room(Work.upper, Lower.size());
    SampleTarget target;
    target.element = Element;
    target.verdict = Verdicts;
    target.xi = Xi;
    target.value = Values;
    target.valueLower = Lower;
    target.valueUpper = Upper;
    target.precision = TheScene.precision;
    target.check = &Counters.floatCheck;
    const bool evaluate = !Values.empty() || !Lower.empty();
    SampleTile(*TheScene.locator, evaluate ? TheScene.field : nullptr, Samples.Positions(), target);
    if (!Buffers.coverage.empty())
    {
      CountOwners();
    }
    WriteAll(components);
  }

  void CountOwners()
  {
    const auto count = static_cast<std::size_t>(Samples.Count());
    const auto positions = Room(Work.positions, count);
    const auto owners = Room(Work.owners, count);
    for (std::size_t i = 0; i < count; ++i)
    {
      positions[i] = Samples.Position(static_cast<int>(i));
    }
    FindOwnersOfTile(*TheScene.locator, positions, owners);
    const Box3& bounds = TheScene.locator->Bounds();
    for (std::size_t i = 0; i < count; ++i)
    {
      if (Verdicts[i] != Verdict::Outside || bounds.Contains(positions[i]))
      {
        Buffers.owners[Samples.place[i]] = owners[i].preimages;
        Buffers.coverage[Samples.place[i]] = static_cast<std::uint8_t>(owners[i].coverage);
      }
    }
  }

  void KeepOutside()
  {
    std::copy_n(Samples.T(), Samples.Count(), Samples.TMin());
    Samples.Filter(
      [&](int i) { return Verdicts[static_cast<std::size_t>(i)] == Verdict::Outside; });
  }

  void WriteAll(std::size_t components)
  {
    SampleWriter& writer = Work.writer;
    writer.Sort(Verdicts, Samples.place);
    Counters.exact += writer.Exact();
    Counters.unknown += writer.Unknown();
    if (writer.Exact() + writer.Unknown() == 0)
    {
      return;
    }
    writer.WriteHeld(Buffers.verdict,
      [&](std::size_t i)
      {
        return static_cast<std::uint8_t>(
          Verdicts[i] == Verdict::Inside ? PixelVerdict::Exact : PixelVerdict::Unknown);
      });
    const auto position = [&](std::size_t i) { return Samples.Position(static_cast<int>(i)); };
    writer.WriteHeld(Buffers.position, position);
    writer.WriteHeld(Buffers.depth, [&](std::size_t i) { return Samples.T()[i]; });
    writer.WriteHeld(Buffers.element, [&](std::size_t i) { return std::int64_t{ Element[i] }; });
    writer.WriteHeld(Buffers.normal,
      [&](std::size_t i) {
        return TheScene.surfaces[static_cast<std::size_t>(Samples.surface[i])]->Normal(position(i));
      });
    writer.WriteInside(Buffers.xi, [&](std::size_t i) { return Xi[i]; });
    WriteValues(components);
    writer.WriteInside(Buffers.valueLower,
      [&](std::size_t i) { return Enclosure(i * components, components).lower; });
    writer.WriteInside(Buffers.valueUpper,
      [&](std::size_t i) { return Enclosure(i * components, components).upper; });
  }

  void WriteValues(std::size_t components)
  {
    if (components > 1 && !Values.empty())
    {
      // Of later samples nothing has been overwritten yet.
      for (std::size_t i = 0; i < Verdicts.size(); ++i)
      {
        Values[i] = Component(Values.subspan(i * components, components));
      }
    }
    Work.writer.WriteInside(Buffers.value, [&](std::size_t i) { return Values[i]; });
    const auto count = static_cast<std::int64_t>(Verdicts.size());
    if (!Values.empty() &&
      (Work.writer.Exact() < count ||
        !GetRayKernels().areFinite(Values.data(), static_cast<int>(count))))
    {
      for (std::size_t i = 0; i < Verdicts.size(); ++i)
      {
        Counters.nonFinite += Verdicts[i] == Verdict::Inside && !std::isfinite(Values[i]) ? 1 : 0;
      }
    }
  }

  /// Of the component that is shown, from those of all components.
  [[nodiscard]] Interval Enclosure(std::size_t first, std::size_t components) const
  {
    if (TheScene.component != Scene::kMagnitude || components == 1)
    {
      const std::size_t at = first + static_cast<std::size_t>(std::max(TheScene.component, 0));
      return { Lower[at], Upper[at] };
    }
    Interval sum(0.0);
    for (std::size_t at = first; at < first + components; ++at)
    {
      sum += Square({ Lower[at], Upper[at] });
    }
    return Sqrt(sum);
  }

  [[nodiscard]] double Component(std::span<const double> values) const
  {
    if (TheScene.component != Scene::kMagnitude || values.size() == 1)
    {
      return values[std::max(TheScene.component, 0)];
    }
    // hypot neither overflows nor underflows on the way.
    return std::accumulate(
      values.begin(), values.end(), 0.0, [](double sum, double v) { return std::hypot(sum, v); });
  }

  const Scene& TheScene;
  SampleBuffers& Buffers;
  FrameCounters& Counters;
  CheckedOut<Scratch> Lease;
  Scratch& Work;
  TileSamples& Samples;
  std::span<std::int32_t> Element;
  std::span<Verdict> Verdicts;
  std::span<Vec3> Xi;
  std::span<double> Values;
  std::span<double> Lower;
  std::span<double> Upper;
};
} // namespace

void TraceTile(const Scene& scene, const Camera& camera, const TileArea& area,
  const SampleLattice& lattice, SampleBuffers& buffers, FrameCounters& counters)
{
  TileWork(scene, buffers, counters).Run(camera, area, lattice);
}
} // namespace pixelexact
