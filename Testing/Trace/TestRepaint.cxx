// SPDX-License-Identifier: BSD-3-Clause
// Colours are the same whenever they are made: with the rays, later, in passes, by any threads.
#include "FrameCheck.h"
#include "LayeredScene.h"

#include "Core/Base/Error.h"
#include "Trace/ProgressiveFrame.h"
#include "Trace/TileVisit.h"

#include <tbb/global_control.h>

#include <gtest/gtest.h>

namespace pixelexact::testing
{
namespace
{
constexpr int kRepaintWidth = 75;
constexpr int kRepaintHeight = 50;

/// Writes a buffer with the largest difference of the values at a pixel's centre and corners, and
/// divides the image's red by two.
class Spread final : public FrameModule
{
public:
  [[nodiscard]] SampleNeeds Needs() const override
  {
    return { .centres = Buffer::Value, .corners = Buffer::Value };
  }
  void Begin(int width, int height) override
  {
    spread.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), -1.0);
  }
  void Process(TileVisit& tile) override
  {
    const TileArea& area = tile.Area();
    Frame& frame = tile.GetFrame();
    const SampleBuffers& corners = tile.Corners();
    for (int y = area.y0; y < area.y1; ++y)
    {
      for (int x = area.x0; x < area.x1; ++x)
      {
        const auto at = static_cast<std::size_t>(y * frame.width + x);
        const auto corner = static_cast<std::size_t>((y - area.y0) * corners.width + x - area.x0);
        spread[at] = std::fabs(frame.centres.value[at] - corners.value[corner]);
        if (!frame.color.empty())
        {
          frame.color[4 * at] /= 2;
        }
      }
    }
  }

  std::vector<double> spread;
};

class Repainted : public ::testing::TestWithParam<bool>
{
public:
  LayeredScene scene{ GetParam() };
  Camera camera{ ObliqueView(), kRepaintWidth, kRepaintHeight };
};

/// Every sheet's and the image's colours.
void ExpectSameColors(const Frame& a, const Frame& b)
{
  EXPECT_EQ(a.color, b.color);
  EXPECT_EQ(a.centres.color, b.centres.color);
  ASSERT_EQ(a.centres.behind.size(), b.centres.behind.size());
  for (std::size_t k = 0; k < a.centres.behind.size(); ++k)
  {
    EXPECT_EQ(a.centres.behind[k].color, b.centres.behind[k].color);
  }
}
} // namespace

TEST_P(Repainted, ColoursAreThoseOfATracedFrame)
{
  const ColorMapping colors = LayeredColors();
  const ColorMapping others = LayeredColors(0.17);
  const Pipeline pipeline{ { &colors }, {} };
  const Frame wanted = Trace(scene.scene_, camera, pipeline);
  ASSERT_EQ(wanted.Image().size(), std::size_t{ 4 } * kRepaintWidth * kRepaintHeight);
  EXPECT_GT(std::ranges::count(wanted.centres.layer, 0), 300);
  EXPECT_GT(std::ranges::count(wanted.centres.layer, 1), 300);
  EXPECT_EQ(wanted.color.empty(), !GetParam());
  EXPECT_EQ(wanted.centres.behind.size(), GetParam() ? 2U : 0U);

  Frame frame = Trace(scene.scene_, camera, {}, { .centres = pipeline.Needs().centres });
  EXPECT_TRUE(frame.Image().empty());
  for (const bool withScene : { false, true })
  {
    for (const Pipeline& by : { Pipeline{ { &others }, {} }, pipeline })
    {
      const std::int64_t rays = frame.counters.rays;
      withScene ? Repaint(scene.scene_, camera, by, frame) : Repaint(by, frame);
      EXPECT_EQ(frame.counters.rays, rays);
      EXPECT_EQ(by.colors[0] == &colors, frame.Image() == wanted.Image());
    }
    ExpectSame(frame, wanted);
    ExpectSameColors(frame, wanted);
  }
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  const Frame one = Trace(scene.scene_, camera, pipeline);
  ExpectSame(one, wanted);
  ExpectSameColors(one, wanted);
}

TEST_P(Repainted, ModulesThatAskForSamplesNeedTheScene)
{
  const ColorMapping colors = LayeredColors();
  Spread module;
  const Pipeline pipeline{ { &colors }, { &module } };
  const Frame wanted = Trace(scene.scene_, camera, pipeline);
  const std::vector<double> spread = module.spread;
  ASSERT_EQ(spread.size(), std::size_t{ kRepaintWidth } * kRepaintHeight);
  EXPECT_EQ(std::ranges::count(spread, -1.0), 0);

  // The module's buffer against the frame's own corners.
  const Frame apart =
    Trace(scene.scene_, camera, {}, { .centres = Buffer::Value, .corners = Buffer::Value });
  for (int at = 0; at < kRepaintWidth * kRepaintHeight; ++at)
  {
    const auto i = static_cast<std::size_t>(at);
    const auto corner =
      static_cast<std::size_t>(at / kRepaintWidth * (kRepaintWidth + 1) + at % kRepaintWidth);
    const double expected = std::fabs(apart.centres.value[i] - apart.corners.value[corner]);
    EXPECT_TRUE(spread[i] == expected || (std::isnan(spread[i]) && std::isnan(expected)));
  }
  // Compares the image with the one without the module.
  const Frame plain = Trace(scene.scene_, camera, { { &colors }, {} });
  for (std::size_t i = 0; i < wanted.Image().size(); ++i)
  {
    EXPECT_EQ(wanted.Image()[i], i % 4 == 0 ? plain.Image()[i] / 2 : plain.Image()[i]);
  }
  EXPECT_EQ(wanted.centres.color, plain.centres.color);

  Frame frame = Trace(scene.scene_, camera, {}, { .centres = pipeline.Needs().centres });
  EXPECT_THROW(Repaint(pipeline, frame), Error);
  const std::int64_t corners = wanted.counters.rays - kRepaintWidth * kRepaintHeight;
  EXPECT_GT(corners, (kRepaintWidth + 1) * (kRepaintHeight + 1));
  Repaint(scene.scene_, camera, pipeline, frame);
  EXPECT_EQ(frame.counters.rays, wanted.counters.rays);
  ExpectSame(frame, wanted);
  ExpectSameColors(frame, wanted);
  EXPECT_TRUE(SameBytes(module.spread, spread));
  // Repainting without the module gives the image of a pipeline that never had it.
  Repaint({ { &colors }, {} }, frame);
  ExpectSameColors(frame, plain);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  ExpectSameColors(Trace(scene.scene_, camera, pipeline), wanted);
  EXPECT_TRUE(SameBytes(module.spread, spread));
}

TEST_P(Repainted, FramesInPassesHaveTheSameColours)
{
  const ColorMapping colors = LayeredColors();
  const ColorMapping others = LayeredColors(0.17);
  for (const bool withModule : { false, true })
  {
    Spread module;
    const Pipeline pipeline{ { &colors },
      withModule ? std::vector<FrameModule*>{ &module } : std::vector<FrameModule*>{} };
    const Frame wanted = Trace(scene.scene_, camera, pipeline);
    const std::vector<double> spread = module.spread;
    for (int passes = 0; passes <= 4; ++passes)
    {
      SCOPED_TRACE(passes);
      module.spread.clear();
      // Begun in the wrong colours where there is time to change them.
      Pipeline first = pipeline;
      first.colors = { passes == 0 ? &colors : &others };
      ProgressiveFrame frame(scene.scene_, camera, first);
      for (int pass = 0; pass < passes; ++pass)
      {
        if (pass == passes / 2)
        {
          frame.Recolor(pipeline);
        }
        EXPECT_TRUE(frame.Refine());
        EXPECT_EQ(frame.Get().Image().empty(), frame.Step() > 1);
        EXPECT_EQ(module.spread.empty(), !withModule || frame.Step() > 1);
      }
      EXPECT_TRUE(frame.Complete());
      EXPECT_TRUE(SameBytes(module.spread, spread));
      ExpectSame(frame.Get(), wanted);
      ExpectSameColors(frame.Get(), wanted);
      // Other colours once all is known are a matter of repainting.
      Frame taken = frame.Take();
      Repaint({ { &others }, {} }, taken);
      ExpectSameColors(taken, Trace(scene.scene_, camera, { { &others }, {} }));
    }
  }
}

/// Buffers that are requested in addition to the pipeline's, on all sheets and in all passes.
TEST_P(Repainted, FramesInPassesHaveTheSameBuffers)
{
  constexpr Buffer kWanted = kAll | Buffer::Layer | Buffer::Coverage | Buffer::Enclosure;
  const Frame wanted = Trace(scene.scene_, camera, {}, { .centres = kWanted });
  for (const int passes : { 0, 2, 4 })
  {
    const ColorMapping colors = LayeredColors();
    ProgressiveFrame frame(scene.scene_, camera, { { &colors }, {} }, kWanted);
    frame.Recolor({});
    for (int pass = 0; pass < passes; ++pass)
    {
      EXPECT_TRUE(frame.Refine());
    }
    EXPECT_TRUE(frame.Complete());
    ExpectSame(frame.Get(), wanted);
  }
}

/// Blocks of pixels in the colours that their known pixel will have.
TEST_P(Repainted, PreviewsAreColouredAsTheFrameWillBe)
{
  const ColorMapping colors = LayeredColors();
  const ColorMapping others = LayeredColors(0.17);
  const Frame wanted = Trace(scene.scene_, camera, { { &colors }, {} });
  Spread module;
  ProgressiveFrame frame(scene.scene_, camera, { { &others }, { &module } });
  frame.Recolor({ { &colors }, { &module } });
  for (const int step : { 16, 4, 1 })
  {
    ASSERT_TRUE(frame.Refine());
    const Frame preview = frame.Preview();
    const int across = (kRepaintWidth + step - 1) / step;
    ASSERT_EQ(preview.width, across);
    for (std::size_t i = 0; i < preview.Image().size(); ++i)
    {
      const auto x = static_cast<int>(i / 4) % across * step;
      const auto y = static_cast<int>(i / 4) / across * step;
      const auto of = static_cast<std::size_t>(y * kRepaintWidth + x);
      ASSERT_EQ(preview.Image()[i], wanted.Image()[4 * of + i % 4]) << x << " " << y;
    }
  }
}

/// An aborted frame without passes contains some tiles, but none of their colours.
TEST_P(Repainted, AbortedFramesHaveNoColours)
{
  const ColorMapping colors = LayeredColors();
  Spread module;
  const Pipeline pipeline{ { &colors }, { &module } };
  const Frame wanted = Trace(scene.scene_, camera, pipeline);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  ProgressiveFrame frame(scene.scene_, camera, pipeline);
  EXPECT_FALSE(frame.Complete([](double done) { return done < 0.5; }));
  EXPECT_EQ(frame.Step(), 0);
  EXPECT_GT(frame.Get().counters.rays, 0);
  EXPECT_TRUE(frame.Get().Image().empty());
  EXPECT_TRUE(frame.Get().centres.color.empty());
  EXPECT_TRUE(frame.Refine());
  EXPECT_TRUE(frame.Get().Image().empty());
  EXPECT_TRUE(frame.Complete());
  ExpectSame(frame.Get(), wanted);
  ExpectSameColors(frame.Get(), wanted);
}

INSTANTIATE_TEST_SUITE_P(Repaint, Repainted, ::testing::Bool(),
  [](const auto& test) { return std::string(test.param ? "Translucent" : "Opaque"); });
} // namespace pixelexact::testing
