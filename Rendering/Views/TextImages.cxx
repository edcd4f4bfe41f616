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
#include <cstddef>
#include <vector>

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

/// Blends a part of a colour over a pixel, both with straight alpha.
void Blend(const Rgba& over, double part, std::uint8_t* to)
{
  const double left = (1.0 - part) * to[3] / 255.0;
  for (std::size_t c = 0; c < 3 && part + left > 0.0; ++c)
  {
    to[c] = static_cast<std::uint8_t>(std::lround((part * over[c] + left * to[c]) / (part + left)));
  }
  to[3] = static_cast<std::uint8_t>(std::lround(255.0 * (part + left)));
}

/// How much of each pixel the letters of an image cover, in a rectangle that exceeds it.
class LetterMask
{
public:
  LetterMask(vtkImageData* image, int border)
  {
    // Coordinates of the extent are relative to the anchor.
    std::array<int, 6> extent{};
    image->GetExtent(extent.data());
    Lower = { extent[0] - border, extent[2] - border };
    Upper = { extent[1] + border, extent[3] + border };
    Parts.resize(static_cast<std::size_t>(Upper[0] - Lower[0] + 1) *
      static_cast<std::size_t>(Upper[1] - Lower[1] + 1));
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        const auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(i, j, extent[4]));
        Parts[Index(i, j)] = static_cast<float>(pixel[3] / 255.0);
      }
    }
  }

  /// Widens the letters by a radius in pixels.
  void Widen(double radius)
  {
    const std::vector<float> letters = Parts;
    const int reach = static_cast<int>(std::ceil(radius));
    ForEach(
      [&](int i, int j)
      {
        for (int y = std::max(j - reach, Lower[1]); y <= std::min(j + reach, Upper[1]); ++y)
        {
          for (int x = std::max(i - reach, Lower[0]); x <= std::min(i + reach, Upper[0]); ++x)
          {
            const double near = std::clamp(radius + 0.5 - std::hypot(x - i, y - j), 0.0, 1.0);
            Parts[Index(i, j)] =
              std::max(Parts[Index(i, j)], static_cast<float>(near) * letters[Index(x, y)]);
          }
        }
      });
  }

  void Paint(const Rgba& color, int x0, int y0, const PixelSpan& to) const
  {
    ForEach(
      [&](int i, int j)
      {
        const int x = x0 + i;
        const int y = y0 + j;
        if (x >= 0 && y >= 0 && x < to.width && y < to.height && Parts[Index(i, j)] > 0.0F)
        {
          const std::size_t pixel =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(to.width) +
            static_cast<std::size_t>(x);
          Blend(color, Parts[Index(i, j)], to.rgba + 4 * pixel);
        }
      });
  }

private:
  [[nodiscard]] std::size_t Index(int i, int j) const
  {
    return static_cast<std::size_t>(j - Lower[1]) *
      static_cast<std::size_t>(Upper[0] - Lower[0] + 1) +
      static_cast<std::size_t>(i - Lower[0]);
  }
  template <class Visit>
  void ForEach(const Visit& visit) const
  {
    for (int j = Lower[1]; j <= Upper[1]; ++j)
    {
      for (int i = Lower[0]; i <= Upper[0]; ++i)
      {
        visit(i, j);
      }
    }
  }

  std::array<int, 2> Lower{};
  std::array<int, 2> Upper{};
  std::vector<float> Parts;
};
} // namespace

Rgba InkOn(const Rgba& background)
{
  const double light = 0.299 * background[0] + 0.587 * background[1] + 0.114 * background[2];
  return light > 127.0 ? Rgba{ 0, 0, 0, 255 } : Rgba{ 255, 255, 255, 255 };
}

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
  const Rgba& color, double angle, const PixelSpan& to, const Rgba& halo)
{
  vtkTextProperty& property = *With->property;
  property.SetJustification(anchor == TextAnchor::Left ? VTK_TEXT_LEFT
      : anchor == TextAnchor::Right                    ? VTK_TEXT_RIGHT
                                                       : VTK_TEXT_CENTERED);
  property.SetOrientation(angle);
  if (!vtkFreeTypeTools::GetInstance()->RenderString(
        With->property, text, kDotsPerInch, With->image))
  {
    Fail();
  }
  const int x0 = static_cast<int>(std::floor(x));
  const int y0 = static_cast<int>(std::floor(y));
  const double rim = std::max(1.0, property.GetFontSize() / 8.0);
  const LetterMask letters(With->image, 0);
  if (halo[3] > 0)
  {
    LetterMask rims(With->image, static_cast<int>(std::ceil(rim)));
    rims.Widen(rim);
    rims.Paint(halo, x0, y0, to);
  }
  letters.Paint(color, x0, y0, to);
}
} // namespace pixelexact
