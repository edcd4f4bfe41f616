// SPDX-License-Identifier: BSD-3-Clause
#include "FrameCheck.h"
#include "TrueLines.h"

#include "Trace/FrameTiles.h"
#include "Trace/Modules/ElementEdges.h"
#include "Trace/TileVisit.h"

#include "Core/Base/Error.h"

#include <tbb/global_control.h>

#include <array>
#include <memory>

namespace pixelexact::testing
{
namespace
{
/// `count` hexahedra in a row along x, from 0 to 1, with y and z from -1 to 1.
class Row
{
public:
  explicit Row(int count)
  {
    const Space space = UniformSpace(Shape::Hexahedron, 1);
    for (int e = 0; e < count; ++e)
    {
      const auto map = [e, count](const LongVec3& xi) {
        return LongVec3{ (e + (xi[0] + 1) / 2) / count, xi[1], xi[2] };
      };
      Elements.Add(space, map);
      Values.Add(space, [](const LongVec3&, long double* u) { u[0] = 1; });
    }
    field_ = { "u", Values.View() };
    locator_ = std::make_unique<Locator>(Elements.View());
    scene_.locator = locator_.get();
    scene_.layers.push_back(
      { std::make_shared<Plane>(Vec3(0.0, 0.0, 0.1), Vec3(0.0, 0.0, 1.0)), &field_ });
  }

  Field field_;
  Scene scene_;

private:
  MeshBuilder Elements;
  ExpansionBuilder Values{ 1 };
  std::unique_ptr<Locator> locator_;
};

/// An image of x from 0 to 1 whose pixels are `1 / pixels` wide, with one pixel beyond either end,
/// moved by a part of a pixel.
Camera AcrossRow(int pixels, double moved = 0.0)
{
  CameraView view;
  const double pixel = 1.0 / pixels;
  view.focalPoint = { 0.5 + moved * pixel, 0.0, 0.0 };
  view.position = view.focalPoint + Vec3(0.0, 0.0, 5.0);
  view.parallel = true;
  view.parallelScale = 2.0 * pixel;
  return { view, pixels + 2, 4 };
}

/// Faces in the order of FacesOf; the ends of a row.
FaceKind KindInRow(int count, int element, int face)
{
  const bool inner = (face == 1 && element > 0) || (face == 2 && element + 1 < count);
  return inner ? FaceKind::Interior : FaceKind::Boundary;
}
} // namespace

/// A straight line is its width wide wherever it lies among the pixels, and its middle is the face.
TEST(ElementEdges, HaveTheirWidthAndPlace)
{
  const Row row(2);
  const ColorMapping colors = MakeWhite();
  for (const double width : { 0.3, 1.0, 1.5, 4.0 })
  {
    ElementEdges edges(EdgeStyle::Plain(width, kBlack));
    for (const double moved : { -0.5, -0.3, 0.0, 0.1, 0.45 })
    {
      const Frame frame = Trace(row.scene_, AcrossRow(40, moved), { { &colors }, { &edges } });
      double sum = 0.0;
      for (int x = 6; x < frame.width - 6; ++x)
      {
        const double cover = CoverAt(frame, x, 1);
        // The part of the pixel between the line's sides.
        const double middle = 21.0 - moved;
        const double exact = std::max(
          0.0, std::min(x + 1.0, middle + 0.5 * width) - std::max(x + 0.0, middle - 0.5 * width));
        EXPECT_NEAR(cover, exact, 0.004) << x;
        sum += cover;
      }
      EXPECT_NEAR(sum, width, 0.01 * width + 0.01);
    }
  }
}

/// On curved surfaces: the part of a pixel within half the width of the true line, by counting
/// samples.
TEST(ElementEdges, CoverWhatIsNearTheLine)
{
  const Block block;
  TrueScene scene(block);
  scene.AddSphere({ 0.2, -0.1, 0.3 }, 0.6, { nullptr, &block.field_ }, &Block::CurvedAt);
  CameraView view;
  view.position = { 1.0, -1.5, 4.0 };
  view.viewAngle = 20.0;
  constexpr int kSize = 90;
  const ColorMapping colors = MakeWhite();
  for (const double width : { 1.0, 2.5 })
  {
    ElementEdges edges(EdgeStyle::Plain(width, kBlack));
    const Frame frame =
      Trace(scene.Traced, Camera(view, kSize, kSize), { { &colors }, { &edges } });
    const TrueLines truth(scene, view, kSize, kSize);
    double sum = 0.0;
    double exactSum = 0.0;
    int rough = 0;
    for (int y = 0; y < kSize; ++y)
    {
      for (int x = 0; x < kSize; ++x)
      {
        if (!truth.IsAlone(x + 0.5, y + 0.5, 0, 2.5))
        {
          continue;
        }
        constexpr int kCount = 10;
        int near = 0;
        for (int k = 0; k < kCount * kCount; ++k)
        {
          const double px = x + (k % kCount + 0.5) / kCount;
          const double py = y + (k / kCount + 0.5) / kCount;
          near += truth.To(px, py, 0).distance < 0.5 * width ? 1 : 0;
        }
        const double exact = near / static_cast<double>(kCount * kCount);
        const double cover = CoverAt(frame, x, y);
        // Where lines cross, their joint coverage is approximate.
        EXPECT_NEAR(cover, exact, 0.3) << x << " " << y;
        rough += std::fabs(cover - exact) > 0.1 ? 1 : 0;
        sum += cover;
        exactSum += exact;
      }
    }
    EXPECT_GT(exactSum, 100.0);
    EXPECT_NEAR(sum / exactSum, 1.0, 0.005);
    EXPECT_LT(rough, 5);
  }
}

TEST(ElementEdges, DistinguishKinds)
{
  const Row row(2);
  const ColorMapping colors = MakeWhite();
  EdgeStyle style = EdgeStyle::Plain(2.0, kBlack);
  style.colors[static_cast<std::size_t>(FaceKind::Boundary)] = kRed;
  ElementEdges edges(style, [](int element, int face) { return KindInRow(2, element, face); });
  for (const double moved : { -0.4, 0.2 })
  {
    const Frame frame = Trace(row.scene_, AcrossRow(40, moved), { { &colors }, { &edges } });
    double red = 0.0;
    double black = 0.0;
    for (int x = 1; x < 21; ++x)
    {
      const std::uint8_t* color = &frame.Image()[4 * static_cast<std::size_t>(frame.width + x)];
      red += (color[0] - color[1]) / 255.0;
      black += 1.0 - color[0] / 255.0;
    }
    // All of the boundary's line is inside; what of a pixel is beyond is drawn as the surface is.
    EXPECT_NEAR(red, 2.0, 0.51) << moved;
    EXPECT_NEAR(black, 1.0 + moved, 0.02);
  }
  // Half of the width where the sides are not distinguished.
  ElementEdges alike(EdgeStyle::Plain(2.0, kBlack));
  const Frame frame = Trace(row.scene_, AcrossRow(40), { { &colors }, { &alike } });
  EXPECT_NEAR(CoverAt(frame, 1, 1), 1.0, 0.01);
  EXPECT_NEAR(CoverAt(frame, 2, 1), 0.0, 0.01);
}

/// Elements of a pixel or two would else be all line.
TEST(ElementEdges, FadeWhereElementsAreSmall)
{
  const ColorMapping colors = MakeWhite();
  ElementEdges edges(EdgeStyle::Plain(1.5, kBlack));
  double before = 1.0;
  for (const int pixels : { 240, 120, 80, 60, 30, 20 })
  {
    const Row row(20);
    const Frame frame = Trace(row.scene_, AcrossRow(pixels), { { &colors }, { &edges } });
    double sum = 0.0;
    for (int x = 1; x <= pixels; ++x)
    {
      sum += CoverAt(frame, x, 1);
    }
    const double size = pixels / 20.0;
    // The lines' width, faded.
    const double part = std::clamp((size / 1.5 - 1.0) / 3.0, 0.0, 1.0);
    EXPECT_NEAR(sum / pixels, part * 1.5 / size, 0.15 * part * 1.5 / size + 0.003) << pixels;
    before = std::min(before, part);
  }
  EXPECT_EQ(before, 0.0);
}

namespace
{
/// The top of a row, z = 1, as a surface that returns the elements of its hits.
class Top final : public Surface
{
public:
  explicit Top(int count)
    : Count(count)
  {
  }
  void Meet(const RayLanes& rays, HitSlots& hits) const override
  {
    Whole.Meet(rays, hits);
    const HitLanes lanes = hits.Slot(0);
    const ElementLanes on = hits.Elements(0);
    for (int i = 0; i < rays.count; ++i)
    {
      const double x = lanes.position[0][i] * Count;
      const double y = lanes.position[1][i];
      if (!(x >= 0.0 && x <= Count && std::fabs(y) <= 1.0))
      {
        lanes.t[i] = kNoHit;
        continue;
      }
      on.element[i] = std::min(static_cast<int>(x), Count - 1);
      on.xi[0][i] = 2.0 * (x - on.element[i]) - 1.0;
      on.xi[1][i] = y;
      on.xi[2][i] = 1.0;
    }
  }
  [[nodiscard]] Vec3 Normal(const SurfacePoint& point) const override
  {
    return Whole.Normal(point);
  }

private:
  int Count;
  Plane Whole{ { 0.0, 0.0, 1.0 }, { 0.0, 0.0, 1.0 } };
};
} // namespace

/// Every hit lies on a face, which must not paint everything.
TEST(ElementEdges, AreDrawnOnFacesOfElements)
{
  Row row(2);
  const ColorMapping colors = MakeWhite();
  ElementEdges alike(EdgeStyle::Plain(2.0, kBlack));
  ElementEdges told(EdgeStyle::Plain(2.0, kBlack),
    [](int element, int face) { return KindInRow(2, element, face); });
  const std::shared_ptr<const Surface> plane =
    std::make_shared<Plane>(Vec3(0.0, 0.0, 1.0), Vec3(0.0, 0.0, 1.0));
  for (const auto& surface : { plane, std::shared_ptr<const Surface>(std::make_shared<Top>(2)) })
  {
    row.scene_.layers.front().surface = surface;
    for (ElementEdges* const edges : { &alike, &told })
    {
      const Frame frame = Trace(row.scene_, AcrossRow(40), { { &colors }, { edges } });
      EXPECT_EQ(frame.counters.exact, 160);
      for (int x = 2; x < 40; ++x)
      {
        EXPECT_NEAR(CoverAt(frame, x, 2), x == 20 || x == 21 ? 1.0 : 0.0, 0.004) << x;
      }
      // Where the boundary turns away, half of the line is on this side.
      EXPECT_NEAR(CoverAt(frame, 1, 2), 1.0, 0.004);
    }
  }
}

TEST(ElementEdges, AreTheSameForAnyTilesAndThreads)
{
  const Block block;
  TrueScene scene(block);
  scene.AddSphere({ 0.2, -0.1, 0.3 }, 0.6, { nullptr, &block.field_ }, &Block::CurvedAt);
  scene.AddPlane(
    { 0.0, 0.0, 0.1 }, { 0.2, 0.1, 1.0 }, { nullptr, &block.field_ }, &Block::CurvedAt);
  const ColorMapping colors = MakeWhite();
  ElementEdges edges(EdgeStyle::Plain(3.0, kBlack));
  const Pipeline pipeline{ { &colors }, { &edges } };
  CameraView view;
  view.position = { 1.0, -1.5, 4.0 };
  const Camera camera(view, 150, 101);
  const Frame many = Trace(scene.Traced, camera, pipeline);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  ExpectSame(Trace(scene.Traced, camera, pipeline), many);
  Frame tiled = Trace(scene.Traced, camera, {}, pipeline.Needs());
  for (const int size : { 7, 20 })
  {
    BeginPipeline(pipeline, tiled);
    for (int y = 0; y < 101; y += size)
    {
      for (int x = 0; x < 150; x += size)
      {
        const TileArea area{ x, y, std::min(x + size, 150), std::min(y + size, 101) };
        TileVisit visit(&scene.Traced, &camera, pipeline, tiled, area);
        visit.MakeImage();
        visit.Run(pipeline.modules);
      }
    }
    EXPECT_EQ(tiled.Image(), many.Image()) << size;
  }
}

/// Other colours and widths trace nothing.
TEST(ElementEdges, AreRepainted)
{
  const Row row(2);
  const ColorMapping colors = MakeWhite();
  ElementEdges thin(EdgeStyle::Plain(1.0, kBlack));
  ElementEdges thick(EdgeStyle::Plain(4.0, kGreen));
  const Camera camera = AcrossRow(40);
  Frame frame = Trace(row.scene_, camera, { { &colors }, { &thin } });
  const std::int64_t rays = frame.counters.rays;
  Repaint(row.scene_, camera, { { &colors }, { &thick } }, frame);
  EXPECT_EQ(frame.counters.rays, rays);
  EXPECT_EQ(frame.Image(), Trace(row.scene_, camera, { { &colors }, { &thick } }).Image());
  // Repainting thicker lines needs the scene.
  EXPECT_THROW(Repaint({ { &colors }, { &thick } }, frame), Error);
}

TEST(ElementEdges, KeepThePixelsOpacity)
{
  const Row row(2);
  const ColorMapping colors([](std::span<const double> values, std::uint8_t* to)
    { std::fill_n(to, 4 * values.size(), std::uint8_t{ 100 }); },
    { 255, 255, 255, 255 });
  ElementEdges edges(EdgeStyle::Plain(2.0, kRed));
  const Frame frame = Trace(row.scene_, AcrossRow(40), { { &colors }, { &edges } });
  const std::uint8_t* const line = &frame.Image()[4 * static_cast<std::size_t>(frame.width + 20)];
  EXPECT_EQ((Rgba{ line[0], line[1], line[2], line[3] }), (Rgba{ 255, 0, 0, 100 }));
  // Without colours there is no image to draw on.
  EXPECT_TRUE(Trace(row.scene_, AcrossRow(40), { {}, { &edges } }).Image().empty());
}

TEST(ElementEdges, RefuseWidthsOutOfRange)
{
  for (const double width : { 0.0, -1.0, 33.0, std::nan("") })
  {
    EXPECT_THROW(ElementEdges(EdgeStyle::Plain(width, kBlack)), Error) << width;
  }
}
} // namespace pixelexact::testing
