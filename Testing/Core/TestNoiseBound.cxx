// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Basis/ModeBound.h"

#include <gtest/gtest.h>

#include <array>
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
  const Space space{ Shape::Tetrahedron, Form::Collapsed, { 8, 8, 8 } };
  EXPECT_TRUE(std::isinf(
    NoiseBound(ChangeOfBasis::Tetrahedron(space, Family::EquispacedLagrange, InOrder(165)))));
}

// The nodes of a straight and very flat tetrahedron far from the origin, of order 3.
TEST(MapNoise, IsFarBelowTheThicknessOfFlatElements)
{
  constexpr int kNodes = 20;
  const Space space{ Shape::Tetrahedron, Form::Collapsed, { 3, 3, 3 } };
  const ChangeOfBasis change =
    ChangeOfBasis::Tetrahedron(space, Family::EquispacedLagrange, InOrder(kNodes));
  const double thickness = std::ldexp(1.0, -30);
  std::vector<double> nodes(3 * kNodes);
  int node = 0;
  for (int i = 0; i <= 3; ++i)
  {
    for (int j = 0; i + j <= 3; ++j)
    {
      for (int k = 0; i + j + k <= 3; ++k, ++node)
      {
        nodes[node] = 1e4 + i / 3.0;
        nodes[kNodes + node] = j / 3.0;
        nodes[2 * kNodes + node] = thickness * k / 3.0;
      }
    }
  }
  std::vector<double> modes(3 * kNodes);
  ChangeOfBasis::Scratch scratch;
  change.Apply(nodes, std::array{ 1e4 + 0.5, 0.5, thickness / 2 }, modes, scratch);
  const double roundings = 4.0 * 0x1p-53 * 1e4;
  const MapNoise noise(change);
  const double moved = LebesgueOfTetrahedron(3) * roundings;
  EXPECT_GE(noise.Of(roundings, modes), moved);
  EXPECT_LE(noise.Of(roundings, modes), 1.6 * moved + 100.0 * 0x1p-53); // the modes are below 1
  EXPECT_LE(noise.Of(roundings, modes), 0.1 * thickness);
}
} // namespace pixelexact
