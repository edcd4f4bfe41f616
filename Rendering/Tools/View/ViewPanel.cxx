// SPDX-License-Identifier: BSD-3-Clause
#include "View/ViewPanel.h"

#include "Base/Report.h"
#include "Drawing/Canvas.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pixelexact
{
namespace
{
constexpr Rgba kBack{ 236, 236, 236, 255 };
constexpr Rgba kInk{ 20, 20, 20, 255 };
constexpr Rgba kFaint{ 150, 150, 150, 255 };
constexpr Rgba kMark{ 40, 100, 180, 255 };
constexpr Rgba kMarkedInk{ 255, 255, 255, 255 };
constexpr int kMinFont = 11;
constexpr int kMaxFont = 24;
/// Width and heights in units of the font's size.
constexpr int kWidth = 17;
constexpr double kRow = 1.5;
constexpr double kSlider = 3.2;
/// Height that is kept for texts, so that fields stay where they are.
constexpr double kMinText = 12.0;
/// Smallest number of positions of a slider.
constexpr double kPositions = 100.0;
} // namespace

std::string SliderValue::Text() const
{
  // Twelve digits leave out the rounding of the product with the step.
  return Short(value, 12);
}

SliderValue SliderOver(
  std::string option, std::string prefix, const std::array<double, 2>& range, double value)
{
  SliderValue slider{ std::move(option), std::move(prefix), {}, std::min(range[0], value),
    std::max(range[1], value), 1.0, value };
  const double length = slider.high - slider.low;
  if (length > 0.0)
  {
    slider.step = std::pow(10.0, std::floor(std::log10(length / kPositions)));
  }
  return slider;
}

int ViewPanel::WidthBeside(int figureFont)
{
  return kWidth * std::clamp(figureFont * 2 / 3, kMinFont, kMaxFont);
}

Image ViewPanel::Draw(int width, int height, const FontChoice& choice)
{
  Width = width;
  Font = width / kWidth;
  RasterCanvas canvas(width, height, kBack, Font, choice);
  canvas.Fill(0, 0, 1, height, kFaint);
  const double least = std::max(kMinText * Font, DrawText(canvas)) +
    static_cast<double>(sliders.size()) * kSlider * Font;
  double y = height - 0.5 * Font;
  DrawFields(canvas, y, least);
  Tracks.clear();
  for (const SliderValue& slider : sliders)
  {
    y -= kSlider * Font;
    Tracks.push_back(y + 0.8 * Font);
    DrawSlider(canvas, slider, Tracks.back());
  }
  return canvas.Picture();
}

void ViewPanel::DrawFields(RasterCanvas& canvas, double& y, double least)
{
  const double left = 0.8 * Font;
  const double row = kRow * Font;
  y -= 0.5 * row;
  canvas.Write(title, left, y, TextAnchor::Left, kFaint);
  y -= 0.5 * row;
  const auto rows = static_cast<std::size_t>(std::max(1.0, std::floor((y - least) / row) - 1.0));
  Shown = std::min(rows, fields.size());
  if (field && field != std::exchange(Followed, field))
  {
    First = std::clamp(First, *field + 1 - std::min(Shown, *field + 1), *field);
  }
  First = std::min(First, fields.size() - Shown);
  Top = y;
  for (std::size_t k = First; k < First + Shown; ++k)
  {
    if (field == k)
    {
      canvas.Fill(static_cast<int>(0.4 * Font), static_cast<int>(y - row),
        Width - static_cast<int>(0.8 * Font), static_cast<int>(row), kMark);
    }
    canvas.Write(canvas.Shortened(fields[k], Width - 2.0 * left), left, y - 0.5 * row,
      TextAnchor::Left, field == k ? kMarkedInk : kInk);
    y -= row;
  }
  if (Shown < fields.size())
  {
    canvas.Write(std::to_string(Shown) + " of " + std::to_string(fields.size()) + ", wheel: scroll",
      left, y - 0.5 * row, TextAnchor::Left, kFaint);
    y -= row;
  }
}

void ViewPanel::DrawSlider(RasterCanvas& canvas, const SliderValue& slider, double y) const
{
  const double left = 0.8 * Font;
  const double value = canvas.WidthOf(slider.Text());
  canvas.Write(canvas.Shortened(slider.name, Width - 3.0 * left - value), left, y + 1.2 * Font,
    TextAnchor::Left, kInk);
  canvas.Write(slider.Text(), Width - left, y + 1.2 * Font, TextAnchor::Right, kInk);
  const double from = left + 0.5 * Font;
  const double to = Width - from;
  canvas.Line(CanvasPoint{ from, y }, { to, y }, 0.25 * Font, kFaint);
  const double length = slider.high - slider.low;
  const double part = length > 0.0 ? (slider.value - slider.low) / length : 0.5;
  const double knob = std::lerp(from, to, std::clamp(part, 0.0, 1.0));
  canvas.Line(CanvasPoint{ knob, y }, { knob, y }, Font, kMark);
}

double ViewPanel::DrawText(RasterCanvas& canvas) const
{
  const double left = 0.8 * Font;
  const double row = kRow * Font;
  const std::vector<std::string> lines = canvas.Wrapped(text, Width - 2.0 * left);
  double y = static_cast<double>(lines.size()) * row + 0.5 * Font;
  const double top = y + 0.5 * row;
  for (const std::string& line : lines)
  {
    y -= row;
    canvas.Write(line, left, y + 0.5 * row, TextAnchor::Left, kInk);
  }
  return top;
}

std::optional<std::size_t> ViewPanel::FieldAt(double x, double y) const
{
  if (x < 0.0 || x >= Width || y > Top || y <= Top - static_cast<double>(Shown) * kRow * Font)
  {
    return std::nullopt;
  }
  return First + static_cast<std::size_t>((Top - y) / (kRow * Font));
}

std::optional<std::size_t> ViewPanel::SliderAt(double x, double y) const
{
  for (std::size_t k = 0; k < Tracks.size(); ++k)
  {
    if (x >= 0.0 && x < Width && std::fabs(y - Tracks[k]) < Font)
    {
      return k;
    }
  }
  return std::nullopt;
}

double ViewPanel::ValueAt(std::size_t slider, double x) const
{
  const SliderValue& at = sliders[slider];
  const double margin = 1.3 * Font;
  const double part = std::clamp((x - margin) / (Width - 2.0 * margin), 0.0, 1.0);
  const double value = std::round(std::lerp(at.low, at.high, part) / at.step) * at.step;
  return std::clamp(value, at.low, at.high);
}

void ViewPanel::Scroll(int by)
{
  const auto last = static_cast<int>(fields.size() - Shown);
  First = static_cast<std::size_t>(std::clamp(static_cast<int>(First) + by, 0, last));
}
} // namespace pixelexact
