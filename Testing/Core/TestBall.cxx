// SPDX-License-Identifier: BSD-3-Clause
// Ball arithmetic against MPFR, as intervals are; here without fused operations, while the
// enclosures' tests run it on every instruction set.
#include "ExactNumbers.h"

#include "Core/Math/Ball-inl.h"

#include <gtest/gtest.h>

#include <array>

namespace pixelexact::testing
{
namespace
{
namespace simd = HWY_NAMESPACE;

simd::Ball MakeBall(double middle, double radius)
{
  return { simd::ball::Set(middle), simd::ball::Set(radius) };
}

Interval ToInterval(const simd::Ball& ball)
{
  std::array<double, 8> middle{};
  std::array<double, 8> radius{};
  simd::Store(ball.middle, middle.data());
  simd::Store(ball.radius, radius.data());
  return std::isfinite(middle[0]) && std::isfinite(radius[0])
    ? Interval::Around(middle[0], radius[0])
    : Interval::Everything();
}

/// A ball, and a member of it that is a double.
struct BallAndMember
{
  simd::Ball ball;
  double member;
};

BallAndMember AnyBall(Random& random)
{
  const double middle = AnyDouble(random);
  const double radius = random() < 0.0 ? 0.0 : std::fabs(AnyDouble(random));
  // Towards zero, so that the member is one.
  const double offset = std::nextafter(random() * radius, 0.0);
  const double member = middle + offset;
  const Exact exactMember(member);
  const Exact exactMiddle(middle);
  Exact distance;
  mpfr_sub(distance.Number, exactMember.Number, exactMiddle.Number, MPFR_RNDN);
  const bool isMember =
    std::isfinite(member) && mpfr_cmpabs(distance.Number, Exact(radius).Number) <= 0;
  return { MakeBall(middle, radius), isMember ? member : middle };
}
} // namespace

TEST(Ball, EveryOperationHoldsTheExactResults)
{
  Random random(5);
  int finite = 0;
  for (int k = 0; k < 30000; ++k)
  {
    const auto [a, x] = AnyBall(random);
    const auto [b, y] = AnyBall(random);
    const auto [c, z] = AnyBall(random);
    EXPECT_TRUE(HoldsResult(ToInterval(a + b), &mpfr_add, x, y)) << x << " + " << y;
    EXPECT_TRUE(HoldsResult(ToInterval(a - b), &mpfr_sub, x, y)) << x << " - " << y;
    EXPECT_TRUE(HoldsResult(ToInterval(a * b), &mpfr_mul, x, y)) << x << " * " << y;
    EXPECT_TRUE(y == 0.0 || HoldsResult(ToInterval(a / b), &mpfr_div, x, y)) << x << " / " << y;
    const Interval sum = ToInterval(MulAdd(a, b, c));
    const Interval difference = ToInterval(NegMulAdd(a, b, c));
    const Exact first(x);
    const Exact second(y);
    const Exact third(z);
    Exact exact;
    mpfr_fma(exact.Number, first.Number, second.Number, third.Number, MPFR_RNDN);
    EXPECT_LE(mpfr_cmp_d(exact.Number, sum.upper), 0) << x << " * " << y << " + " << z;
    EXPECT_GE(mpfr_cmp_d(exact.Number, sum.lower), 0) << x << " * " << y << " + " << z;
    mpfr_fms(exact.Number, first.Number, second.Number, third.Number, MPFR_RNDN);
    mpfr_neg(exact.Number, exact.Number, MPFR_RNDN);
    EXPECT_LE(mpfr_cmp_d(exact.Number, difference.upper), 0);
    EXPECT_GE(mpfr_cmp_d(exact.Number, difference.lower), 0);
    finite += sum.IsFinite() ? 1 : 0;
  }
  EXPECT_GT(finite, 9000);
}
} // namespace pixelexact::testing
