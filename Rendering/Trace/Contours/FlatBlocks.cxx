// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Contours/FlatBlocks.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace pixelexact
{
namespace
{
/// Largest side, in pixels, of blocks that are tested against all elements that they may meet.
constexpr int kBlock = 8;
/// Largest side of blocks for which these elements are subdivided.
constexpr int kThorough = 4;
/// Largest side of blocks whose pixels are classified one by one from the block's bounds.
constexpr int kOneByOne = 2;
} // namespace

FlatBlocks::FlatBlocks(const LayerSight& sight, TileVisit& tile, std::optional<LatticePart> centres)
  : Sight(sight)
  , Centres(centres)
  , Area(tile.Area())
  , ShowsAll(tile.GetScene().layers.size() == 1 && tile.GetScene().kept.empty())
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

std::array<FlatBlocks::Corner, Outline::kMaxCorners> FlatBlocks::CornersOf(const TileArea& pixels)
{
  return { CornerAt(pixels.x0, pixels.y0), CornerAt(pixels.x1, pixels.y0),
    CornerAt(pixels.x1, pixels.y1), CornerAt(pixels.x0, pixels.y1) };
}

bool FlatBlocks::IsBeyond(const TileArea& pixels)
{
  std::array<EdgeEnd, Outline::kMaxCorners> ends;
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

EdgeFinding FlatBlocks::ClassifyInside(const EdgeClassifier& classifier, const TileArea& block)
{
  const int x = block.x0;
  const int y = block.y0;
  // A block of one row or column uses the centre of the other pixel of its pair.
  const auto next = [](int at, int width, int from, int to)
  { return width > 1 ? at + width - 1 : ((at ^ 1) < to ? at ^ 1 : std::max(at - 1, from)); };
  const int right = next(x, block.Width(), Area.x0, Area.x1);
  const int above = next(y, block.Height(), Area.y0, Area.y1);
  if (right == x || above == y || !ShowsAt(x, y) || !ShowsAt(right, y) || !ShowsAt(x, above))
  {
    return EdgeFinding::Uncovered;
  }
  const std::vector<std::int64_t>& elements = Centres->samples.element;
  const std::int64_t element = elements[Centres->At(x, y)];
  if (elements[Centres->At(right, y)] != element || elements[Centres->At(x, above)] != element)
  {
    return EdgeFinding::Uncovered;
  }
  const std::array<EdgeEnd, 3> ends{ EndAt(x, y), EndAt(right, y), EndAt(x, above) };
  const int side = classifier.SideOf(ends[0].point.value);
  const bool oneByOne = std::max(block.Width(), block.Height()) <= kOneByOne;
  if (!oneByOne &&
    (classifier.SideOf(ends[1].point.value) != side ||
      classifier.SideOf(ends[2].point.value) != side))
  {
    return EdgeFinding::Open;
  }
  const std::optional<Outline> outline = OutlineOf(block);
  const std::optional<PlanarValues> values =
    outline ? classifier.Over(ends, *outline) : std::nullopt;
  if (!values)
  {
    return EdgeFinding::Uncovered;
  }
  if (!classifier.Meets(values->values.lower, values->values.upper))
  {
    return EdgeFinding::Out;
  }
  if (oneByOne)
  {
    SettlePixels(classifier, block, *values);
  }
  return EdgeFinding::Open;
}

void FlatBlocks::SettlePixels(
  const EdgeClassifier& classifier, const TileArea& block, const PlanarValues& values)
{
  const double error = values.error;
  for (int y = block.y0; y < block.y1; ++y)
  {
    for (int x = block.x0; x < block.x1; ++x)
    {
      ContourVerdict& state = States[PixelAt(x, y)];
      if (state != ContourVerdict::Undecided)
      {
        continue;
      }
      const auto corners = CornersOf({ x, y, x + 1, y + 1 });
      if (!std::ranges::all_of(corners, &Corner::meets))
      {
        continue;
      }
      double lower = values.At(corners[0].x);
      double upper = lower;
      for (const Corner& corner : corners)
      {
        const double value = values.At(corner.x);
        lower = std::min(lower, value);
        upper = std::max(upper, value);
      }
      if (!classifier.Meets(lower - error, upper + error))
      {
        state = ContourVerdict::Out;
      }
      else if (ShowsAll && std::ranges::all_of(corners, &Corner::isAhead) &&
        lower + error < upper - error && classifier.Meets(lower + error, upper - error))
      {
        // The pixel's edge crosses the value inside the element.
        state = ContourVerdict::In;
      }
    }
  }
}

bool FlatBlocks::IsOpen(const TileArea& block) const
{
  for (int y = block.y0; y < block.y1; ++y)
  {
    const auto first = States.begin() + static_cast<std::ptrdiff_t>(PixelAt(block.x0, y));
    if (std::find(first, first + block.Width(), ContourVerdict::Undecided) != first + block.Width())
    {
      return true;
    }
  }
  return false;
}

void FlatBlocks::LeaveOut(const TileArea& block)
{
  for (int y = block.y0; y < block.y1; ++y)
  {
    const auto first = States.begin() + static_cast<std::ptrdiff_t>(PixelAt(block.x0, y));
    std::replace(first, first + block.Width(), ContourVerdict::Undecided, ContourVerdict::Out);
  }
}

bool FlatBlocks::IsOutAnyhow(const EdgeClassifier& classifier, const TileArea& block)
{
  const bool isLarge = std::max(block.Width(), block.Height()) > kBlock;
  int side = EdgeClassifier::kNoSide;
  double lower = std::numeric_limits<double>::infinity();
  double upper = -lower;
  for (int y = block.y0; y < block.y1; ++y)
  {
    for (int x = block.x0; x < block.x1; ++x)
    {
      if (ShowsAt(x, y))
      {
        if (isLarge)
        {
          return false;
        }
        const double value = Sight.ValueAt(Centres->samples, Centres->At(x, y));
        const int its = classifier.SideOf(value);
        lower = std::min(lower, value);
        upper = std::max(upper, value);
        if (side != EdgeClassifier::kNoSide && its != side)
        {
          return false;
        }
        side = its;
      }
    }
  }
  // Extrapolated linearly from the outermost centres to the block's edge, the field takes a value.
  const int steps = std::max(block.Width(), block.Height()) - 1;
  const double more = steps > 0 ? 0.5 * (upper - lower) / steps : 0.0;
  if (side != EdgeClassifier::kNoSide && steps > 0 && classifier.Meets(lower - more, upper + more))
  {
    return false;
  }
  const std::optional<Outline> outline = OutlineOf(block);
  return outline &&
    classifier.BlockStaysOn(
      side, *outline, side == EdgeClassifier::kNoSide || block.Width() <= kThorough);
}

void FlatBlocks::Settle(const EdgeClassifier& classifier, const TileArea& block)
{
  const EdgeFinding finding =
    !IsAhead && IsBeyond(block) ? EdgeFinding::Out : ClassifyInside(classifier, block);
  if (finding == EdgeFinding::Out ||
    (finding == EdgeFinding::Uncovered && IsOutAnyhow(classifier, block)))
  {
    LeaveOut(block);
    return;
  }
  if ((block.Width() == 1 && block.Height() == 1) || !IsOpen(block))
  {
    return;
  }
  const int x = block.x0 + (block.Width() + 1) / 2;
  const int y = block.y0 + (block.Height() + 1) / 2;
  for (const TileArea& part :
    { TileArea{ block.x0, block.y0, x, y }, TileArea{ x, block.y0, block.x1, y },
      TileArea{ block.x0, y, x, block.y1 }, TileArea{ x, y, block.x1, block.y1 } })
  {
    if (part.Width() > 0 && part.Height() > 0 && IsOpen(part))
    {
      Settle(classifier, part);
    }
  }
}

std::vector<ContourVerdict> FlatBlocks::Settle(
  const EdgeClassifier& classifier, std::span<const std::uint8_t> asked)
{
  const auto width = static_cast<std::size_t>(Area.Width());
  const auto height = static_cast<std::size_t>(Area.Height());
  Corners.resize((width + 1) * (height + 1));
  States.resize(width * height);
  std::ranges::transform(asked, States.begin(),
    [](std::uint8_t one) { return one != 0 ? ContourVerdict::Undecided : ContourVerdict::Out; });
  IsAhead = std::ranges::all_of(CornersOf(Area), &Corner::isAhead);
  Settle(classifier, Area);
  return std::move(States);
}
} // namespace pixelexact
