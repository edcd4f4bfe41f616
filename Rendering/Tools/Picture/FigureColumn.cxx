// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/FigureColumn.h"

#include "Base/Numbers.h"
#include "Base/Report.h"
#include "Drawing/Canvas.h"
#include "Drawing/Ticks.h"
#include "Scene/Shot.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pixelexact
{
FigureColumn::FigureColumn(Canvas& canvas, int left, int font, const Rgba& ink)
  : To(canvas)
  , Left(left)
  , Font(font)
  , Ink(ink)
{
}

void FigureColumn::DrawBar(
  const FigureBar& bar, int top, int height, bool logarithm, const std::optional<int>& bands)
{
  const int width = Font * 6 / 5;
  const double pen = std::max(1.0, Font / 20.0);
  const int y0 = top - height;
  const auto valueAt = [&](double part)
  {
    return logarithm ? bar.range[0] * std::pow(bar.range[1] / bar.range[0], part)
                     : std::lerp(bar.range[0], bar.range[1], part);
  };
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(height));
  for (int row = 0; row < height; ++row)
  {
    values.push_back(std::clamp(valueAt((row + 0.5) / height), bar.range[0], bar.range[1]));
  }
  std::vector<std::uint8_t> colors(4 * values.size());
  (*bar.map)(values, colors.data());
  for (int row = 0; row < height; ++row)
  {
    const std::uint8_t* color = &colors[4 * static_cast<std::size_t>(row)];
    // Extends to the row above, because viewers of PDF let the background through between rows.
    To.Fill(
      Left, y0 + row, width, std::min(2, height - row), { color[0], color[1], color[2], 255 });
  }
  To.Frame(Left, y0, width, height, Ink);
  const double length = bar.range[1] - bar.range[0];
  const int most = std::max(2, height / (2 * Font));
  for (const Tick& tick : bands ? TicksOfBands(bar.range, logarithm, *bands, most)
                                : TicksWithin(bar.range, logarithm, most))
  {
    double part = length > 0.0 ? (tick.value - bar.range[0]) / length : 0.5;
    if (logarithm && length > 0.0)
    {
      part = std::log(tick.value / bar.range[0]) / std::log(bar.range[1] / bar.range[0]);
    }
    // A line in the middle of a row of pixels is sharp.
    const double y = std::floor(y0 + part * height) + 0.5;
    To.Line(CanvasPoint{ Left + width + 1.0, y }, { Left + width + 0.4 * Font, y }, pen, Ink);
    To.Write(tick.text, Left + width + 0.7 * Font, y, TextAnchor::Left, Ink);
  }
}

void FigureColumn::Write(const std::string& text, double y)
{
  std::string shown = text;
  const double room = (kWidth - 1.0) * Font;
  while (shown.size() > 3 && To.WidthOf(shown) > room)
  {
    shown = shown.substr(0, shown.size() - 4) + "...";
  }
  To.Write(shown, Left, y, TextAnchor::Left, Ink);
}

void FigureColumn::DrawMark(const Rgba& color, const std::string& text, double y)
{
  const int side = Font;
  To.Fill(Left, static_cast<int>(y) - side / 2, side, side, color);
  To.Frame(Left, static_cast<int>(y) - side / 2, side, side, Ink);
  To.Write(text, Left + 1.5 * Font, y, TextAnchor::Left, Ink);
}

void FigureColumn::DrawAxes(const CameraView& view, double y)
{
  const Vec3 towards = glm::normalize(view.position - view.focalPoint);
  const Vec3 right = glm::normalize(glm::cross(view.viewUp, towards));
  const Vec3 up = glm::cross(towards, right);
  const double length = 2.2 * Font;
  const CanvasPoint centre{ Left + 3.0 * Font, y };
  constexpr std::array<Rgba, 3> kColors{ Rgba{ 200, 40, 40, 255 }, Rgba{ 30, 140, 50, 255 },
    Rgba{ 50, 80, 220, 255 } };
  std::array<int, 3> order{ 0, 1, 2 };
  std::ranges::sort(order, {}, [&](int d) { return towards[d]; });
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

void FigureColumn::DrawScale(double unit, double y)
{
  const double most = 7.0 * Font;
  const double power = std::pow(10.0, std::floor(std::log10(most * unit)));
  const double length = power *
    (most * unit >= 5.0 * power      ? 5.0
        : most * unit >= 2.0 * power ? 2.0
                                     : 1.0);
  const double end = Left + length / unit;
  To.Line(CanvasPoint{ static_cast<double>(Left), y }, { end, y }, std::max(1.5, Font / 9.0), Ink);
  for (const double x : { static_cast<double>(Left), end })
  {
    To.Line(
      CanvasPoint{ x, y - 0.3 * Font }, { x, y + 0.3 * Font }, std::max(1.0, Font / 20.0), Ink);
  }
  To.Write(Short(length), 0.5 * (Left + end), y + 0.9 * Font, TextAnchor::Centre, Ink);
}
} // namespace pixelexact
