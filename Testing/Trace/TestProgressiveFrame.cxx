// SPDX-License-Identifier: BSD-3-Clause
#include "Block.h"
#include "FrameCheck.h"

#include "Trace/ProgressiveFrame.h"
#include "Trace/Surfaces/Plane.h"
#include "Trace/Tracer.h"

#include "Core/Base/Error.h"

#include <tbb/global_control.h>

#include <gtest/gtest.h>

namespace pixelexact::testing
{
namespace
{
/// A bent cube about the origin with the field x y + z.
class CurvedCube
{
public:
  CurvedCube()
  {
    const Space space = UniformSpace(Shape::Hexahedron, 4);
    const auto map = [](const LongVec3& xi) -> LongVec3 {
      return { xi[0] + 0.2L * xi[1] * xi[2], xi[1] - 0.1L * xi[0] * xi[0], xi[2] };
    };
    Elements.Add(space, map);
    Values.Add(space,
      [&](const LongVec3& xi, long double* u)
      {
        const LongVec3 x = map(xi);
        u[0] = x[0] * x[1] + x[2];
      });
    field_ = { "u", Values.View() };
    locator_ = std::make_unique<Locator>(Elements.View());
    scene_.locator = locator_.get();
    scene_.layers.push_back(
      { std::make_shared<Plane>(Vec3(0.0, 0.0, 0.1), Vec3(0.1, 0.2, 1.0)), &field_ });
  }

  Scene scene_;

private:
  Field field_;
  MeshBuilder Elements;
  ExpansionBuilder Values{ 1 };
  std::unique_ptr<Locator> locator_;
};

Camera MakeCubeView(int width, int height)
{
  CameraView view;
  view.position = { 0.5, 0.0, 5.0 };
  return { view, width, height };
}

/// The frame of every step-th pixel.
void ExpectEvery(int step, const Frame& coarse, const Frame& wanted)
{
  ASSERT_EQ(coarse.width, (wanted.width + step - 1) / step);
  ASSERT_EQ(coarse.height, (wanted.height + step - 1) / step);
  for (int y = 0; y < coarse.height; ++y)
  {
    for (int x = 0; x < coarse.width; ++x)
    {
      const auto at = static_cast<std::size_t>(y * coarse.width + x);
      const auto of = static_cast<std::size_t>(y * step * wanted.width + x * step);
      ASSERT_EQ(coarse.centres.verdict[at], wanted.centres.verdict[of]);
      ASSERT_EQ(coarse.centres.depth[at], wanted.centres.depth[of]);
    }
  }
}

constexpr Buffer kAllWithCoverage = kAll | Buffer::Coverage;
} // namespace

TEST(ProgressiveFrame, EndsAsAFrameMadeAtOnce)
{
  const CurvedCube cube;
  // Sizes that no step divides, one smaller than a step.
  for (const auto& [width, height] : { std::pair(93, 71), std::pair(256, 160), std::pair(5, 3) })
  {
    const Camera camera = MakeCubeView(width, height);
    const Frame wanted = Trace(cube.scene_, camera, {}, { .centres = kAllWithCoverage });
    ProgressiveFrame frame(cube.scene_, camera, {}, kAllWithCoverage);
    EXPECT_EQ(frame.Step(), 0);
    for (const int step : { 16, 4, 1 })
    {
      ASSERT_TRUE(frame.Refine());
      ASSERT_EQ(frame.Step(), step);
      ExpectEvery(step, frame.Preview(), wanted);
    }
    ExpectSame(frame.Get(), wanted);
    EXPECT_TRUE(frame.Refine());
    ExpectSame(frame.Take(), wanted);
  }
}

TEST(ProgressiveFrame, MayBeCompletedAtAnyTime)
{
  const CurvedCube cube;
  const Camera camera = MakeCubeView(93, 71);
  const Frame wanted = Trace(cube.scene_, camera, {}, { .centres = kAllWithCoverage });
  for (int passes = 0; passes <= 3; ++passes)
  {
    // The frame reuses the memory of another frame.
    Frame spare = Trace(cube.scene_, MakeCubeView(120, 90), {},
      { .centres = kAllWithCoverage, .corners = kAllWithCoverage });
    ProgressiveFrame frame(
      cube.scene_, camera, {}, kAllWithCoverage, Buffer::None, std::move(spare));
    for (int pass = 0; pass < passes; ++pass)
    {
      ASSERT_TRUE(frame.Refine());
    }
    EXPECT_TRUE(frame.Complete());
    EXPECT_EQ(frame.Step(), 1);
    ExpectSame(frame.Get(), wanted);
  }
}

TEST(ProgressiveFrame, PassesGoOnWhereTheyWereEnded)
{
  const CurvedCube cube;
  const Camera camera = MakeCubeView(193, 171);
  const Frame wanted = Trace(cube.scene_, camera, {}, { .centres = kAllWithCoverage });
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  for (const bool byTime : { false, true })
  {
    ProgressiveFrame frame(cube.scene_, camera, {}, kAllWithCoverage);
    frame.GoTo(1);
    // Six by seven tiles, one by one.
    for (int tile = 1; tile < 6 * 7; ++tile)
    {
      EXPECT_FALSE(
        byTime ? frame.Refine({}, Deadline::min()) : frame.Refine([](double) { return false; }));
      EXPECT_EQ(frame.Step(), 0);
      EXPECT_NEAR(frame.PartDone(), tile / 42.0, 1e-12);
      EXPECT_FALSE(frame.IsComplete());
    }
    // The last tile, and what comes after it.
    while (!frame.IsComplete())
    {
      (void)frame.Refine({}, Deadline::min());
    }
    ExpectSame(frame.Get(), wanted);
  }
}

TEST(ProgressiveFrame, ACoarseFrameMayBeMadeBesideAFineOne)
{
  const CurvedCube cube;
  const Camera camera = MakeCubeView(193, 171);
  const Frame wanted = Trace(cube.scene_, camera, {}, { .centres = kAllWithCoverage });
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  for (const int step : { 1, 4, 16 })
  {
    ProgressiveFrame frame(cube.scene_, camera, {}, kAllWithCoverage);
    frame.GoTo(step);
    EXPECT_FALSE(frame.Refine({}, Deadline::min()));
    const double part = frame.PartDone();
    EXPECT_GT(part, 0.0);
    frame.Fill();
    EXPECT_EQ(frame.Step(), 16);
    EXPECT_EQ(frame.PartDone(), step == 16 ? 0.0 : part);
    EXPECT_EQ(frame.NextStep(), step == 16 ? 4 : step);
    ExpectEvery(16, frame.Preview(), wanted);
    EXPECT_TRUE(frame.Complete());
    ExpectSame(frame.Get(), wanted);
  }
}

TEST(ProgressiveFrame, AFrameMadeAtOnceIsLostWhereItIsEnded)
{
  const CurvedCube cube;
  const Camera camera = MakeCubeView(193, 171);
  const Frame wanted = Trace(cube.scene_, camera, {}, { .centres = kAllWithCoverage });
  ProgressiveFrame frame(cube.scene_, camera, {}, kAllWithCoverage);
  const Progress abort = [](double) { return false; };
  EXPECT_FALSE(frame.Complete(abort));
  EXPECT_EQ(frame.Step(), 0);
  EXPECT_EQ(frame.PartDone(), 0.0);
  EXPECT_TRUE(frame.Refine());
  EXPECT_EQ(frame.Step(), 16);
  EXPECT_TRUE(frame.Complete());
  ExpectSame(frame.Get(), wanted);
}

TEST(ProgressiveFrame, ScenesThatCannotBeTraced)
{
  EXPECT_THROW(ProgressiveFrame({}, MakeCubeView(9, 9), {}, Buffer::Value), Error);
}
} // namespace pixelexact::testing
