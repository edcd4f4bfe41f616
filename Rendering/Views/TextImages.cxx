// SPDX-License-Identifier: BSD-3-Clause
#include "Views/TextImages.h"

#include "Core/Base/Error.h"

#include "vtkFreeTypeTools.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkStdString.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Makes one point of the font's size one pixel.
constexpr int kDotsPerInch = 72;

[[noreturn]] void Fail()
{
  throw Error("FreeType makes no text; leave labels and titles out");
}

/// Blends a text's colour, with straight alpha, over an image's.
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
} // namespace

struct TextImages::Font
{
  vtkNew<vtkTextProperty> property;
  vtkNew<vtkImageData> image;
};

TextImages::TextImages(int size, const FontChoice& font)
  : With(std::make_unique<Font>())
{
  switch (font.family)
  {
    case FontChoice::Family::Serif:
      With->property->SetFontFamilyToTimes();
      break;
    case FontChoice::Family::File:
      With->property->SetFontFamily(VTK_FONT_FILE);
      With->property->SetFontFile(font.file.c_str());
      break;
    default:
      With->property->SetFontFamilyToArial();
  }
  With->property->SetFontSize(size);
  With->property->SetVerticalJustificationToCentered();
}

TextImages::~TextImages() = default;

TextSize TextImages::SizeOf(const std::string& text)
{
  std::array<int, 4> box{};
  With->property->SetOrientation(0.0);
  if (!vtkFreeTypeTools::GetInstance()->GetBoundingBox(
        With->property, text, kDotsPerInch, box.data()))
  {
    Fail();
  }
  return { box[1] - box[0] + 1.0, box[3] - box[2] + 1.0 };
}

void TextImages::Put(const std::string& text, double x, double y, TextAnchor anchor,
  const Rgba& color, double angle, const PixelSpan& to)
{
  vtkTextProperty& property = *With->property;
  property.SetJustification(anchor == TextAnchor::Left ? VTK_TEXT_LEFT
      : anchor == TextAnchor::Right                    ? VTK_TEXT_RIGHT
                                                       : VTK_TEXT_CENTERED);
  property.SetColor(color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
  property.SetOrientation(angle);
  if (!vtkFreeTypeTools::GetInstance()->RenderString(
        With->property, text, kDotsPerInch, With->image))
  {
    Fail();
  }
  // Coordinates of the extent are relative to the anchor.
  std::array<int, 6> extent{};
  With->image->GetExtent(extent.data());
  const int x0 = static_cast<int>(std::floor(x));
  const int y0 = static_cast<int>(std::floor(y));
  for (int j = std::max(extent[2], -y0); j <= std::min(extent[3], to.height - 1 - y0); ++j)
  {
    for (int i = std::max(extent[0], -x0); i <= std::min(extent[1], to.width - 1 - x0); ++i)
    {
      const std::size_t pixel =
        static_cast<std::size_t>(y0 + j) * static_cast<std::size_t>(to.width) +
        static_cast<std::size_t>(x0 + i);
      Blend(static_cast<unsigned char*>(With->image->GetScalarPointer(i, j, extent[4])),
        to.rgba + 4 * pixel);
    }
  }
}
} // namespace pixelexact
