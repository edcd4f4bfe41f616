// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Modules/ContourCertifier.h"

#include "Core/Base/Error.h"
#include "Trace/Contours/ContourTile.h"
#include "Trace/TileVisit.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
void ContourCounters::Add(const ContourCounters& other)
{
  in += other.in;
  out += other.out;
  undecided += other.undecided;
  jumps += other.jumps;
  samples += other.samples;
}

ContourCertifier::ContourCertifier(
  std::vector<std::vector<double>> values, const ContourEffort& effort)
  : IsoValues(std::move(values))
  , Effort(effort)
{
  for (std::vector<double>& ofLayer : IsoValues)
  {
    if (!std::ranges::all_of(ofLayer, [](double value) { return std::isfinite(value); }))
    {
      throw Error("contours: an iso-value is not finite; give finite numbers.");
    }
    std::ranges::sort(ofLayer);
  }
}

ContourCertifier::~ContourCertifier() = default;

SampleNeeds ContourCertifier::Needs() const
{
  return { .corners = Buffer::Value | Buffer::Verdict | Buffer::Layer | Buffer::Element |
      Buffer::Xi | Buffer::Position };
}

void ContourCertifier::Begin(int width, int height)
{
  Width = width;
  Pixels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
    static_cast<std::uint8_t>(ContourVerdict::Out));
  Counted = {};
}

const LayerBounds& ContourCertifier::BoundsOf(const Scene& scene, std::size_t layer)
{
  const std::scoped_lock lock(Making);
  Bounds.resize(scene.layers.size());
  if (!Bounds[layer])
  {
    Bounds[layer] = std::make_unique<const LayerBounds>(*scene.locator, scene.layers[layer]);
  }
  return *Bounds[layer];
}

void ContourCertifier::Process(TileVisit& tile)
{
  const Scene& scene = tile.GetScene();
  ContourTile pixels(tile, Effort);
  for (std::size_t k = 0; k < std::min(IsoValues.size(), scene.layers.size()); ++k)
  {
    if (!IsoValues[k].empty() && scene.layers[k].field)
    {
      pixels.Judge({ static_cast<int>(k), IsoValues[k], &BoundsOf(scene, k) });
    }
  }
  ContourCounters counters = pixels.Counters();
  const TileArea& area = tile.Area();
  const std::vector<ContourVerdict> verdicts = pixels.Verdicts();
  auto verdict = verdicts.begin();
  for (int y = area.y0; y < area.y1; ++y)
  {
    for (int x = area.x0; x < area.x1; ++x, ++verdict)
    {
      counters.in += *verdict == ContourVerdict::In ? 1 : 0;
      counters.out += *verdict == ContourVerdict::Out ? 1 : 0;
      counters.undecided += *verdict == ContourVerdict::Undecided ? 1 : 0;
      Pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(Width) +
        static_cast<std::size_t>(x)] = static_cast<std::uint8_t>(*verdict);
    }
  }
  const std::lock_guard lock(CountersMutex);
  Counted.Add(counters);
}
} // namespace pixelexact
