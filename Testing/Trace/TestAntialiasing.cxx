// SPDX-License-Identifier: BSD-3-Clause
// Edges against the area that they cover of each pixel, counted in closed form on 64 x 64 points.
#include "FrameCheck.h"
#include "LayeredScene.h"
#include "SheetCheck.h"

#include "Core/Base/Error.h"
#include "Trace/Modules/Antialiasing.h"
#include "Trace/Modules/DebugColors.h"
#include "Trace/ProgressiveFrame.h"

#include <tbb/global_control.h>

#include <gtest/gtest.h>

namespace pixelexact::testing
{
namespace
{
/// Everything in one colour.
ColorMapping Plain(double opacity = 1.0)
{
  const ColorMap map = [](std::span<const double> values, std::uint8_t* rgba)
  {
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      rgba = std::copy_n(std::array<std::uint8_t, 4>{ 200, 100, 50, 255 }.data(), 4, rgba);
    }
  };
  return ColorMapping(std::vector{ LayerColors{ map, { 255, 0, 255, 255 }, opacity } });
}

struct Scenery
{
  const char* name;
  bool isDisc;
  CameraView view;
};

CameraView MakeTurnedView(double viewAngle)
{
  CameraView view;
  view.position = { 0.3, -0.4, 5.0 };
  view.viewUp = { 0.3, 1.0, 0.0 };
  view.parallel = viewAngle == 0.0;
  view.parallelScale = 1.5;
  view.viewAngle = viewAngle == 0.0 ? 30.0 : viewAngle;
  return view;
}

/// A sphere in the cube, or a plane whose edge is that of the cube.
class Edges : public ::testing::TestWithParam<Scenery>
{
public:
  static constexpr int kWidth = 37;
  static constexpr int kHeight = 35;

  Edges()
  {
    const auto sphere = std::make_shared<Quadric>(MakeSphere(kCentre, kRadius));
    const auto plane = std::make_shared<Plane>(Vec3(0.0), Vec3(0.0, 0.0, 1.0));
    block.scene_.layers.push_back({ nullptr, &block.field_ });
    block.scene_.layers[0].surface =
      GetParam().isDisc ? std::shared_ptr<const Surface>(sphere) : plane;
  }

  /// Whether the ray through an image position meets the scene.
  [[nodiscard]] static bool IsCovered(double px, double py)
  {
    const LongRay ray = RayThrough(GetParam().view, kWidth, kHeight, px, py);
    if (GetParam().isDisc)
    {
      const LongVec3 from = Minus(ray.origin, ToLong(kCentre));
      const LongVec3 nearest = Minus(from, Times(Dot(from, ray.direction), ray.direction));
      return Dot(nearest, nearest) <= static_cast<long double>(kRadius) * kRadius;
    }
    return Largest(Plus(ray.origin, Times(-ray.origin[2] / ray.direction[2], ray.direction))) <= 1;
  }

  /// The part of a pixel that is covered.
  [[nodiscard]] static double AreaOf(int x, int y)
  {
    constexpr int kSide = 64;
    int covered = 0;
    for (int k = 0; k < kSide * kSide; ++k)
    {
      covered += IsCovered(x + (k % kSide + 0.5) / kSide, y + (k / kSide + 0.5) / kSide) ? 1 : 0;
    }
    return static_cast<double>(covered) / (kSide * kSide);
  }

  /// Whether centre and corners are not all alike.
  [[nodiscard]] static bool IsSplit(int x, int y)
  {
    const bool centre = IsCovered(x + 0.5, y + 0.5);
    return centre != IsCovered(x, y) || centre != IsCovered(x + 1, y) ||
      centre != IsCovered(x, y + 1) || centre != IsCovered(x + 1, y + 1);
  }

  static constexpr Vec3 kCentre{ 0.03, 0.02, 0.0 };
  static constexpr double kRadius = 0.9;
  Block block;
  Camera camera{ GetParam().view, kWidth, kHeight };
};
} // namespace

TEST_P(Edges, ShowTheAreaThatIsCovered)
{
  for (const bool translucent : { false, true })
  {
    block.scene_.layers[0].translucent = translucent;
    const ColorMapping colors = Plain(translucent ? 0.6 : 1.0);
    // A sphere has two sheets.
    const double full = !translucent ? 1.0 : GetParam().isDisc ? 1.0 - 0.4 * 0.4 : 0.6;
    std::vector<double> area;
    for (const int samples : { 4, 16, 61 })
    {
      SCOPED_TRACE(samples);
      Antialiasing module(samples);
      const Frame frame = Trace(block.scene_, camera, { { &colors }, { &module } });
      int split = 0;
      double squares = 0.0;
      for (int y = 0; y < kHeight; ++y)
      {
        for (int x = 0; x < kWidth; ++x)
        {
          const std::uint8_t* color =
            &frame.Image()[static_cast<std::size_t>(4 * (y * kWidth + x))];
          if (!IsSplit(x, y))
          {
            EXPECT_NEAR(color[3], IsCovered(x + 0.5, y + 0.5) ? 255.0 * full : 0.0, 0.6);
            continue;
          }
          if (area.size() == static_cast<std::size_t>(split))
          {
            area.push_back(AreaOf(x, y));
          }
          const double covered = area[static_cast<std::size_t>(split++)];
          const double error = color[3] / 255.0 / full - covered;
          EXPECT_LE(std::fabs(error), 1.5 / std::sqrt(samples) * 0.6) << x << " " << y;
          squares += error * error;
          if (color[3] > 10)
          {
            // The colour itself is not mixed with that of empty samples.
            EXPECT_NEAR(color[0], 200, 1);
            EXPECT_NEAR(color[1], 100, 1);
            EXPECT_NEAR(color[2], 50, 1);
          }
        }
      }
      EXPECT_EQ(module.Refined(), split);
      EXPECT_GT(split, 60);
      // On average the error is much smaller than for the same number of random samples, 0.4 /
      // sqrt(samples).
      EXPECT_LT(std::sqrt(squares / split), 0.25 / std::sqrt(samples));
    }
  }
}

TEST_P(Edges, LeaveTheBuffersAlone)
{
  const ColorMapping colors = Plain();
  Antialiasing module(9);
  const Frame plain = Trace(block.scene_, camera, { { &colors }, {} });
  const Frame frame = Trace(block.scene_, camera, { { &colors }, { &module } });
  ExpectSame(frame.centres, plain.centres);
  EXPECT_EQ(frame.centres.color, plain.centres.color);
  EXPECT_NE(frame.Image(), plain.Image());
  EXPECT_EQ(frame.counters.exact, plain.counters.exact);
  // Two tiles each way; 9 samples for each pixel that is refined.
  EXPECT_EQ(frame.counters.rays, kWidth * kHeight + (33 + 6) * (33 + 4) + 9 * module.Refined());
  // One sample in the middle gives the same image.
  Antialiasing one(1);
  const Frame same = Trace(block.scene_, camera, { { &colors }, { &one } });
  EXPECT_EQ(same.Image(), plain.Image());
  EXPECT_EQ(one.Refined(), module.Refined());
}

INSTANTIATE_TEST_SUITE_P(Antialiasing, Edges,
  ::testing::Values(Scenery{ "Disc", true, MakeTurnedView(0.0) },
    Scenery{ "DiscNear", true, MakeTurnedView(31.0) },
    Scenery{ "Square", false, MakeTurnedView(0.0) },
    Scenery{ "SquareNear", false, MakeTurnedView(33.0) }),
  [](const auto& test) { return std::string(test.param.name); });

TEST(Antialiasing, IsTheSameWhereverItIsMade)
{
  const ColorMapping colors = LayeredColors();
  for (const bool translucent : { false, true })
  {
    const LayeredScene scene(translucent);
    const Camera camera(ObliqueView(), 70, 50);
    Antialiasing module(8);
    const Pipeline pipeline{ { &colors }, { &module } };
    const Frame wanted = Trace(scene.scene_, camera, pipeline);
    const std::int64_t refined = module.Refined();
    EXPECT_GT(refined, 500);
    ProgressiveFrame frame(scene.scene_, camera, pipeline);
    EXPECT_TRUE(frame.Refine());
    EXPECT_TRUE(frame.Complete());
    ExpectSame(frame.Get(), wanted);
    EXPECT_EQ(module.Refined(), refined);
    Frame repainted = Trace(scene.scene_, camera, {}, { .centres = colors.Needs() });
    Repaint(scene.scene_, camera, pipeline, repainted);
    ExpectSame(repainted, wanted);
    EXPECT_EQ(module.Refined(), refined);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    ExpectSame(Trace(scene.scene_, camera, pipeline), wanted);
  }
}

/// Colours of different opacities count by how much they show.
TEST(Antialiasing, MixesWhatShows)
{
  Block block;
  const Field& side = block.Add(1, [](const LongVec3& x, long double* u) { u[0] = x[0]; });
  Scene& scene = block.WithPlane({ 0.0, 0.0, 0.1 }, { 0.0, 0.0, 1.0 });
  scene.layers[0].field = &side;
  const ColorMapping colors(
    [](std::span<const double> values, std::uint8_t* rgba)
    {
      for (const double v : values)
      {
        const std::array<std::uint8_t, 4> left{ 250, 0, 100, 51 };
        const std::array<std::uint8_t, 4> right{ 0, 200, 100, 255 };
        rgba = std::ranges::copy(v < 0.0 ? left : right, rgba).out;
      }
    });
  // A step of colour at x = 0: the middle one of five pixels is cut in two.
  Antialiasing module(64);
  const Frame frame = Trace(scene, ViewAlongZ(5, 5, 0.9), { { &colors }, { &module } });
  EXPECT_EQ(module.Refined(), 5);
  for (int y = 0; y < 5; ++y)
  {
    const std::uint8_t* row = &frame.Image()[static_cast<std::size_t>(20 * y)];
    EXPECT_EQ(std::vector<int>(row, row + 4), (std::vector{ 250, 0, 100, 51 }));
    EXPECT_EQ(std::vector<int>(row + 16, row + 20), (std::vector{ 0, 200, 100, 255 }));
    // Children: alpha (0.2 + 1) / 2, colours weighted 1 to 5.
    EXPECT_NEAR(row[8], 250.0 / 6.0, 1.0);
    EXPECT_NEAR(row[9], 200.0 * 5.0 / 6.0, 1.0);
    EXPECT_NEAR(row[10], 100.0, 0.0);
    EXPECT_NEAR(row[11], 0.6 * 255.0, 1.0);
  }
}

TEST(Antialiasing, WithoutColoursOrSamples)
{
  EXPECT_THROW(Antialiasing(0), Error);
  EXPECT_THROW(Antialiasing(-3), Error);
  const LayeredScene scene(false);
  Antialiasing module(4);
  const Frame frame = Trace(scene.scene_, Camera(ObliqueView(), 20, 20), { {}, { &module } });
  EXPECT_TRUE(frame.Image().empty());
  EXPECT_EQ(frame.counters.rays, 400);
  EXPECT_EQ(module.Refined(), 0);
}

/// All buffers that the colours read also exist for samples between the centres.
TEST(Antialiasing, AsksForWhatTheColoursNeed)
{
  const LayeredScene scene(false);
  const CoverageColors owners;
  Antialiasing module(4);
  const Frame frame =
    Trace(scene.scene_, Camera(ObliqueView(), 40, 30), { { &owners }, { &module } });
  EXPECT_GT(module.Refined(), 0);
  EXPECT_GT(std::ranges::count(frame.Image(), 255), 0);
}
} // namespace pixelexact::testing
