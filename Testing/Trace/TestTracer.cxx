// SPDX-License-Identifier: BSD-3-Clause
#include "Block.h"
#include "InstructionSets.h"

#include "Trace/BufferTable.h"
#include "Trace/Modules/ColorMapping.h"
#include "Trace/TileVisit.h"
#include "Trace/Tracer.h"

#include "Core/Base/Error.h"
#include "Core/Location/Sample.h"
#include "Core/Math/Rounding.h"

#include <glm/geometric.hpp>
#include <tbb/global_control.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace pixelexact::testing
{
namespace
{
class Counting final : public FrameModule
{
public:
  explicit Counting(const SampleNeeds& needs)
    : Wanted(needs)
  {
  }
  [[nodiscard]] SampleNeeds Needs() const override { return Wanted; }
  void Begin(int width, int height) override
  {
    Seen.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  }
  void Process(TileVisit& tile) override
  {
    const TileArea& area = tile.Area();
    for (int y = area.y0; y < area.y1; ++y)
    {
      for (int x = area.x0; x < area.x1; ++x)
      {
        ++Seen[static_cast<std::size_t>(y * tile.GetFrame().width + x)];
      }
    }
    if (Wanted.corners != Buffer::None)
    {
      EXPECT_EQ(tile.Corners().width, area.Width() + 1);
      EXPECT_EQ(tile.Corners().height, area.Height() + 1);
      EXPECT_TRUE(tile.Corners().position.empty());
    }
  }

  std::vector<int> Seen; ///< how often each pixel was

private:
  SampleNeeds Wanted;
};
} // namespace

TEST(Tracer, EveryPixelIsExactOrNothing)
{
  Block block;
  const Scene& scene = block.WithPlane({ 0.0, 0.0, 0.1 }, { 0.1, 0.2, 1.0 });
  const Camera camera = ViewAlongZ(150, 150);
  const Frame frame = Trace(scene, camera, {}, { .centres = kAll });
  const auto& buffers = frame.centres;
  const Vec3 normal = glm::normalize(Vec3(0.1, 0.2, 1.0));
  int exact = 0;
  for (int j = 0; j < 150; ++j)
  {
    for (int i = 0; i < 150; ++i)
    {
      const std::size_t at = static_cast<std::size_t>(j) * 150 + i;
      const Ray ray = camera.At(i + 0.5, j + 0.5);
      // The cube's cross-section is convex: no pinhole can hide in this condition.
      const double z = 0.1 - (0.1 * ray.origin.x + 0.2 * ray.origin.y);
      const bool inside =
        std::fabs(ray.origin.x) < 1.0 && std::fabs(ray.origin.y) < 1.0 && std::fabs(z) < 1.0;
      ASSERT_EQ(buffers.verdict[at],
        static_cast<std::uint8_t>(inside ? PixelVerdict::Exact : PixelVerdict::Nothing))
        << i << " " << j;
      if (!inside)
      {
        EXPECT_TRUE(std::isnan(buffers.value[at]));
        EXPECT_EQ(buffers.element[at], -1);
        EXPECT_EQ(buffers.depth[at], kNoHit);
        continue;
      }
      ++exact;
      const Vec3& x = buffers.position[at];
      EXPECT_NEAR(glm::dot(normal, x - Vec3(0.0, 0.0, 0.1)), 0.0, 1e-15);
      EXPECT_NEAR(glm::length(x - (ray.origin + buffers.depth[at] * ray.direction)), 0.0, 1e-14);
      EXPECT_NEAR(buffers.value[at], x.x + 10.0 * x.y + 100.0 * x.z, 2e-13);
      EXPECT_NEAR(glm::length(buffers.normal[at] - normal), 0.0, 1e-15);
      EXPECT_GE(Margin(Shape::Hexahedron, buffers.xi[at]), -1e-13);
    }
  }
  EXPECT_EQ(frame.counters.exact, exact);
  EXPECT_EQ(frame.counters.unknown, 0);
  EXPECT_EQ(frame.counters.nothing, 150 * 150 - exact);
  EXPECT_EQ(frame.counters.rays, 150 * 150);
}

struct CornerCase
{
  const char* name;
  bool parallel;
  int width;
  int height;
};

class Corners : public ::testing::TestWithParam<CornerCase>
{
};

/// Every pixel's corners, each once, at the places that camera, plane and field have in closed
/// form.
TEST_P(Corners, AreOnThePlaneWhereTheCameraSeesThem)
{
  const auto [name, parallel, width, height] = GetParam();
  Block block;
  const LongVec3 through{ 0.1L, -0.05L, 0.2L };
  const LongVec3 across{ 0.3L, -0.2L, 1.0L };
  const LongVec3 unit = Unit(across);
  Scene& scene = block.WithPlane(ToDouble(through), ToDouble(across));
  block.MakeCurved();
  CameraView view;
  view.position = { 1.5, -2.0, 4.0 };
  view.focalPoint = { 0.1, 0.2, 0.0 };
  view.viewUp = { 0.3, 1.0, 0.1 };
  view.parallel = parallel;
  view.parallelScale = 1.5;
  view.viewAngle = 36.0;
  view.windowCenter = { 0.2, -0.1 };
  const Camera camera(view, width, height);
  const Frame frame = Trace(scene, camera, {}, { .corners = kAll });
  const SampleBuffers& corners = frame.corners;
  ASSERT_EQ(corners.width, width + 1);
  ASSERT_EQ(corners.height, height + 1);
  const auto count = static_cast<std::size_t>(width + 1) * static_cast<std::size_t>(height + 1);
  ASSERT_EQ(corners.verdict.size(), count);
  ASSERT_EQ(corners.position.size(), count);
  ASSERT_EQ(corners.value.size(), count);
  int exact = 0;
  int nothing = 0;
  for (std::size_t at = 0; at < count; ++at)
  {
    const int i = static_cast<int>(at) % (width + 1);
    const int j = static_cast<int>(at) / (width + 1);
    const auto [origin, direction] = RayThrough(view, width, height, i, j);
    const long double slope = Dot(unit, direction);
    const long double t = Dot(unit, Minus(through, origin)) / slope;
    const LongVec3 x = Plus(origin, Times(t, direction));
    // Some ten roundings of numbers of the distance's size, along a ray that is not steep.
    const auto rounding =
      static_cast<double>(16 * kUnitRoundoff * (Largest(origin) + t) / std::fabs(slope));
    if (std::fabs(Largest(x) - 1) < rounding)
    {
      continue;
    }
    if (Largest(x) > 1)
    {
      ++nothing;
      ASSERT_EQ(corners.verdict[at], static_cast<std::uint8_t>(PixelVerdict::Nothing))
        << i << " " << j;
      EXPECT_TRUE(std::isnan(corners.value[at]));
      EXPECT_TRUE(std::isnan(corners.position[at].x));
      EXPECT_EQ(corners.element[at], -1);
      EXPECT_EQ(corners.depth[at], kNoHit);
      continue;
    }
    ++exact;
    ASSERT_EQ(corners.verdict[at], static_cast<std::uint8_t>(PixelVerdict::Exact)) << i << " " << j;
    EXPECT_LE(Largest(Minus(ToLong(corners.position[at]), x)), rounding) << i << " " << j;
    EXPECT_NEAR(corners.depth[at], static_cast<double>(t), rounding);
    EXPECT_LE(Largest(Minus(ToLong(corners.normal[at]), unit)), 4.0 * kUnitRoundoff);
    const LongVec3 image =
      Block::Map(static_cast<int>(corners.element[at]), ToLong(corners.xi[at]));
    EXPECT_GE(Margin(Shape::Hexahedron, corners.xi[at]), -1e-14);
    EXPECT_LE(Largest(Minus(image, x)), rounding + 1e-15);
    // The gradient's norm, and the evaluation of numbers up to 13.
    EXPECT_NEAR(corners.value[at], static_cast<double>(Block::CurvedAt(x)),
      12.0 * rounding + 13.0 * Gamma(32));
  }
  const auto all = static_cast<int>(count);
  EXPECT_GT(exact, all / 4);
  EXPECT_GT(nothing, all / 10);
  EXPECT_GE(exact + nothing, all - 4);
  EXPECT_EQ(frame.counters.rays, all);
  EXPECT_EQ(frame.centres.Size(), 0U);

  // The same together with the centres.
  const Frame both = Trace(scene, camera, {}, { .centres = Buffer::Value, .corners = kAll });
  EXPECT_EQ(both.counters.rays, all + width * height);
  EXPECT_EQ(both.corners.verdict, corners.verdict);
  EXPECT_EQ(both.corners.element, corners.element);
  EXPECT_EQ(
    std::memcmp(both.corners.value.data(), corners.value.data(), count * sizeof(double)), 0);
  EXPECT_EQ(
    std::memcmp(both.corners.position.data(), corners.position.data(), count * sizeof(Vec3)), 0);
}

// Tiles are 32 samples wide: a part of one, one and the corner after it, exactly two.
INSTANTIATE_TEST_SUITE_P(Tracer, Corners,
  ::testing::Values(CornerCase{ "PerspectiveWide", false, 77, 45 },
    CornerCase{ "PerspectiveTall", false, 32, 64 }, CornerCase{ "ParallelWide", true, 77, 45 },
    CornerCase{ "ParallelTall", true, 31, 63 }),
  [](const auto& test) { return std::string(test.param.name); });

TEST(Tracer, ValueIsThatOfTheProbeAtThePosition)
{
  Block block;
  const Scene& scene = block.WithPlane(Vec3(0.0), { 0.3, -0.4, 1.0 });
  CameraView view;
  view.position = { 1.0, 2.0, 6.0 };
  const Frame frame = Trace(scene, Camera(view, 97, 61), {}, { .centres = kAll });
  const auto count = frame.centres.Size();
  std::vector<double> value(2 * count);
  std::vector<std::int32_t> element(count);
  SampleTarget target;
  target.value = value;
  target.element = element;
  Sample(*scene.locator, scene.layers[0].field, frame.centres.position, target);
  for (std::size_t i = 0; i < count; ++i)
  {
    if (frame.centres.verdict[i] == static_cast<std::uint8_t>(PixelVerdict::Exact))
    {
      EXPECT_EQ(frame.centres.value[i], value[2 * i]);
      EXPECT_EQ(frame.centres.element[i], element[i]);
    }
  }
}

TEST(Tracer, SameBitsForAnyNumberOfThreads)
{
  Block block;
  const Scene& scene = block.WithPlane(Vec3(0.0), { 0.3, -0.4, 1.0 });
  const Camera camera = ViewAlongZ(201, 133);
  const Frame many = Trace(scene, camera, {}, { .centres = kAll });
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  const Frame one = Trace(scene, camera, {}, { .centres = kAll });
  const auto bytes = many.centres.value.size() * sizeof(double);
  EXPECT_EQ(std::memcmp(many.centres.value.data(), one.centres.value.data(), bytes), 0);
  EXPECT_EQ(std::memcmp(many.centres.xi.data(), one.centres.xi.data(), 3 * bytes), 0);
  EXPECT_EQ(many.centres.verdict, one.centres.verdict);
}

TEST(Tracer, FramesInTheMemoryOfOthersHaveNothingOfThem)
{
  Block block;
  const Scene& scene = block.WithPlane({ 0.1, 0.05, -0.2 }, { 0.2, 0.1, 1.0 });
  const Camera large = ViewAlongZ(90, 70);
  const SampleNeeds all{ .centres = kAll, .corners = kAll };
  const SampleNeeds few{ .centres = Buffer::Value | Buffer::Verdict };
  for (const Camera& camera : { large, ViewAlongZ(40, 30), ViewAlongZ(120, 100) })
  {
    for (const SampleNeeds& needs : { all, few })
    {
      const Frame fresh = Trace(scene, camera, {}, needs);
      const Frame frame =
        Trace(scene, camera, {}, needs, {}, nullptr, Trace(scene, large, {}, all));
      EXPECT_EQ(frame.width, fresh.width);
      EXPECT_EQ(frame.counters.exact, fresh.counters.exact);
      EXPECT_EQ(frame.counters.rays, fresh.counters.rays);
      EXPECT_EQ(frame.corners.Size(), fresh.corners.Size());
      EXPECT_TRUE(frame.Image().empty());
      const auto isSame = [](const SampleBuffers& a, const SampleBuffers& b)
      {
        ForEachBuffer(
          [&](const auto& row)
          {
            const auto& values = a.*row.member;
            ASSERT_EQ(values.size(), (b.*row.member).size()) << row.name;
            const auto bytes = values.size() * sizeof(values.front());
            EXPECT_TRUE(
              values.empty() || std::memcmp(values.data(), (b.*row.member).data(), bytes) == 0)
              << row.name;
          });
      };
      isSame(frame.centres, fresh.centres);
      isSame(frame.corners, fresh.corners);
    }
  }
}

TEST(Tracer, RaysGoOnBehindSurfacesOutsideOfTheMesh)
{
  Block block;
  // The first plane lies in front of the mesh everywhere.
  block.WithPlane({ 0.0, 0.0, 2.0 }, { 0.0, 0.0, 1.0 });
  const Scene& scene = block.WithPlane(Vec3(0.0), { 0.0, 0.0, 1.0 });
  const Frame frame =
    Trace(scene, ViewAlongZ(20, 20, 0.9), {}, { .centres = Buffer::Depth | Buffer::Verdict });
  EXPECT_EQ(frame.counters.exact, 400);
  EXPECT_EQ(frame.centres.depth[210], 5.0);
  // The nearer plane wins where both are inside.
  block.WithPlane({ 0.0, 0.0, 0.5 }, { 0.0, 0.0, 1.0 });
  const Frame nearer =
    Trace(block.scene_, ViewAlongZ(20, 20, 0.9), {}, { .centres = Buffer::Depth });
  EXPECT_EQ(nearer.centres.depth[210], 4.5);
}

TEST(Tracer, CastsTheUnionOfWhatModulesNeedAndNoMore)
{
  Block block;
  const Scene& scene = block.WithPlane(Vec3(0.0), { 0.0, 0.0, 1.0 });
  Counting centres({ .centres = Buffer::Value });
  Counting corners({ .corners = Buffer::Value | Buffer::Verdict });
  const Camera camera = ViewAlongZ(40, 30);
  const Frame first = Trace(scene, camera, { {}, { &centres } });
  EXPECT_EQ(first.counters.rays, 40 * 30);
  EXPECT_EQ(first.corners.Size(), 0U);
  EXPECT_TRUE(first.centres.position.empty());
  EXPECT_EQ(std::ranges::count(centres.Seen, 1), 40 * 30);
  const Frame both = Trace(scene, camera, { {}, { &centres, &corners, &centres } });
  // Two tiles, which have a column of corners in common.
  EXPECT_EQ(both.counters.rays, 40 * 30 + 33 * 31 + 9 * 31);
  EXPECT_EQ(both.corners.Size(), 0U);
  EXPECT_EQ(std::ranges::count(centres.Seen, 2), 40 * 30);
  EXPECT_EQ(std::ranges::count(corners.Seen, 1), 40 * 30);
}

TEST(Tracer, ComponentsMagnitudeAndNan)
{
  Block block;
  Scene& scene = block.WithPlane({ 0.0, 0.0, -0.5 }, { 0.0, 0.0, 1.0 });
  scene.layers[0].component = 1;
  const Frame component =
    Trace(scene, ViewAlongZ(20, 20, 0.9), {}, { .centres = Buffer::Value | Buffer::Verdict });
  EXPECT_EQ(component.counters.exact, 400);
  // The first element covers about a quarter of the cross-section; its NaN stays within it.
  EXPECT_GT(component.counters.nonFinite, 50);
  EXPECT_LT(component.counters.nonFinite, 200);
  scene.layers[0].component = kMagnitude;
  const Frame magnitude = Trace(scene, ViewAlongZ(20, 20, 0.9), {}, { .centres = kAll });
  const std::size_t at = 399;
  const Vec3& x = magnitude.centres.position[at];
  EXPECT_NEAR(magnitude.centres.value[at], std::hypot(x.x + 10 * x.y + 100 * x.z, 1.0), 1e-12);
}

TEST(Tracer, ColoursByVerdict)
{
  Block block;
  const Scene& scene = block.WithPlane(Vec3(0.0), { 0.0, 0.0, 1.0 });
  const ColorMapping module(
    [](std::span<const double> values, std::uint8_t* rgba)
    {
      for (const double v : values)
      {
        const std::uint8_t color[4] = { v > 0.0 ? std::uint8_t{ 200 } : std::uint8_t{ 100 }, 1, 2,
          255 };
        rgba = std::copy_n(color, 4, rgba);
      }
    });
  const Frame frame = Trace(scene, ViewAlongZ(60, 60), { { &module }, {} });
  for (std::size_t i = 0; i < frame.centres.Size(); ++i)
  {
    const bool exact = frame.centres.verdict[i] == static_cast<std::uint8_t>(PixelVerdict::Exact);
    EXPECT_EQ(frame.Image()[4 * i + 3], exact ? 255 : 0);
    if (exact)
    {
      EXPECT_EQ(frame.Image()[4 * i], frame.centres.value[i] > 0.0 ? 200 : 100);
    }
  }
}

TEST(Tracer, ProgressCanAbort)
{
  Block block;
  const Scene& scene = block.WithPlane(Vec3(0.0), { 0.0, 0.0, 1.0 });
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  double last = 0.0;
  const Camera camera = ViewAlongZ(200, 200);
  Trace(scene, camera, {}, { .centres = Buffer::Verdict },
    [&](double done)
    {
      EXPECT_GT(done, last);
      last = done;
      return true;
    });
  EXPECT_EQ(last, 1.0);
  const Frame aborted = Trace(
    scene, camera, {}, { .centres = Buffer::Verdict }, [](double done) { return done < 0.5; });
  EXPECT_LT(aborted.counters.rays, 200 * 200);
}

TEST(Tracer, RefusesScenesThatShowNothing)
{
  Block block;
  const Camera camera = ViewAlongZ(8, 8);
  EXPECT_THROW(Trace(block.scene_, camera, {}), Error);
  Scene& scene = block.WithPlane(Vec3(0.0), { 0.0, 0.0, 1.0 });
  scene.layers[0].component = 2;
  EXPECT_THROW(Trace(scene, camera, {}), Error);
  scene.layers[0].component = 0;
  scene.layers[0].field = nullptr;
  for (const Buffer values : { Buffer::Value, Buffer::Enclosure })
  {
    EXPECT_THROW(Trace(scene, camera, {}, { .centres = values }), Error);
  }
  scene.layers[0].surface = nullptr;
  EXPECT_THROW(Trace(scene, camera, {}), Error);
}

TEST(Tracer, MeshesWithoutFieldAreCutInOneColour)
{
  Block block;
  Scene& scene = block.WithPlane({ 0.0, 0.0, 0.1 }, { 0.1, 0.2, 1.0 });
  const Camera camera = ViewAlongZ(120, 90);
  const Buffer places = Buffer::Verdict | Buffer::Element | Buffer::Xi | Buffer::Position;
  const Frame exact = Trace(scene, camera, {}, { .centres = places });
  scene.layers[0].field = nullptr;
  const Rgba color{ 1, 2, 3, 255 };
  const ColorMapping colors(
    std::vector<LayerColors>{ { .map = SolidColor(color), .readsValues = false } });
  const Frame frame = Trace(scene, camera, { { &colors }, {} }, { .centres = places });
  EXPECT_TRUE(frame.centres.value.empty());
  EXPECT_EQ(frame.centres.verdict, exact.centres.verdict);
  EXPECT_EQ(frame.centres.element, exact.centres.element);
  EXPECT_GT(frame.counters.exact, 100);
  EXPECT_EQ(frame.counters.nonFinite, 0);
  for (std::size_t i = 0; i < frame.centres.Size(); ++i)
  {
    const bool hit = frame.centres.verdict[i] == static_cast<std::uint8_t>(PixelVerdict::Exact);
    EXPECT_TRUE(std::ranges::equal(
      std::span(frame.Image()).subspan(4 * i, 4), hit ? color : Rgba{ 0, 0, 0, 0 }));
  }
}

TEST(Tracer, FloatsChangeValuesAloneAndReportHowMuch)
{
  Block block;
  Scene scene = block.WithPlane({ 0.0, 0.0, 0.1 }, { 0.1, 0.2, 1.0 });
  const Camera camera = ViewAlongZ(120, 90);
  const Frame exact = Trace(scene, camera, {}, { .centres = kAll });
  EXPECT_EQ(exact.counters.floatCheck.points, 0);
  scene.layers[0].precision = Precision::Float;
  const Frame frame = Trace(scene, camera, {}, { .centres = kAll });
  EXPECT_EQ(frame.centres.verdict, exact.centres.verdict);
  EXPECT_EQ(frame.centres.element, exact.centres.element);
  EXPECT_EQ(std::memcmp(frame.centres.xi.data(), exact.centres.xi.data(),
              exact.centres.Size() * sizeof(Vec3)),
    0);
  EXPECT_GT(frame.counters.floatCheck.points, 100);
  // For values up to 111: 17 roundoffs of a float.
  EXPECT_GT(frame.counters.floatCheck.largest, 0.0);
  EXPECT_LT(frame.counters.floatCheck.largest, 111 * 1e-6);
  double largest = 0.0;
  for (std::size_t i = 0; i < exact.centres.Size(); ++i)
  {
    if (exact.centres.verdict[i] == static_cast<std::uint8_t>(PixelVerdict::Exact))
    {
      largest = std::max(largest, std::fabs(frame.centres.value[i] - exact.centres.value[i]));
    }
  }
  EXPECT_GE(largest, frame.counters.floatCheck.largest);
  EXPECT_LT(largest, 3.0 * frame.counters.floatCheck.largest);
  EXPECT_THROW((void)Trace(scene, camera, {}, { .centres = Buffer::Enclosure }), Error);
}

TEST(Tracer, EveryInstructionSetFindsTheSamePixels)
{
  Block block;
  const Scene& scene = block.WithPlane({ 0.0, 0.0, 0.1 }, { 0.1, 0.2, 1.0 });
  const Camera camera = ViewAlongZ(120, 90);
  const Frame usual = Trace(scene, camera, {}, { .centres = kAll });
  OnEveryInstructionSet(
    [&]
    {
      const Frame frame = Trace(scene, camera, {}, { .centres = kAll });
      EXPECT_EQ(frame.centres.verdict, usual.centres.verdict);
      EXPECT_EQ(frame.centres.element, usual.centres.element);
      for (std::size_t i = 0; i < usual.centres.Size(); ++i)
      {
        if (usual.centres.verdict[i] == static_cast<std::uint8_t>(PixelVerdict::Exact))
        {
          EXPECT_NEAR(frame.centres.value[i], usual.centres.value[i], 111 * 2e-15);
        }
      }
    });
}
} // namespace pixelexact::testing
