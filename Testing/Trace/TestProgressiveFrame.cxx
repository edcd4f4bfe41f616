// SPDX-License-Identifier: BSD-3-Clause
#include "FrameCheck.h"
#include "MeshBuilder.h"

#include "Trace/ProgressiveFrame.h"
#include "Trace/Surfaces/Plane.h"
#include "Trace/Tracer.h"

#include "Core/Base/Error.h"

#include <gtest/gtest.h>

namespace pixelexact::testing
{
namespace
{
/// A bent cube about the origin with the field x y + z.
class Cube
{
public:
  Cube()
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
    TheField = { "u", Values.View() };
    TheLocator = std::make_unique<Locator>(Elements.View());
    TheScene.locator = TheLocator.get();
    TheScene.layers.push_back(
      { std::make_shared<Plane>(Vec3(0.0, 0.0, 0.1), Vec3(0.1, 0.2, 1.0)), &TheField });
  }

  Scene TheScene;

private:
  Field TheField;
  MeshBuilder Elements;
  ExpansionBuilder Values{ 1 };
  std::unique_ptr<Locator> TheLocator;
};

Camera View(int width, int height)
{
  CameraView view;
  view.position = { 0.5, 0.0, 5.0 };
  return { view, width, height };
}

constexpr Buffer kAll = Buffer::Value | Buffer::Position | Buffer::Normal | Buffer::Xi |
  Buffer::Element | Buffer::Depth | Buffer::Verdict | Buffer::Coverage;
} // namespace

TEST(ProgressiveFrame, EndsAsAFrameMadeAtOnce)
{
  const Cube cube;
  // Sizes that no step divides, one smaller than a step.
  for (const auto& [width, height] : { std::pair(93, 71), std::pair(64, 40), std::pair(5, 3) })
  {
    const Camera camera = View(width, height);
    const Frame wanted = Trace(cube.TheScene, camera, {}, { .centres = kAll });
    ProgressiveFrame frame(cube.TheScene, camera, {}, kAll);
    EXPECT_EQ(frame.Step(), 0);
    for (const int step : { 8, 4, 2, 1 })
    {
      ASSERT_TRUE(frame.Refine());
      ASSERT_EQ(frame.Step(), step);
      const Frame preview = frame.Preview();
      for (int y = 0; y < height; ++y)
      {
        for (int x = 0; x < width; ++x)
        {
          const auto at = static_cast<std::size_t>(y * width + x);
          const auto of = static_cast<std::size_t>((y - y % step) * width + (x - x % step));
          EXPECT_EQ(preview.centres.verdict[at], wanted.centres.verdict[of]);
          EXPECT_EQ(preview.centres.depth[at], wanted.centres.depth[of]);
        }
      }
    }
    ExpectSame(frame.Get(), wanted);
    EXPECT_TRUE(frame.Refine());
    ExpectSame(frame.Take(), wanted);
  }
}

TEST(ProgressiveFrame, MayBeCompletedAtAnyTime)
{
  const Cube cube;
  const Camera camera = View(93, 71);
  const Frame wanted = Trace(cube.TheScene, camera, {}, { .centres = kAll });
  for (int passes = 0; passes <= 3; ++passes)
  {
    ProgressiveFrame frame(cube.TheScene, camera, {}, kAll);
    for (int pass = 0; pass < passes; ++pass)
    {
      ASSERT_TRUE(frame.Refine());
    }
    EXPECT_TRUE(frame.Complete());
    EXPECT_EQ(frame.Step(), 1);
    ExpectSame(frame.Get(), wanted);
  }
}

TEST(ProgressiveFrame, AbortedPassesAreMadeAgain)
{
  const Cube cube;
  const Camera camera = View(93, 71);
  const Frame wanted = Trace(cube.TheScene, camera, {}, { .centres = kAll });
  ProgressiveFrame frame(cube.TheScene, camera, {}, kAll);
  const Progress abort = [](double) { return false; };
  EXPECT_FALSE(frame.Refine(abort));
  EXPECT_EQ(frame.Step(), 0);
  EXPECT_TRUE(frame.Refine());
  EXPECT_FALSE(frame.Complete(abort));
  EXPECT_EQ(frame.Step(), 8);
  EXPECT_TRUE(frame.Complete());
  ExpectSame(frame.Get(), wanted);
}

TEST(ProgressiveFrame, ScenesThatCannotBeTraced)
{
  EXPECT_THROW(ProgressiveFrame({}, View(9, 9), {}, Buffer::Value), Error);
}
} // namespace pixelexact::testing
