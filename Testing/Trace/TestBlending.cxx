// SPDX-License-Identifier: BSD-3-Clause
// Translucent sheets become one image; buffers are there where they are asked for.
#include "LayeredScene.h"
#include "SheetCheck.h"

#include "Trace/BufferTable.h"
#include "Trace/TileVisit.h"

#include <gtest/gtest.h>

namespace pixelexact::testing
{
namespace
{
using LongRgba = std::array<long double, 4>;

/// `front` over `back`, premultiplied (T. Porter, T. Duff, 1984).
LongRgba Over(const LongRgba& front, const LongRgba& back)
{
  LongRgba color;
  for (std::size_t c = 0; c < 4; ++c)
  {
    color[c] = front[c] + (1 - front[3]) * back[c];
  }
  return color;
}

LongRgba Premultiplied(const std::uint8_t* rgba)
{
  const long double alpha = rgba[3] / 255.0L;
  return { alpha * rgba[0] / 255, alpha * rgba[1] / 255, alpha * rgba[2] / 255, alpha };
}

/// Pixel by pixel, of straight bytes.
void ExpectImage(const std::uint8_t* image, const LongRgba& color)
{
  EXPECT_NEAR(image[3], static_cast<double>(255 * color[3]), 0.5 + 1e-9);
  for (std::size_t c = 0; c < 3; ++c)
  {
    if (color[3] < 1e-9L)
    {
      EXPECT_EQ(image[c], 0);
    }
    else
    {
      EXPECT_NEAR(image[c], static_cast<double>(255 * color[c] / color[3]), 0.5 + 1e-9);
    }
  }
}
} // namespace

TEST(Blending, SheetsLieOverEachOther)
{
  Random random(23);
  constexpr std::size_t kCount = 4000;
  for (std::size_t sheets = 1; sheets <= 5; ++sheets)
  {
    SampleBuffers samples;
    samples.Allocate(Buffer::Verdict, 80, 50);
    samples.behind.resize(sheets - 1, samples);
    const auto fill = [&](SampleBuffers& sheet)
    {
      for (std::size_t i = 0; i < 4 * kCount; ++i)
      {
        const double kind = random(0.0, 1.0);
        // Many samples are opaque or empty.
        sheet.color.push_back(i % 4 == 3 && kind < 0.3
            ? (kind < 0.15 ? 0 : 255)
            : static_cast<std::uint8_t>(random(0.0, 256.0)));
      }
    };
    fill(samples);
    std::ranges::for_each(samples.behind, fill);
    constexpr std::size_t kBegin = 70;
    std::vector<std::uint8_t> image(4 * (kCount - kBegin) + 4, 77);
    BlendSheets(samples, kBegin, kCount, image.data());
    for (std::size_t i = kBegin; i < kCount; ++i)
    {
      LongRgba color{};
      const auto all = SheetsOf(samples);
      for (auto sheet = all.rbegin(); sheet != all.rend(); ++sheet)
      {
        color = Over(Premultiplied(&(*sheet)->color[4 * i]), color);
      }
      ExpectImage(&image[4 * (i - kBegin)], color);
    }
    EXPECT_EQ(image.back(), 77);
  }
}

/// From the colour map to the image: opacities of layers times those of their maps.
TEST(Blending, OfTranslucentLayers)
{
  const LayeredScene scene(true);
  const ColorMapping colors = LayeredColors();
  constexpr std::array kOpacity{ 0.6, 0.8 };
  const Frame frame = Trace(scene.scene_, Camera(ObliqueView(), 60, 45), { { &colors }, {} });
  const auto sheets = SheetsOf(frame.centres);
  ASSERT_EQ(sheets.size(), 3U);
  int deep = 0;
  int empty = 0;
  for (std::size_t i = 0; i < frame.centres.Size(); ++i)
  {
    LongRgba color{};
    for (auto sheet = sheets.rbegin(); sheet != sheets.rend(); ++sheet)
    {
      const std::uint8_t layer = (*sheet)->layer[i];
      if (layer == kNoLayer)
      {
        continue;
      }
      std::array<std::uint8_t, 4> own{};
      Striped(layer == 0 ? 0.3 : 0.6)(std::span(&(*sheet)->value[i], 1), own.data());
      LongRgba front = Premultiplied(own.data());
      for (long double& c : front)
      {
        c *= kOpacity[layer];
      }
      color = Over(front, color);
    }
    deep += sheets[2]->layer[i] != kNoLayer ? 1 : 0;
    empty += color[3] == 0 ? 1 : 0;
    const std::uint8_t* image = &frame.Image()[4 * i];
    EXPECT_NEAR(image[3], static_cast<double>(255 * color[3]), 1.5);
    for (std::size_t c = 0; c < 3; ++c)
    {
      const long double straight = color[3] > 0 ? 255 * color[c] / color[3] : 0;
      // A sheet's alpha is rounded to a byte: by a part in 72 where it is least.
      EXPECT_NEAR(image[c], static_cast<double>(straight), color[3] > 0 ? 4.0 : 0.0);
    }
  }
  EXPECT_GT(deep, 200);
  EXPECT_GT(empty, 200);
}

TEST(SampleBuffers, AreThereWhenAskedFor)
{
  struct Row
  {
    Buffer buffer;
    std::vector<std::string> names;
  };
  const std::vector<Row> rows{ { Buffer::Value, { "Value" } }, { Buffer::Position, { "Position" } },
    { Buffer::Normal, { "Normal" } }, { Buffer::Xi, { "Xi" } }, { Buffer::Element, { "Element" } },
    { Buffer::Depth, { "Depth" } }, { Buffer::Verdict, { "Verdict" } },
    { Buffer::Coverage, { "Owners", "Coverage" } },
    { Buffer::Enclosure, { "Value_lower", "Value_upper" } }, { Buffer::Layer, { "Layer" } },
    { Buffer::Piece, { "Piece", "Piece_u", "Piece_v" } }, { Buffer::Color, {} },
    { Buffer::None, {} } };
  SampleBuffers samples;
  for (const auto& [buffer, names] : rows)
  {
    samples.color.assign(8, 1);
    samples.behind.resize(2);
    samples.Allocate(buffer, 3, 2);
    EXPECT_EQ(samples.Size(), 6U);
    EXPECT_TRUE(samples.color.empty());
    EXPECT_TRUE(samples.behind.empty());
    std::vector<std::string> there;
    ForEachBuffer(
      [&](const auto& row)
      {
        const std::size_t size = (samples.*row.member).size();
        EXPECT_TRUE(size == 0 || size == 6);
        if (size > 0)
        {
          there.emplace_back(row.name);
        }
      });
    EXPECT_EQ(there, names);
  }
  // Some of them, and what they begin with.
  samples.Allocate(kAll | Buffer::Layer | Buffer::Coverage | Buffer::Enclosure, 1, 1);
  EXPECT_TRUE(std::isnan(samples.value.at(0)));
  EXPECT_TRUE(std::isnan(samples.valueLower.at(0)));
  EXPECT_TRUE(std::isnan(samples.valueUpper.at(0)));
  for (int d = 0; d < 3; ++d)
  {
    EXPECT_TRUE(std::isnan(samples.position.at(0)[d]));
    EXPECT_TRUE(std::isnan(samples.normal.at(0)[d]));
    EXPECT_TRUE(std::isnan(samples.xi.at(0)[d]));
  }
  EXPECT_EQ(samples.element.at(0), -1);
  EXPECT_EQ(samples.depth.at(0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(samples.verdict.at(0), 0);
  EXPECT_EQ(samples.owners.at(0), -1);
  EXPECT_EQ(samples.coverage.at(0), 255);
  EXPECT_EQ(samples.layer.at(0), 255);
  samples.Allocate(Buffer::Layer | Buffer::Depth, 2, 1);
  EXPECT_EQ(samples.layer.size(), 2U);
  EXPECT_EQ(samples.depth.size(), 2U);
  EXPECT_TRUE(samples.value.empty());
}

/// Traced frames contain exactly the requested buffers, on all sheets.
TEST(SampleBuffers, OfFramesAreThoseThatWereAskedFor)
{
  const LayeredScene scene(true);
  const Camera camera(ObliqueView(), 9, 7);
  for (const Buffer buffer :
    { Buffer::Value, Buffer::Position, Buffer::Normal, Buffer::Xi, Buffer::Element, Buffer::Depth,
      Buffer::Verdict, Buffer::Coverage, Buffer::Enclosure, Buffer::Layer, Buffer::Piece })
  {
    const Frame frame = Trace(scene.scene_, camera, {}, { .centres = buffer });
    const Frame corners = Trace(scene.scene_, camera, {}, { .corners = buffer });
    EXPECT_EQ(frame.centres.behind.size(), 2U);
    for (const SampleBuffers* samples : { &frame.centres, &corners.corners })
    {
      for (const SampleBuffers* sheet : SheetsOf(*samples))
      {
        ForEachBuffer(
          [&](const auto& row)
          {
            EXPECT_EQ((sheet->*row.member).size(),
              row.buffer == buffer ? samples->Size() : std::size_t{ 0 })
              << row.name;
          });
        EXPECT_TRUE(sheet->color.empty());
      }
    }
    EXPECT_TRUE(frame.Image().empty());
  }
}
} // namespace pixelexact::testing
