// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/FigureLegend.h"

#include "Base/Report.h"
#include "Scene/Shot.h"

#include "Trace/Projection.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pixelexact
{
namespace
{
// Lengths in units of the font's size.
constexpr double kRow = 1.6;
constexpr double kRowOfStrip = 1.5;
constexpr double kTopOfStrip = 6.0;
constexpr std::size_t kRowsOfStrip = 4;
constexpr double kNameRow = 1.3;
constexpr double kBarWidth = 1.2;
constexpr double kMinBarAcross = 14.0;
constexpr double kMinBarUpright = 8.0;
constexpr double kArrow = 1.0;

/// The largest of 1, 2 or 5 times a power of ten that is not above a positive number.
double RoundBelow(double limit)
{
  const double power = std::pow(10.0, std::floor(std::log10(limit)));
  return power * (limit >= 5.0 * power ? 5.0 : limit >= 2.0 * power ? 2.0 : 1.0);
}

std::vector<Tick> TicksOf(const FigureBar& bar, int most)
{
  if (!bar.ticks.empty())
  {
    std::vector<double> within;
    std::ranges::copy_if(bar.ticks, std::back_inserter(within),
      [&bar](double value) { return value >= bar.range[0] && value <= bar.range[1]; });
    std::ranges::sort(within);
    return TicksAt(within);
  }
  const int count = std::min(bar.tickCount.value_or(most), most);
  return bar.bands ? TicksOfBands(bar.range, bar.logarithm, *bar.bands, count)
                   : TicksOfBar(bar.range, bar.logarithm, count);
}
} // namespace

FigureLegend::FigureLegend(Canvas& canvas, const FigureLayout& layout, const Rgba& ink)
  : To(canvas)
  , Layout(layout)
  , Ink(ink)
  , Font(layout.font)
  , Pen(std::max(1.0, layout.font / 20.0))
  , Taken(layout.legendBelow ? layout.size.width - 0.5 * layout.font : 0.0)
{
}

CanvasPoint FigureLegend::NextRows(std::size_t rows)
{
  if (!Layout.legendBelow)
  {
    Taken = std::max(Taken, 0.6 * Font);
    const double top = Taken + (static_cast<double>(rows) - 0.5) * kRow * Font;
    Taken += static_cast<double>(rows) * kRow * Font;
    return { static_cast<double>(Layout.size.width - (kColumn - 1) * Font), top };
  }
  if (Rows == 0 || Rows + rows > kRowsOfStrip)
  {
    Taken -= kColumn * Font;
    Rows = 0;
  }
  const CanvasPoint at{ Taken + 0.5 * Font,
    (kTopOfStrip - kRowOfStrip * static_cast<double>(Rows)) * Font };
  Rows += rows;
  return at;
}

void FigureLegend::Write(const std::string& text, const CanvasPoint& at, double room)
{
  To.Write(To.Shortened(text, room), at[0], at[1], TextAnchor::Left, Ink);
}

void FigureLegend::AddMark(const ColorMark& mark)
{
  const double room = (kColumn - 2.5) * Font;
  const std::vector<std::string> lines = To.Wrapped(mark.text, room);
  const CanvasPoint at = NextRows(lines.size());
  const int x = static_cast<int>(at[0]);
  const int y = static_cast<int>(at[1]) - Font / 2;
  To.Fill(x, y, Font, Font, mark.color);
  To.Frame(x, y, Font, Font, Ink);
  for (std::size_t k = 0; k < lines.size(); ++k)
  {
    const double row = (Layout.legendBelow ? kRowOfStrip : kRow) * static_cast<double>(k);
    Write(lines[k], { at[0] + 1.5 * Font, at[1] - row * Font }, room);
  }
}

void FigureLegend::AddText(const std::string& text)
{
  Write(text, NextRows(1), (kColumn - 1.0) * Font);
}

void FigureLegend::AddArrow(const FigureArrow& arrow)
{
  const double room = (kColumn - 1.2) * Font;
  const CanvasPoint at = NextRows(2);
  const double y = at[1] - (Layout.legendBelow ? kRowOfStrip : kRow) * Font;
  Write(arrow.field, at, room);
  const double limit = std::min(arrow.longest, (kColumn - 5.0) * Font / arrow.pixelsPerValue);
  double end = at[0];
  double length = 0.0;
  if (limit > 0.0 && std::isfinite(limit))
  {
    length = RoundBelow(limit);
    end += length * arrow.pixelsPerValue + 0.6 * Font;
    arrow.draw({ at[0], y }, { at[0] + length * arrow.pixelsPerValue, y });
  }
  Write(WithMinus(Short(length)), { end, y }, room);
}

void FigureLegend::AddDirections(const CameraView& view)
{
  const auto [forward, right, up] = AxesOf(view);
  const double length = 2.2 * Font;
  CanvasPoint centre{ Layout.size.width - (kColumn - 4.0) * Font, 3.5 * Font };
  if (Layout.legendBelow)
  {
    centre = { Taken - 3.0 * Font, 3.5 * Font };
    Taken -= 6.5 * Font;
    Rows = 0;
  }
  else
  {
    Taken += 7.0 * Font;
  }
  constexpr std::array<Rgba, 3> kColors{ Rgba{ 200, 40, 40, 255 }, Rgba{ 30, 140, 50, 255 },
    Rgba{ 50, 80, 220, 255 } };
  std::array<int, 3> order{ 0, 1, 2 };
  std::ranges::sort(order, [&axis = forward](int a, int b) { return axis[a] > axis[b]; });
  for (const int d : order)
  {
    const Rgba& color = kColors[static_cast<std::size_t>(d)];
    const double across = length * right[d];
    const double along = length * up[d];
    To.Line(centre, { centre[0] + across, centre[1] + along }, std::max(1.5, Font / 9.0), color);
    // An axis that points at the viewer has no end to be named.
    if (const double seen = std::hypot(across, along); seen > 0.15 * length)
    {
      const double further = 1.0 + 0.6 * Font / seen;
      To.Write(std::string(1, "xyz"[d]), centre[0] + further * across, centre[1] + further * along,
        TextAnchor::Centre, color);
    }
  }
}

void FigureLegend::AddScale(double unit, const std::string& name)
{
  const double length = RoundBelow(7.0 * Font * unit);
  double left = Layout.size.width - (kColumn - 1.0) * Font;
  double y = Taken + 0.7 * Font;
  if (Layout.legendBelow)
  {
    Taken -= 9.0 * Font;
    Rows = 0;
    left = Taken;
    y = 3.0 * Font;
  }
  else
  {
    Taken += 2.6 * Font;
  }
  const double end = left + length / unit;
  To.Line(CanvasPoint{ left, y }, { end, y }, std::max(1.5, Font / 9.0), Ink);
  for (const double x : { left, end })
  {
    To.Line(CanvasPoint{ x, y - 0.3 * Font }, { x, y + 0.3 * Font }, Pen, Ink);
  }
  To.Write(WithMinus(Short(length)) + (name.empty() ? "" : " " + name), 0.5 * (left + end),
    y + 0.9 * Font, TextAnchor::Centre, Ink);
}

int FigureLegend::MaxTicks(int length, bool isUpright) const
{
  return std::max(2, length / ((isUpright ? 2 : 5) * Font));
}

void FigureLegend::AddBars(const std::vector<FigureBar>& bars)
{
  if (Layout.isOfSeries && Layout.legendBelow && Rows == 0)
  {
    Taken -= kColumn * Font; // other pictures may have rows
  }
  const double room = Layout.legendBelow
    ? Taken - Layout.corner[0]
    : Layout.corner[1] + Layout.picture.height - 0.3 * Font - Taken;
  const auto most = static_cast<std::size_t>(
    std::max(1.0, room / ((Layout.legendBelow ? kMinBarAcross : kMinBarUpright) * Font)));
  const std::size_t count = std::min(bars.size(), most);
  if (count < bars.size())
  {
    Warn(fmt::format(
      "--figure: {} of {} colour bars have room; choose a larger --size", count, bars.size()));
  }
  const double share = room / static_cast<double>(std::max<std::size_t>(1, count));
  for (std::size_t k = 0; k < count; ++k)
  {
    if (Layout.legendBelow)
    {
      AddBarBelow(bars[k], Layout.corner[0] + static_cast<double>(k) * share, share);
    }
    else
    {
      AddBarBeside(bars[k], Taken + room - static_cast<double>(k) * share, share);
    }
  }
}

void FigureLegend::AddBarBelow(const FigureBar& bar, double left, double room)
{
  const int inner = static_cast<int>(room - 2.0 * Font);
  const std::vector<Tick> ticks = TicksOf(bar, MaxTicks(inner, false));
  // The texts of the ends are within the room.
  const auto half = [&](const Tick& tick) { return 0.5 * To.WidthOf(tick.text) + 0.3 * Font; };
  const double begin = ticks.empty() ? Font : std::max(0.5 * Font, half(ticks.front()));
  const double end = ticks.empty() ? Font : std::max<double>(Font, half(ticks.back()));
  const double width = room - begin - end;
  Write(bar.name, { left + begin, (kTopOfStrip - 0.6) * Font }, width);
  DrawBar(bar,
    { static_cast<int>(left + begin), 3 * Font, std::max(Font, static_cast<int>(width)),
      static_cast<int>(kBarWidth * Font) },
    false);
}

void FigureLegend::AddBarBeside(const FigureBar& bar, double top, double room)
{
  const int left = Layout.size.width - (kColumn - 1) * Font;
  const double width = (kColumn - 1.2) * Font;
  double y = top - 0.7 * Font;
  for (const std::string& line : To.Wrapped(bar.name, width))
  {
    Write(line, { static_cast<double>(left), y }, width);
    y -= kNameRow * Font;
  }
  const double height =
    std::min(y - (top - room) - Font, 0.6 * static_cast<double>(Layout.size.height));
  const int length = std::max(Font, static_cast<int>(height));
  DrawBar(
    bar, { left, static_cast<int>(y) - length, static_cast<int>(kBarWidth * Font), length }, true);
}

void FigureLegend::DrawBar(const FigureBar& bar, Box box, bool isUpright)
{
  // Arrows take their room from the bar, in a series also where there are none.
  int& length = isUpright ? box.height : box.width;
  int& begin = isUpright ? box.y : box.x;
  const int arrow = static_cast<int>(kArrow * Font);
  const int below = bar.beyond[0] || Layout.isOfSeries ? arrow : 0;
  const int above = bar.beyond[1] || Layout.isOfSeries ? arrow : 0;
  length -= below + above;
  begin += below;
  length = std::max(length, 1);
  DrawColors(bar, box, isUpright);
  To.Frame(box.x, box.y, box.width, box.height, Ink);
  for (const bool isUpper : { false, true })
  {
    if (bar.beyond[isUpper ? 1 : 0])
    {
      DrawArrow(bar, box, isUpright, isUpper);
    }
  }
  DrawTicks(bar, box, isUpright);
}

void FigureLegend::DrawColors(const FigureBar& bar, const Box& box, bool isUpright)
{
  const int length = isUpright ? box.height : box.width;
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(length));
  for (int step = 0; step < length; ++step)
  {
    values.push_back(ValueInRange(bar.range, bar.logarithm, (step + 0.5) / length));
  }
  std::vector<std::uint8_t> colors(4 * values.size());
  bar.map(values, colors.data());
  for (int step = 0; step < length; ++step)
  {
    const std::uint8_t* from = &colors[4 * static_cast<std::size_t>(step)];
    const Rgba color{ from[0], from[1], from[2], 255 };
    // Extends to the next step, because viewers of PDF let the background through between them.
    const int thickness = std::min(2, length - step);
    if (isUpright)
    {
      To.Fill(box.x, box.y + step, box.width, thickness, color);
    }
    else
    {
      To.Fill(box.x + step, box.y, thickness, box.height, color);
    }
  }
}

void FigureLegend::DrawArrow(const FigureBar& bar, const Box& box, bool isUpright, bool isUpper)
{
  const double value = bar.range[isUpper ? 1 : 0];
  Rgba color{};
  bar.map({ &value, 1 }, color.data());
  color[3] = 255;
  const double length = isUpright ? box.height : box.width;
  const double width = isUpright ? box.width : box.height;
  const double base = isUpper ? length + 0.5 : -0.5;
  const double tip = base + (isUpper ? kArrow : -kArrow) * Font;
  std::array<CanvasPoint, 4> points{ CanvasPoint{ base, -0.5 }, { base, width + 0.5 },
    { tip, 0.5 * width }, { base, -0.5 } };
  for (CanvasPoint& point : points)
  {
    point = isUpright ? CanvasPoint{ box.x + point[1], box.y + point[0] }
                      : CanvasPoint{ box.x + point[0], box.y + point[1] };
  }
  To.FillPolygon(points, color);
  To.Line(points, 1.0, Ink);
}

void FigureLegend::DrawTicks(const FigureBar& bar, const Box& box, bool isUpright)
{
  const int length = isUpright ? box.height : box.width;
  const std::vector<Tick> ticks = TicksOf(bar, MaxTicks(length, isUpright));
  const auto place = [&](const Tick& tick)
  {
    const double part =
      bar.range[1] > bar.range[0] ? PartOfRange(bar.range, bar.logarithm, tick.value) : 0.5;
    // A line in the middle of a row of pixels is sharp.
    return std::floor(std::clamp(part * length, 0.0, length - 0.5)) + 0.5;
  };
  const auto extent = [&](const Tick& tick)
  { return isUpright ? 1.1 * Font : To.WidthOf(tick.text) + 0.6 * Font; };
  // The text of the last tick has precedence over those that would overlap with it.
  double free = -1e9;
  for (std::size_t k = 0; k < ticks.size(); ++k)
  {
    const Tick& tick = ticks[k];
    const double at = place(tick);
    const double half = 0.5 * extent(tick);
    const bool isLast = k + 1 == ticks.size();
    const bool hasRoom = at - half >= free &&
      (isLast || at + half <= place(ticks.back()) - 0.5 * extent(ticks.back()));
    free = hasRoom ? at + half : free;
    if (isUpright)
    {
      const double x = box.x + box.width;
      const double y = box.y + at;
      To.Line(CanvasPoint{ x + 1.0, y }, { x + 0.4 * Font, y }, Pen, Ink);
      if (hasRoom)
      {
        const double left = x + 0.7 * Font;
        To.WriteWithin(
          tick.text, left, y, TextAnchor::Left, Layout.size.width - 0.3 * Font - left, Ink);
      }
    }
    else
    {
      const double x = box.x + at;
      To.Line(CanvasPoint{ x, box.y - 1.0 }, { x, box.y - 0.4 * Font }, Pen, Ink);
      if (hasRoom)
      {
        To.Write(tick.text, x, box.y - 1.1 * Font, TextAnchor::Centre, Ink);
      }
    }
  }
}
} // namespace pixelexact
