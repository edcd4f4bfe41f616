// SPDX-License-Identifier: BSD-3-Clause
#include "InstructionSets.h"

#include "Core/Bernstein/PolynomialBatch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

// Hulls of several polynomials, compared with values in long double and with the hull of each
// alone.
namespace pixelexact::testing
{
namespace
{
using LongPoint = std::array<long double, 3>;

long double Bernstein(int n, int i, long double t)
{
  long double value = 1.0L;
  for (int k = 0; k < i; ++k)
  {
    value *= t * static_cast<long double>(n - k) / static_cast<long double>(i - k);
  }
  return value * std::pow(1.0L - t, static_cast<long double>(n - i));
}

/// The value at t in [-1, 1]^3.
long double ValueAt(const BoxPolynomial& polynomial, const LongPoint& t)
{
  long double sum = 0.0L;
  auto next = polynomial.b.begin();
  for (int i = 0; i <= polynomial.degree[0]; ++i)
  {
    for (int j = 0; j <= polynomial.degree[1]; ++j)
    {
      for (int k = 0; k <= polynomial.degree[2]; ++k)
      {
        sum += static_cast<long double>(*next++) *
          Bernstein(polynomial.degree[0], i, 0.5L + t[0] / 2) *
          Bernstein(polynomial.degree[1], j, 0.5L + t[1] / 2) *
          Bernstein(polynomial.degree[2], k, 0.5L + t[2] / 2);
      }
    }
  }
  return sum;
}

class Polynomials
{
public:
  /// Random polynomials of this degree, and of lower ones.
  std::vector<BoxPolynomial> Make(const Degrees& degree, std::size_t count)
  {
    std::vector<BoxPolynomial> list;
    for (std::size_t c = 0; c < count; ++c)
    {
      BoxPolynomial one{ degree, {}, c % 3 == 1 ? 1e-10 : 0.0 };
      for (std::size_t d = 0; d < 3; ++d)
      {
        one.degree[d] = std::max(0, degree[d] - static_cast<int>((c >> d) % 2));
      }
      one.b.resize(CoefficientCount(one.degree));
      std::ranges::generate(one.b, [this] { return Any(Engine); });
      list.push_back(one);
    }
    return list;
  }

  Box3 MakePart()
  {
    Box3 part;
    for (int d = 0; d < 3; ++d)
    {
      const double a = Any(Engine);
      const double b = Any(Engine);
      part.lower[d] = std::min(a, b);
      part.upper[d] = std::max(a, b);
    }
    return part;
  }

  long double Between(double lower, double upper)
  {
    return lower + (static_cast<long double>(upper) - lower) * (0.5L + Any(Engine) / 2);
  }

private:
  std::mt19937_64 Engine{ 11 };
  std::uniform_real_distribution<double> Any{ -1.0, 1.0 };
};

const std::vector<Degrees> kBatchDegrees{ { 1, 1, 1 }, { 3, 3, 3 }, { 2, 5, 1 }, { 0, 4, 2 },
  { 8, 7, 9 } };
} // namespace

TEST(PolynomialBatch, HullsHoldAllValues)
{
  OnEveryInstructionSet(
    []
    {
      Polynomials made;
      for (const Degrees& degree : kBatchDegrees)
      {
        for (const std::size_t count : { std::size_t{ 1 }, std::size_t{ 10 }, std::size_t{ 18 } })
        {
          const std::vector<BoxPolynomial> list = made.Make(degree, count);
          const PolynomialBatch batch(degree, list);
          const Box3 part = made.MakePart();
          std::vector<Interval> hulls(count);
          batch.HullsOver(part, hulls);
          for (int point = 0; point < 8; ++point)
          {
            const LongPoint t{ made.Between(part.lower.x, part.upper.x),
              made.Between(part.lower.y, part.upper.y), made.Between(part.lower.z, part.upper.z) };
            for (std::size_t c = 0; c < count; ++c)
            {
              const long double value = ValueAt(list[c], t);
              EXPECT_LE(hulls[c].lower + list[c].error, value);
              EXPECT_GE(hulls[c].upper - list[c].error, value);
            }
          }
        }
      }
    });
}

/// Over a small box polynomials have almost a lower degree. The hulls include the dropped part.
TEST(PolynomialBatch, LoweredOnesHoldAllValues)
{
  OnEveryInstructionSet(
    []
    {
      Polynomials made;
      for (const Degrees& degree : { Degrees{ 0, 4, 2 }, Degrees{ 8, 7, 9 }, Degrees{ 12, 1, 15 } })
      {
        std::vector<BoxPolynomial> list = made.Make(degree, 10);
        for (BoxPolynomial& one : list)
        {
          for (int d = 0; d < 3; ++d)
          {
            one.Restrict(d, 0.25, 0.375);
          }
        }
        const PolynomialBatch batch(degree, list);
        for (const double left : { 0.0, 1e-9, 1e-3 })
        {
          const PolynomialBatch lowered = batch.Lowered(left);
          for (std::size_t d = 0; d < 3; ++d)
          {
            EXPECT_LE(lowered.Degree()[d], degree[d]);
            EXPECT_GE(lowered.Degree()[d], std::min(degree[d], 1));
          }
          EXPECT_TRUE(left > 0.0 || lowered.Degree() == degree);
          EXPECT_TRUE(left < 1e-3 || lowered.Degree() != degree);
          for (int trial = 0; trial < 4; ++trial)
          {
            const Box3 part = made.MakePart();
            std::vector<Interval> hulls(list.size());
            lowered.HullsOver(part, hulls);
            for (int point = 0; point < 8; ++point)
            {
              const LongPoint t{ made.Between(part.lower.x, part.upper.x),
                made.Between(part.lower.y, part.upper.y),
                made.Between(part.lower.z, part.upper.z) };
              for (std::size_t c = 0; c < list.size(); ++c)
              {
                const long double value = ValueAt(list[c], t);
                EXPECT_LE(hulls[c].lower + list[c].error, value);
                EXPECT_GE(hulls[c].upper - list[c].error, value);
              }
            }
          }
        }
      }
    });
}

namespace
{
/// Coordinates of degree 1 in each direction, as xi is in eta.
Vec3 PlaceAt(const Vec3& t)
{
  return { 0.25 * (1.0 + t.x) * (1.0 - t.y) * (1.0 - t.z) - 1.0, 0.5 * (1.0 + t.y) * (1.0 - t.z),
    t.z };
}

std::vector<Vec3> PlacesIn(const Box3& part, const Degrees& degree)
{
  std::vector<Vec3> places;
  const auto at = [&](int d, int i)
  {
    return part.lower[d] +
      (part.upper[d] - part.lower[d]) * i / degree[static_cast<std::size_t>(d)];
  };
  for (int i = 0; i <= degree[0]; ++i)
  {
    for (int j = 0; j <= degree[1]; ++j)
    {
      for (int k = 0; k <= degree[2]; ++k)
      {
        places.push_back(PlaceAt({ at(0, i), at(1, j), at(2, k) }));
      }
    }
  }
  return places;
}

long double AffineAt(const AffineBound& bound, const Vec3& x)
{
  long double sum = bound.value;
  for (int d = 0; d < 3; ++d)
  {
    sum += static_cast<long double>(bound.slope[static_cast<std::size_t>(d)]) * x[d];
  }
  return sum;
}
} // namespace

/// The affine bounds contain all values; for affine polynomials the remainder is nearly zero.
TEST(PolynomialBatch, AffineBoundsHoldAllValues)
{
  OnEveryInstructionSet(
    []
    {
      Polynomials made;
      for (const Degrees& degree : { Degrees{ 1, 1, 1 }, Degrees{ 3, 3, 3 }, Degrees{ 8, 7, 9 } })
      {
        std::vector<BoxPolynomial> list = made.Make(degree, 11);
        BoxPolynomial affine{ degree, {}, 0.0 };
        for (const Vec3& x : PlacesIn({ Vec3(-1.0), Vec3(1.0) }, degree))
        {
          affine.b.push_back(3.0 + 2.0 * x.x - 5.0 * x.y + 7.0 * x.z);
        }
        list.push_back(affine);
        const PolynomialBatch batch(degree, list);
        for (int trial = 0; trial < 4; ++trial)
        {
          const Box3 part = trial == 0 ? Box3{ Vec3(-1.0), Vec3(1.0) } : made.MakePart();
          const std::vector<Vec3> places = PlacesIn(part, degree);
          std::vector<Interval> hulls(list.size());
          std::vector<AffineBound> bounds(6);
          batch.BoundsOver(part, hulls, places, bounds);
          EXPECT_LE(bounds.back().radius, 1e-11);
          for (int point = 0; point < 8; ++point)
          {
            const LongPoint t{ made.Between(part.lower.x, part.upper.x),
              made.Between(part.lower.y, part.upper.y), made.Between(part.lower.z, part.upper.z) };
            const Vec3 x = PlaceAt(
              { static_cast<double>(t[0]), static_cast<double>(t[1]), static_cast<double>(t[2]) });
            for (std::size_t c = 0; c < bounds.size(); ++c)
            {
              const BoxPolynomial& own = list[list.size() - bounds.size() + c];
              const long double off = ValueAt(own, t) - AffineAt(bounds[c], x);
              EXPECT_LE(std::fabs(off), bounds[c].radius + 1e-13);
            }
          }
        }
      }
    });
}

TEST(PolynomialBatch, HullsAreThoseOfEachAlone)
{
  Polynomials made;
  for (const Degrees& degree : kBatchDegrees)
  {
    for (int trial = 0; trial < 20; ++trial)
    {
      std::vector<BoxPolynomial> list = made.Make(degree, 9);
      const PolynomialBatch batch(degree, list);
      Box3 part = made.MakePart();
      part = trial == 0 ? Box3{ Vec3(-1.0), Vec3(1.0) } : part;
      part.lower.y = trial == 1 ? -1.0 : part.lower.y;
      part.upper.x = trial == 2 ? 1.0 : part.upper.x;
      std::vector<Interval> hulls(list.size());
      batch.HullsOver(part, hulls);
      for (std::size_t c = 0; c < list.size(); ++c)
      {
        const bool raised = list[c].degree != degree;
        for (int d = 0; d < 3; ++d)
        {
          list[c].Restrict(d, part.lower[d], part.upper[d]);
        }
        const Interval alone = list[c].Hull();
        const double rounding = 1e-12;
        EXPECT_GE(hulls[c].lower, alone.lower - rounding);
        EXPECT_LE(hulls[c].upper, alone.upper + rounding);
        if (!raised)
        {
          EXPECT_LE(hulls[c].lower, alone.lower + rounding);
          EXPECT_GE(hulls[c].upper, alone.upper - rounding);
        }
      }
    }
  }
}

TEST(PolynomialBatch, ErrorsAreKept)
{
  BoxPolynomial one{ { 1, 0, 0 }, { 0.0, 1.0 }, 0.25 };
  BoxPolynomial other{ { 1, 0, 0 }, { 2.0, 1.0 }, std::numeric_limits<double>::infinity() };
  const PolynomialBatch batch({ 1, 0, 0 }, std::vector{ one, other });
  std::array<Interval, 2> hulls;
  batch.HullsOver({ Vec3(0.0), Vec3(1.0) }, hulls);
  EXPECT_NEAR(hulls[0].lower, 0.25, 1e-12);
  EXPECT_NEAR(hulls[0].upper, 1.25, 1e-12);
  EXPECT_FALSE(hulls[1].IsFinite());
}
} // namespace pixelexact::testing
