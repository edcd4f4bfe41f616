// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/FrameTiles.h"

#include "Core/Base/CheckedOut.h"
#include "Core/Base/Error.h"
#include "Trace/BufferTable.h"
#include "Trace/TileLoop.h"
#include "Trace/TraceTile.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
/// Samples of a lattice along one side of an image.
int SamplesAlong(int first, int step, int size)
{
  return first < size ? (size - first + step - 1) / step : 0;
}

/// Samples along a tile's side. Rays that are far apart have few elements in common: then a large
/// tile asks many elements for few points each.
int SideOf(const SampleLattice& lattice)
{
  return lattice.step > 1 ? TileSamples::kRow : kTileSize;
}
} // namespace

void RequireTraceable(const Scene& scene, const SampleNeeds& needs)
{
  if (!scene.locator)
  {
    throw Error("scene: no data set to render; set one.");
  }
  if (scene.layers.empty() || scene.layers.size() > Scene::kMostLayers)
  {
    throw Error(scene.layers.empty() ? "scene: no cut-surface to render; add at least one."
                                     : "scene: more than 255 layers; leave some out.");
  }
  const Buffer wanted = needs.centres | needs.corners | needs.edges;
  for (const Layer& layer : scene.layers)
  {
    if (!layer.surface)
    {
      throw Error("scene: a layer without surface; set one.");
    }
    if (!layer.field)
    {
      if (Has(wanted, Buffer::Value | Buffer::Enclosure))
      {
        throw Error("scene: a layer without field has no values; set one, or paint it in one "
                    "colour.");
      }
      continue;
    }
    const int components = layer.field->values.components;
    if (layer.component != kMagnitude && (layer.component < 0 || layer.component >= components))
    {
      throw Error("scene: field '" + layer.field->name + "' has no component " +
        std::to_string(layer.component) + "; it has " + std::to_string(components) +
        ", counted from 0.");
    }
    if (layer.precision == Precision::Float && Has(wanted, Buffer::Enclosure))
    {
      throw Error(
        "scene: values in single precision have no enclosures; ask for double precision.");
    }
  }
}

int TilesOf(const SampleLattice& lattice, int width, int height)
{
  const int side = SideOf(lattice);
  return TilesAlong(SamplesAlong(lattice.x0, lattice.step, width), side) *
    TilesAlong(SamplesAlong(lattice.y0, lattice.step, height), side);
}

namespace
{
/// What the frame keeps of a tile's samples.
void KeepRows(const SampleBuffers& own, const TileArea& area, SampleBuffers& frame)
{
  ForEachBuffer(
    [&](const auto& row)
    {
      const auto& from = own.*row.member;
      auto& to = frame.*row.member;
      if (from.empty() || to.empty())
      {
        return;
      }
      for (int y = area.y0; y < area.y1; ++y)
      {
        std::copy_n(from.begin() + std::ptrdiff_t{ y - area.y0 } * area.Width(), area.Width(),
          to.begin() + std::ptrdiff_t{ y } * frame.width + area.x0);
      }
    });
}

/// Samples that stay with the tile until it has been visited: far smaller than the frame's.
void TraceAlone(const Scene& scene, const Camera& camera, const TileArea& area,
  const SampleLattice& lattice, Sheets& sheets, const LatticeWork& work, FrameCounters& counters)
{
  const CheckedOut<SampleBuffers> own;
  const Buffer all = sheets.Buffers() | work.passing;
  (*own).Allocate(all, area.Width(), area.Height());
  {
    const CheckedOut<TileSamples> samples;
    {
      const StageScope scope(Stage::Rays);
      (*samples).BeginAlone(camera, area, lattice.offset);
    }
    Sheets alone(*own, all);
    TraceTile(scene, camera, *samples, alone, counters);
  }
  KeepRows(*own, area, sheets.At(0));
  work.after(area, &*own, counters);
}

void TraceInto(const Scene& scene, const Camera& camera, const TileArea& area,
  const SampleLattice& lattice, Sheets& sheets, const LatticeWork& work, FrameCounters& counters)
{
  {
    const CheckedOut<TileSamples> samples;
    {
      const StageScope scope(Stage::Rays);
      (*samples).Begin(camera, area, lattice, sheets.At(0).width);
    }
    TraceTile(scene, camera, *samples, sheets, counters);
  }
  if (work.after)
  {
    work.after(area, nullptr, counters);
  }
}
} // namespace

FrameCounters TraceLattice(const Scene& scene, const Camera& camera, const SampleLattice& lattice,
  Sheets& sheets, Reporter& reporter, StageTimes* stages, const LatticeWork& work)
{
  const int width = sheets.At(0).width;
  const int height = sheets.At(0).height;
  const int columns = lattice.packed ? width : SamplesAlong(lattice.x0, lattice.step, width);
  const int rows = lattice.packed ? height : SamplesAlong(lattice.y0, lattice.step, height);
  const int side = SideOf(lattice);
  const auto trace = work.passing != Buffer::None ? &TraceAlone : &TraceInto;
  FrameCounters total = ForEachTile(
    &scene, columns, rows, stages,
    [&](const TileArea& area, FrameCounters& counters)
    {
      const int tile = area.y0 / side * TilesAlong(columns, side) + area.x0 / side;
      std::uint8_t* const isDone =
        work.done != nullptr ? &(*work.done)[static_cast<std::size_t>(tile)] : nullptr;
      if (!work.turn.Has(tile) || (isDone != nullptr && *isDone != 0) || !reporter.HasTime())
      {
        return;
      }
      trace(scene, camera, area, lattice, sheets, work, counters);
      if (isDone != nullptr)
      {
        *isDone = 1;
      }
      reporter.TileDone();
    },
    side);
  total.nothing = static_cast<std::int64_t>(columns) * rows - total.exact - total.unknown;
  return total;
}

void AddSamples(const FrameCounters& counted, FrameCounters& total)
{
  total.rays += counted.rays;
  total.floatCheck.Add(counted.floatCheck);
}

void AddCounters(const FrameCounters& counted, FrameCounters& total)
{
  total.rays += counted.rays;
  total.surfaceHits += counted.surfaceHits;
  total.nothing += counted.nothing;
  total.exact += counted.exact;
  total.unknown += counted.unknown;
  total.nonFinite += counted.nonFinite;
  total.numericHits += counted.numericHits;
  total.undecidedHits += counted.undecidedHits;
  total.cutOff += counted.cutOff;
  total.floatCheck.Add(counted.floatCheck);
}
} // namespace pixelexact
