// SPDX-License-Identifier: BSD-3-Clause
// What modules are given: tiles, corners, samples on edges and wherever they like.
#include "FrameCheck.h"
#include "LayeredScene.h"
#include "SheetCheck.h"

#include "Trace/TileVisit.h"

#include <gtest/gtest.h>

#include <mutex>
#include <optional>
#include <set>

namespace pixelexact::testing
{
namespace
{
/// Calls what the test gives it.
class Asking final : public FrameModule
{
public:
  using Ask = std::function<void(TileVisit& tile)>;

  Asking(const SampleNeeds& needs, Ask ask)
    : Wanted(needs)
    , ask_(std::move(ask))
  {
  }
  [[nodiscard]] SampleNeeds Needs() const override { return Wanted; }
  void Begin(int width, int height) override
  {
    ++frames;
    size = { width, height };
  }
  void Process(TileVisit& tile) override
  {
    const std::scoped_lock lock(OneAtATime);
    ask_(tile);
  }

  int frames = 0;
  std::pair<int, int> size;

private:
  SampleNeeds Wanted;
  Ask ask_;
  std::mutex OneAtATime;
};

/// Sample `from` of one set is sample `to` of the other, bit for bit, on all sheets.
void ExpectSameSample(
  const SampleBuffers& a, std::size_t from, const SampleBuffers& b, std::size_t to)
{
  const auto first = SheetsOf(a);
  const auto second = SheetsOf(b);
  const auto nothing = [](const SampleBuffers& sheet, std::size_t at)
  { return sheet.verdict[at] == static_cast<std::uint8_t>(PixelVerdict::Nothing); };
  for (std::size_t k = 0; k < std::max(first.size(), second.size()); ++k)
  {
    if (k >= first.size() || k >= second.size())
    {
      // A sheet is there as soon as any of the samples has it.
      EXPECT_TRUE(k < first.size() ? nothing(*first[k], from) : nothing(*second[k], to));
      continue;
    }
    ForEachBuffer(
      [&](const auto& row)
      {
        const auto& x = first[k]->*row.member;
        const auto& y = second[k]->*row.member;
        ASSERT_EQ(x.empty(), y.empty()) << row.name;
        if (!x.empty())
        {
          EXPECT_EQ(std::memcmp(&x[from], &y[to], sizeof x[from]), 0) << row.name << " " << k;
        }
      });
  }
}

struct PipelineCase
{
  const char* name;
  bool translucent;
};

class Pipelines : public ::testing::TestWithParam<PipelineCase>
{
};
} // namespace

TEST_P(Pipelines, GiveEachTileOnce)
{
  const LayeredScene scene(GetParam().translucent);
  for (const auto& [width, height] : { std::pair(70, 40), std::pair(32, 33), std::pair(5, 1) })
  {
    std::multiset<std::array<int, 4>> areas;
    const Frame* seen = nullptr;
    Asking module({ .centres = kAllWithLayer },
      [&](TileVisit& tile)
      {
        const TileArea& area = tile.Area();
        areas.insert({ area.x0, area.y0, area.x1, area.y1 });
        EXPECT_EQ(area.Width(), area.x1 - area.x0);
        EXPECT_EQ(area.Height(), area.y1 - area.y0);
        seen = &tile.GetFrame();
        EXPECT_EQ(tile.GetFrame().centres.depth.size(), static_cast<std::size_t>(width * height));
        EXPECT_EQ(tile.SamplesPerEdge(), 0);
        EXPECT_EQ(tile.EdgesUp().Size(), 0U);
        EXPECT_EQ(tile.Counters().rays, 0);
      });
    const Frame frame =
      Trace(scene.scene_, Camera(ObliqueView(), width, height), { {}, { &module } });
    std::multiset<std::array<int, 4>> expected;
    for (int y = 0; y < height; y += kTileSize)
    {
      for (int x = 0; x < width; x += kTileSize)
      {
        expected.insert({ x, y, std::min(x + kTileSize, width), std::min(y + kTileSize, height) });
      }
    }
    EXPECT_EQ(areas, expected);
    EXPECT_NE(seen, nullptr);
    EXPECT_EQ(module.frames, 1);
    EXPECT_EQ(module.size, std::pair(width, height));
    EXPECT_EQ(frame.counters.rays, width * height);
    EXPECT_TRUE(frame.color.empty());
  }
}

TEST_P(Pipelines, GiveTheCornersThatAFrameHas)
{
  const LayeredScene scene(GetParam().translucent);
  const Camera camera(ObliqueView(), 71, 45);
  const Frame wanted = Trace(scene.scene_, camera, {}, { .corners = kAllWithLayer });
  EXPECT_EQ(wanted.corners.behind.empty(), !GetParam().translucent);
  std::int64_t rays = 0;
  Asking module({ .corners = kAllWithLayer },
    [&](TileVisit& tile)
    {
      const TileArea& area = tile.Area();
      SampleBuffers& corners = tile.Corners();
      ASSERT_EQ(corners.width, area.Width() + 1);
      ASSERT_EQ(corners.height, area.Height() + 1);
      for (int y = 0; y < corners.height; ++y)
      {
        for (int x = 0; x < corners.width; ++x)
        {
          ExpectSameSample(corners, static_cast<std::size_t>(y * corners.width + x), wanted.corners,
            static_cast<std::size_t>((area.y0 + y) * wanted.corners.width + area.x0 + x));
        }
      }
      // Corners are cast once for several requests.
      EXPECT_EQ(&tile.Corners(), &corners);
      EXPECT_EQ(tile.Counters().rays, static_cast<std::int64_t>(corners.Size()));
      rays += static_cast<std::int64_t>(corners.Size());
    });
  const Frame frame = Trace(scene.scene_, camera, { {}, { &module, &module } });
  EXPECT_EQ(frame.counters.rays, 71 * 45 + rays / 2);
  EXPECT_EQ(frame.corners.Size(), 0U);
  // Corners are no pixels.
  EXPECT_EQ(frame.counters.exact + frame.counters.nothing, 71 * 45);
}

TEST_P(Pipelines, GiveTheCentresThatModulesWelcome)
{
  const LayeredScene scene(GetParam().translucent);
  const Camera camera(ObliqueView(), 71, 45);
  const Frame wanted = Trace(scene.scene_, camera, {}, { .centres = kAllWithLayer });
  int visits = 0;
  Asking module({ .centres = Buffer::Depth, .welcome = kAllWithLayer },
    [&](TileVisit& tile)
    {
      const TileArea& area = tile.Area();
      const std::optional<LatticePart> centres = tile.Centres();
      ASSERT_TRUE(centres.has_value());
      for (int y = area.y0; y < area.y1; ++y)
      {
        for (int x = area.x0; x < area.x1; ++x)
        {
          ExpectSameSample(centres->samples, centres->At(x, y), wanted.centres,
            static_cast<std::size_t>(y * 71 + x));
        }
      }
      EXPECT_EQ(tile.Counters().rays, 0);
      ++visits;
    });
  Frame frame = Trace(scene.scene_, camera, { {}, { &module } });
  EXPECT_EQ(visits, 6);
  EXPECT_EQ(frame.counters.rays, 71 * 45);
  EXPECT_EQ(frame.counters.exact, wanted.counters.exact);
  EXPECT_EQ(frame.centres.depth, wanted.centres.depth);
  // Frames keep them only where modules come after all tiles.
  EXPECT_EQ(frame.centres.Holds(kAllWithLayer), GetParam().translucent);
  // Optional buffers that do not exist are not traced.
  Asking again({ .welcome = kAllWithLayer },
    [&](TileVisit& tile) { EXPECT_EQ(tile.Centres().has_value(), GetParam().translucent); });
  Repaint(scene.scene_, camera, { {}, { &again } }, frame);
  EXPECT_EQ(frame.counters.rays, 71 * 45);
}

/// Samples at the centres of pixels an eighth as wide.
TEST_P(Pipelines, TraceSamplesAnywhere)
{
  const LayeredScene scene(GetParam().translucent);
  constexpr int kFine = 8;
  constexpr int kWidth = 37;
  constexpr int kHeight = 34;
  const Frame fine = Trace(scene.scene_, Camera(ObliqueView(), kFine * kWidth, kFine * kHeight), {},
    { .centres = kAllWithLayer });
  Random random(3);
  Asking module({},
    [&](TileVisit& tile)
    {
      const TileArea& area = tile.Area();
      for (const int count : { 1, 7, 700 })
      {
        std::vector<ImagePosition> positions;
        std::vector<std::size_t> places;
        for (int i = 0; i < count; ++i)
        {
          const int x = static_cast<int>(random(kFine * area.x0, kFine * area.x1));
          const int y = static_cast<int>(random(kFine * area.y0, kFine * area.y1));
          positions.push_back({ (x + 0.5) / kFine, (y + 0.5) / kFine });
          places.push_back(static_cast<std::size_t>(y * kFine * kWidth + x));
        }
        const std::int64_t before = tile.Counters().rays;
        const SampleBuffers samples = tile.Trace(positions, kAllWithLayer);
        EXPECT_EQ(tile.Counters().rays, before + count);
        ASSERT_EQ(samples.width, count);
        ASSERT_EQ(samples.height, 1);
        for (std::size_t i = 0; i < places.size(); ++i)
        {
          ExpectSameSample(samples, i, fine.centres, places[i]);
        }
      }
      // Verdicts are there unasked; nothing else is.
      const std::vector<ImagePosition> one{ { 1.0, 1.0 } };
      const SampleBuffers few = tile.Trace(one, Buffer::Depth);
      EXPECT_EQ(few.verdict.size(), 1U);
      EXPECT_EQ(few.depth.size(), 1U);
      EXPECT_TRUE(few.value.empty());
      EXPECT_EQ(tile.Trace({}, kAllWithLayer).Size(), 0U);
    });
  const Frame frame =
    Trace(scene.scene_, Camera(ObliqueView(), kWidth, kHeight), { {}, { &module } });
  EXPECT_EQ(frame.counters.rays, kWidth * kHeight + 4 * 709);
  EXPECT_EQ(frame.counters.exact + frame.counters.nothing, kWidth * kHeight);
}

INSTANTIATE_TEST_SUITE_P(Pipeline, Pipelines,
  ::testing::Values(PipelineCase{ "Opaque", false }, PipelineCase{ "Translucent", true }),
  [](const auto& test) { return std::string(test.param.name); });

/// A plane across the view, where image and world differ only by a factor.
TEST(Pipeline, SamplesOnEdges)
{
  Block block;
  const Scene& scene = block.WithPlane(Vec3(0.0), { 0.0, 0.0, 1.0 });
  constexpr int kWidth = 45;
  constexpr int kHeight = 38;
  // All of the image is in the mesh; a pixel is 1.6 / 38 wide.
  const Camera camera = ViewAlongZ(kWidth, kHeight, 0.8);
  const auto inWorld = [](double px, double py) -> LongVec3
  {
    const long double pixel = 1.6L / kHeight;
    return { (px - kWidth / 2.0L) * pixel, (py - kHeight / 2.0L) * pixel, 0 };
  };
  for (int level = 1; level <= 3; ++level)
  {
    const int inEdge = (1 << level) - 1;
    std::int64_t asked = 0;
    Asking module({ .edges = Buffer::Position, .edgeLevel = level },
      [&](TileVisit& tile)
      {
        const TileArea& area = tile.Area();
        EXPECT_EQ(tile.SamplesPerEdge(), inEdge);
        for (const bool across : { false, true })
        {
          const SampleBuffers& edges = across ? tile.EdgesAcross() : tile.EdgesUp();
          EXPECT_TRUE(edges.value.empty());
          const int columns = area.Width() + (across ? 0 : 1);
          const int rows = area.Height() + (across ? 1 : 0);
          ASSERT_EQ(edges.position.size(), static_cast<std::size_t>(columns * rows * inEdge));
          asked += static_cast<std::int64_t>(edges.position.size());
          for (std::size_t i = 0; i < edges.position.size(); ++i)
          {
            const int edge = static_cast<int>(i) / inEdge;
            const double part = static_cast<double>(1 + i % inEdge) / (1 << level);
            const double px = area.x0 + edge % columns + (across ? part : 0.0);
            const double py = area.y0 + edge / columns + (across ? 0.0 : part);
            EXPECT_LE(Largest(Minus(ToLong(edges.position[i]), inWorld(px, py))), 1e-15);
          }
          EXPECT_EQ(&edges, across ? &tile.EdgesAcross() : &tile.EdgesUp());
        }
      });
    // The other one's needs are less: both get the most.
    Asking less({ .edges = Buffer::Verdict, .edgeLevel = 1 },
      [&](TileVisit& tile)
      {
        EXPECT_EQ(tile.SamplesPerEdge(), inEdge);
        EXPECT_FALSE(tile.EdgesUp().verdict.empty());
      });
    const Frame frame = Trace(scene, camera, { {}, { &module, &less } });
    EXPECT_EQ(frame.counters.rays, kWidth * kHeight + asked);
  }
}

TEST(Pipeline, NeedsAreTheUnion)
{
  Asking first({ .centres = Buffer::Depth, .edges = Buffer::Xi, .edgeLevel = 2 }, {});
  Asking second({ .centres = Buffer::Normal, .corners = Buffer::Layer, .edgeLevel = 1 }, {});
  const ColorMapping colors(Striped(1.0));
  const SampleNeeds needs = Pipeline{ { &colors }, { &first, &second } }.Needs();
  EXPECT_EQ(needs.centres, Buffer::Depth | Buffer::Normal | Buffer::Value | Buffer::Verdict);
  EXPECT_EQ(needs.corners, Buffer::Layer);
  EXPECT_EQ(needs.edges, Buffer::Xi);
  EXPECT_EQ(needs.edgeLevel, 2);
  EXPECT_TRUE(needs.BeyondCentres());
  EXPECT_FALSE((SampleNeeds{ .centres = Buffer::Value, .edgeLevel = 3 }.BeyondCentres()));
  EXPECT_FALSE((SampleNeeds{ .edges = Buffer::Value }.BeyondCentres()));
}
} // namespace pixelexact::testing
