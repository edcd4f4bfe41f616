// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/LogPlot.h"

#include "Drawing/Canvas.h"
#include "Drawing/Ticks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
constexpr Rgba kInk{ 40, 40, 40, 255 };
constexpr Rgba kGrid{ 225, 225, 225, 255 };
constexpr Rgba kPaper{ 255, 255, 255, 255 };
constexpr int kMaxTicks = 9;

/// Powers of ten about positive numbers.
class Scale
{
public:
  Scale(double begin, double end)
    : Begin(begin)
    , End(end)
  {
  }

  void Add(double value)
  {
    if (value > 0.0 && std::isfinite(value))
    {
      Range[0] = std::min(Range[0], value);
      Range[1] = std::max(Range[1], value);
      HasAny = true;
    }
    HasZero = HasZero || value == 0.0;
    HasInfinity = HasInfinity || std::isinf(value);
  }
  void Settle()
  {
    if (!HasAny)
    {
      Range = { 0.1, 10.0 };
    }
    // Room at the ends, and a decade for what has no logarithm.
    Range = { Range[0] / 1.5 / (HasZero ? 10.0 : 1.0),
      Range[1] * 1.5 * (HasInfinity ? 10.0 : 1.0) };
    if (Range[1] < 10.0 * Range[0])
    {
      const double middle = std::sqrt(Range[0] * Range[1]);
      Range = { middle / 3.2, middle * 3.2 };
    }
  }
  [[nodiscard]] double At(double value) const
  {
    const double part = value > 0.0
      ? std::log(std::min(value, Range[1]) / Range[0]) / std::log(Range[1] / Range[0])
      : 0.0;
    return std::lerp(Begin, End, std::clamp(part, 0.0, 1.0));
  }
  [[nodiscard]] std::vector<Tick> Ticks() const { return TicksWithin(Range, true, kMaxTicks); }
  [[nodiscard]] bool Zero() const { return HasZero; }
  [[nodiscard]] bool Infinity() const { return HasInfinity; }

private:
  double Begin;
  double End;
  std::array<double, 2> Range{ std::numeric_limits<double>::infinity(), 0.0 };
  bool HasAny = false;
  bool HasZero = false;
  bool HasInfinity = false;
};

void DrawSeries(Canvas& canvas, const LogPlot::Series& series, const Scale& x, const Scale& y)
{
  constexpr double kMark = 9.0;
  const CanvasPoint* before = nullptr;
  CanvasPoint last{};
  for (const LogPlot::Point& point : series.points)
  {
    const CanvasPoint at{ x.At(point.x), y.At(point.y) };
    if (before != nullptr && series.joined)
    {
      canvas.Line(last, at, series.dashed ? 1.0 : 2.0, series.color);
    }
    last = at;
    before = &last;
    if (!series.dashed)
    {
      canvas.Line(at, at, kMark, series.color);
      canvas.Write(point.label, at[0] + kMark, at[1] + kMark, TextAnchor::Left, series.color);
    }
  }
}
} // namespace

std::vector<std::uint8_t> LogPlot::Draw(int width, int height) const
{
  const int font = std::max(11, height / 44);
  const int left = 6 * font;
  const int bottom = 4 * font;
  const int right = width - 10 * font;
  const int top = height - 5 * font;
  RasterCanvas canvas(width, height, kPaper, font, {});
  Scale x(left, right);
  Scale y(bottom, top);
  for (const Series& one : series)
  {
    for (const Point& point : one.points)
    {
      x.Add(point.x);
      y.Add(point.y);
    }
  }
  x.Settle();
  y.Settle();
  for (const Tick& tick : x.Ticks())
  {
    const double at = x.At(tick.value);
    canvas.Line({ at, static_cast<double>(bottom) }, { at, static_cast<double>(top) }, 1.0, kGrid);
    canvas.Write(tick.text, at, bottom - font, TextAnchor::Centre, kInk);
  }
  for (const Tick& tick : y.Ticks())
  {
    const double at = y.At(tick.value);
    canvas.Line({ static_cast<double>(left), at }, { static_cast<double>(right), at }, 1.0, kGrid);
    canvas.Write(tick.text, left - 0.5 * font, at, TextAnchor::Right, kInk);
  }
  if (y.Zero())
  {
    canvas.Write("0", left - 0.5 * font, bottom, TextAnchor::Right, kInk);
  }
  if (y.Infinity())
  {
    canvas.Write("infinite", left - 0.5 * font, top, TextAnchor::Right, kInk);
  }
  canvas.Frame(left, bottom, right - left, top - bottom, kInk);
  for (const Series& one : series)
  {
    DrawSeries(canvas, one, x, y);
  }
  double row = top - font;
  for (const Series& one : series)
  {
    canvas.Line(
      { right + 1.0 * font, row }, { right + 2.0 * font, row }, one.dashed ? 1.0 : 4.0, one.color);
    canvas.Write(one.name, right + 2.5 * font, row, TextAnchor::Left, kInk);
    row -= 1.7 * font;
  }
  canvas.Write(title, left, height - 1.2 * font, TextAnchor::Left, kInk);
  canvas.Write(up, left, height - 2.8 * font, TextAnchor::Left, kInk);
  canvas.Write(across, 0.5 * (left + right), 1.2 * font, TextAnchor::Centre, kInk);
  return canvas.Picture().pixels;
}
} // namespace pixelexact
