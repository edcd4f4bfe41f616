// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Questions/EdgeArithmetic.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace pixelexact
{
namespace
{
constexpr double kMax = 10.0 / 3.0;

using Rows = std::array<std::array<long double, 3>, 3>;

/// Gauss' elimination with pivots.
Rows InverseOf(Rows m)
{
  Rows inverse{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    inverse[k][k] = 1.0L;
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    std::size_t pivot = k;
    for (std::size_t i = k; i < 3; ++i)
    {
      pivot = std::fabs(m[i][k]) > std::fabs(m[pivot][k]) ? i : pivot;
    }
    std::swap(m[k], m[pivot]);
    std::swap(inverse[k], inverse[pivot]);
    const long double by = m[k][k];
    for (std::size_t j = 0; j < 3; ++j)
    {
      m[k][j] /= by;
      inverse[k][j] /= by;
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      const long double times = i == k ? 0.0L : m[i][k];
      for (std::size_t j = 0; j < 3; ++j)
      {
        m[i][j] -= times * m[k][j];
        inverse[i][j] -= times * inverse[k][j];
      }
    }
  }
  return inverse;
}
} // namespace

TEST(EdgeArithmetic, SolutionsHoldTheInversesOfAllThatABounds)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  int known = 0;
  int wide = 0;
  for (int round = 0; round < 20000; ++round)
  {
    double a[3][3];
    const double scale[3] = { std::exp2(4.0 * part(random)), std::exp2(4.0 * part(random)), 1.0 };
    double largest = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      double sum = 0.0;
      for (std::size_t j = 0; j < 3; ++j)
      {
        a[i][j] = 0.35 * part(random) * scale[i] / scale[j];
        sum += a[i][j];
      }
      largest = std::max(largest, sum);
    }
    double solution[3][3];
    if (!edges::BoundSolution(a, kMax, solution))
    {
      // Row sums below 0.7 are always enough.
      EXPECT_GT(largest, 0.7);
      continue;
    }
    ++known;
    wide += largest > 0.7 ? 1 : 0;
    for (int sample = 0; sample < 8; ++sample)
    {
      Rows m;
      for (std::size_t i = 0; i < 3; ++i)
      {
        for (std::size_t j = 0; j < 3; ++j)
        {
          // The first is -A, which is the worst.
          const double by = sample == 0 ? -1.0 : 2.0 * part(random) - 1.0;
          m[i][j] = (i == j ? 1.0L : 0.0L) + static_cast<long double>(by) * a[i][j];
        }
      }
      const Rows inverse = InverseOf(m);
      for (std::size_t i = 0; i < 3; ++i)
      {
        for (std::size_t j = 0; j < 3; ++j)
        {
          ASSERT_LE(std::fabs(inverse[i][j]), solution[i][j]);
        }
      }
    }
  }
  EXPECT_GT(known, 2000);
  EXPECT_GT(wide, 500);
}

TEST(EdgeArithmetic, SolutionsAreNotKnownWhereTheSeriesDiverges)
{
  double solution[3][3];
  const double unit[3][3] = { { 1.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } };
  EXPECT_FALSE(edges::BoundSolution(unit, kMax, solution));
  const double twice[3][3] = { { 2.0, 0.0, 0.0 }, { 0.0, 2.0, 0.0 }, { 0.0, 0.0, 2.0 } };
  EXPECT_FALSE(edges::BoundSolution(twice, kMax, solution));
  for (const double odd :
    { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    for (std::size_t place = 0; place < 9; ++place)
    {
      double a[3][3] = {};
      a[place / 3][place % 3] = odd;
      EXPECT_FALSE(edges::BoundSolution(a, kMax, solution));
    }
  }
}
} // namespace pixelexact
