// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Basis/NoiseBound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace pixelexact
{
namespace
{
std::vector<int> InOrder(int count)
{
  std::vector<int> source(static_cast<std::size_t>(count));
  std::iota(source.begin(), source.end(), 0);
  return source;
}

/// Lebesgue's function of n + 1 equispaced nodes on [-1, 1], at its largest of many points.
double LebesgueOfLine(int n)
{
  double most = 0.0;
  for (int k = 0; k <= 4000; ++k)
  {
    const long double x = -1.0L + k / 2000.0L;
    long double sum = 0.0L;
    for (int i = 0; i <= n; ++i)
    {
      long double product = 1.0L;
      for (int j = 0; j <= n; ++j)
      {
        product *= j == i ? 1.0L : (x - (-1.0L + 2.0L * j / n)) / (2.0L * (i - j) / n);
      }
      sum += std::fabs(product);
    }
    most = std::max(most, static_cast<double>(sum));
  }
  return most;
}

/// The same of nodes (i, j, k) / n of the tetrahedron: a product of linear factors each.
double LebesgueOfTetrahedron(int n)
{
  const auto factors = [n](long double t, int i)
  {
    long double product = 1.0L;
    for (int j = 0; j < i; ++j)
    {
      product *= (n * t - j) / static_cast<long double>(i - j);
    }
    return product;
  };
  double most = 0.0;
  constexpr int kParts = 40;
  for (int a = 0; a <= kParts; ++a)
  {
    for (int b = 0; a + b <= kParts; ++b)
    {
      for (int c = 0; a + b + c <= kParts; ++c)
      {
        const long double x[4] = { static_cast<long double>(a) / kParts,
          static_cast<long double>(b) / kParts, static_cast<long double>(c) / kParts,
          static_cast<long double>(kParts - a - b - c) / kParts };
        long double sum = 0.0L;
        for (int i = 0; i <= n; ++i)
        {
          for (int j = 0; i + j <= n; ++j)
          {
            for (int k = 0; i + j + k <= n; ++k)
            {
              sum += std::fabs(factors(x[0], i) * factors(x[1], j) * factors(x[2], k) *
                factors(x[3], n - i - j - k));
            }
          }
        }
        most = std::max(most, static_cast<double>(sum));
      }
    }
  }
  return most;
}
} // namespace

TEST(NoiseBound, HoldsLebesguesConstantOfEquispacedNodes)
{
  for (const int n : { 1, 2, 3, 4 })
  {
    const auto order = static_cast<std::uint8_t>(n);
    const Space hexahedron{ Shape::Hexahedron, Form::Collapsed, { order, order, order } };
    const double ofLine = LebesgueOfLine(n);
    const double exact = ofLine * ofLine * ofLine;
    const double bound = NoiseBound(ChangeOfBasis::Hexahedron(
      hexahedron, Family::EquispacedLagrange, InOrder((n + 1) * (n + 1) * (n + 1))));
    EXPECT_GE(bound, exact);
    EXPECT_LE(bound, 1.6 * exact);
  }
  for (const int n : { 1, 2, 4, 6 })
  {
    const auto order = static_cast<std::uint8_t>(n);
    const Space tetrahedron{ Shape::Tetrahedron, Form::Collapsed, { order, order, order } };
    const double exact = LebesgueOfTetrahedron(n);
    const double bound = NoiseBound(ChangeOfBasis::Tetrahedron(
      tetrahedron, Family::EquispacedLagrange, InOrder((n + 1) * (n + 2) * (n + 3) / 6)));
    EXPECT_GE(bound, exact);
    EXPECT_LE(bound, 1.6 * exact);
  }
}

TEST(NoiseBound, IsNotKnownWhereItWouldTakeLong)
{
  const Space space{ Shape::Hexahedron, Form::Collapsed, { 12, 12, 12 } };
  EXPECT_TRUE(std::isinf(NoiseBound(
    ChangeOfBasis::Hexahedron(space, Family::EquispacedLagrange, InOrder(13 * 13 * 13)))));
}
} // namespace pixelexact
