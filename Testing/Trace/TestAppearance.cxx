// SPDX-License-Identifier: BSD-3-Clause
#include "Block.h"

#include "Core/Base/Error.h"
#include "Core/Contour/RoundValues.h"
#include "Trace/Appearance/Painter.h"
#include "Trace/Appearance/Resolve.h"
#include "Trace/Surfaces/Plane.h"
#include "Trace/View.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <memory>
#include <vector>

namespace pixelexact::testing
{
namespace
{
using Ends = std::array<double, 2>;

/// Grey levels over a range.
class GreyTable final : public ColorTable
{
public:
  explicit GreyTable(bool logarithmic = false)
    : Logarithmic(logarithmic)
  {
  }
  [[nodiscard]] ColorMap Over(const Ends& range) const override
  {
    return [range](std::span<const double> values, std::uint8_t* rgba)
    {
      for (const double value : values)
      {
        const double part = std::clamp((value - range[0]) / (range[1] - range[0]), 0.0, 1.0);
        const auto grey = static_cast<std::uint8_t>(255.0 * part);
        rgba = std::ranges::copy(Rgba{ grey, grey, grey, 255 }, rgba).out;
      }
    };
  }
  [[nodiscard]] bool IsLogarithmic() const override { return Logarithmic; }
  [[nodiscard]] bool IsOpaque() const override { return true; }
  [[nodiscard]] Ends RangeOfNothing() const override { return { 3.0, 4.0 }; }
  [[nodiscard]] bool IsSame(const ColorTable& other) const override { return &other == this; }

private:
  bool Logarithmic;
};

/// Three layers, and a frame whose values are written by hand: two sheets of four pixels.
struct AppearanceScene
{
  Block block;
  View view{ nullptr, { block.scene_.locator, {}, {} }, {}, {} };
  Scene& scene = view.scene;
  Appearance& appearance = view.appearance;
  Frame frame;
  FieldRanges fields;

  AppearanceScene()
  {
    const auto plane = std::make_shared<Plane>(Vec3(0.0), Vec3(0.0, 0.0, 1.0));
    for (std::size_t k = 0; k < 3; ++k)
    {
      scene.layers.push_back({ plane, &block.field_ });
      appearance.layers.emplace_back();
      appearance.layers.back().table = std::make_shared<GreyTable>();
    }
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    const auto write = [](SampleBuffers& samples, const std::vector<double>& values,
                         const std::vector<std::uint8_t>& layers)
    {
      samples.Allocate(Buffer::Value | Buffer::Verdict | Buffer::Layer, 4, 1);
      samples.value = values;
      samples.layer = layers;
      samples.verdict.assign(4, kExactPixel);
    };
    frame.width = 4;
    frame.height = 1;
    write(frame.centres, { -0.5, 0.25, 100.0, kNan }, { 0, 1, 2, 0 });
    frame.centres.verdict[2] = kUnknownPixel;
    frame.centres.behind.emplace_back();
    write(frame.centres.behind.front(), { 0.75, 2.0, 0.125, 0.5 }, { 0, 1, 2, 2 });
  }

  [[nodiscard]] Ends RangeOf(std::size_t layer)
  {
    return *Resolve(view, &frame, fields).layers[layer].range;
  }
};
} // namespace

TEST(Appearance, GroupsHaveTheRangeOfTheValuesThatTheirLayersShow)
{
  AppearanceScene made;
  EXPECT_EQ(made.RangeOf(0), (Ends{ -0.5, 2.0 }));
  made.appearance.layers[1].rangeGroup = 1;
  EXPECT_EQ(made.RangeOf(0), (Ends{ -0.5, 0.75 }));
  EXPECT_EQ(made.RangeOf(1), (Ends{ 0.25, 2.0 }));
  // A layer in one colour counts where the range determines its contours.
  made.appearance.layers[0].solid = Rgba{ 1, 2, 3, 255 };
  EXPECT_EQ(made.RangeOf(2), (Ends{ 0.125, 0.5 }));
  made.appearance.layers[0].contours.count = 2;
  EXPECT_EQ(made.RangeOf(2), (Ends{ -0.5, 0.75 }));
  EXPECT_EQ(Resolve(made.view, &made.frame, made.fields).layers[0].contours,
    RoundValues(2, { -0.5, 0.75 }));
}

TEST(Appearance, RangesFollowTheirRules)
{
  AppearanceScene made;
  RangeRule& rule = made.appearance.layers[0].range;
  rule.symmetric = true;
  EXPECT_EQ(made.RangeOf(0), (Ends{ -2.0, 2.0 }));
  // Six exact finite values: -0.5, 0.125, 0.25, 0.5, 0.75, 2; the ranks are 0.2 times 5 and 0.5
  // times 5.
  rule = { RangeRule::Of::Parts, { 20.0, 50.0 } };
  EXPECT_EQ(made.RangeOf(0), (Ends{ 0.125, 0.375 }));
  rule = { RangeRule::Of::Ends, { 7.0, 8.0 } };
  EXPECT_EQ(made.RangeOf(0), (Ends{ 7.0, 8.0 }));
  rule = { RangeRule::Of::All };
  const std::vector<ValueRange> ofAll{ Ends{ -9.0, 9.0 }, std::nullopt, std::nullopt };
  EXPECT_EQ(Resolve(made.view, &made.frame, made.fields, ofAll).layers[0].range,
    ValueRange(Ends{ -9.0, 9.0 }));
  rule = { RangeRule::Of::Field };
  const Ends proven = made.RangeOf(0);
  const auto own = made.fields.Of(made.scene.locator->GetMesh(), made.block.field_, 0);
  EXPECT_EQ(ValueRange(proven), own);
}

TEST(Appearance, LogarithmsCountValuesAboveZero)
{
  AppearanceScene made;
  for (LayerAppearance& layer : made.appearance.layers)
  {
    layer.table = std::make_shared<GreyTable>(true);
  }
  EXPECT_EQ(made.RangeOf(0), (Ends{ 0.125, 2.0 }));
  // A range that is not above 0: the table keeps its own.
  made.appearance.layers[1].range = { RangeRule::Of::Ends, { -1.0, 2.0 } };
  made.appearance.layers[1].contours.count = 1;
  EXPECT_EQ(Resolve(made.view, &made.frame, made.fields).layers[1].contours,
    RoundValues(1, { 3.0, 4.0 }, true));
}

TEST(Appearance, WithoutValuesTheRangeIsThatOfTheTable)
{
  AppearanceScene made;
  made.appearance.layers[0].contours.count = 4;
  const ResolvedAppearance before = Resolve(made.view, nullptr, made.fields);
  EXPECT_EQ(before.layers[0].range, ValueRange(Ends{ 3.0, 4.0 }));
  EXPECT_TRUE(before.layers[0].contours.empty());
  EXPECT_TRUE(made.appearance.NeedsFrame());
  made.appearance.layers.resize(1);
  made.scene.layers.resize(1);
  made.appearance.layers[0].range = { RangeRule::Of::Ends, { 0.0, 1.0 } };
  made.appearance.layers[0].contours = { .values = { 0.5 } };
  EXPECT_FALSE(made.appearance.NeedsFrame());
  // The table's colour of 0.5.
  EXPECT_EQ(Resolve(made.view, nullptr, made.fields).layers[0].contourColors,
    (std::vector<Rgba>{ { 127, 127, 127, 255 } }));
  made.scene.layers[0].field = nullptr;
  EXPECT_THROW((void)Resolve(made.view, nullptr, made.fields), Error);
}

TEST(Appearance, PipelinesDrawWhatIsAskedForInOneOrder)
{
  AppearanceScene made;
  const auto modules = [&made](const Drawn& drawn = {})
  {
    Painter painter(made.view, Resolve(made.view, &made.frame, made.fields));
    return painter.MakePipeline(drawn).modules.size();
  };
  EXPECT_EQ(modules(), 0U);
  made.appearance.samples = 4;
  made.appearance.edges = EdgeStyle();
  made.appearance.outlines = Rgba{ 0, 0, 0, 255 };
  EXPECT_EQ(modules(), 3U);
  made.appearance.layers[0].contours.values = { 0.5 };
  EXPECT_EQ(modules(), 5U);
  EXPECT_EQ(modules({ .edges = false }), 4U);
  EXPECT_EQ(modules({ .edges = false, .contours = false }), 3U);
}

TEST(Appearance, BandsHaveTheColourOfTheirMiddle)
{
  AppearanceScene made;
  const auto greys = [&made](const std::vector<double>& values)
  {
    std::vector<Rgba> colors(values.size());
    Resolve(made.view, &made.frame, made.fields).layers[0].map(values, colors[0].data());
    std::vector<int> red;
    std::ranges::transform(colors, std::back_inserter(red), [](const Rgba& c) { return c[0]; });
    return red;
  };
  LayerAppearance& layer = made.appearance.layers[0];
  layer.range = { RangeRule::Of::Ends, { 0.0, 1.0 } };
  layer.bands = 4;
  EXPECT_EQ(
    greys({ -7.0, 0.0, 0.24, 0.26, 1.0, 7.0 }), (std::vector<int>{ 31, 31, 31, 95, 223, 223 }));
  // Bands of equal ratio: from 1 to 10 and from 10 to 100.
  layer.table = std::make_shared<GreyTable>(true);
  layer.range = { RangeRule::Of::Ends, { 1.0, 100.0 } };
  layer.bands = 2;
  EXPECT_EQ(greys({ 1.0, 5.0, 50.0, 200.0 }), (std::vector<int>{ 5, 5, 78, 78 }));
}

TEST(Appearance, UndecidedPixelsAreMarkedOnSurfacesWithTheColoursOfValues)
{
  AppearanceScene made;
  const auto isMarked = [&made]
  {
    Painter painter(made.view, Resolve(made.view, &made.frame, made.fields));
    const bool marks = painter.Undecided() != nullptr;
    EXPECT_EQ(marks, Has(NeedsOf(made.view), Buffer::Enclosure));
    EXPECT_EQ(marks, painter.MakePipeline().colors.back() == painter.Undecided());
    return marks;
  };
  EXPECT_FALSE(isMarked());
  made.appearance.undecided = Rgba{ 255, 0, 0, 255 };
  EXPECT_TRUE(isMarked());
  made.appearance.samples = 4;
  EXPECT_THROW(isMarked(), Error);
  made.appearance.samples = 1;
  made.appearance.layers[0].contours.values = { 0.5 };
  made.appearance.contours.only = Rgba{};
  EXPECT_FALSE(isMarked());
  made.appearance.contours.only.reset();
  for (LayerAppearance& layer : made.appearance.layers)
  {
    layer.solid = Rgba{ 1, 2, 3, 255 };
  }
  EXPECT_FALSE(isMarked());
}

TEST(Appearance, LabelsAreLeftOutWhereSheetsAreDrawnOneByOne)
{
  AppearanceScene made;
  made.appearance.layers[0].contours.values = { 0.5 };
  made.appearance.contours.labels = 12;
  const auto labels = [&made]
  {
    const Painter painter(made.view, Resolve(made.view, &made.frame, made.fields));
    return painter.Labels();
  };
  EXPECT_EQ(labels(), 12);
  made.appearance.bySheets = true;
  EXPECT_EQ(labels(), 12);
  made.scene.layers[1].translucent = true;
  EXPECT_EQ(labels(), std::nullopt);
  made.appearance.bySheets = false;
  EXPECT_EQ(labels(), 12);
}

TEST(Appearance, IsTheSameWhereAllSettingsAre)
{
  AppearanceScene made;
  const Appearance same = made.appearance;
  EXPECT_TRUE(made.appearance == same);
  made.appearance.layers[2].opacity = 0.5;
  EXPECT_FALSE(made.appearance == same);
  made.appearance = same;
  made.appearance.layers[1].table = std::make_shared<GreyTable>();
  EXPECT_FALSE(made.appearance == same);
  made.appearance = same;
  made.appearance.contours.method.interior = true;
  EXPECT_FALSE(made.appearance == same);
}
} // namespace pixelexact::testing
