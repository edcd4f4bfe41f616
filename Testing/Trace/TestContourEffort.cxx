// SPDX-License-Identifier: BSD-3-Clause
// What may be spent on a tile decides how many pixels stay undecided, and nothing else.
#include "BentCube.h"

#include "Trace/Contours/LayerBounds.h"
#include "Trace/Surfaces/Quadric.h"

#include <tbb/global_control.h>

#include <vector>

namespace pixelexact::testing
{
namespace
{
constexpr int kAcross = 128;
constexpr int kUp = 96;

struct Told
{
  std::vector<std::uint8_t> verdicts;
  ContourCounters counters;
};

/// Of what a tile of these scenes takes a part, and hardly anything.
constexpr std::int64_t kSome = 1'000'000;
constexpr std::int64_t kLittle = 300'000;

Told Tell(const Scene& scene, std::int64_t work, std::shared_ptr<ContourBounds> bounds,
  bool interior = false)
{
  ContourMethod method;
  method.work = work;
  method.interior = interior;
  ContourCertifier certifier({ { -2.0, -0.7, -0.1, 0.05, 0.4, 1.1 } }, method, std::move(bounds));
  Trace(scene, Camera(Oblique(), kAcross, kUp), { {}, { &certifier } });
  return { certifier.Verdicts(), certifier.Counters() };
}

std::vector<std::shared_ptr<const Surface>> Surfaces()
{
  return { std::make_shared<Plane>(Vec3(0.1, 0.0, 0.05), Vec3(0.2, 0.1, 1.0)),
    std::make_shared<Quadric>(MakeSphere(Vec3(0.05, -0.1, 0.1), 0.7)) };
}
} // namespace

TEST(ContourEffort, LessLeavesMoreUndecidedAndNothingElse)
{
  for (const auto& surface : Surfaces())
  {
    const BentCube cube({ std::begin(kShapes), std::end(kShapes) });
    const Scene scene = cube.With(surface);
    const Told usual = Tell(scene, ContourMethod().work, nullptr);
    const Told little = Tell(scene, kLittle, nullptr);
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
  (void)Tell(scene, ContourMethod().work, kept);
  for (const bool interior : { false, true })
  {
    for (const std::int64_t work : { kLittle, kSome })
    {
      const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
      const Told cold = Tell(scene, work, nullptr, interior);
      EXPECT_GT(cold.counters.spent, 0) << work;
      EXPECT_EQ(cold.verdicts, Tell(scene, work, kept, interior).verdicts) << work;
    }
    const Told alone = Tell(scene, kSome, nullptr, interior);
    EXPECT_EQ(alone.verdicts, Tell(scene, kSome, nullptr, interior).verdicts);
  }
}

TEST(ContourEffort, MoreHalvesMore)
{
  ContourMethod method;
  method.SetEffort(8.0);
  const ContourMethod usual;
  EXPECT_EQ(method.halvings, usual.halvings + 3);
  EXPECT_EQ(method.crossings, usual.crossings + 3);
  EXPECT_EQ(method.work, 8 * usual.work);
  method.SetEffort(1.0);
  EXPECT_EQ(method.halvings, usual.halvings);
  EXPECT_EQ(method.parts, usual.parts);
}
} // namespace pixelexact::testing
