// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Contours/ContourTile.h"

#include "Core/Math/Rounding.h"
#include "Trace/Contours/FlatBlocks.h"
#include "Trace/Contours/LayerSight.h"
#include "Trace/Contours/PixelInteriors.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

namespace pixelexact
{
namespace
{
/// Parts of the work budget that are reserved for the steps after blocks, and after whole edges.
constexpr double kLeftByBlocks = 0.5;
constexpr double kLeftByEdges = 0.25;

/// The elements whose boxes meet the box of an outline; all elements if there is no outline.
std::vector<int> ElementsNear(const ElementIndex& index, const std::optional<Outline>& part)
{
  Box3 box = index.Bounds();
  if (part)
  {
    box = { Vec3(kInfinity), Vec3(-kInfinity) };
    const Vec3 margin(SlackOf(part->Corners()));
    for (const Vec3& corner : part->Corners())
    {
      box.lower = glm::min(box.lower, corner - margin);
      box.upper = glm::max(box.upper, corner + margin);
    }
  }
  std::vector<int> elements;
  index.FindNear(box, elements);
  return elements;
}

/// The longest side of the box of some points; 0 without any.
class WidestBox
{
public:
  void Add(const Vec3& x)
  {
    Lower = glm::min(Lower, x);
    Upper = glm::max(Upper, x);
  }
  [[nodiscard]] double Width() const
  {
    const Vec3 sides = Upper - Lower;
    return std::max({ 0.0, sides.x, sides.y, sides.z });
  }

private:
  Vec3 Lower{ std::numeric_limits<double>::infinity() };
  Vec3 Upper{ -std::numeric_limits<double>::infinity() };
};

/// The longest side of the box of an outline's corners.
double WidthOf(const Outline& part)
{
  WidestBox box;
  for (const Vec3& corner : part.Corners())
  {
    box.Add(corner);
  }
  return box.Width();
}

/// The longest side of the box of the points where corners show the layer.
double WidthOf(const LayerSight& sight, const TileCorners& corners)
{
  WidestBox box;
  for (std::size_t i = 0; i < corners.Size(); ++i)
  {
    if (sight.Shows(corners[i]))
    {
      box.Add(corners[i].point.x);
    }
  }
  return box.Width();
}
} // namespace

ContourTile::ContourTile(TileVisit& tile, const ContourMethod& method)
  : Tile(tile)
  , Method(method)
  , Across(static_cast<std::size_t>(tile.Area().Width()) + 1)
  , Up(static_cast<std::size_t>(tile.Area().Height()) + 1)
  , Pixels((Across - 1) * (Up - 1), ContourVerdict::Out)
  , Asked(Pixels.size(), 1)
  , OnPlateau(Pixels.size(), 0)
{
}

ContourTile::ContourTile(
  TileVisit& tile, const ContourMethod& method, std::vector<ContourVerdict> before)
  : ContourTile(tile, method)
{
  Again = true;
  Pixels = std::move(before);
  std::ranges::transform(Pixels, Asked.begin(),
    [](ContourVerdict verdict)
    { return static_cast<std::uint8_t>(verdict == ContourVerdict::Undecided); });
  std::ranges::replace(Pixels, ContourVerdict::Undecided, ContourVerdict::Out);
}

TileCorners ContourTile::EndsOf(const LayerSight& sight, std::span<const std::uint8_t> open)
{
  const std::vector<std::uint8_t> wanted = CornersOfPixels(open, Tile.Area().Width());
  const TileArea& area = Tile.Area();
  SampleBuffers traced;
  const LatticePart corners = Tile.CornersOf({ area.x0, area.y0, area.x1 + 1, area.y1 + 1 }, wanted,
    kEdgeSampleBuffers | Buffer::Piece, traced);
  TileCorners ends(Across * Up);
  std::size_t i = 0;
  for (int y = area.y0; y <= area.y1; ++y)
  {
    for (int x = area.x0; x <= area.x1; ++x, ++i)
    {
      if (wanted[i] != 0)
      {
        ends.Set(i,
          sight.EndOf(
            corners.samples, corners.At(x, y), { static_cast<double>(x), static_cast<double>(y) }));
      }
    }
  }
  return ends;
}

std::vector<std::uint8_t> ContourTile::ShownAround(
  const LayerSight& sight, const TileCorners& corners)
{
  const std::size_t wide = Across + 2;
  std::vector<std::uint8_t> shown(wide * (Up + 2), 0);
  for (std::size_t i = 0; i < corners.Size(); ++i)
  {
    shown[(i / Across + 1) * wide + i % Across + 1] = sight.Shows(corners[i]) ? 1 : 0;
  }
  // Corners outside the tile are needed only beside outermost edges with no end on the layer.
  std::vector<std::uint8_t> wanted(shown.size(), 0);
  const auto lookBeside = [&](std::size_t a, std::size_t along, std::ptrdiff_t beside)
  {
    if ((shown[a] | shown[a + along]) == 0)
    {
      const std::size_t outer = a + static_cast<std::size_t>(beside);
      wanted[outer] = wanted[outer + along] = 1;
    }
  };
  for (std::size_t x = 1; x < Across; ++x)
  {
    lookBeside(wide + x, 1, -static_cast<std::ptrdiff_t>(wide));
    lookBeside(Up * wide + x, 1, static_cast<std::ptrdiff_t>(wide));
  }
  for (std::size_t y = 1; y < Up; ++y)
  {
    lookBeside(y * wide + 1, wide, -1);
    lookBeside(y * wide + Across, wide, 1);
  }
  const TileArea& area = Tile.Area();
  const TileArea all{ area.x0 - 1, area.y0 - 1, area.x0 - 1 + static_cast<int>(wide),
    area.y0 + 1 + static_cast<int>(Up) };
  const auto isInFrame = [&](int x, int y)
  { return x >= 0 && y >= 0 && x <= Tile.GetFrame().width && y <= Tile.GetFrame().height; };
  std::size_t i = 0;
  for (int y = all.y0; y < all.y1; ++y)
  {
    for (int x = all.x0; x < all.x1; ++x, ++i)
    {
      wanted[i] = isInFrame(x, y) ? wanted[i] : 0;
    }
  }
  if (std::ranges::find(wanted, 1) == wanted.end())
  {
    return shown;
  }
  SampleBuffers traced;
  const LatticePart outer = Tile.CornersOf(all, wanted, Buffer::Verdict | Buffer::Layer, traced);
  i = 0;
  for (int y = all.y0; y < all.y1; ++y)
  {
    for (int x = all.x0; x < all.x1; ++x, ++i)
    {
      if (wanted[i] != 0)
      {
        shown[i] = sight.ShowsAt(outer.samples, outer.At(x, y)) ? 1 : 0;
      }
    }
  }
  return shown;
}

template <class Visit, class EndRow>
void ContourTile::ForEachEdge(
  std::span<const std::uint8_t> open, const Visit& visit, const EndRow& endRow) const
{
  const std::size_t columns = Across - 1;
  const std::size_t rows = Up - 1;
  const auto visitOpen = [&](
                           bool before, bool after, std::size_t edge, std::size_t a, std::size_t b)
  {
    if (before || after)
    {
      visit(edge, a, b);
    }
    else
    {
      endRow();
    }
  };
  // Most rows and columns have no open pixel.
  std::vector<std::uint8_t> openRows(Up + 1, 0);
  std::vector<std::uint8_t> openColumns(Across + 1, 0);
  for (std::size_t pixel = 0; pixel < open.size(); ++pixel)
  {
    openRows[pixel / columns + 1] |= open[pixel];
    openColumns[pixel % columns + 1] |= open[pixel];
  }
  for (std::size_t i = 0; i < Up; ++i)
  {
    if ((openRows[i] | openRows[i + 1]) == 0)
    {
      continue;
    }
    std::size_t edge = i * columns;
    for (std::size_t j = 0; j < columns; ++j, ++edge)
    {
      visitOpen(i > 0 && open[(i - 1) * columns + j] != 0, i < rows && open[i * columns + j] != 0,
        edge, i * Across + j, i * Across + j + 1);
    }
    endRow();
  }
  for (std::size_t j = 0; j < Across; ++j)
  {
    if ((openColumns[j] | openColumns[j + 1]) == 0)
    {
      continue;
    }
    std::size_t edge = columns * Up + j * rows;
    for (std::size_t i = 0; i < rows; ++i, ++edge)
    {
      visitOpen(j > 0 && open[i * columns + j - 1] != 0, j < columns && open[i * columns + j] != 0,
        edge, i * Across + j, (i + 1) * Across + j);
    }
    endRow();
  }
}

std::optional<LatticePart> ContourTile::Centres()
{
  const std::optional<LatticePart> atHand = Tile.Centres();
  if (atHand || !Again)
  {
    return atHand;
  }
  const TileArea& area = Tile.Area();
  if (Traced.Size() == 0)
  {
    std::vector<ImagePosition> places;
    for (int y = area.y0; y < area.y1; ++y)
    {
      for (int x = area.x0; x < area.x1; ++x)
      {
        places.push_back({ x + 0.5, y + 0.5 });
      }
    }
    Traced = Tile.Trace(places, kEdgeSampleBuffers);
    Traced.width = area.Width();
    Traced.height = area.Height();
  }
  return LatticePart{ Traced, area.x0, area.y0 };
}

std::optional<double> ContourTile::HeldBy(const Surface& surface, const ContouredLayer& layer) const
{
  const Layer& shown = Tile.GetScene().layers[static_cast<std::size_t>(layer.number)];
  return surface.HeldValue(*shown.field, shown.component);
}

void ContourTile::Classify(const ContouredLayer& layer, EdgeWork& work)
{
  LayerSight sight(Tile, layer.number, *layer.bounds);
  const Surface& surface = sight.GetSurface();
  if (layer.bounds->IsUnknown())
  {
    LeaveOpen(layer.number);
    return;
  }
  if (!surface.HasSagitta())
  {
    const EdgeClassifier classifier(*layer.bounds, layer.values, nullptr);
    const Interval& range = layer.bounds->Values();
    if (classifier.Meets(range.lower, range.upper))
    {
      LeaveOpen(layer.number);
    }
    return;
  }
  if (!surface.IsPlane())
  {
    EdgeClassifier classifier(*layer.bounds, layer.values, &work);
    if (const std::optional<double> held = HeldBy(surface, layer))
    {
      const double value = layer.bounds->ToBounded(*held);
      if (!classifier.Meets(value, value))
      {
        Counted.byBlocks += std::ranges::count(Asked, 1);
        return;
      }
      classifier.HoldEverywhere();
    }
    ClassifyEdges(sight, classifier, Asked, work);
    return;
  }
  FlatBlocks blocks(sight, Tile, Centres());
  if (blocks.AreBeyond())
  {
    Counted.byBlocks += std::ranges::count(Asked, 1);
    return;
  }
  const std::optional<Outline> whole = blocks.Whole();
  work.SetWidth(whole ? WidthOf(*whole) : 0.0);
  EdgeClassifier classifier(
    *layer.bounds, layer.values, &work, ElementsNear(Tile.GetScene().locator->Index(), whole));
  classifier.LieOn(*sight.AsPlane());
  if (!classifier.IsNeeded())
  {
    Counted.byBlocks += std::ranges::count(Asked, 1);
    return;
  }
  classifier.Reserve(kLeftByBlocks);
  std::vector<ContourVerdict> states = blocks.Settle(classifier, Asked);
  std::vector<std::uint8_t> open(states.size());
  std::ranges::transform(states, open.begin(),
    [](ContourVerdict state)
    { return static_cast<std::uint8_t>(state == ContourVerdict::Undecided); });
  std::ranges::replace(states, ContourVerdict::Undecided, ContourVerdict::Out);
  Add(states);
  ClassifyEdges(sight, classifier, open, work);
}

void ContourTile::ClassifyEdges(LayerSight& sight, const EdgeClassifier& classifier,
  std::span<const std::uint8_t> open, EdgeWork& work)
{
  Counted.byBlocks += std::ranges::count(Asked, 1) - std::ranges::count(open, 1);
  if (std::ranges::find(open, 1) == open.end())
  {
    return;
  }
  classifier.Reserve(kLeftByEdges);
  const TileCorners corners = EndsOf(sight, open);
  if (!Again && !sight.GetSurface().IsPlane())
  {
    work.SetWidth(WidthOf(sight, corners));
  }
  const std::vector<std::uint8_t> shown =
    sight.GetSurface().IsPlane() ? std::vector<std::uint8_t>() : ShownAround(sight, corners);
  const std::size_t wide = Across + 2;
  // A corner of one of the edge's two pixels shows the layer.
  const auto peeks = [&](std::size_t a, std::size_t b)
  {
    const std::size_t at = (a / Across + 1) * wide + a % Across + 1;
    const std::size_t along = b == a + 1 ? 1 : wide;
    const std::size_t beside = b == a + 1 ? wide : 1;
    return !shown.empty() &&
      (shown[at] | shown[at + along] | shown[at + beside] | shown[at - beside] |
        shown[at + along + beside] | shown[at + along - beside]) != 0;
  };
  std::vector<ContourVerdict> edges(CountEdges(), ContourVerdict::Out);
  EdgeRefiner refiner(sight, classifier, Method, edges, Counted);
  ForEachEdge(
    open,
    [&](std::size_t edge, std::size_t a, std::size_t b)
    { refiner.Add(edge, corners[a], corners[b], peeks(a, b)); },
    [&] { refiner.EndRow(); });
  std::vector<ContourVerdict> unsplit = edges;
  refiner.MarkOpen(unsplit);
  classifier.Reserve(0.0);
  refiner.Refine();
  std::vector<ContourVerdict> states = StatesOf(edges, open);
  CountStages(StatesOf(unsplit, open), states, open);
  MarkPlateaus(sight, classifier, corners, states);
  if (Method.interior)
  {
    ClassifyInteriors(sight, classifier, corners, open, states);
  }
  Add(states);
}

void ContourTile::CountStages(std::span<const ContourVerdict> unsplit,
  std::span<const ContourVerdict> states, std::span<const std::uint8_t> open)
{
  for (std::size_t pixel = 0; pixel < states.size(); ++pixel)
  {
    if (open[pixel] == 0 || states[pixel] == ContourVerdict::Undecided)
    {
      continue;
    }
    ++(unsplit[pixel] == ContourVerdict::Undecided ? Counted.byParts : Counted.byEdges);
  }
}

void ContourTile::MarkPlateaus(const LayerSight& sight, const EdgeClassifier& classifier,
  const TileCorners& corners, std::span<const ContourVerdict> states)
{
  const std::size_t columns = Across - 1;
  for (std::size_t pixel = 0; pixel < states.size(); ++pixel)
  {
    if (states[pixel] != ContourVerdict::In)
    {
      continue;
    }
    const std::size_t lower = pixel / columns * Across + pixel % columns;
    const std::array around{ lower, lower + 1, lower + Across, lower + Across + 1 };
    OnPlateau[pixel] |= static_cast<std::uint8_t>(std::ranges::all_of(around,
      [&](std::size_t at)
      { return sight.Shows(corners[at]) && classifier.IsOnPlateau(corners[at]); }));
  }
}

void ContourTile::ClassifyInteriors(LayerSight& sight, const EdgeClassifier& classifier,
  const TileCorners& corners, std::span<const std::uint8_t> open, std::span<ContourVerdict> states)
{
  const std::vector<ContourVerdict> before(states.begin(), states.end());
  PixelInteriors interiors(sight, classifier, Method, states, Counted);
  const std::size_t columns = Across - 1;
  for (std::size_t pixel = 0; pixel < states.size(); ++pixel)
  {
    if (open[pixel] != 0)
    {
      const std::size_t lower = pixel / columns * Across + pixel % columns;
      const std::size_t upper = lower + Across;
      interiors.Add(
        pixel, { corners[lower], corners[lower + 1], corners[upper + 1], corners[upper] });
    }
  }
  interiors.Refine();
  for (std::size_t pixel = 0; pixel < states.size(); ++pixel)
  {
    const bool isLoop = before[pixel] == ContourVerdict::Out && states[pixel] == ContourVerdict::In;
    Counted.loops += isLoop && Pixels[pixel] != ContourVerdict::In ? 1 : 0;
  }
}

void ContourTile::LeaveOpen(int layer)
{
  const SampleBuffers& samples = Tile.Corners();
  const auto shows = [&](std::size_t corner)
  {
    return samples.verdict[corner] == static_cast<std::uint8_t>(PixelVerdict::Exact) &&
      samples.layer[corner] == layer;
  };
  std::vector<ContourVerdict> edges(CountEdges(), ContourVerdict::Out);
  ForEachEdge(
    Asked,
    [&](std::size_t edge, std::size_t a, std::size_t b)
    { edges[edge] = shows(a) || shows(b) ? ContourVerdict::Undecided : ContourVerdict::Out; },
    [] {});
  Add(StatesOf(edges, Asked));
}

std::vector<ContourVerdict> ContourTile::StatesOf(
  std::span<const ContourVerdict> edges, std::span<const std::uint8_t> open) const
{
  const std::size_t columns = Across - 1;
  const std::size_t rows = Up - 1;
  const std::size_t ups = columns * Up;
  std::vector<ContourVerdict> states(Pixels.size(), ContourVerdict::Out);
  for (std::size_t pixel = 0; pixel < states.size(); ++pixel)
  {
    if (open[pixel] != 0)
    {
      const std::size_t up = ups + pixel % columns * rows + pixel / columns;
      states[pixel] = JoinVerdicts(JoinVerdicts(edges[pixel], edges[pixel + columns]),
        JoinVerdicts(edges[up], edges[up + rows]));
    }
  }
  return states;
}

void ContourTile::Add(std::span<const ContourVerdict> states)
{
  std::ranges::transform(Pixels, states, Pixels.begin(), JoinVerdicts);
}
} // namespace pixelexact
