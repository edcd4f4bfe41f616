// SPDX-License-Identifier: BSD-3-Clause
// What may be spent on a frame decides how many pixels stay undecided, and nothing else.
#include "BentCube.h"
#include "CurvedCheck.h"

#include "Trace/Contours/LayerBounds.h"
#include "Trace/FrameTiles.h"
#include "Trace/ProgressiveFrame.h"
#include "Trace/Surfaces/Quadric.h"
#include "Trace/TileVisit.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <vector>

namespace pixelexact::testing
{
namespace
{
constexpr int kAcross = 128;
constexpr int kUp = 96;

struct EffortResult
{
  std::vector<std::uint8_t> verdicts;
  ContourCounters counters;
};

/// Budgets that are a part of a frame's need, and nearly nothing.
constexpr std::int64_t kSome = 12'000'000;
constexpr std::int64_t kLittle = 3'600'000;

ContourCertifier CertifierWith(
  std::int64_t work, std::shared_ptr<ContourBounds> bounds, bool interior = false)
{
  ContourMethod method;
  method.work = work;
  method.interior = interior;
  return ContourCertifier({ kContourValues }, method, std::move(bounds));
}

EffortResult CertifyWithin(const Scene& scene, std::int64_t work,
  std::shared_ptr<ContourBounds> bounds, bool interior = false)
{
  ContourCertifier certifier = CertifierWith(work, std::move(bounds), interior);
  Trace(scene, Camera(Oblique(), kAcross, kUp), { {}, { &certifier } });
  return { certifier.Verdicts(), certifier.Counters() };
}

std::vector<std::shared_ptr<const Surface>> Surfaces()
{
  return { std::make_shared<Plane>(kPlaneOrigin, kPlaneNormal),
    std::make_shared<Quadric>(MakeSphere(Vec3(0.05, -0.1, 0.1), 0.7)) };
}
} // namespace

TEST(ContourEffort, LessLeavesMoreUndecidedAndNothingElse)
{
  const BentCube cube({ std::begin(kShapes), std::end(kShapes) });
  const ElementIndex& index = cube.locator_.Index();
  std::vector<std::shared_ptr<const Surface>> surfaces = Surfaces();
  surfaces.push_back(std::make_shared<ElementFaces>(index, BoundaryOf(index)));
  for (const auto& surface : surfaces)
  {
    const Scene scene = cube.With(surface);
    const EffortResult usual = CertifyWithin(scene, ContourMethod().work, nullptr);
    const EffortResult little = CertifyWithin(scene, kLittle, nullptr);
    EXPECT_EQ(usual.counters.spent, 0);
    EXPECT_GT(little.counters.spent, 0);
    EXPECT_GT(little.counters.undecided, usual.counters.undecided);
    for (std::size_t i = 0; i < usual.verdicts.size(); ++i)
    {
      EXPECT_TRUE(little.verdicts[i] == usual.verdicts[i] ||
        little.verdicts[i] == static_cast<std::uint8_t>(ContourVerdict::Undecided))
        << i;
    }
  }
}

TEST(ContourEffort, WhatIsKeptAndThreadsChangeNothing)
{
  const BentCube cube({ std::begin(kShapes), std::end(kShapes) });
  const Scene scene = cube.With(Surfaces().front());
  const auto kept = std::make_shared<ContourBounds>();
  (void)CertifyWithin(scene, ContourMethod().work, kept);
  for (const bool interior : { false, true })
  {
    for (const std::int64_t work : { kLittle, kSome })
    {
      const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
      const EffortResult cold = CertifyWithin(scene, work, nullptr, interior);
      EXPECT_GT(cold.counters.spent, 0) << work;
      EXPECT_EQ(cold.verdicts, CertifyWithin(scene, work, kept, interior).verdicts) << work;
    }
    const EffortResult alone = CertifyWithin(scene, kSome, nullptr, interior);
    EXPECT_EQ(alone.verdicts, CertifyWithin(scene, kSome, nullptr, interior).verdicts);
  }
}

TEST(ContourEffort, HardTilesGetWhatOthersLeave)
{
  const BentCube cube({ std::begin(kShapes), std::end(kShapes) });
  const Scene scene = cube.With(Surfaces().front());
  const Camera camera(Oblique(), kAcross, kUp);
  const EffortResult usual = CertifyWithin(scene, ContourMethod().work, nullptr);
  // The least of powers of 1.25 that is enough for the frame.
  std::int64_t work = 100'000;
  while (CertifyWithin(scene, work, nullptr).counters.spent > 0)
  {
    work += work / 4;
  }
  EXPECT_EQ(CertifyWithin(scene, work, nullptr).verdicts, usual.verdicts);
  // Without the remaining work of other tiles some tiles have a too small budget.
  ContourCertifier certifier = CertifierWith(work, nullptr);
  const Pipeline pipeline{ {}, { &certifier } };
  ASSERT_EQ(pipeline.Runs().size(), 3U);
  Frame frame = Trace(scene, camera, {});
  BeginPipeline(pipeline, frame);
  std::int64_t settled = 0;
  for (int y = 0; y < kUp; y += kTileSize)
  {
    for (int x = 0; x < kAcross; x += kTileSize)
    {
      TileVisit visit(&scene, &camera, pipeline, frame, { x, y, x + kTileSize, y + kTileSize });
      visit.Run(pipeline.Runs().front());
      ++settled;
    }
  }
  const ContourCounters& counted = certifier.Counters();
  EXPECT_LT(counted.in + counted.out + counted.undecided, settled * kTileSize * kTileSize);
  EXPECT_EQ(usual.counters.in + usual.counters.out + usual.counters.undecided, kAcross * kUp);
}

TEST(ContourEffort, PassesReportTheSame)
{
  const BentCube cube({ std::begin(kShapes), std::end(kShapes) });
  const Scene scene = cube.With(Surfaces().front());
  for (const std::int64_t work : { kLittle, ContourMethod().work })
  {
    ContourCertifier certifier = CertifierWith(work, nullptr);
    ProgressiveFrame frame(
      scene, Camera(Oblique(), kAcross, kUp), { {}, { &certifier } }, certifier.Needs().welcome);
    frame.GoTo(1);
    int calls = 0;
    const auto everyFewTiles = [&calls](double /*done*/) { return ++calls % 3 != 0; };
    while (!frame.IsComplete())
    {
      (void)frame.Refine(everyFewTiles);
    }
    const EffortResult told = CertifyWithin(scene, work, nullptr);
    EXPECT_EQ(certifier.Verdicts(), told.verdicts) << work;
    EXPECT_EQ(certifier.Counters().spent, told.counters.spent) << work;
    EXPECT_EQ(certifier.Counters().undecided, told.counters.undecided) << work;
  }
}

/// Decided pixels stay decided, and are not evaluated again.
TEST(ContourEffort, TilesGoOnWhereTheyEnded)
{
  const BentCube cube({ std::begin(kShapes), std::end(kShapes) });
  const Scene scene = cube.With(Surfaces().back());
  const Camera camera(Oblique(), kAcross, kUp);
  ContourCertifier certifier = CertifierWith(kSome, nullptr);
  const Pipeline pipeline{ {}, { &certifier } };
  Frame frame = Trace(scene, camera, {});
  BeginPipeline(pipeline, frame);
  std::vector<std::int64_t> undecided;
  std::vector<std::uint8_t> before;
  for (const std::vector<FrameModule*>& run : pipeline.Runs())
  {
    for (int y = 0; y < kUp; y += kTileSize)
    {
      for (int x = 0; x < kAcross; x += kTileSize)
      {
        TileVisit visit(&scene, &camera, pipeline, frame, { x, y, x + kTileSize, y + kTileSize });
        visit.Run(run);
      }
    }
    const std::vector<std::uint8_t>& now = certifier.Verdicts();
    undecided.push_back(
      std::ranges::count(now, static_cast<std::uint8_t>(ContourVerdict::Undecided)));
    for (std::size_t i = 0; i < before.size(); ++i)
    {
      EXPECT_TRUE(
        now[i] == before[i] || before[i] == static_cast<std::uint8_t>(ContourVerdict::Undecided))
        << i;
    }
    before = now;
  }
  EXPECT_GT(undecided[0], undecided[1]);
  EXPECT_GE(undecided[1], undecided[2]);
  EXPECT_EQ(certifier.Counters().undecided, undecided[2]);
}

TEST(ContourEffort, CanBeEndedInHardTiles)
{
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const BentCube cube({ std::begin(kShapes), std::end(kShapes) });
  const Scene scene = cube.With(Surfaces().front());
  const Camera camera(Oblique(), kAcross, kUp);
  constexpr int kTiles = kAcross / kTileSize * (kUp / kTileSize);
  std::vector<double> told;
  const auto traced = [&](int most)
  {
    told.clear();
    ContourCertifier certifier = CertifierWith(kSome, nullptr);
    Trace(scene, camera, { {}, { &certifier } }, {},
      [&](double done)
      {
        told.push_back(done);
        return std::ssize(told) < most;
      });
  };
  traced(1000);
  ASSERT_EQ(std::ssize(told), 3 * kTiles);
  EXPECT_TRUE(std::ranges::is_sorted(told));
  EXPECT_EQ(told.back(), 1.0);
  // Tiles of the second pass.
  traced(kTiles + 2);
  EXPECT_EQ(std::ssize(told), kTiles + 2);
}

TEST(ContourEffort, WorkIsSpentOnceForEachNode)
{
  const EdgeNode nodes[2];
  EdgeWork work(100);
  EXPECT_TRUE(work.Affords(nodes[0], 40));
  EXPECT_TRUE(work.Affords(nodes[0], 40));
  EXPECT_EQ(work.Spent(), 40);
  work.Reserve(0.5);
  EXPECT_FALSE(work.Affords(nodes[1], 10));
  EXPECT_TRUE(work.IsSpent());
  EXPECT_TRUE(work.Affords(9));
  work.Reserve(0.0);
  EXPECT_TRUE(work.Affords(nodes[1], 10));
  work.Spend(60);
  EXPECT_FALSE(work.IsLeft());
  // An exhausted budget affords nothing, not even a node that was paid for.
  EXPECT_FALSE(work.Affords(nodes[0], 40));
}

TEST(ContourEffort, LargeBoxesCostAPlanePartWhatItSees)
{
  EdgeWork work(100);
  EXPECT_EQ(work.PartOf({ 8.0, 8.0, 8.0 }), 1.0);
  work.SetWidth(2.0);
  EXPECT_EQ(work.PartOf({ 8.0, 8.0, 8.0 }), 1.0 / 16);
  EXPECT_EQ(work.PartOf({ 8.0, 0.1, 4.0 }), 1.0 / 8);
  EXPECT_EQ(work.PartOf({ 1.0, 8.0, 0.0 }), 1.0 / 4);
  EXPECT_EQ(work.PartOf({ 1.0, 2.0, 1.5 }), 1.0);
}

TEST(ContourEffort, MoreSubdivideMore)
{
  ContourMethod method;
  method.SetEffort(8.0);
  const ContourMethod usual;
  EXPECT_EQ(method.edgeLevels, usual.edgeLevels + 3);
  EXPECT_EQ(method.crossings, usual.crossings + 3);
  EXPECT_EQ(method.work, 8 * usual.work);
  EXPECT_EQ(method.samples, 8 * usual.samples);
  method.SetEffort(1.0);
  EXPECT_EQ(method.edgeLevels, usual.edgeLevels);
  EXPECT_EQ(method.parts, usual.parts);
}
} // namespace pixelexact::testing
