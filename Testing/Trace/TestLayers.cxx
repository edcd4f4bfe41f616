// SPDX-License-Identifier: BSD-3-Clause
// Several layers: which sheets rays see, in which order, and what is counted of them.
#include "FrameCheck.h"
#include "SheetCheck.h"

#include "Core/Base/Error.h"
#include "Trace/TraceTile.h"

#include <tbb/global_control.h>

namespace pixelexact::testing
{
namespace
{
/// Two fields, the second of two components, and the block that they are on.
struct Fields
{
  Block block;
  const Field& curved =
    block.Add(1, [](const LongVec3& x, long double* u) { u[0] = Block::CurvedAt(x); });
  const Field& pair = block.Add(2,
    [](const LongVec3& x, long double* u)
    {
      u[0] = First(x);
      u[1] = Second(x);
    });

  static long double First(const LongVec3& x) { return 3 - x[0] + 2 * x[1] * x[2]; }
  static long double Second(const LongVec3& x) { return 1 + x[0] * x[1] - 5 * x[2]; }
  static long double Norm(const LongVec3& x) { return std::hypot(First(x), Second(x)); }
};

CameraView MakeLayersView(bool parallel)
{
  CameraView view;
  view.position = { 1.5, -2.0, 4.0 };
  view.focalPoint = { 0.1, 0.2, 0.0 };
  view.viewUp = { 0.3, 1.0, 0.1 };
  view.parallel = parallel;
  view.parallelScale = 1.5;
  view.viewAngle = 36.0;
  return view;
}

/// Sheets of all pixels.
std::int64_t Sum(const std::vector<int>& counts)
{
  std::int64_t sum = 0;
  for (std::size_t depth = 0; depth < counts.size(); ++depth)
  {
    sum += static_cast<std::int64_t>(depth) * counts[depth];
  }
  return sum;
}
} // namespace

TEST(Layers, OfTwoThatCoincideTheFirstIsSeen)
{
  Fields fields;
  // Tilted: t of both is the same, whatever it is.
  const Vec3 through(0.1, 0.0, 0.1);
  const Vec3 normal(0.1, 0.2, 1.0);
  for (const bool translucent : { false, true })
  {
    TrueScene scene(fields.block);
    scene.AddPlane(through, normal, { nullptr, &fields.curved, 0, Precision::Double, translucent },
      &Block::CurvedAt);
    scene.AddPlane(through, normal, { nullptr, &fields.pair, 1 }, &Fields::Second);
    const Camera camera = ViewAlongZ(70, 50);
    const Frame frame = Trace(scene.Traced, camera, {}, { .centres = kAllWithLayer });
    const SampleBuffers& first = frame.centres;
    ASSERT_EQ(first.behind.size(), translucent ? 1U : 0U);
    int seen = 0;
    for (std::size_t i = 0; i < first.Size(); ++i)
    {
      EXPECT_EQ(first.layer[i], first.verdict[i] == kExactPixel ? 0 : kNoLayer);
      if (first.verdict[i] != kExactPixel)
      {
        continue;
      }
      ++seen;
      const LongVec3 x = ToLong(first.position[i]);
      EXPECT_NEAR(first.value[i], static_cast<double>(Block::CurvedAt(x)), 1e-12);
      if (translucent)
      {
        const SampleBuffers& second = first.behind[0];
        EXPECT_EQ(second.layer[i], 1);
        EXPECT_EQ(second.depth[i], first.depth[i]);
        EXPECT_EQ(second.position[i], first.position[i]);
        EXPECT_NEAR(second.value[i], static_cast<double>(Fields::Second(x)), 1e-12);
      }
    }
    EXPECT_GT(seen, 1000);
    EXPECT_EQ(frame.counters.exact, seen);
    EXPECT_EQ(frame.counters.nothing, 70 * 50 - seen);
  }
}

TEST(Layers, AreSeenInTheOrderOfTheirDistance)
{
  Fields fields;
  // The planes intersect within the cube: no order is valid everywhere.
  const std::array<std::pair<Vec3, Vec3>, 3> planes{ std::pair(
                                                       Vec3(0.0, 0.0, 0.3), Vec3(0.2, 0, 1)),
    std::pair(Vec3(0.1), Vec3(-0.5, 0.3, 1.0)), std::pair(Vec3(0.0, 0.1, -0.4), Vec3(0, -0.8, 1)) };
  const std::array<std::pair<Layer, TrueScene::Value>, 3> looks{
    std::pair(Layer{ nullptr, &fields.curved }, &Block::CurvedAt),
    std::pair(Layer{ nullptr, &fields.pair, 0 }, &Fields::First),
    std::pair(Layer{ nullptr, &fields.pair, kMagnitude }, &Fields::Norm)
  };
  std::array order{ 0, 1, 2 };
  do
  {
    for (const unsigned translucent : { 0U, 1U, 2U, 6U, 7U })
    {
      SCOPED_TRACE(::testing::Message() << order[0] << order[1] << order[2] << " " << translucent);
      TrueScene scene(fields.block);
      for (std::size_t k = 0; k < 3; ++k)
      {
        const auto of = static_cast<std::size_t>(order[k]);
        Layer layer = looks[of].first;
        layer.translucent = (translucent >> of & 1U) != 0;
        scene.AddPlane(planes[of].first, planes[of].second, layer, looks[of].second);
      }
      const CameraView view = MakeLayersView(order[0] == 1);
      const Frame frame =
        Trace(scene.Traced, Camera(view, 35, 37), {}, { .centres = kAllWithLayer });
      const SheetTally tally = ExpectSheets(frame, scene, view);
      EXPECT_LE(tally.uncertain, 5);
      EXPECT_GT(tally.WithDepth(0), 100);
      // Hidden layers are visible exactly where the front is translucent.
      const std::size_t most = translucent == 0 ? 1 : translucent == 7 || translucent == 6 ? 3 : 2;
      EXPECT_EQ(frame.centres.behind.size() + 1, most);
      EXPECT_GT(tally.WithDepth(most), 5);
      EXPECT_EQ(frame.counters.rays, 35 * 37);
      EXPECT_NEAR(static_cast<double>(frame.counters.nothing), tally.WithDepth(0), tally.uncertain);
      EXPECT_EQ(frame.counters.exact, 35 * 37 - frame.counters.nothing);
      EXPECT_EQ(frame.counters.cutOff, 0);
    }
  } while (std::ranges::next_permutation(order).found);
}

TEST(Layers, TranslucentSphereAroundAPlane)
{
  Fields fields;
  for (const bool parallel : { false, true })
  {
    TrueScene scene(fields.block);
    // Beyond the cube in places: its near half is not in the mesh everywhere.
    scene.AddSphere({ 0.1, 0.0, 0.2 }, 0.95, { nullptr, &fields.pair, 1, Precision::Double, true },
      &Fields::Second);
    scene.AddPlane(
      { 0.0, 0.0, 0.1 }, { 0.2, 0.3, 1.0 }, { nullptr, &fields.curved, 0 }, &Block::CurvedAt);
    const CameraView view = MakeLayersView(parallel);
    const Frame frame = Trace(scene.Traced, Camera(view, 90, 80), {}, { .centres = kAllWithLayer });
    const SheetTally tally = ExpectSheets(frame, scene, view);
    EXPECT_LE(tally.uncertain, 5);
    // The plane hides the sphere, unless it is behind all of it.
    EXPECT_EQ(frame.centres.behind.size(), 2U);
    EXPECT_GT(tally.WithDepth(2), 1000);
    EXPECT_GT(tally.WithDepth(1), 50);
    EXPECT_EQ(frame.counters.rays, 90 * 80);
    EXPECT_EQ(frame.counters.exact + frame.counters.nothing, 90 * 80);
    EXPECT_GE(frame.counters.surfaceHits, Sum(tally.pixelsOfDepth));

    // With both translucent, the far half is the third sheet.
    scene.Traced.layers[1].translucent = true;
    const Frame through =
      Trace(scene.Traced, Camera(view, 90, 80), {}, { .centres = kAllWithLayer });
    const SheetTally all = ExpectSheets(through, scene, view);
    EXPECT_EQ(through.centres.behind.size(), 2U);
    EXPECT_GT(all.WithDepth(3), 1000 + tally.WithDepth(3));
    // The nearest sheet is the same as before.
    EXPECT_EQ(through.counters.exact, frame.counters.exact);
    EXPECT_EQ(through.counters.nothing, frame.counters.nothing);
    EXPECT_EQ(through.centres.layer, frame.centres.layer);
    EXPECT_TRUE(SameBytes(through.centres.value, frame.centres.value));
  }
}

TEST(Layers, HitsAreCountedAsRaysComeToThem)
{
  Fields fields;
  Block& block = fields.block;
  // Seen along z from 5: outside, outside, inside, inside.
  for (const double z : { 3.0, 2.0, 0.5, 0.0 })
  {
    block.WithPlane({ 0.0, 0.0, z }, { 0.0, 0.0, 1.0 });
  }
  const Camera camera = ViewAlongZ(20, 20, 0.9);
  const auto counters = [&]
  { return Trace(block.scene_, camera, {}, { .centres = kAllWithLayer }).counters; };
  const FrameCounters opaque = counters();
  EXPECT_EQ(opaque.rays, 400);
  EXPECT_EQ(opaque.surfaceHits, 3 * 400);
  EXPECT_EQ(opaque.exact, 400);
  block.scene_.layers[2].translucent = true;
  const FrameCounters through = counters();
  EXPECT_EQ(through.rays, 400);
  EXPECT_EQ(through.surfaceHits, 4 * 400);
  EXPECT_EQ(through.exact, 400);
  EXPECT_EQ(through.nothing, 0);
  EXPECT_EQ(through.numericHits + through.undecidedHits + through.cutOff, 0);
}

TEST(Layers, ValuesThatAreNotANumberAreSheetsToo)
{
  Block block;
  // The second component is NaN in the first element, which is below zero everywhere.
  block.WithPlane({ 0.0, 0.0, -0.3 }, { 0.0, 0.0, 1.0 });
  block.WithPlane({ 0.0, 0.0, -0.6 }, { 0.0, 0.0, 1.0 });
  Scene& scene = block.scene_;
  scene.layers[0].component = scene.layers[1].component = 1;
  scene.layers[0].translucent = true;
  const Frame frame = Trace(scene, ViewAlongZ(40, 40, 0.9), {}, { .centres = kAllWithLayer });
  ASSERT_EQ(frame.centres.behind.size(), 1U);
  EXPECT_EQ(frame.counters.exact, 1600);
  int nan = 0;
  for (const SampleBuffers* sheet : SheetsOf(frame.centres))
  {
    for (std::size_t i = 0; i < sheet->Size(); ++i)
    {
      EXPECT_EQ(sheet->verdict[i], kExactPixel);
      EXPECT_EQ(std::isnan(sheet->value[i]), sheet->element[i] == 0);
      EXPECT_TRUE(sheet->element[i] == 0 || sheet->value[i] == 1.0);
      nan += sheet == &frame.centres && sheet->element[i] == 0 ? 1 : 0;
    }
  }
  EXPECT_GT(nan, 200);
  EXPECT_EQ(frame.counters.nonFinite, nan);
}

TEST(Layers, MoreSheetsThanAreKeptAreCounted)
{
  Block block;
  const auto with = [&](int planes)
  {
    block.scene_.layers.clear();
    for (int k = 0; k < planes; ++k)
    {
      // Half of each in the mesh, the nearest last.
      block.WithPlane({ 0.0, 0.0, -0.95 + 0.02 * k }, { 0.0, 0.0, 1.0 }).layers.back().translucent =
        true;
    }
    return Trace(block.scene_, ViewAlongZ(12, 10, 1.25), {}, { .centres = kAllWithLayer });
  };
  constexpr int kMax = Sheets::kMax;
  for (const int planes : { kMax - 1, kMax, kMax + 1, kMax + 20 })
  {
    SCOPED_TRACE(planes);
    const Frame frame = with(planes);
    EXPECT_GT(frame.counters.exact, 50);
    EXPECT_EQ(frame.counters.cutOff, planes > kMax ? frame.counters.exact : 0);
    const auto sheets = SheetsOf(frame.centres);
    ASSERT_EQ(sheets.size(), static_cast<std::size_t>(std::min(planes, kMax)));
    for (std::size_t k = 0; k < sheets.size(); ++k)
    {
      for (std::size_t i = 0; i < frame.centres.Size(); ++i)
      {
        const bool seen = frame.centres.verdict[i] == kExactPixel;
        EXPECT_EQ(int{ sheets[k]->layer[i] }, seen ? planes - 1 - static_cast<int>(k) : kNoLayer);
      }
    }
  }
}

TEST(Layers, AsManyAsANumberOfThemCanTell)
{
  Block block;
  const Camera camera = ViewAlongZ(4, 4, 0.9);
  for (int k = 0; k < 255; ++k)
  {
    // All planes except the last are outside the mesh.
    block.WithPlane({ 0.0, 0.0, k < 254 ? 2.0 : 0.0 }, { 0.0, 0.0, 1.0 });
  }
  const Frame frame = Trace(block.scene_, camera, {}, { .centres = kAllWithLayer });
  EXPECT_EQ(std::ranges::count(frame.centres.layer, 254), 16);
  block.WithPlane(Vec3(0.0), { 0.0, 0.0, 1.0 });
  EXPECT_THROW((void)Trace(block.scene_, camera, {}, { .centres = kAllWithLayer }), Error);
}

TEST(Layers, SheetsAreTheSameForAnyNumberOfThreads)
{
  Fields fields;
  TrueScene scene(fields.block);
  scene.AddSphere({ 0.1, 0.0, 0.2 }, 0.95, { nullptr, &fields.pair, 1, Precision::Double, true },
    &Fields::Second);
  scene.AddPlane({ 0.0, 0.0, 0.1 }, { 0.2, 0.3, 1.0 },
    { nullptr, &fields.curved, 0, Precision::Double, true }, &Block::CurvedAt);
  const Camera camera(MakeLayersView(false), 150, 101);
  constexpr Buffer kWanted = kAllWithLayer | Buffer::Coverage | Buffer::Enclosure;
  const Frame many = Trace(scene.Traced, camera, {}, { .centres = kWanted });
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  ExpectSame(Trace(scene.Traced, camera, {}, { .centres = kWanted }), many);
  EXPECT_EQ(many.centres.behind.size(), 2U);
}
} // namespace pixelexact::testing
