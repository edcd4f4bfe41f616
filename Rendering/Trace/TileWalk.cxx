// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/TileWalk.h"

#include "Core/Base/CheckedOut.h"
#include "Core/Base/StageClock.h"
#include "Trace/HitValues.h"
#include "Trace/HitWriter.h"
#include "Trace/RayKernels.h"
#include "Trace/Room.h"

#include <algorithm>
#include <numeric>

namespace pixelexact
{
namespace
{
/// The hits of one layer that rays have come to.
struct Arrived
{
  std::vector<int> ray;
  std::vector<int> slot;
  std::vector<double> lanes; ///< t and position, coordinate by coordinate
  std::vector<std::size_t> place;
};

/// The arrays of a tile.
struct Scratch
{
  std::vector<HitSlots> hits; ///< by layer
  std::vector<int> alive;     ///< rays that have not come to their end
  std::vector<int> next;      ///< by layer and ray: the slot that was not passed
  std::vector<int> depth;     ///< by ray: sheets that are written
  std::vector<Arrived> arrived;
  HitWriter writer;
  HitValues values;
};

class TileWalk
{
public:
  TileWalk(const Scene& scene, TileSamples& samples, Sheets& sheets, FrameCounters& counters)
    : TheScene(scene)
    , Samples(samples)
    , TheSheets(sheets)
    , Nearest(sheets.At(0))
    , Counters(counters)
    , Work(*Lease)
    , Translucent(std::ranges::any_of(scene.layers, &Layer::translucent))
  {
  }

  void Run(const Camera& camera)
  {
    {
      const StageScope scope(Stage::Rays);
      Samples.Meet(camera, TheScene, Work.hits);
    }
    Counters.rays += Samples.Count();
    if (Translucent)
    {
      Work.depth.assign(static_cast<std::size_t>(Samples.Count()), 0);
    }
    if (TheScene.layers.size() == 1)
    {
      WalkOneLayer();
    }
    else
    {
      WalkLayers();
    }
  }

private:
  /// Slot by slot; where every ray meets the surface, nothing is gathered.
  void WalkOneLayer()
  {
    const HitSlots& hits = Work.hits[0];
    bool all = true;
    Work.arrived.resize(std::max<std::size_t>(Work.arrived.size(), 1));
    for (int slot = 0; slot < hits.Count(); ++slot)
    {
      if (all && GetRayKernels().countHits(hits.T(slot), Samples.Count()) == Samples.Count())
      {
        HitResults found = ResultsOf(0);
        found.t = hits.T(slot);
        for (int d = 0; d < 3; ++d)
        {
          found.position[d] = hits.Position(slot, d);
        }
        found.slot = slot;
        Evaluate(found, static_cast<std::size_t>(Samples.Count()),
          std::span(Samples.place).first(static_cast<std::size_t>(Samples.Count())));
        all = false;
        if (slot + 1 < hits.Count())
        {
          GoOn(found);
        }
      }
      else
      {
        if (all)
        {
          Work.alive.resize(static_cast<std::size_t>(Samples.Count()));
          std::iota(Work.alive.begin(), Work.alive.end(), 0);
          all = false;
        }
        Arrived& arrived = Work.arrived[0];
        arrived.ray.clear();
        arrived.slot.clear();
        const double* t = hits.T(slot);
        for (const int ray : Work.alive)
        {
          if (t[ray] < kNoHit)
          {
            arrived.ray.push_back(ray);
            arrived.slot.push_back(slot);
          }
        }
        Arrive(0);
      }
      if (Work.alive.empty())
      {
        return;
      }
    }
  }

  void WalkLayers()
  {
    const auto rays = static_cast<std::size_t>(Samples.Count());
    const std::size_t layers = TheScene.layers.size();
    Work.alive.resize(rays);
    std::iota(Work.alive.begin(), Work.alive.end(), 0);
    Work.next.assign(layers * rays, 0);
    Work.arrived.resize(std::max(Work.arrived.size(), layers));
    while (!Work.alive.empty())
    {
      for (std::size_t k = 0; k < layers; ++k)
      {
        Work.arrived[k].ray.clear();
        Work.arrived[k].slot.clear();
      }
      for (const int ray : Work.alive)
      {
        Advance(ray, rays);
      }
      Work.alive.clear();
      for (std::size_t k = 0; k < layers; ++k)
      {
        Arrive(k);
      }
      // SampleWriter wants neighbours beside each other.
      std::ranges::sort(Work.alive);
    }
  }

  /// Takes a ray to the nearest of its hits that it has not passed.
  void Advance(int ray, std::size_t rays)
  {
    const auto at = static_cast<std::size_t>(ray);
    double nearest = kNoHit;
    std::size_t layer = 0;
    for (std::size_t k = 0; k < TheScene.layers.size(); ++k)
    {
      const int slot = Work.next[k * rays + at];
      if (slot < Work.hits[k].Count() && Work.hits[k].T(slot)[ray] < nearest)
      {
        nearest = Work.hits[k].T(slot)[ray];
        layer = k;
      }
    }
    if (nearest < kNoHit)
    {
      Work.arrived[layer].ray.push_back(ray);
      Work.arrived[layer].slot.push_back(Work.next[layer * rays + at]++);
    }
  }

  /// Evaluates the hits that rays have come to, gathered.
  void Arrive(std::size_t layer)
  {
    Arrived& arrived = Work.arrived[layer];
    const std::size_t count = arrived.ray.size();
    if (TheScene.layers.size() == 1)
    {
      Work.alive.clear();
    }
    if (count == 0)
    {
      return;
    }
    const auto stride = static_cast<std::size_t>(PaddedCount(static_cast<int>(count)));
    const auto lanes = Room(arrived.lanes, 4 * stride);
    const auto place = Room(arrived.place, count);
    const HitSlots& hits = Work.hits[layer];
    for (std::size_t i = 0; i < stride; ++i)
    {
      // Padded with the last.
      const std::size_t k = std::min(i, count - 1);
      const int ray = arrived.ray[k];
      const int slot = arrived.slot[k];
      lanes[i] = hits.T(slot)[ray];
      for (int d = 0; d < 3; ++d)
      {
        lanes[static_cast<std::size_t>(1 + d) * stride + i] = hits.Position(slot, d)[ray];
      }
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      place[i] = Samples.place[static_cast<std::size_t>(arrived.ray[i])];
    }
    HitResults found = ResultsOf(layer);
    found.t = lanes.data();
    for (std::size_t d = 0; d < 3; ++d)
    {
      found.position[d] = lanes.data() + (1 + d) * stride;
    }
    found.ray = arrived.ray.data();
    found.slotOf = arrived.slot.data();
    Evaluate(found, count, place);
    GoOn(found);
  }

  [[nodiscard]] HitResults ResultsOf(std::size_t layer) const
  {
    HitResults found;
    found.layer = &TheScene.layers[layer];
    found.layerNumber = static_cast<std::uint8_t>(layer);
    found.slots = &Work.hits[layer];
    return found;
  }

  void Evaluate(HitResults& found, std::size_t count, std::span<const std::size_t> place)
  {
    Counters.surfaceHits += static_cast<std::int64_t>(count);
    Work.values.Evaluate(*TheScene.locator, Nearest, count, found, Counters.floatCheck);
    Work.writer.Write(*TheScene.locator, found, place,
      Translucent ? std::span<const int>(Work.depth) : std::span<const int>(), TheSheets, Counters);
  }

  [[nodiscard]] int& DepthOf(const HitResults& found, std::size_t i)
  {
    return Work.depth[static_cast<std::size_t>(found.RayOf(i))];
  }

  /// Rays that do not end at their hits.
  void GoOn(const HitResults& found)
  {
    if (TheScene.layers.size() == 1)
    {
      Work.alive.clear();
    }
    for (std::size_t i = 0; i < found.verdict.size(); ++i)
    {
      if (found.verdict[i] == Verdict::Outside)
      {
        Work.alive.push_back(found.RayOf(i));
      }
      else if (Translucent && DepthOf(found, i) == Sheets::kMost)
      {
        ++Counters.cutOff;
      }
      else if (found.layer->translucent)
      {
        ++DepthOf(found, i);
        Work.alive.push_back(found.RayOf(i));
      }
    }
  }

  const Scene& TheScene;
  TileSamples& Samples;
  Sheets& TheSheets;
  SampleBuffers& Nearest;
  FrameCounters& Counters;
  CheckedOut<Scratch> Lease;
  Scratch& Work;
  bool Translucent;
};
} // namespace

void WalkTile(const Scene& scene, const Camera& camera, TileSamples& samples, Sheets& sheets,
  FrameCounters& counters)
{
  TileWalk(scene, samples, sheets, counters).Run(camera);
}
} // namespace pixelexact
