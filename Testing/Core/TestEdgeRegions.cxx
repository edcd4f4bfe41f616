// SPDX-License-Identifier: BSD-3-Clause
// Flat polygons and elements, against points of both evaluated in 113 bits.
#include "EdgeCases.h"

#include <array>
#include <iostream>

namespace pixelexact::testing
{
namespace
{
constexpr EdgeEffort kEfforts[] = { {}, { 0, 6 }, { EdgeEffort::kAny, EdgeEffort::kAny } };
} // namespace

/// Polygons about points of the element, from a millionth of it to some of it, through its faces as
/// well.
TEST(EdgeRegions, HoldTheValuesOfTheirPoints)
{
  constexpr double kSlack = 1e-14;
  Random random(81);
  int held = 0;
  ForAllOrders(random,
    [&](const EdgeCase& one)
    {
      for (int k = 0; k < 4; ++k)
      {
        const auto known = one.Located(one.PointAt(random.Inside(one.mesh.ShapeOf(0))));
        if (!known)
        {
          continue;
        }
        const double length = kEdgeCaseSize * std::pow(10.0, random(-6.0, 0.0));
        const Vec3 a = length * Direction(random);
        const Vec3 b = length * Direction(random);
        const std::array<Vec3, 4> square{ known->x - a - b, known->x + a - b, known->x + a + b,
          known->x - a + b };
        const Outline outline(std::span<const Vec3>(square).first(k % 2 == 0 ? 4 : 3));
        for (int i = 0; i < 8; ++i)
        {
          // Of the first triangle.
          const double s = i == 0 ? 1.0 : random(-1.0, 1.0);
          const double t = i == 0 ? 0.0 : random(-1.0, s);
          const auto point = one.Located(known->x + s * a + t * b);
          if (!point)
          {
            continue;
          }
          const auto truth = static_cast<double>(one.Truth(ToQuad(point->xi)));
          for (const EdgeEffort& effort : kEfforts)
          {
            const auto values =
              one.bounds->ValuesIn({ outline, kSlack }, ValueSet{ { &truth, 1 } }, effort);
            ASSERT_TRUE(values);
            EXPECT_LE(values->lower, truth);
            EXPECT_GE(values->upper, truth);
          }
          ++held;
        }
      }
    });
  std::cout << held << " points\n";
  EXPECT_GT(held, 1000);
}
} // namespace pixelexact::testing
