// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/Plot.h"

#include "Base/ImageSize.h"
#include "Drawing/Canvas.h"
#include "Drawing/Ticks.h"
#include "Drawing/VectorCanvas.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace pixelexact
{
namespace
{
constexpr Rgba kInk{ 40, 40, 40, 255 };
constexpr Rgba kGrid{ 225, 225, 225, 255 };
constexpr Rgba kPaper{ 255, 255, 255, 255 };
constexpr int kMaxTicks = 9;

/// A linear or logarithmic axis about numbers.
class Scale
{
public:
  Scale(double begin, double end, bool logarithmic)
    : Begin(begin)
    , End(end)
    , Logarithmic(logarithmic)
  {
  }

  void Add(double value)
  {
    if (std::isfinite(value) && (value > 0.0 || !Logarithmic))
    {
      Range[0] = HasAny ? std::min(Range[0], value) : value;
      Range[1] = HasAny ? std::max(Range[1], value) : value;
      HasAny = true;
    }
    HasZero = HasZero || (Logarithmic && value == 0.0);
    HasInfinity = HasInfinity || (Logarithmic && std::isinf(value));
  }
  /// Leaves room at the ends, `part` of a linear range.
  void Settle(double part)
  {
    if (Logarithmic)
    {
      SettlePowers();
      return;
    }
    if (!HasAny)
    {
      Range = { 0.0, 1.0 };
    }
    if (!(Range[1] > Range[0]))
    {
      const double room = std::max(std::fabs(Range[0]), 1e-300) * 0.1;
      Range = { Range[0] - room, Range[1] + room };
    }
    const double room = part * (Range[1] - Range[0]);
    Range = { Range[0] - room, Range[1] + room };
  }
  [[nodiscard]] double At(double value) const
  {
    const double part = !Logarithmic ? (value - Range[0]) / (Range[1] - Range[0])
      : value > 0.0 ? std::log(std::min(value, Range[1]) / Range[0]) / std::log(Range[1] / Range[0])
                    : 0.0;
    return std::lerp(Begin, End, std::clamp(part, 0.0, 1.0));
  }
  /// Whether a value has a place on the axis.
  [[nodiscard]] bool Holds(double value) const
  {
    return Logarithmic ? !std::isnan(value) : std::isfinite(value);
  }
  [[nodiscard]] std::vector<Tick> Ticks() const
  {
    return TicksWithin(Range, Logarithmic, kMaxTicks);
  }
  [[nodiscard]] bool Zero() const { return HasZero; }
  [[nodiscard]] bool Infinity() const { return HasInfinity; }

private:
  void SettlePowers()
  {
    if (!HasAny)
    {
      Range = { 0.1, 10.0 };
    }
    // A decade for what has no logarithm.
    Range = { Range[0] / 1.5 / (HasZero ? 10.0 : 1.0),
      Range[1] * 1.5 * (HasInfinity ? 10.0 : 1.0) };
    if (Range[1] < 10.0 * Range[0])
    {
      const double middle = std::sqrt(Range[0] * Range[1]);
      Range = { middle / 3.2, middle * 3.2 };
    }
  }

  double Begin;
  double End;
  bool Logarithmic;
  std::array<double, 2> Range{};
  bool HasAny = false;
  bool HasZero = false;
  bool HasInfinity = false;
};

void DrawSeries(Canvas& canvas, const Plot::Series& series, const Scale& x, const Scale& y)
{
  constexpr double kMark = 9.0;
  std::vector<CanvasPoint> line;
  const auto finish = [&]
  {
    if (line.size() > 1 && series.joined)
    {
      canvas.Line(line, series.dashed ? 1.0 : 2.0, series.color);
    }
    line.clear();
  };
  for (const Plot::Point& point : series.points)
  {
    if (!x.Holds(point.x) || !y.Holds(point.y))
    {
      finish();
      continue;
    }
    const CanvasPoint at{ x.At(point.x), y.At(point.y) };
    line.push_back(at);
    if (!series.dashed && series.marks)
    {
      canvas.Line(at, at, kMark, series.color);
      canvas.Write(point.label, at[0] + kMark, at[1] + kMark, TextAnchor::Left, series.color);
    }
  }
  finish();
}

void DrawBars(Canvas& canvas, const std::vector<Plot::Bar>& bars, const Scale& x, const Scale& y)
{
  const auto pixel = [](double at) { return static_cast<int>(std::lround(at)); };
  const int floor = pixel(y.At(0.0));
  for (const Plot::Bar& bar : bars)
  {
    const int left = pixel(x.At(bar.from));
    const int right = pixel(x.At(bar.to));
    const int top = pixel(y.At(bar.y));
    canvas.Fill(
      left, floor, std::max(right - left - 1, 1), std::max(top - floor, 0), SeriesColor(0));
    const double middle = 0.5 * (left + right - 1);
    canvas.Line({ middle, y.At(bar.range[0]) }, { middle, y.At(bar.range[1]) }, 2.0, kInk);
  }
}
} // namespace

void Plot::DrawOn(Canvas& canvas, int width, int height, int font) const
{
  // The legend's names have the room that they need, up to a third of the picture.
  double room = 0.0;
  for (const Series& one : series)
  {
    room = one.name.empty() ? room : std::max({ room, 7.0 * font, canvas.WidthOf(one.name) });
  }
  room = std::min(room, std::max(7.0 * font, width / 3.0));
  const int left = 7 * font;
  const int bottom = 4 * font;
  const int right = width - (room > 0.0 ? 3 * font + static_cast<int>(room) : 2 * font);
  const int top = height - 5 * font;
  Scale x(left, right, logarithmic[0]);
  Scale y(bottom, top, logarithmic[1]);
  for (const Series& one : series)
  {
    for (const Point& point : one.points)
    {
      if (x.Holds(point.x) && y.Holds(point.y))
      {
        x.Add(point.x);
        y.Add(point.y);
      }
    }
  }
  for (const Bar& bar : bars)
  {
    x.Add(bar.from);
    x.Add(bar.to);
    y.Add(0.0);
    y.Add(bar.range[1]);
  }
  x.Settle(0.0);
  y.Settle(bars.empty() ? 0.05 : 0.0);
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
  DrawBars(canvas, bars, x, y);
  canvas.Frame(left, bottom, right - left, top - bottom, kInk);
  for (const Series& one : series)
  {
    DrawSeries(canvas, one, x, y);
  }
  double row = top - font;
  for (const Series& one : series)
  {
    if (!one.name.empty())
    {
      canvas.Line({ right + 1.0 * font, row }, { right + 2.0 * font, row }, one.dashed ? 1.0 : 4.0,
        one.color);
      canvas.Write(
        canvas.Shortened(one.name, room), right + 2.5 * font, row, TextAnchor::Left, kInk);
      row -= 1.7 * font;
    }
  }
  canvas.Write(title, left, height - 1.2 * font, TextAnchor::Left, kInk);
  canvas.Write(up, left, height - 2.8 * font, TextAnchor::Left, kInk);
  canvas.Write(across, 0.5 * (left + right), 1.2 * font, TextAnchor::Centre, kInk);
}

std::vector<std::uint8_t> Plot::Draw(int width, int height) const
{
  const int font = std::max(11, height / 44);
  RasterCanvas canvas(width, height, kPaper, font, {});
  DrawOn(canvas, width, height, font);
  return canvas.Picture().pixels;
}

std::string Plot::Encode(PictureFormat format, int width, int height, const FontChoice& font,
  const PictureTexts& texts, const std::string& file) const
{
  const int letters = std::max(11, height / 44);
  if (IsVector(format))
  {
    VectorCanvas canvas(format, width, height, kDefaultDpi, kPaper, letters, font);
    DrawOn(canvas, width, height, letters);
    return canvas.Finish(texts, file);
  }
  RasterCanvas canvas(width, height, kPaper, letters, font);
  DrawOn(canvas, width, height, letters);
  return EncodeImage(canvas.Picture(), format, { std::nullopt, texts }, file);
}

Rgba SeriesColor(std::size_t number)
{
  constexpr std::array<Rgba, 7> kColors{ Rgba{ 0, 114, 178, 255 }, Rgba{ 213, 94, 0, 255 },
    Rgba{ 0, 158, 115, 255 }, Rgba{ 204, 121, 167, 255 }, Rgba{ 86, 180, 233, 255 },
    Rgba{ 230, 159, 0, 255 }, Rgba{ 0, 0, 0, 255 } };
  return kColors[number % kColors.size()];
}
} // namespace pixelexact
