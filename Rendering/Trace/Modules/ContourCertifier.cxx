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
/// Parts of a frame's work budget: for the first pass over all tiles, and for one tile at most.
constexpr double kFirstShare = 0.5;
constexpr double kMaxOfTile = 0.1;
/// Factor on a frame's work budget if a layer with iso-values shows an expression. Work of
/// expressions is underestimated, by up to a factor of 2.
constexpr double kShareOfExpressions = 0.5;

std::size_t PixelsOf(const TileArea& area)
{
  return static_cast<std::size_t>(area.Width()) * static_cast<std::size_t>(area.Height());
}

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
  edgeLevels = usual.edgeLevels + doublings;
  crossings = usual.crossings + doublings;
  quarterings = usual.quarterings + doublings;
  parts = std::max(usual.parts, times(usual.parts));
  samples = std::max(usual.samples, times(usual.samples));
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

SampleNeeds ContourCertifier::Remainder::Needs() const
{
  return { .wholeFrame = true };
}

void ContourCertifier::Remainder::Process(TileVisit& tile)
{
  Of.ProcessAgain(tile, Pass);
}

FrameModule* ContourCertifier::Rest()
{
  return Method.subdivisions ? nullptr : &Again;
}

SampleNeeds ContourCertifier::Needs() const
{
  // The surface itself decides whether it is continuous between two corners.
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
  OnPlateau.assign(Pixels.size(), 0);
  const auto squares = [](int pixels) { return (pixels + kTileSize - 1) / kTileSize; };
  Across = squares(width);
  Marked.assign(static_cast<std::size_t>(Across) * static_cast<std::size_t>(squares(height)),
    std::uint8_t{ 0 });
  Counted = {};
  Passes = {};
  Bounds = Given ? Given : std::make_shared<ContourBounds>();
}

void ContourCertifier::Process(TileVisit& tile)
{
  const Scene& scene = tile.GetScene();
  RequireListsFor(scene, IsoValues.size());
  std::vector<std::uint8_t> verdicts(PixelsOf(tile.Area()));
  if (Method.subdivisions)
  {
    IntervalCounters found;
    ClassifyByIntervals(tile, IsoValues, *Method.subdivisions, verdicts, found);
    ContourCounters counters;
    counters.samples = found.samples;
    Keep(tile.Area(), verdicts, counters);
    Count(counters);
    return;
  }
  // A tile's share is proportional to its pixels.
  const double part = kFirstShare * static_cast<double>(verdicts.size()) /
    static_cast<double>(std::max<std::size_t>(Pixels.size(), 1));
  const auto share = static_cast<std::int64_t>(part * WorkOf(tile.GetScene()));
  ClassifiedTile classified;
  classified.area = tile.Area();
  Classify(tile, share, classified);
  Take(std::move(classified), 0);
}

void ContourCertifier::Take(ClassifiedTile classified, std::size_t pass)
{
  const std::lock_guard lock(CountersMutex);
  Passes[pass].spent += classified.spent;
  if (classified.counters.spent > 0 && pass + 1 < kPasses)
  {
    Passes[pass].left.push_back(std::move(classified));
  }
  else
  {
    Counted.Add(classified.counters);
  }
}

void ContourCertifier::ProcessAgain(TileVisit& tile, std::size_t pass)
{
  std::vector<ClassifiedTile>& left = Passes[pass].left;
  const auto isThis = [&area = tile.Area()](const ClassifiedTile& one)
  { return one.area.x0 == area.x0 && one.area.y0 == area.y0; };
  const auto found = std::ranges::find_if(left, isThis);
  if (found == left.end())
  {
    return;
  }
  const double all = WorkOf(tile.GetScene());
  double rest = all;
  for (std::size_t k = 0; k <= pass; ++k)
  {
    rest -= static_cast<double>(Passes[k].spent);
  }
  const double share = std::min(kMaxOfTile * all, rest / static_cast<double>(left.size()));
  ClassifiedTile classified = std::move(*found);
  Classify(tile, static_cast<std::int64_t>(std::max(share, 0.0)), classified);
  Take(std::move(classified), pass + 1);
}

bool ContourCertifier::HasLines(const Scene& scene, std::size_t layer) const
{
  return !IsoValues[layer].empty() && scene.layers[layer].field != nullptr;
}

double ContourCertifier::WorkOf(const Scene& scene) const
{
  bool hasExpressions = false;
  for (std::size_t k = 0; k < IsoValues.size(); ++k)
  {
    hasExpressions =
      hasExpressions || (HasLines(scene, k) && scene.layers[k].field->function != nullptr);
  }
  return (hasExpressions ? kShareOfExpressions : 1.0) * static_cast<double>(Method.work);
}

void ContourCertifier::Classify(TileVisit& tile, std::int64_t most, ClassifiedTile& classified)
{
  const Scene& scene = tile.GetScene();
  const auto hasLines = [&](std::size_t k) { return HasLines(scene, k); };
  std::int64_t layers = 0;
  for (std::size_t k = 0; k < IsoValues.size(); ++k)
  {
    layers += hasLines(k) ? 1 : 0;
  }
  const bool again = !classified.works.empty();
  ContourTile pixels =
    again ? ContourTile(tile, Method, VerdictsOf(classified.area)) : ContourTile(tile, Method);
  classified.spent = 0;
  classified.counters.spent = 0;
  std::size_t number = 0;
  for (std::size_t k = 0; k < IsoValues.size(); ++k)
  {
    if (!hasLines(k))
    {
      continue;
    }
    const std::int64_t share = (most - classified.spent) / layers--;
    if (again)
    {
      classified.works[number].GoOn(share);
    }
    else
    {
      classified.works.emplace_back(share);
    }
    EdgeWork& work = classified.works[number++];
    pixels.Classify(
      { static_cast<int>(k), IsoValues[k], &Bounds->Of(*scene.locator, scene.layers[k]) }, work);
    classified.spent += work.Spent();
    classified.counters.spent += work.IsSpent() ? 1 : 0;
  }
  std::vector<std::uint8_t> verdicts(PixelsOf(tile.Area()));
  std::ranges::transform(pixels.Verdicts(), verdicts.begin(),
    [](ContourVerdict verdict) { return static_cast<std::uint8_t>(verdict); });
  classified.counters.Add(pixels.Counters());
  Keep(tile.Area(), verdicts, classified.counters);
  if (classified.counters.in > 0)
  {
    KeepPlateaus(classified.area, pixels.Plateaus());
  }
}

void ContourCertifier::KeepPlateaus(const TileArea& area, std::span<const std::uint8_t> onPlateau)
{
  auto plateau = onPlateau.begin();
  for (int y = area.y0; y < area.y1; ++y)
  {
    for (int x = area.x0; x < area.x1; ++x, ++plateau)
    {
      if (*plateau != 0)
      {
        OnPlateau[PixelAt(x, y)] = 1;
      }
    }
  }
}

std::vector<ContourVerdict> ContourCertifier::VerdictsOf(const TileArea& area) const
{
  std::vector<ContourVerdict> verdicts;
  for (int y = area.y0; y < area.y1; ++y)
  {
    for (int x = area.x0; x < area.x1; ++x)
    {
      verdicts.push_back(static_cast<ContourVerdict>(Pixels[PixelAt(x, y)]));
    }
  }
  return verdicts;
}

void ContourCertifier::Count(const ContourCounters& counters)
{
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
