// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/ContourLabels.h"

#include "Views/TextImages.h"

#include "Core/Base/Error.h"
#include "Trace/Appearance/Painter.h"
#include "Trace/Modules/ContourPlaces.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <set>

namespace pixelexact
{
namespace
{
std::string Formatted(double value, int digits)
{
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, value == 0.0 ? 0.0 : value);
  return text.data();
}

/// Calls visit(x, y, pixel) for the frame's pixels in a rectangle.
template <class Visit>
void ForEachPixel(const Frame& frame, const std::array<int, 4>& box, const Visit& visit)
{
  for (int y = std::max(box[2], 0); y <= std::min(box[3], frame.height - 1); ++y)
  {
    for (int x = std::max(box[0], 0); x <= std::min(box[1], frame.width - 1); ++x)
    {
      visit(x, y,
        static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) +
          static_cast<std::size_t>(x));
    }
  }
}

/// Removes the lines beneath a label's text.
void OpenGap(Frame& frame, const ContourLabel& label, const std::vector<std::uint8_t>& beneath)
{
  constexpr double kGap = ContourLabel::kGap;
  const double angle = label.angle * std::numbers::pi / 180.0;
  const glm::dvec2 along(std::cos(angle), std::sin(angle));
  // Not a structured binding, which clang 14 cannot capture in a lambda.
  const double width = label.size.width;
  const double height = label.size.height;
  const int reach = static_cast<int>(std::ceil(0.5 * std::hypot(width, height) + kGap));
  const int cx = static_cast<int>(label.x);
  const int cy = static_cast<int>(label.y);
  ForEachPixel(frame, { cx - reach, cx + reach, cy - reach, cy + reach },
    [&](int x, int y, std::size_t pixel)
    {
      const glm::dvec2 from = glm::dvec2(x + 0.5, y + 0.5) - glm::dvec2(label.x, label.y);
      if (std::fabs(glm::dot(from, along)) <= 0.5 * width + kGap &&
        std::fabs(from.y * along.x - from.x * along.y) <= 0.5 * height + kGap)
      {
        std::copy_n(&beneath[4 * pixel], 4, &frame.color[4 * pixel]);
      }
    });
}
} // namespace

std::vector<std::string> LabelTexts(const std::vector<double>& values)
{
  constexpr int kMaxDigits = 17;
  const std::set<double> different(values.begin(), values.end());
  std::vector<std::string> texts;
  for (int digits = 3; digits <= kMaxDigits; ++digits)
  {
    texts.clear();
    std::ranges::transform(values, std::back_inserter(texts),
      [digits](double value) { return Formatted(value, digits); });
    if (std::set<std::string>(texts.begin(), texts.end()).size() == different.size())
    {
      break;
    }
  }
  return texts;
}

void RequireLabelSize(int size)
{
  if (size < LabelFont::kSmallest || size > LabelFont::kLargest)
  {
    throw Error("contours: labels of " + std::to_string(size) + " pixels; they may be " +
      std::to_string(LabelFont::kSmallest) + " to " + std::to_string(LabelFont::kLargest) +
      " pixels high");
  }
}

std::vector<ContourLabel> PlaceContourLabels(const Frame& frame, const Camera& camera,
  const ContourCertifier& contours, const ContourLines& lines, int size, const FontChoice& font)
{
  RequireLabelSize(size);
  TextImages writer(size, font);
  std::vector<std::vector<std::string>> texts;
  std::vector<std::vector<LabelSize>> sizes;
  for (const std::vector<double>& values : contours.Values())
  {
    texts.push_back(LabelTexts(values));
    sizes.emplace_back();
    std::ranges::transform(texts.back(), std::back_inserter(sizes.back()),
      [&writer](const std::string& text)
      {
        const TextSize box = writer.SizeOf(text);
        return LabelSize{ box.width, box.height };
      });
  }
  std::vector<ContourLabel> labels;
  for (const ContourPlace& place :
    PlaceLabels(frame, camera, contours, sizes, lines.DrawsUndecided()))
  {
    const LabelSize& box = sizes[place.layer][place.value];
    labels.push_back({ texts[place.layer][place.value], place.centre.x, place.centre.y, place.angle,
      { box.width, box.height }, lines.ColorOf(place.layer, place.value) });
  }
  return labels;
}

int DrawContourLabels(Frame& frame, const Camera& camera, const ContourCertifier& contours,
  const ContourLines& lines, int size, const FontChoice& font)
{
  const std::vector<ContourLabel> labels =
    PlaceContourLabels(frame, camera, contours, lines, size, font);
  TextImages writer(size, font);
  const PixelSpan image{ frame.width, frame.height, frame.color.data() };
  for (const ContourLabel& label : labels)
  {
    OpenGap(frame, label, lines.Beneath());
    writer.Put(label.text, label.x, label.y, TextAnchor::Centre, label.color, label.angle, image,
      InkOn(label.color));
  }
  return static_cast<int>(labels.size());
}

void DrawLabelsOf(Frame& frame, const Camera& camera, const Painter& painter)
{
  (void)DrawContourLabels(frame, camera, *painter.Contours(), *painter.Lines(), *painter.Labels());
}
} // namespace pixelexact
