// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Contours/ContourTile.h"

#include <algorithm>
#include <limits>

namespace pixelexact
{
ContourTile::ContourTile(TileVisit& tile, const ContourMethod& method)
  : Tile(tile)
  , Method(method)
  , Across(static_cast<std::size_t>(tile.Area().Width()) + 1)
  , Up(static_cast<std::size_t>(tile.Area().Height()) + 1)
  , Edges((Across - 1) * Up + Across * (Up - 1), EdgeState::Out)
{
}

std::vector<EdgeEnd> ContourTile::EndsOf(const LayerSight& sight)
{
  const SampleBuffers& samples = Tile.Corners();
  const TileArea& area = Tile.Area();
  std::vector<EdgeEnd> ends;
  ends.reserve(samples.Size());
  for (int y = area.y0; y <= area.y1; ++y)
  {
    for (int x = area.x0; x <= area.x1; ++x)
    {
      ends.push_back(
        sight.EndOf(samples, ends.size(), { static_cast<double>(x), static_cast<double>(y) }));
    }
  }
  return ends;
}

std::vector<int> ContourTile::ElementsNear(std::span<const EdgeEnd> corners) const
{
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const ElementIndex& index = Tile.GetScene().locator->Index();
  Box3 box{ Vec3(kInfinity), Vec3(-kInfinity) };
  bool known = true;
  for (const std::size_t i : { std::size_t{ 0 }, Across - 1, Across * (Up - 1), Across * Up - 1 })
  {
    known = known && corners[i].meets;
    box.lower = glm::min(box.lower, corners[i].point.x);
    box.upper = glm::max(box.upper, corners[i].point.x);
  }
  const Vec3 margin = 1e-12 * (glm::abs(box.lower) + glm::abs(box.upper));
  std::vector<int> elements;
  index.FindNear(known ? Box3{ box.lower - margin, box.upper + margin } : index.Bounds(), elements);
  return elements;
}

template <class Visit, class EndRow>
void ContourTile::ForEachEdge(const Visit& visit, const EndRow& endRow) const
{
  std::size_t edge = 0;
  for (std::size_t i = 0; i < Up; ++i)
  {
    for (std::size_t j = 0; j + 1 < Across; ++j, ++edge)
    {
      visit(edge, i * Across + j, i * Across + j + 1);
    }
    endRow();
  }
  for (std::size_t j = 0; j < Across; ++j)
  {
    for (std::size_t i = 0; i + 1 < Up; ++i, ++edge)
    {
      visit(edge, i * Across + j, (i + 1) * Across + j);
    }
    endRow();
  }
}

void ContourTile::Judge(const ContouredLayer& layer)
{
  LayerSight sight(Tile, layer.number);
  if (!layer.bounds->CanProve())
  {
    LeaveOpen(layer.number);
    return;
  }
  if (!sight.GetSurface().HasSagitta())
  {
    const Interval& range = layer.bounds->Values();
    if (ValueSet{ layer.values }.Meets(range.lower, range.upper))
    {
      LeaveOpen(layer.number);
    }
    return;
  }
  const std::vector<EdgeEnd> corners = EndsOf(sight);
  const EdgeJudge judge = sight.GetSurface().IsFlat()
    ? EdgeJudge(*layer.bounds, layer.values, ElementsNear(corners))
    : EdgeJudge(*layer.bounds, layer.values);
  if (!judge.IsNeeded())
  {
    return;
  }
  EdgeSettler settler(sight, judge, Method, Edges, Counted);
  ForEachEdge([&](std::size_t edge, std::size_t a, std::size_t b)
    { settler.Add(edge, corners[a], corners[b]); },
    [&] { settler.EndRow(); });
  settler.Refine();
}

void ContourTile::LeaveOpen(int layer)
{
  const SampleBuffers& samples = Tile.Corners();
  const auto shows = [&](std::size_t corner)
  {
    return samples.verdict[corner] == static_cast<std::uint8_t>(PixelVerdict::Exact) &&
      samples.layer[corner] == layer;
  };
  ForEachEdge(
    [&](std::size_t edge, std::size_t a, std::size_t b)
    {
      if (shows(a) || shows(b))
      {
        Edges[edge] = std::max(Edges[edge], EdgeState::Undecided);
      }
    },
    [] {});
}

void ContourTile::Tell(std::span<std::uint8_t> verdicts) const
{
  const std::size_t ups = (Across - 1) * Up;
  auto verdict = verdicts.begin();
  for (std::size_t i = 0; i + 1 < Up; ++i)
  {
    for (std::size_t j = 0; j + 1 < Across; ++j, ++verdict)
    {
      const std::size_t across = i * (Across - 1) + j;
      const std::size_t up = ups + j * (Up - 1) + i;
      const EdgeState state =
        std::max({ Edges[across], Edges[across + Across - 1], Edges[up], Edges[up + Up - 1] });
      *verdict = static_cast<std::uint8_t>(state == EdgeState::In ? ContourVerdict::In
          : state == EdgeState::Undecided                         ? ContourVerdict::Undecided
                                                                  : ContourVerdict::Out);
    }
  }
}
} // namespace pixelexact
