// SPDX-License-Identifier: BSD-3-Clause
// Surfaces that rays meet many times, and what they know of their hits.
#include "FrameCheck.h"
#include "SheetCheck.h"

namespace pixelexact::testing
{
namespace
{
/// Planes z = const whose hits have a given status, without xi and elements.
class Stack final : public Surface
{
public:
  struct Level
  {
    double z;
    HitStatus status = HitStatus::Certain;
  };
  std::vector<Level> levels; ///< falling

  void Meet(const RayLanes& rays, HitSlots& hits) const override
  {
    for (std::size_t level = 0; level < levels.size(); ++level)
    {
      const auto k = static_cast<int>(level);
      const HitLanes lanes = hits.Slot(k);
      for (int i = 0; i < rays.count; ++i)
      {
        lanes.t[i] = rays.origin[2][i] - levels[level].z;
        lanes.position[0][i] = rays.origin[0][i];
        lanes.position[1][i] = rays.origin[1][i];
        lanes.position[2][i] = levels[level].z;
        if (levels[level].status != HitStatus::Certain)
        {
          hits.Status(k)[i] = levels[level].status;
        }
      }
    }
  }
  [[nodiscard]] Vec3 Normal(const SurfacePoint& /*point*/) const override
  {
    return { 0.0, 0.0, 1.0 };
  }
};

} // namespace

TEST(ManyHits, HitsOutsideOfTheMeshArePassed)
{
  Block block;
  const auto surface = std::make_shared<Stack>();
  surface->levels = { { 2.5 }, { 1.5 }, { 0.9 }, { 0.1 }, { -0.5 }, { -1.5 }, { -2.0 } };
  block.scene_.layers = { MakeLayer(surface, block.field_, true) };
  const Camera camera = ViewAlongZ(33, 29, 0.95);
  const Frame frame = Trace(block.scene_, camera, {}, { .centres = kAllWithLayer });
  const auto sheets = SheetsOf(frame.centres);
  ASSERT_EQ(sheets.size(), 3U);
  int seen = 0;
  for (std::size_t i = 0; i < frame.centres.Size(); ++i)
  {
    const Ray ray = camera.At(static_cast<double>(i % 33) + 0.5, static_cast<double>(i / 33) + 0.5);
    const bool within = std::max(std::fabs(ray.origin.x), std::fabs(ray.origin.y)) < 1.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      ASSERT_EQ(sheets[k]->verdict[i], within ? kExactPixel : kNothingPixel);
      EXPECT_EQ(sheets[k]->depth[i], within ? 5.0 - surface->levels[2 + k].z : kNoHit);
    }
    seen += within ? 1 : 0;
  }
  EXPECT_EQ(frame.counters.exact, seen);
  // Rays outside the cube reach all planes, and so do rays through it.
  EXPECT_EQ(frame.counters.surfaceHits, 7 * 33 * 29);
  block.scene_.layers[0].translucent = false;
  const Frame opaque = Trace(block.scene_, camera, {}, { .centres = kAllWithLayer });
  EXPECT_EQ(opaque.counters.surfaceHits, 3 * seen + 7 * (33 * 29 - seen));
  EXPECT_TRUE(SameBytes(opaque.centres.value, frame.centres.value));
  EXPECT_TRUE(opaque.centres.behind.empty());
}

TEST(ManyHits, WhatIsKnownOfHits)
{
  Block block;
  const auto surface = std::make_shared<Stack>();
  surface->levels = { { 1.5, HitStatus::Undecided }, { 1.2, HitStatus::Numeric },
    { 0.5, HitStatus::Numeric }, { 0.2, HitStatus::Undecided }, { -0.3 } };
  const Camera camera = ViewAlongZ(20, 20, 0.9);
  block.scene_.layers = { MakeLayer(surface, block.field_, true) };
  const Frame frame = Trace(block.scene_, camera, {}, { .centres = kAllWithLayer });
  const auto sheets = SheetsOf(frame.centres);
  // Outside of the mesh nothing is, decided or not.
  ASSERT_EQ(sheets.size(), 3U);
  EXPECT_EQ(frame.counters.exact, 400);
  EXPECT_EQ(frame.counters.unknown, 0);
  EXPECT_EQ(frame.counters.numericHits, 400);
  EXPECT_EQ(frame.counters.undecidedHits, 400);
  for (std::size_t i = 0; i < 400; ++i)
  {
    EXPECT_EQ(sheets[0]->verdict[i], kExactPixel);
    EXPECT_EQ(sheets[1]->verdict[i], kUnknownPixel);
    EXPECT_EQ(sheets[2]->verdict[i], kExactPixel);
    EXPECT_EQ(sheets[1]->depth[i], 4.8);
    EXPECT_EQ(sheets[1]->position[i].z, 0.2);
    EXPECT_GE(sheets[1]->element[i], 4);
    EXPECT_TRUE(std::isnan(sheets[1]->value[i]));
    EXPECT_TRUE(std::isnan(sheets[1]->xi[i].x));
    EXPECT_EQ(sheets[2]->depth[i], 5.3);
  }

  // A ray ends at the first visible hit of an opaque layer.
  surface->levels.erase(surface->levels.begin() + 2);
  block.scene_.layers[0].translucent = false;
  const Frame opaque = Trace(block.scene_, camera, {}, { .centres = kAllWithLayer });
  EXPECT_EQ(opaque.counters.unknown, 400);
  EXPECT_EQ(opaque.counters.exact, 0);
  EXPECT_EQ(opaque.counters.numericHits, 0);
  EXPECT_EQ(opaque.counters.undecidedHits, 400);
  EXPECT_EQ(std::ranges::count(opaque.centres.depth, 4.8), 400);
  EXPECT_EQ(opaque.counters.surfaceHits, 3 * 400);

  // Hidden hits are not counted.
  block.scene_.layers.insert(block.scene_.layers.begin(),
    MakeLayer(std::make_shared<Plane>(Vec3(0.0, 0.0, 0.8), Vec3(0.0, 0.0, 1.0)), block.field_));
  const Frame hidden = Trace(block.scene_, camera, {}, { .centres = kAllWithLayer });
  EXPECT_EQ(hidden.counters.exact, 400);
  EXPECT_EQ(hidden.counters.undecidedHits, 0);
}
} // namespace pixelexact::testing
