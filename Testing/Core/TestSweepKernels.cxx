// SPDX-License-Identifier: BSD-3-Clause
#include "InstructionSets.h"

#include "Core/Bernstein/SweepKernels.h"
#include "Core/Bernstein/TensorPolynomial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

// The sweeps in lanes against the same written number by number: the same bits, whatever part of a
// pack the lines fill.
namespace pixelexact::testing
{
namespace
{
using Numbers = std::vector<double>;

const std::vector<Degrees> kSweepDegrees{ { 0, 0, 0 }, { 1, 1, 1 }, { 3, 3, 3 }, { 6, 0, 2 },
  { 2, 5, 1 }, { 1, 2, 9 }, { 4, 8, 0 }, { 2, 10, 10 }, { 34, 1, 12 } };

Numbers Made(const Degrees& degree)
{
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  Numbers b(CoefficientCount(degree));
  std::ranges::generate(b, [&] { return any(engine); });
  return b;
}

/// De Casteljau's scheme at the middle of each line along a direction.
std::array<Numbers, 2> Subdivided(const Degrees& degree, int direction, Numbers b)
{
  const int n = degree[static_cast<std::size_t>(direction)];
  const std::size_t stride = StrideOf(degree, direction);
  Numbers upper(b.size());
  for (std::size_t first = 0; first < b.size(); ++first)
  {
    if (first / stride % static_cast<std::size_t>(n + 1) != 0)
    {
      continue;
    }
    const auto index = [&](int i) { return first + static_cast<std::size_t>(i) * stride; };
    upper[index(n)] = b[index(n)];
    for (int level = 1; level <= n; ++level)
    {
      for (int i = n; i >= level; --i)
      {
        b[index(i)] = 0.5 * (b[index(i - 1)] + b[index(i)]);
      }
      upper[index(n - level)] = b[index(n)];
    }
  }
  return { b, upper };
}

/// The same over a part of each line.
Numbers Restricted(const Degrees& degree, int direction, double from, double rest, Numbers b)
{
  const int n = degree[static_cast<std::size_t>(direction)];
  const std::size_t stride = StrideOf(degree, direction);
  for (std::size_t first = 0; first < b.size(); ++first)
  {
    if (first / stride % static_cast<std::size_t>(n + 1) != 0)
    {
      continue;
    }
    const auto at = [&](int i) -> double&
    { return b[first + static_cast<std::size_t>(i) * stride]; };
    for (int level = 1; from > 0.0 && level <= n; ++level)
    {
      for (int i = 0; i <= n - level; ++i)
      {
        at(i) = (1.0 - from) * at(i) + from * at(i + 1);
      }
    }
    for (int level = 1; rest < 1.0 && level <= n; ++level)
    {
      for (int i = n; i >= level; --i)
      {
        at(i) = (1.0 - rest) * at(i - 1) + rest * at(i);
      }
    }
  }
  return b;
}

double Difference(const Degrees& degree, int direction, int order, const Numbers& b)
{
  const auto n = static_cast<std::size_t>(degree[static_cast<std::size_t>(direction)]);
  const std::size_t stride = StrideOf(degree, direction);
  double most = 0.0;
  for (std::size_t i = 0; i < b.size(); ++i)
  {
    if (i / stride % (n + 1) + static_cast<std::size_t>(order) <= n)
    {
      const double step = b[i + stride] - b[i];
      most =
        std::max(most, std::fabs(order == 1 ? step : b[i + 2 * stride] - b[i + stride] - step));
    }
  }
  return most;
}
} // namespace

TEST(SweepKernels, SubdivideLikeDeCasteljau)
{
  for (const Degrees& degree : kSweepDegrees)
  {
    const Numbers b = Made(degree);
    for (int direction = 0; direction < 3; ++direction)
    {
      const auto expected = Subdivided(degree, direction, b);
      OnEveryInstructionSet(
        [&]
        {
          Numbers lower = b;
          Numbers upper(b.size());
          Subdivide(degree, direction, lower, upper);
          EXPECT_EQ(lower, expected[0]) << degree[0] << degree[1] << degree[2] << direction;
          EXPECT_EQ(upper, expected[1]) << degree[0] << degree[1] << degree[2] << direction;
        });
    }
  }
}

TEST(SweepKernels, RestrictLikeDeCasteljau)
{
  OnEveryInstructionSet(
    []
    {
      for (const Degrees& degree : kSweepDegrees)
      {
        for (int direction = 0; direction < 3; ++direction)
        {
          for (const auto& [from, rest] : { std::pair{ 0.0, 1.0 }, std::pair{ 0.3, 1.0 },
                 std::pair{ 0.0, 0.6 }, std::pair{ 0.7, 0.2 } })
          {
            Numbers b = Made(degree);
            const Numbers expected = Restricted(degree, direction, from, rest, b);
            SweepTo(degree, direction, from, rest, b);
            EXPECT_EQ(b, expected) << degree[0] << degree[1] << degree[2] << " along " << direction;
          }
        }
      }
    });
}

TEST(SweepKernels, LargestDifferenceAndMagnitude)
{
  OnEveryInstructionSet(
    []
    {
      for (const Degrees& degree : kSweepDegrees)
      {
        const Numbers b = Made(degree);
        double largest = 0.0;
        for (const double one : b)
        {
          largest = std::max(largest, std::fabs(one));
        }
        EXPECT_EQ(LargestMagnitude(b), largest);
        for (int direction = 0; direction < 3; ++direction)
        {
          const int n = degree[static_cast<std::size_t>(direction)];
          const std::size_t stride = StrideOf(degree, direction);
          for (int order = 1; order <= std::min(n, 2); ++order)
          {
            EXPECT_EQ(LargestDifference(b, stride, stride * static_cast<std::size_t>(n + 1), order),
              Difference(degree, direction, order, b));
          }
        }
      }
    });
}

TEST(SweepKernels, WeighMagnitudesOnEachInstructionSetAlike)
{
  for (const std::size_t count : { 1U, 7U, 8U, 9U, 33U })
  {
    Numbers values = Made({ 4, 8, 0 });
    values.resize(count);
    const Numbers weights(count, 0.75);
    long double exact = 0.0L;
    for (const double value : values)
    {
      exact += 0.75L * std::fabs(static_cast<long double>(value));
    }
    const double first = WeighMagnitudes(values, weights.data());
    EXPECT_NEAR(first, static_cast<double>(exact), 1e-14 * static_cast<double>(exact));
    OnEveryInstructionSet([&] { EXPECT_EQ(WeighMagnitudes(values, weights.data()), first); });
  }
}

TEST(SweepKernels, MagnitudesOfWhatIsNoNumber)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const std::size_t at : { 0, 3, 16 })
  {
    Numbers b(17, 2.0);
    b[at] = nan;
    EXPECT_TRUE(std::isnan(LargestMagnitude(b)));
    b[at] = -infinity;
    EXPECT_EQ(LargestMagnitude(b), infinity);
    b[at] = -3.0;
    EXPECT_EQ(LargestMagnitude(b), 3.0);
  }
  EXPECT_EQ(LargestMagnitude({}), 0.0);
}
} // namespace pixelexact::testing
