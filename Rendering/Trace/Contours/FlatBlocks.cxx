// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Contours/FlatBlocks.h"

#include <algorithm>
#include <array>

namespace pixelexact
{
namespace
{
/// Pixels along a side, up to which blocks are held against all elements that they may meet.
constexpr int kBlock = 8;
/// And up to which more is found out about these for it.
constexpr int kThorough = 2;
} // namespace

FlatBlocks::FlatBlocks(const LayerSight& sight, TileVisit& tile)
  : Sight(sight)
  , Centres(tile.Centres())
  , Area(tile.Area())
{
}

EdgeEnd FlatBlocks::EndAt(int x, int y) const
{
  return Sight.EndOf(Centres->samples, Centres->At(x, y), { x + 0.5, y + 0.5 });
}

FlatBlocks::Corner FlatBlocks::CornerAt(int x, int y)
{
  Corner one;
  Corner& corner = Corners.empty()
    ? one
    : Corners[static_cast<std::size_t>(y - Area.y0) * static_cast<std::size_t>(Area.Width() + 1) +
        static_cast<std::size_t>(x - Area.x0)];
  if (!corner.isKnown)
  {
    EdgeEnd end;
    end.position = { static_cast<double>(x), static_cast<double>(y) };
    Sight.MeetPlane(end);
    corner = { true, end.meets, end.isAhead, end.point.x };
  }
  return corner;
}

std::array<FlatBlocks::Corner, Outline::kMostCorners> FlatBlocks::CornersOf(const TileArea& pixels)
{
  return { CornerAt(pixels.x0, pixels.y0), CornerAt(pixels.x1, pixels.y0),
    CornerAt(pixels.x1, pixels.y1), CornerAt(pixels.x0, pixels.y1) };
}

bool FlatBlocks::IsBeyond(const TileArea& pixels)
{
  std::array<EdgeEnd, Outline::kMostCorners> ends;
  const auto corners = CornersOf(pixels);
  for (std::size_t k = 0; k < ends.size(); ++k)
  {
    ends[k].isAhead = corners[k].isAhead;
    ends[k].point.x = corners[k].x;
  }
  return Sight.IsPlaneBeyond(ends);
}

std::optional<Outline> FlatBlocks::OutlineOf(const TileArea& pixels)
{
  const auto found = CornersOf(pixels);
  if (!std::ranges::all_of(found, &Corner::meets))
  {
    return std::nullopt;
  }
  return Outline(std::array{ found[0].x, found[1].x, found[2].x, found[3].x });
}

FlatBlocks::Finding FlatBlocks::JudgeInside(const EdgeJudge& judge, const TileArea& block)
{
  const int x = block.x0;
  const int y = block.y0;
  // Of a single row or column the next one serves, in the same pair of pixels.
  const auto next = [](int at, int width, int from, int to)
  { return width > 1 ? at + width - 1 : ((at ^ 1) < to ? at ^ 1 : std::max(at - 1, from)); };
  const int right = next(x, block.Width(), Area.x0, Area.x1);
  const int above = next(y, block.Height(), Area.y0, Area.y1);
  if (right == x || above == y || !ShowsAt(x, y) || !ShowsAt(right, y) || !ShowsAt(x, above))
  {
    return Finding::Uncovered;
  }
  const std::vector<std::int64_t>& elements = Centres->samples.element;
  const std::int64_t element = elements[Centres->At(x, y)];
  if (elements[Centres->At(right, y)] != element || elements[Centres->At(x, above)] != element)
  {
    return Finding::Uncovered;
  }
  const std::array<EdgeEnd, 3> ends{ EndAt(x, y), EndAt(right, y), EndAt(x, above) };
  const int side = judge.SideOf(ends[0].point.value);
  if (judge.SideOf(ends[1].point.value) != side || judge.SideOf(ends[2].point.value) != side)
  {
    return Finding::Open;
  }
  const std::optional<Outline> outline = OutlineOf(block);
  const std::optional<Interval> values = outline ? judge.Over(ends, *outline) : std::nullopt;
  return !values ? Finding::Uncovered : judge.Meets(*values) ? Finding::Open : Finding::Out;
}

bool FlatBlocks::IsOutAnyhow(const EdgeJudge& judge, const TileArea& block)
{
  int side = EdgeJudge::kNoSide;
  for (int y = block.y0; y < block.y1; ++y)
  {
    for (int x = block.x0; x < block.x1; ++x)
    {
      if (ShowsAt(x, y))
      {
        const int its = judge.SideOf(Centres->samples.value[Centres->At(x, y)]);
        if (side != EdgeJudge::kNoSide && its != side)
        {
          return false;
        }
        side = its;
      }
    }
  }
  if (side != EdgeJudge::kNoSide && std::max(block.Width(), block.Height()) > kBlock)
  {
    return false;
  }
  const std::optional<Outline> outline = OutlineOf(block);
  return outline && judge.BlockStaysOn(side, *outline, block.Width() <= kThorough);
}

void FlatBlocks::Settle(const EdgeJudge& judge, const TileArea& block)
{
  if (IsBeyond(block))
  {
    return;
  }
  const Finding finding = JudgeInside(judge, block);
  if (finding == Finding::Out || (finding == Finding::Uncovered && IsOutAnyhow(judge, block)))
  {
    return;
  }
  if (block.Width() == 1 && block.Height() == 1)
  {
    Open[static_cast<std::size_t>(block.y0 - Area.y0) * static_cast<std::size_t>(Area.Width()) +
      static_cast<std::size_t>(block.x0 - Area.x0)] = 1;
    return;
  }
  const int x = block.x0 + (block.Width() + 1) / 2;
  const int y = block.y0 + (block.Height() + 1) / 2;
  for (const TileArea& part :
    { TileArea{ block.x0, block.y0, x, y }, TileArea{ x, block.y0, block.x1, y },
      TileArea{ block.x0, y, x, block.y1 }, TileArea{ x, y, block.x1, block.y1 } })
  {
    if (part.Width() > 0 && part.Height() > 0)
    {
      Settle(judge, part);
    }
  }
}

std::vector<std::uint8_t> FlatBlocks::FindOpen(const EdgeJudge& judge)
{
  const auto width = static_cast<std::size_t>(Area.Width());
  const auto height = static_cast<std::size_t>(Area.Height());
  Corners.resize((width + 1) * (height + 1));
  Open.assign(width * height, 0);
  Settle(judge, Area);
  return Open;
}
} // namespace pixelexact
