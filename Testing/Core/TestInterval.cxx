// SPDX-License-Identifier: BSD-3-Clause
// Interval arithmetic against MPFR with directed rounding: each operation's result must hold the
// exact results of the operands' ends and of members between, for numbers of every size.
#include "ExactNumbers.h"

#include <gtest/gtest.h>

namespace pixelexact::testing
{
namespace
{
Interval AnyInterval(Random& random)
{
  const double a = AnyDouble(random);
  const double kind = random(0.0, 4.0);
  if (kind < 1.0)
  {
    return a;
  }
  if (kind < 1.2)
  {
    return { a, kInfinity };
  }
  if (kind < 1.4)
  {
    return { -kInfinity, a };
  }
  const double b = AnyDouble(random);
  return { std::min(a, b), std::max(a, b) };
}

/// Members: the ends where they are finite, zero and something between.
std::vector<double> Members(const Interval& interval, Random& random)
{
  std::vector<double> members;
  const auto add = [&](double v)
  {
    if (std::isfinite(v) && interval.Contains(v))
    {
      members.push_back(v);
    }
  };
  add(interval.lower);
  add(interval.upper);
  add(0.0);
  for (int k = 0; k < 4; ++k)
  {
    add(AnyDouble(random));
  }
  if (interval.IsFinite())
  {
    add(interval.Middle());
  }
  return members;
}
} // namespace

TEST(Interval, BelowAndAboveAreNeighboursOrOneBeyond)
{
  Random random(1);
  for (int k = 0; k < 200000; ++k)
  {
    const double v = AnyDouble(random);
    const double below = rounding::Below(v);
    EXPECT_LE(below, std::nextafter(v, -kInfinity));
    EXPECT_GE(below, std::nextafter(std::nextafter(v, -kInfinity), -kInfinity)) << v;
    EXPECT_EQ(rounding::Above(v), -rounding::Below(-v));
  }
  EXPECT_EQ(rounding::Below(-kInfinity), -kInfinity);
  EXPECT_EQ(rounding::Below(kInfinity), std::numeric_limits<double>::max());
  EXPECT_EQ(rounding::Above(kInfinity), kInfinity);
  EXPECT_EQ(rounding::Above(-kInfinity), -std::numeric_limits<double>::max());
  EXPECT_TRUE(std::isnan(rounding::Below(NAN)));
}

TEST(Interval, EveryOperationHoldsTheExactResults)
{
  Random random(2);
  for (int k = 0; k < 8000; ++k)
  {
    const Interval a = AnyInterval(random);
    const Interval b = AnyInterval(random);
    const Interval sum = a + b;
    const Interval difference = a - b;
    const Interval product = a * b;
    const Interval quotient = a / b;
    for (const double x : Members(a, random))
    {
      EXPECT_TRUE((-a).Contains(-x));
      EXPECT_TRUE(Abs(a).Contains(std::fabs(x)));
      EXPECT_TRUE(HoldsResult(Square(a), &mpfr_mul, x, x)) << x;
      for (const double y : Members(b, random))
      {
        EXPECT_TRUE(HoldsResult(sum, &mpfr_add, x, y)) << x << " + " << y;
        EXPECT_TRUE(HoldsResult(difference, &mpfr_sub, x, y)) << x << " - " << y;
        EXPECT_TRUE(HoldsResult(product, &mpfr_mul, x, y)) << x << " * " << y;
        EXPECT_TRUE(y == 0.0 || HoldsResult(quotient, &mpfr_div, x, y)) << x << " / " << y;
      }
    }
  }
}

TEST(Interval, RootsHoldTheExactOnes)
{
  Random random(3);
  for (int k = 0; k < 20000; ++k)
  {
    const double x = std::fabs(AnyDouble(random));
    const Interval root = Sqrt(Interval(x));
    const Exact number(x);
    Exact exact;
    mpfr_sqrt(exact.Number, number.Number, MPFR_RNDU);
    EXPECT_LE(mpfr_cmp_d(exact.Number, root.upper), 0) << x;
    mpfr_sqrt(exact.Number, number.Number, MPFR_RNDD);
    EXPECT_GE(mpfr_cmp_d(exact.Number, root.lower), 0) << x;
    EXPECT_GE(root.lower, 0.0);
  }
}

TEST(Interval, NotANumberGivesEverything)
{
  const double nan = NAN;
  const auto expectEverything = [](const Interval& value)
  {
    EXPECT_EQ(value.lower, -kInfinity);
    EXPECT_EQ(value.upper, kInfinity);
  };
  for (const Interval& bad : { Interval(nan), Interval(nan, 1.0), Interval(0.0, nan) })
  {
    for (const Interval& other : { Interval(2.0), Interval(-1.0, 1.0), Interval(0.0) })
    {
      expectEverything(bad * other);
      expectEverything(other * bad);
      expectEverything(bad / other);
      expectEverything(other / bad);
      EXPECT_FALSE((bad + other).IsFinite());
      EXPECT_FALSE((other - bad).IsFinite());
    }
  }
  expectEverything(Interval(1.0) / Interval(-1.0, 1.0));
  expectEverything(Interval(0.0) / Interval(0.0));
  expectEverything(Interval(0.0) * Interval::Everything());
}

TEST(Interval, WidthsAreUpperBounds)
{
  Random random(4);
  for (int k = 0; k < 20000; ++k)
  {
    const double a = AnyDouble(random);
    const double b = AnyDouble(random);
    const Interval interval(std::min(a, b), std::max(a, b));
    const Exact low(interval.lower);
    const Exact high(interval.upper);
    Exact width;
    mpfr_sub(width.Number, high.Number, low.Number, MPFR_RNDU);
    EXPECT_LE(mpfr_cmp_d(width.Number, interval.Width()), 0);
    const double middle = interval.Middle();
    EXPECT_TRUE(interval.Contains(middle));
    const Interval around = Interval::Around(middle, interval.RadiusAround(middle));
    EXPECT_TRUE(around.Contains(interval));
  }
}
} // namespace pixelexact::testing
