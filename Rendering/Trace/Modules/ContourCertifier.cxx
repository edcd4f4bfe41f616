// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Modules/ContourCertifier.h"

#include "Core/Base/Error.h"
#include "Trace/Contours/ContourTile.h"
#include "Trace/Contours/IntervalEdges.h"
#include "Trace/TileVisit.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>

namespace pixelexact
{
namespace
{
void RequireListsFor(const Scene& scene, std::size_t lists)
{
  const std::size_t layers = scene.layers.size();
  if (lists != layers)
  {
    throw Error("contours: " + std::to_string(lists) + " lists of iso-values for " +
      std::to_string(layers) + " layers; give one for each, which may be empty.");
  }
}
} // namespace

void ContourMethod::SetEffort(double effort)
{
  const ContourMethod usual;
  const int doublings = std::max(0, static_cast<int>(std::log2(effort)));
  const auto times = [effort](auto least)
  { return static_cast<decltype(least)>(static_cast<double>(least) * effort); };
  halvings = usual.halvings + doublings;
  crossings = usual.crossings + doublings;
  quarterings = usual.quarterings + doublings;
  parts = std::max(usual.parts, times(usual.parts));
  squares = std::max(usual.squares, times(usual.squares));
  work = times(usual.work);
}

void ContourCounters::Add(const ContourCounters& other)
{
  in += other.in;
  out += other.out;
  undecided += other.undecided;
  jumps += other.jumps;
  loops += other.loops;
  spent += other.spent;
  samples += other.samples;
  byBlocks += other.byBlocks;
  byEdges += other.byEdges;
  byParts += other.byParts;
}

ContourCertifier::ContourCertifier(std::vector<std::vector<double>> values,
  const ContourMethod& method, std::shared_ptr<ContourBounds> bounds)
  : IsoValues(std::move(values))
  , Method(method)
  , Given(std::move(bounds))
{
  if (method.interior && method.subdivisions)
  {
    throw Error("contours: the paper's algorithm looks at edges alone; look inside of pixels with "
                "the project's own, without subdivisions.");
  }
  for (std::vector<double>& ofLayer : IsoValues)
  {
    if (!std::ranges::all_of(ofLayer, [](double value) { return std::isfinite(value); }))
    {
      throw Error("contours: an iso-value is not finite; give finite numbers.");
    }
    std::ranges::sort(ofLayer);
    ofLayer.erase(std::unique(ofLayer.begin(), ofLayer.end()), ofLayer.end());
  }
}

ContourCertifier::~ContourCertifier() = default;

SampleNeeds ContourCertifier::Needs() const
{
  // Whether a surface goes on between two corners is asked of the surface alone.
  if (Method.subdivisions)
  {
    return { .corners = kEdgeSampleBuffers };
  }
  return { .welcome = kEdgeSampleBuffers, .corners = kEdgeSampleBuffers | Buffer::Piece };
}

void ContourCertifier::Begin(int width, int height)
{
  Width = width;
  Pixels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
    static_cast<std::uint8_t>(ContourVerdict::Out));
  const auto squares = [](int pixels) { return (pixels + kTileSize - 1) / kTileSize; };
  Across = squares(width);
  Marked.assign(static_cast<std::size_t>(Across) * static_cast<std::size_t>(squares(height)),
    std::uint8_t{ 0 });
  Counted = {};
  Bounds = Given ? Given : std::make_shared<ContourBounds>();
}

void ContourCertifier::Process(TileVisit& tile)
{
  const Scene& scene = tile.GetScene();
  RequireListsFor(scene, IsoValues.size());
  ContourCounters counters;
  std::vector<std::uint8_t> verdicts(
    static_cast<std::size_t>(tile.Area().Width()) * static_cast<std::size_t>(tile.Area().Height()));
  if (Method.subdivisions)
  {
    IntervalCounters found;
    JudgeByIntervals(tile, IsoValues, *Method.subdivisions, verdicts, found);
    counters.samples = found.samples;
  }
  else
  {
    ContourTile pixels(tile, Method);
    for (std::size_t k = 0; k < IsoValues.size(); ++k)
    {
      if (!IsoValues[k].empty() && scene.layers[k].field)
      {
        pixels.Judge(
          { static_cast<int>(k), IsoValues[k], &Bounds->Of(*scene.locator, scene.layers[k]) });
      }
    }
    std::ranges::transform(pixels.Verdicts(), verdicts.begin(),
      [](ContourVerdict verdict) { return static_cast<std::uint8_t>(verdict); });
    counters = pixels.Counters();
  }
  Keep(tile.Area(), verdicts, counters);
  const std::lock_guard lock(CountersMutex);
  Counted.Add(counters);
}

void ContourCertifier::Keep(
  const TileArea& area, std::span<const std::uint8_t> verdicts, ContourCounters& counters)
{
  const auto count = [&](ContourVerdict verdict)
  { return std::ranges::count(verdicts, static_cast<std::uint8_t>(verdict)); };
  counters.out = count(ContourVerdict::Out);
  counters.in = counters.out < std::ssize(verdicts) ? count(ContourVerdict::In) : 0;
  counters.undecided = std::ssize(verdicts) - counters.out - counters.in;
  auto verdict = verdicts.begin();
  for (int y = area.y0; y < area.y1; ++y, verdict += area.Width())
  {
    std::copy_n(verdict, area.Width(), Pixels.begin() + std::ptrdiff_t{ y } * Width + area.x0);
  }
  for (int y = area.y0 / kTileSize; y * kTileSize < area.y1 && counters.out < std::ssize(verdicts);
       ++y)
  {
    for (int x = area.x0 / kTileSize; x * kTileSize < area.x1; ++x)
    {
      std::atomic_ref(Marked[SquareAt(x, y)]).store(1, std::memory_order_relaxed);
    }
  }
}

bool ContourCertifier::HasLinesNear(const TileArea& pixels) const
{
  for (int y = pixels.y0 / kTileSize; y * kTileSize < pixels.y1; ++y)
  {
    for (int x = pixels.x0 / kTileSize; x * kTileSize < pixels.x1; ++x)
    {
      if (Marked[SquareAt(x, y)] != 0)
      {
        return true;
      }
    }
  }
  return false;
}
} // namespace pixelexact
