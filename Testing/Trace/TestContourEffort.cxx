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

Told Tell(
  const Scene& scene, double effort, std::shared_ptr<ContourBounds> bounds, bool interior = false)
{
  ContourMethod method;
  method.SetEffort(effort);
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
    const Told usual = Tell(scene, 1.0, nullptr);
    const Told little = Tell(scene, ContourMethod::kLeastEffort, nullptr);
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
  (void)Tell(scene, 1.0, kept);
  for (const bool interior : { false, true })
  {
    for (const double effort : { ContourMethod::kLeastEffort, 0.01 })
    {
      const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
      const Told cold = Tell(scene, effort, nullptr, interior);
      EXPECT_EQ(cold.verdicts, Tell(scene, effort, kept, interior).verdicts) << effort;
    }
    const Told alone = Tell(scene, 0.01, nullptr, interior);
    EXPECT_EQ(alone.verdicts, Tell(scene, 0.01, nullptr, interior).verdicts);
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
