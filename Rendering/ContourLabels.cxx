// SPDX-License-Identifier: BSD-3-Clause
#include "ContourLabels.h"

#include "Core/Base/Error.h"
#include "Trace/Modules/ContourPlaces.h"

#include "vtkFreeTypeTools.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkStdString.h"
#include "vtkTextProperty.h"

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
/// Of a point of the font's size a pixel.
constexpr int kDotsPerInch = 72;
/// Around a text, in pixels.
constexpr double kGap = 2.0;

std::string Formatted(double value, int digits)
{
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, value == 0.0 ? 0.0 : value);
  return text.data();
}

/// Makes texts of one font.
class Writer
{
public:
  explicit Writer(int size)
  {
    Property->SetFontFamilyToArial();
    Property->SetFontSize(size);
    Property->SetJustificationToCentered();
    Property->SetVerticalJustificationToCentered();
  }

  [[nodiscard]] LabelSize SizeOf(const std::string& text)
  {
    std::array<int, 4> box{};
    Property->SetOrientation(0.0);
    if (!vtkFreeTypeTools::GetInstance()->GetBoundingBox(Property, text, kDotsPerInch, box.data()))
    {
      Fail();
    }
    return { box[1] - box[0] + 1.0, box[3] - box[2] + 1.0 };
  }

  /// The text about the origin; its extent's first point is the lower left pixel.
  [[nodiscard]] vtkImageData* Write(const std::string& text, const Rgba& color, double angle)
  {
    Property->SetColor(color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
    Property->SetOrientation(angle);
    if (!vtkFreeTypeTools::GetInstance()->RenderString(Property, text, kDotsPerInch, Image))
    {
      Fail();
    }
    return Image;
  }

private:
  [[noreturn]] static void Fail()
  {
    throw Error("contours: FreeType makes no text for labels; leave labels out");
  }

  vtkNew<vtkTextProperty> Property;
  vtkNew<vtkImageData> Image;
};

/// A text's colour, of straight alpha, over an image's.
void Blend(const unsigned char* over, std::uint8_t* to)
{
  const double part = over[3] / 255.0;
  const double left = (1.0 - part) * to[3] / 255.0;
  for (int c = 0; c < 3 && part + left > 0.0; ++c)
  {
    to[c] = static_cast<std::uint8_t>(std::lround((part * over[c] + left * to[c]) / (part + left)));
  }
  to[3] = static_cast<std::uint8_t>(std::lround(255.0 * (part + left)));
}

/// visit(x, y, pixel) for the pixels of the frame in a rectangle.
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

/// Takes the lines away where the text goes.
void OpenGap(Frame& frame, const ContourPlace& place, const LabelSize& size,
  const std::vector<std::uint8_t>& beneath)
{
  const double angle = place.angle * std::numbers::pi / 180.0;
  const glm::dvec2 along(std::cos(angle), std::sin(angle));
  const int reach = static_cast<int>(std::ceil(0.5 * std::hypot(size.width, size.height) + kGap));
  const int cx = static_cast<int>(place.centre.x);
  const int cy = static_cast<int>(place.centre.y);
  ForEachPixel(frame, { cx - reach, cx + reach, cy - reach, cy + reach },
    [&](int x, int y, std::size_t pixel)
    {
      const glm::dvec2 from = glm::dvec2(x + 0.5, y + 0.5) - place.centre;
      if (std::fabs(glm::dot(from, along)) <= 0.5 * size.width + kGap &&
        std::fabs(from.y * along.x - from.x * along.y) <= 0.5 * size.height + kGap)
      {
        std::copy_n(&beneath[4 * pixel], 4, &frame.color[4 * pixel]);
      }
    });
}

void Put(Frame& frame, const ContourPlace& place, vtkImageData* text)
{
  std::array<int, 6> extent{};
  text->GetExtent(extent.data());
  const int x0 = static_cast<int>(std::floor(place.centre.x));
  const int y0 = static_cast<int>(std::floor(place.centre.y));
  ForEachPixel(frame, { x0 + extent[0], x0 + extent[1], y0 + extent[2], y0 + extent[3] },
    [&](int x, int y, std::size_t pixel)
    {
      Blend(static_cast<unsigned char*>(text->GetScalarPointer(x - x0, y - y0, extent[4])),
        &frame.color[4 * pixel]);
    });
}
} // namespace

std::vector<std::string> LabelTexts(const std::vector<double>& values)
{
  constexpr int kMostDigits = 17;
  const std::set<double> different(values.begin(), values.end());
  std::vector<std::string> texts;
  for (int digits = 3; digits <= kMostDigits; ++digits)
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

int DrawContourLabels(Frame& frame, const Camera& camera, const ContourCertifier& contours,
  const ContourLines& lines, int size)
{
  RequireLabelSize(size);
  Writer writer(size);
  std::vector<std::vector<std::string>> texts;
  std::vector<std::vector<LabelSize>> sizes;
  for (const std::vector<double>& values : contours.Values())
  {
    texts.push_back(LabelTexts(values));
    sizes.emplace_back();
    std::ranges::transform(texts.back(), std::back_inserter(sizes.back()),
      [&writer](const std::string& text) { return writer.SizeOf(text); });
  }
  const std::vector<ContourPlace> places =
    PlaceLabels(frame, camera, contours, sizes, lines.DrawsUndecided());
  for (const ContourPlace& place : places)
  {
    OpenGap(frame, place, sizes[place.layer][place.value], lines.Beneath());
    Put(frame, place,
      writer.Write(
        texts[place.layer][place.value], lines.ColorOf(place.layer, place.value), place.angle));
  }
  return static_cast<int>(places.size());
}
} // namespace pixelexact
