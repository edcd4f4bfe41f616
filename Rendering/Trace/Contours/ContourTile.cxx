// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Contours/ContourTile.h"

#include "Core/Shape/Shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
constexpr double kInfinity = std::numeric_limits<double>::infinity();
} // namespace

ContourTile::ContourTile(TileVisit& tile, const ContourEffort& effort)
  : Tile(tile)
  , Effort(effort)
  , Across(static_cast<std::size_t>(tile.Area().Width()) + 1)
  , Up(static_cast<std::size_t>(tile.Area().Height()) + 1)
  , Edges((Across - 1) * Up + Across * (Up - 1), State::Out)
  , Parts(Edges.size(), 0)
{
  const SampleBuffers& samples = tile.Corners();
  const TileArea& area = tile.Area();
  Corners.reserve(samples.Size());
  for (std::size_t i = 0; i < samples.Size(); ++i)
  {
    Corners.push_back(EndOf(samples, i,
      { area.x0 + static_cast<double>(i % Across), area.y0 + static_cast<double>(i / Across) }));
  }
}

EdgeEnd ContourTile::EndOf(
  const SampleBuffers& samples, std::size_t i, const ImagePosition& position) const
{
  EdgeEnd end;
  end.position = position;
  const auto verdict = static_cast<PixelVerdict>(samples.verdict[i]);
  end.unknown = verdict == PixelVerdict::Unknown;
  if (verdict == PixelVerdict::Exact)
  {
    end.layer = samples.layer[i];
    end.element = static_cast<int>(samples.element[i]);
    end.point.x = samples.position[i];
    end.point.xi = samples.xi[i];
    end.point.value = samples.value[i];
    end.point.eta =
      ReferenceToTensor(Tile.GetScene().locator->GetMesh().ShapeOf(end.element), end.point.xi);
  }
  return end;
}

SurfaceEdge ContourTile::EdgeBetween(const EdgeEnd& a, const EdgeEnd& b) const
{
  SurfaceEdge edge;
  edge.sagitta = TheSurface->IsFlat() ? 0.0 : kInfinity;
  const auto place = [&](const EdgeEnd& end)
  {
    if (end.layer == Layer)
    {
      return end.point.x;
    }
    const auto hits = HitsOf(*TheSurface, Tile.GetCamera().At(end.position[0], end.position[1]));
    if (hits.empty())
    {
      edge.sagitta = kInfinity;
      return Vec3(0.0);
    }
    return hits.front().position;
  };
  edge.from = place(a);
  edge.to = place(b);
  return edge;
}

std::vector<int> ContourTile::ElementsNear() const
{
  const ElementIndex& index = Tile.GetScene().locator->Index();
  Box3 box{ Vec3(kInfinity), Vec3(-kInfinity) };
  bool known = TheSurface->IsFlat();
  for (const std::size_t i : { std::size_t{ 0 }, Across - 1, Across * (Up - 1), Across * Up - 1 })
  {
    const SurfaceEdge edge = EdgeBetween(Corners[i], Corners[i]);
    known = known && std::isfinite(edge.sagitta);
    box.lower = glm::min(box.lower, edge.from);
    box.upper = glm::max(box.upper, edge.from);
  }
  const Vec3 margin = 1e-12 * (glm::abs(box.lower) + glm::abs(box.upper));
  box.lower -= margin;
  box.upper += margin;
  std::vector<int> elements;
  index.FindNear(known ? box : index.Bounds(), elements);
  return elements;
}

void ContourTile::Judge(const ContouredLayer& layer)
{
  Layer = layer.number;
  TheSurface = Tile.GetScene().layers[static_cast<std::size_t>(Layer)].surface.get();
  const EdgeJudge judge(*layer.bounds, layer.values, ElementsNear());
  if (!judge.IsNeeded())
  {
    return;
  }
  Judging = &judge;
  std::vector<Part> open;
  std::vector<Part> run;
  std::size_t edge = 0;
  const auto visit = [&](std::size_t a, std::size_t b)
  {
    if (Edges[edge] != State::In)
    {
      Part part{ edge, Corners[a], Corners[b] };
      const EdgeFinding finding = JudgeWithin(part);
      if (finding == EdgeFinding::Uncovered)
      {
        run.push_back(std::move(part));
        ++edge;
        return;
      }
      Settle(part, finding, 0, open);
    }
    SettleRun(run, open);
    run.clear();
    ++edge;
  };
  for (std::size_t i = 0; i < Up; ++i)
  {
    for (std::size_t j = 0; j + 1 < Across; ++j)
    {
      visit(i * Across + j, i * Across + j + 1);
    }
    SettleRun(run, open);
    run.clear();
  }
  edge = (Across - 1) * Up;
  for (std::size_t j = 0; j < Across; ++j)
  {
    for (std::size_t i = 0; i + 1 < Up; ++i)
    {
      visit(i * Across + j, (i + 1) * Across + j);
    }
    SettleRun(run, open);
    run.clear();
  }
  Refine(std::move(open));
}

EdgeFinding ContourTile::JudgeWithin(const Part& part) const
{
  const EdgeEnd& a = part.a;
  const EdgeEnd& b = part.b;
  if (a.layer >= 0 && b.layer >= 0 && a.layer != Layer && b.layer != Layer)
  {
    // Another layer hides this one at both ends.
    return EdgeFinding::Out;
  }
  return a.layer == Layer && b.layer == Layer && a.element == b.element
    ? Judging->Within(a, b, EdgeBetween(a, b))
    : EdgeFinding::Uncovered;
}

void ContourTile::SettleRun(std::span<const Part> run, std::vector<Part>& open)
{
  if (run.empty())
  {
    return;
  }
  // Together they are a straight edge.
  const SurfaceEdge all = EdgeBetween(run.front().a, run.back().b);
  if (run.size() > 1 && (Judging->IsFar(all) || Judging->IsExcluded(all, false)))
  {
    return;
  }
  if (run.size() == 1)
  {
    SettlePart(run.front(), 0, open);
    return;
  }
  SettleRun(run.first(run.size() / 2), open);
  SettleRun(run.subspan(run.size() / 2), open);
}

void ContourTile::Settle(const Part& part, EdgeFinding finding, int level, std::vector<Part>& open)
{
  if (finding == EdgeFinding::Out)
  {
    return;
  }
  if (finding == EdgeFinding::In || finding == EdgeFinding::Touching)
  {
    Edges[part.edge] = State::In;
    return;
  }
  const int deepest = finding == EdgeFinding::Open ? Effort.halvings : Effort.crossings;
  if (level < deepest && Parts[part.edge] < Effort.parts)
  {
    ++Parts[part.edge];
    open.push_back(part);
    return;
  }
  if (part.a.layer == Layer && part.b.layer == Layer && Judging->AreOpposite(part.a, part.b))
  {
    Edges[part.edge] = State::In;
    Counted.jumps += Judging->IsJump(part.a, part.b, EdgeBetween(part.a, part.b)) ? 1 : 0;
    return;
  }
  Edges[part.edge] = std::max(Edges[part.edge], State::Undecided);
}

void ContourTile::SettlePart(const Part& part, int level, std::vector<Part>& open)
{
  if (Edges[part.edge] == State::In)
  {
    return;
  }
  EdgeFinding finding = JudgeWithin(part);
  if (finding == EdgeFinding::Uncovered)
  {
    const SurfaceEdge edge = EdgeBetween(part.a, part.b);
    if (Judging->IsFar(edge) || Judging->IsExcluded(edge, true))
    {
      finding = EdgeFinding::Out;
    }
  }
  Settle(part, finding, level, open);
}

void ContourTile::Refine(std::vector<Part> parts)
{
  const Buffer wanted =
    Buffer::Value | Buffer::Xi | Buffer::Element | Buffer::Position | Buffer::Layer;
  for (int level = 1; !parts.empty(); ++level)
  {
    std::erase_if(parts, [this](const Part& part) { return Edges[part.edge] == State::In; });
    std::vector<ImagePosition> middles;
    for (const Part& part : parts)
    {
      middles.push_back({ 0.5 * (part.a.position[0] + part.b.position[0]),
        0.5 * (part.a.position[1] + part.b.position[1]) });
      Parts[part.edge] = 0;
    }
    if (parts.empty())
    {
      return;
    }
    const SampleBuffers samples = Tile.Trace(middles, wanted);
    std::vector<Part> open;
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      const EdgeEnd middle = EndOf(samples, i, middles[i]);
      SettlePart({ parts[i].edge, parts[i].a, middle }, level, open);
      SettlePart({ parts[i].edge, middle, parts[i].b }, level, open);
    }
    Counted.samples += static_cast<std::int64_t>(middles.size());
    parts = std::move(open);
  }
}

std::vector<ContourVerdict> ContourTile::Verdicts() const
{
  std::vector<ContourVerdict> verdicts;
  const std::size_t ups = (Across - 1) * Up;
  for (std::size_t i = 0; i + 1 < Up; ++i)
  {
    for (std::size_t j = 0; j + 1 < Across; ++j)
    {
      const std::size_t across = i * (Across - 1) + j;
      const std::size_t up = ups + j * (Up - 1) + i;
      const State state =
        std::max({ Edges[across], Edges[across + Across - 1], Edges[up], Edges[up + Up - 1] });
      verdicts.push_back(state == State::In ? ContourVerdict::In
          : state == State::Undecided       ? ContourVerdict::Undecided
                                            : ContourVerdict::Out);
    }
  }
  return verdicts;
}
} // namespace pixelexact
