// SPDX-License-Identifier: BSD-3-Clause
#include "FrameCheck.h"
#include "SheetCheck.h"

#include "Trace/FrameTiles.h"
#include "Trace/Modules/Antialiasing.h"
#include "Trace/Modules/ElementOutlines.h"
#include "Trace/TileVisit.h"

#include "Core/Base/Error.h"

#include <tbb/global_control.h>

#include <array>
#include <memory>

namespace pixelexact::testing
{
namespace
{
constexpr Rgba kField{ 200, 100, 50, 255 };
constexpr Rgba kUnknownColor{ 255, 0, 255, 255 };
constexpr Rgba kOutline{ 10, 20, 30, 255 };
constexpr Rgba kNothingColor{ 0, 0, 0, 0 };

ColorMapping OneColor()
{
  return ColorMapping(
    [](std::span<const double> values, std::uint8_t* to)
    {
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        to = std::ranges::copy(kField, to).out;
      }
    },
    kUnknownColor);
}

/// A block that is cut by a sphere and a plane.
struct CutBlock
{
  Block block;
  TrueScene scene{ block };

  explicit CutBlock(bool translucent = false)
  {
    const Layer sphere{ nullptr, &block.field_, 0, Precision::Double, translucent };
    scene.AddSphere({ 0.2, -0.1, 0.3 }, 0.6, sphere, &Block::CurvedAt);
    scene.AddPlane(
      { 0.0, 0.0, 0.1 }, { 0.2, 0.1, 1.0 }, { nullptr, &block.field_ }, &Block::CurvedAt);
  }
};

/// The block's element at a point of it; none where rounding may change it.
std::optional<int> ElementAt(const LongVec3& x)
{
  // The inner faces: Block::Map with a, b, c = 0.
  const long double sides[] = { x[0] - 0.2L * x[1] * x[2], x[1] - 0.2L * x[0], x[2] };
  int element = 0;
  for (int d = 0; d < 3; ++d)
  {
    if (std::fabs(sides[d]) < 1e-9L)
    {
      return std::nullopt;
    }
    element |= sides[d] > 0 ? 1 << d : 0;
  }
  return element;
}

/// Element and layer that are nearest along a ray, -1 where nothing is; none where rounding may
/// change them.
std::optional<std::array<int, 2>> SeenAlong(const TrueScene& scene, const LongRay& ray)
{
  const auto sheets = scene.See(ray);
  if (!sheets)
  {
    return std::nullopt;
  }
  if (sheets->empty())
  {
    return std::array{ -1, -1 };
  }
  const auto element = ElementAt(sheets->front().position);
  return element ? std::optional(std::array{ *element, sheets->front().layer }) : std::nullopt;
}

struct OutlineTally
{
  int outlines = 0;
  int ofLayers = 0; ///< of these, where the element does not change
  int atEnds = 0;   ///< where elements meet, but some samples see nothing
  int uncertain = 0;
};

/// Checks a frame of one colour with outlines: every pixel is one or none by the closed form.
OutlineTally ExpectOutlines(const Frame& frame, const TrueScene& scene, const CameraView& view)
{
  OutlineTally tally;
  for (int y = 0; y < frame.height; ++y)
  {
    for (int x = 0; x < frame.width; ++x)
    {
      std::vector<std::array<int, 2>> seen;
      for (const auto& [dx, dy] : { std::array{ 0.5L, 0.5L }, { 0.0L, 0.0L }, { 1.0L, 0.0L },
             { 0.0L, 1.0L }, { 1.0L, 1.0L } })
      {
        const auto at =
          SeenAlong(scene, RayThrough(view, frame.width, frame.height, x + dx, y + dy));
        if (at)
        {
          seen.push_back(*at);
        }
      }
      if (seen.size() < 5)
      {
        ++tally.uncertain;
        continue;
      }
      const auto differs = [&seen](std::size_t i)
      {
        return std::ranges::any_of(seen,
          [&](const auto& other)
          { return other[0] >= 0 && seen[0][i] >= 0 && other[i] != seen[0][i]; });
      };
      const bool ends = std::ranges::any_of(seen, [](const auto& at) { return at[0] < 0; });
      const bool outline = !ends && (differs(0) || differs(1));
      tally.outlines += outline ? 1 : 0;
      tally.ofLayers += outline && !differs(0) ? 1 : 0;
      tally.atEnds += ends && differs(0) ? 1 : 0;
      EXPECT_EQ(ColorAt(frame.Image(), static_cast<std::size_t>(y * frame.width + x)),
        outline ? kOutline : (seen[0][0] < 0 ? kNothingColor : kField))
        << "pixel " << x << " " << y;
    }
  }
  return tally;
}
} // namespace

TEST(ElementOutlines, AreWhereElementsAndLayersMeet)
{
  const CutBlock cut;
  const ColorMapping colors = OneColor();
  ElementOutlines outlines(kOutline);
  const Frame frame =
    Trace(cut.scene.Traced, Camera(MakeAskewView(), 120, 95), { { &colors }, { &outlines } });
  const OutlineTally tally = ExpectOutlines(frame, cut.scene, MakeAskewView());
  EXPECT_GT(tally.outlines, 300);
  EXPECT_GT(tally.ofLayers, 50);
  EXPECT_GE(tally.atEnds, 3);
  EXPECT_LT(tally.uncertain, 10);
}

TEST(ElementOutlines, AreThoseOfTheNearestSheet)
{
  const CutBlock cut(true);
  const ColorMapping colors = OneColor();
  ElementOutlines outlines(kOutline);
  const Frame frame =
    Trace(cut.scene.Traced, Camera(MakeAskewView(), 120, 95), { { &colors }, { &outlines } });
  EXPECT_FALSE(frame.centres.behind.empty());
  EXPECT_GT(ExpectOutlines(frame, cut.scene, MakeAskewView()).outlines, 300);
}

TEST(ElementOutlines, AreTheSameForAnyTilesAndThreads)
{
  const CutBlock cut;
  const ColorMapping colors = OneColor();
  ElementOutlines outlines(kOutline);
  const Pipeline pipeline{ { &colors }, { &outlines } };
  const Camera camera(MakeAskewView(), 150, 101);
  const Frame many = Trace(cut.scene.Traced, camera, pipeline);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  ExpectSame(Trace(cut.scene.Traced, camera, pipeline), many);
  Frame tiled = Trace(cut.scene.Traced, camera, {}, pipeline.Needs());
  for (const int size : { 7, 20 })
  {
    BeginPipeline(pipeline, tiled);
    for (int y = 0; y < 101; y += size)
    {
      for (int x = 0; x < 150; x += size)
      {
        const TileArea area{ x, y, std::min(x + size, 150), std::min(y + size, 101) };
        TileVisit visit(&cut.scene.Traced, &camera, pipeline, tiled, area);
        visit.MakeImage();
        visit.Run(pipeline.modules);
      }
    }
    EXPECT_EQ(tiled.Image(), many.Image()) << size;
  }
}

/// A plane of which nothing is decided beyond x = 0.3.
class HalfDecided final : public Surface
{
public:
  void Meet(const RayLanes& rays, HitSlots& hits) const override
  {
    Whole.Meet(rays, hits);
    for (int i = 0; i < rays.count; ++i)
    {
      hits.Status(0)[i] =
        hits.Slot(0).position[0][i] > 0.3 ? HitStatus::Undecided : HitStatus::Certain;
    }
  }
  [[nodiscard]] Vec3 Normal(const SurfacePoint& point) const override
  {
    return Whole.Normal(point);
  }

private:
  Plane Whole{ { 0.0, 0.0, 0.1 }, { 0.0, 0.0, 1.0 } };
};

TEST(ElementOutlines, LeaveWhatIsUnknown)
{
  Block block;
  block.scene_.layers.push_back({ std::make_shared<HalfDecided>(), &block.field_ });
  const ColorMapping colors = OneColor();
  ElementOutlines outlines(kOutline);
  const Frame frame = Trace(block.scene_, ViewAlongZ(50, 50, 0.95), { { &colors }, { &outlines } });
  int found = 0;
  for (std::size_t i = 0; i < 2500; ++i)
  {
    const double right = (static_cast<double>(i % 50) + 1.0) / 50.0 * 1.9 - 0.95;
    const Rgba color = ColorAt(frame.Image(), i);
    EXPECT_TRUE(color != kOutline || right <= 0.3);
    EXPECT_EQ(color == kUnknownColor, right - 0.019 > 0.3);
    found += color == kOutline ? 1 : 0;
  }
  EXPECT_GT(found, 50);
}

TEST(ElementOutlines, AreNotSmoothed)
{
  const CutBlock cut;
  const ColorMapping colors = OneColor();
  ElementOutlines outlines(kOutline);
  const Camera camera(MakeAskewView(), 60, 50);
  const Frame plain = Trace(cut.scene.Traced, camera, { { &colors }, { &outlines } });
  Antialiasing smooth(4);
  const Frame both = Trace(cut.scene.Traced, camera, { { &colors }, { &smooth, &outlines } });
  EXPECT_GT(smooth.Refined(), 0);
  for (std::size_t i = 0; i < 3000; ++i)
  {
    EXPECT_EQ(ColorAt(both.Image(), i) == kOutline, ColorAt(plain.Image(), i) == kOutline);
  }
}

TEST(ElementOutlines, NeedTheScene)
{
  const CutBlock cut;
  const ColorMapping colors = OneColor();
  ElementOutlines outlines(kOutline);
  // Without colours outlines do nothing.
  Frame frame = Trace(cut.scene.Traced, Camera(MakeAskewView(), 20, 20), { {}, { &outlines } });
  EXPECT_TRUE(frame.Image().empty());
  frame = Trace(cut.scene.Traced, Camera(MakeAskewView(), 20, 20), {},
    { .centres = outlines.Needs().centres | kAll });
  EXPECT_THROW(Repaint({ { &colors }, { &outlines } }, frame), Error);
}
} // namespace pixelexact::testing
