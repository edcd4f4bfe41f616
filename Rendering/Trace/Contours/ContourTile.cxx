// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Contours/ContourTile.h"

#include "Core/Shape/Shape.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Distance of two hits over that of their rays, where the surface is taken to go on between them.
constexpr double kSteepest = 64.0;
/// Sagitta over chord of the edges on curved surfaces that are held against other elements.
constexpr double kBulge = 0.25;
} // namespace

ContourTile::ContourTile(TileVisit& tile, const ContourMethod& method)
  : Tile(tile)
  , Method(method)
  , Across(static_cast<std::size_t>(tile.Area().Width()) + 1)
  , Up(static_cast<std::size_t>(tile.Area().Height()) + 1)
  , Edges((Across - 1) * Up + Across * (Up - 1), State::Out)
  , Parts(Edges.size(), 0)
{
  const SampleBuffers& samples = tile.Corners();
  const TileArea& area = tile.Area();
  Corners.reserve(samples.Size());
  std::size_t i = 0;
  for (int y = area.y0; y <= area.y1; ++y)
  {
    for (int x = area.x0; x <= area.x1; ++x, ++i)
    {
      Corners.push_back(EndOf(samples, i, { static_cast<double>(x), static_cast<double>(y) }));
    }
  }
}

EdgeEnd ContourTile::EndOf(
  const SampleBuffers& samples, std::size_t i, const ImagePosition& position) const
{
  EdgeEnd end;
  end.position = position;
  if (samples.verdict[i] == static_cast<std::uint8_t>(PixelVerdict::Exact))
  {
    end.layer = samples.layer[i];
    end.element = static_cast<int>(samples.element[i]);
    end.point.x = samples.position[i];
    end.point.xi = samples.xi[i];
    end.point.value = samples.value[i];
    end.piece = samples.piece[i];
    end.parameters[0] = samples.pieceU[i];
    end.parameters[1] = samples.pieceV[i];
    end.point.eta =
      ReferenceToTensor(Tile.GetScene().locator->GetMesh().ShapeOf(end.element), end.point.xi);
  }
  return end;
}

SurfaceEdge ContourTile::EdgeBetween(const EdgeEnd& a, const EdgeEnd& b) const
{
  SurfaceEdge edge{ a.point.x, b.point.x, kInfinity };
  const Camera& camera = Tile.GetCamera();
  const auto rayOf = [&](const EdgeEnd& end)
  { return camera.At(end.position[0], end.position[1]); };
  if (!TheSurface->IsPlane())
  {
    if (a.layer == Layer && b.layer == Layer)
    {
      edge.sagitta = TheSurface->Sagitta(rayOf(a), a.OnSurface(), rayOf(b), b.OnSurface());
    }
    return edge;
  }
  // A plane goes on where the mesh ends.
  edge.sagitta = 0.0;
  const auto place = [&](const EdgeEnd& end, Vec3& x)
  {
    if (end.layer != Layer)
    {
      const auto hits = HitsOf(*TheSurface, rayOf(end));
      edge.sagitta = hits.empty() ? kInfinity : edge.sagitta;
      x = hits.empty() ? Vec3(0.0) : hits.front().position;
    }
  };
  place(a, edge.from);
  place(b, edge.to);
  return edge;
}

std::vector<int> ContourTile::ElementsNear() const
{
  const ElementIndex& index = Tile.GetScene().locator->Index();
  Box3 box{ Vec3(kInfinity), Vec3(-kInfinity) };
  bool known = true;
  for (const std::size_t i : { std::size_t{ 0 }, Across - 1, Across * (Up - 1), Across * Up - 1 })
  {
    const SurfaceEdge edge = EdgeBetween(Corners[i], Corners[i]);
    known = known && std::isfinite(edge.sagitta);
    box.lower = glm::min(box.lower, edge.from);
    box.upper = glm::max(box.upper, edge.from);
  }
  const Vec3 margin = 1e-12 * (glm::abs(box.lower) + glm::abs(box.upper));
  std::vector<int> elements;
  index.FindNear(known ? Box3{ box.lower - margin, box.upper + margin } : index.Bounds(), elements);
  return elements;
}

template <class Visit, class EndRow>
void ContourTile::ForEachEdge(const Visit& visit, const EndRow& endRow) const
{
  for (std::size_t i = 0; i < Up; ++i)
  {
    for (std::size_t j = 0; j + 1 < Across; ++j)
    {
      visit(i * Across + j, i * Across + j + 1);
    }
    endRow();
  }
  for (std::size_t j = 0; j < Across; ++j)
  {
    for (std::size_t i = 0; i + 1 < Up; ++i)
    {
      visit(i * Across + j, (i + 1) * Across + j);
    }
    endRow();
  }
}

void ContourTile::Judge(const ContouredLayer& layer)
{
  Layer = layer.number;
  TheSurface = Tile.GetScene().layers[static_cast<std::size_t>(Layer)].surface.get();
  if (!layer.bounds->CanProve())
  {
    LeaveOpen();
    return;
  }
  if (!TheSurface->HasSagitta())
  {
    const Interval& range = layer.bounds->Values();
    const auto first = std::ranges::lower_bound(layer.values, range.lower);
    if (first != layer.values.end() && *first <= range.upper)
    {
      LeaveOpen();
    }
    return;
  }
  const EdgeJudge judge = TheSurface->IsPlane()
    ? EdgeJudge(*layer.bounds, layer.values, ElementsNear())
    : EdgeJudge(*layer.bounds, layer.values);
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
      const Part part{ edge, Corners[a], Corners[b] };
      const bool jumps = MayJump(part);
      const EdgeFinding finding = jumps ? EdgeFinding::Out : JudgeWithin(part);
      if (finding == EdgeFinding::Uncovered)
      {
        run.push_back(part);
        ++edge;
        return;
      }
      if (jumps)
      {
        SettlePart(part, 0, open);
      }
      Settle(part, finding, 0, open);
    }
    SettleRun(run, open);
    run.clear();
    ++edge;
  };
  ForEachEdge(visit,
    [&]
    {
      SettleRun(run, open);
      run.clear();
    });
  Refine(std::move(open));
}

void ContourTile::LeaveOpen()
{
  std::size_t edge = 0;
  const auto visit = [&](std::size_t a, std::size_t b)
  {
    if (Corners[a].layer == Layer || Corners[b].layer == Layer)
    {
      Edges[edge] = std::max(Edges[edge], State::Undecided);
    }
    ++edge;
  };
  ForEachEdge(visit, [] {});
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

/// Whether two hits are about as far apart as their rays: a surface that goes on between them.
bool ContourTile::AreJoined(const EdgeEnd& a, const EdgeEnd& b) const
{
  if (TheSurface->IsPlane())
  {
    return true;
  }
  const Camera& camera = Tile.GetCamera();
  const Ray first = camera.At(a.position[0], a.position[1]);
  const Ray second = camera.At(b.position[0], b.position[1]);
  const double depth = glm::distance(first.origin, a.point.x);
  const double apart = glm::distance(a.point.x, second.origin + depth * second.direction);
  return glm::distance(a.point.x, b.point.x) <= kSteepest * apart;
}

int ContourTile::SideOf(const Part& part) const
{
  return part.a.layer == Layer ? Judging->SideOf(part.a.point.value)
    : part.b.layer == Layer    ? Judging->SideOf(part.b.point.value)
                               : EdgeJudge::kNoSide;
}

bool ContourTile::MayJump(const Part& part) const
{
  return part.a.layer == Layer && part.b.layer == Layer && part.a.element != part.b.element &&
    Judging->AreOpposite(part.a, part.b);
}

void ContourTile::SettleRun(std::span<const Part> run, std::vector<Part>& open)
{
  if (run.empty())
  {
    return;
  }
  if (run.size() > 1 && TheSurface->IsPlane())
  {
    // Together they are a straight edge.
    const SurfaceEdge all = EdgeBetween(run.front().a, run.back().b);
    const int side = SideOf(run.front());
    if (std::ranges::all_of(run, [&](const Part& part) { return SideOf(part) == side; }) &&
      Judging->StaysOn(side, all, false))
    {
      return;
    }
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
  const bool onBoth = part.a.layer == Layer && part.b.layer == Layer;
  if (!TheSurface->IsPlane())
  {
    if (!onBoth && part.a.layer != Layer && part.b.layer != Layer)
    {
      // Whether the surface shows between two rays that do not see it is not asked.
      return;
    }
  }
  const int deepest = finding == EdgeFinding::Open ? Method.halvings : Method.crossings;
  if (level < deepest && Parts[part.edge] < Method.parts)
  {
    ++Parts[part.edge];
    open.push_back(part);
    return;
  }
  const bool joined = onBoth && AreJoined(part.a, part.b);
  const bool opposite = onBoth && Judging->AreOpposite(part.a, part.b);
  if (joined && opposite && finding == EdgeFinding::Uncovered)
  {
    Edges[part.edge] = State::In;
    Counted.jumps += Judging->IsJump(part.a, part.b, EdgeBetween(part.a, part.b)) ? 1 : 0;
    return;
  }
  if (level >= deepest && !joined && !opposite && !TheSurface->IsPlane())
  {
    // Closer to a silhouette, or to where the surface leaves the mesh, nothing is asked. Where a
    // value is between those of two sheets it stays open whether that is a line.
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
    const bool inReach = edge.sagitta <= kBulge * glm::distance(edge.from, edge.to);
    if (inReach && !MayJump(part) && Judging->StaysOn(SideOf(part), edge, true))
    {
      finding = EdgeFinding::Out;
    }
  }
  Settle(part, finding, level, open);
}

void ContourTile::Refine(std::vector<Part> parts)
{
  const Buffer wanted =
    Buffer::Value | Buffer::Xi | Buffer::Element | Buffer::Position | Buffer::Layer | Buffer::Piece;
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
      const State state =
        std::max({ Edges[across], Edges[across + Across - 1], Edges[up], Edges[up + Up - 1] });
      *verdict = static_cast<std::uint8_t>(state == State::In ? ContourVerdict::In
          : state == State::Undecided                         ? ContourVerdict::Undecided
                                                              : ContourVerdict::Out);
    }
  }
}
} // namespace pixelexact
