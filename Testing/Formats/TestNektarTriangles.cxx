// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Basis/BasisFactor.h"
#include "Formats/Nektar/Geometry/CurvePoints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pixelexact::testing
{
namespace
{
using nektar::Distribution;

/// Values and derivatives of the monomials up to a total order.
struct Monomials
{
  std::vector<long double> value;
  std::vector<long double> db;
  std::vector<long double> dc;
};

Monomials MonomialsAt(int order, long double b, long double c)
{
  Monomials at;
  const auto power = [](long double x, int n) { return n < 0 ? 0.0L : std::pow(x, n); };
  for (int i = 0; i <= order; ++i)
  {
    for (int j = 0; i + j <= order; ++j)
    {
      at.value.push_back(power(b, i) * power(c, j));
      at.db.push_back(i * power(b, i - 1) * power(c, j));
      at.dc.push_back(j * power(b, i) * power(c, j - 1));
    }
  }
  return at;
}

/// The cardinal functions of some points, as coefficients of the monomials.
class Cardinals
{
public:
  Cardinals(const std::vector<LongVec3>& points, int order)
    : Order(order)
  {
    const auto n = static_cast<int>(points.size());
    std::vector<long double> matrix;
    std::vector<long double> identity(std::size_t(n) * n, 0.0L);
    for (int i = 0; i < n; ++i)
    {
      identity[std::size_t(i) * (n + 1)] = 1.0L;
      const auto row = MonomialsAt(order, Shifted(points[i][1]), Shifted(points[i][2])).value;
      matrix.insert(matrix.end(), row.begin(), row.end());
    }
    Factor = SolveFactor(n, n, matrix, identity);
  }

  long double Lebesgue(long double b, long double c) const
  {
    const auto at = MonomialsAt(Order, Shifted(b), Shifted(c));
    long double sum = 0.0L;
    for (int i = 0; i < Factor.columns; ++i)
    {
      sum += std::fabs(Dot(at.value, i));
    }
    return sum;
  }

  /// The slope of function i.
  long double Slope(int i, long double b, long double c) const
  {
    const auto at = MonomialsAt(Order, Shifted(b), Shifted(c));
    return 2 * std::hypot(Dot(at.db, i), Dot(at.dc, i));
  }

private:
  static long double Shifted(long double x) { return 2 * x - 1; }

  long double Dot(const std::vector<long double>& values, int i) const
  {
    long double sum = 0.0L;
    for (int m = 0; m < Factor.rows; ++m)
    {
      sum += values[m] * Factor.matrix[std::size_t(m) * Factor.columns + i];
    }
    return sum;
  }

  int Order;
  BasisFactor Factor;
};

/// A lower bound of the Lebesgue constant, from the points of a grid.
double LebesgueConstant(Distribution distribution, int order, int steps)
{
  const Cardinals cardinals(TrianglePoints(distribution, order), order);
  long double most = 0.0L;
  for (int i = 0; i <= steps; ++i)
  {
    for (int j = 0; i + j <= steps; ++j)
    {
      most = std::max(most,
        cardinals.Lebesgue(
          static_cast<long double>(i) / steps, static_cast<long double>(j) / steps));
    }
  }
  return static_cast<double>(most);
}

} // namespace

TEST(NektarTriangles, PointsAreInNektarsOrder)
{
  for (const Distribution distribution : { Distribution::TriangleEquispaced,
         Distribution::TriangleElectrostatic, Distribution::TriangleFekete })
  {
    const auto name = static_cast<int>(distribution);
    for (int n = 1; n <= std::min(10, HighestOrder(distribution)); ++n)
    {
      const auto points = TrianglePoints(distribution, n);
      ASSERT_EQ(points.size(), std::size_t(n + 1) * (n + 2) / 2) << name << " " << n;
      for (int edge = 0; edge < 3; ++edge)
      {
        EXPECT_EQ(points[edge][edge], 1);
        for (int i = 1; i < n; ++i)
        {
          const LongVec3& at = points[3 + edge * (n - 1) + i - 1];
          const LongVec3& mirrored = points[3 + edge * (n - 1) + n - 1 - i];
          EXPECT_EQ(at[(edge + 2) % 3], 0) << name << " " << n;
          EXPECT_NEAR(at[(edge + 1) % 3], mirrored[edge], 1e-15) << name << " " << n;
          EXPECT_TRUE(
            i == 1 || at[(edge + 1) % 3] > points[3 + edge * (n - 1) + i - 2][(edge + 1) % 3])
            << name << " " << n;
        }
      }
      // Rows of n - 2, n - 3, ... points, each from left to right.
      std::size_t k = 3 * n;
      for (int row = n - 2; row > 0; --row)
      {
        for (int i = 0; i < row; ++i, ++k)
        {
          EXPECT_GT(*std::ranges::min_element(points[k]), 0.01) << name << " " << n;
          EXPECT_TRUE(i == 0 || points[k][1] >= points[k - 1][1]) << name << " " << n;
        }
      }
    }
  }
}

TEST(NektarTriangles, EdgesHaveGaussLobattoPoints)
{
  // The points agree to the table's ten digits; Nektar++'s Fekete points of orders 6 and 9 have
  // fewer correct digits.
  for (int n = 1; n <= 10; ++n)
  {
    const auto line = GaussLobattoPoints(n + 1);
    const auto electrostatic = TrianglePoints(Distribution::TriangleElectrostatic, n);
    const auto fekete = TrianglePoints(Distribution::TriangleFekete, std::min(n, 9));
    for (int i = 1; i < n; ++i)
    {
      EXPECT_NEAR(electrostatic[2 + i][1], (1 + line[i]) / 2, 5.1e-11) << n;
      if (n < 10)
      {
        EXPECT_NEAR(fekete[2 + i][1], (1 + line[i]) / 2,
          n == 6     ? 1.1e-5
            : n == 9 ? 4e-7
                     : 1e-10)
          << n;
      }
    }
  }
}

TEST(NektarTriangles, FeketePointsMakeTheDeterminantStationary)
{
  // The gradient of each inner point's own function is then zero there, to the table's digits.
  for (int n = 3; n <= HighestOrder(Distribution::TriangleFekete); ++n)
  {
    const auto points = TrianglePoints(Distribution::TriangleFekete, n);
    const Cardinals cardinals(points, n);
    for (std::size_t i = 3 * n; i < points.size(); ++i)
    {
      EXPECT_LT(cardinals.Slope(static_cast<int>(i), points[i][1], points[i][2]), 1e-6) << n;
    }
  }
}

TEST(NektarTriangles, LebesgueConstants)
{
  // Taylor, Wingate and Vincent's for Fekete points.
  EXPECT_NEAR(LebesgueConstant(Distribution::TriangleFekete, 3, 120), 2.11, 0.01);
  EXPECT_NEAR(LebesgueConstant(Distribution::TriangleFekete, 6, 120), 4.17, 0.01);
  EXPECT_NEAR(LebesgueConstant(Distribution::TriangleFekete, 9, 120), 6.80, 0.01);
  // Electrostatic ones are about as good; a wrong digit would not be.
  for (int n = 3; n <= 10; ++n)
  {
    EXPECT_LT(LebesgueConstant(Distribution::TriangleElectrostatic, n, 40), n);
  }
  EXPECT_GT(LebesgueConstant(Distribution::TriangleEquispaced, 10, 40), 20);
}

} // namespace pixelexact::testing
