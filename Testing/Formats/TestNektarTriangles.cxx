// SPDX-License-Identifier: BSD-3-Clause
#include "NektarTexts.h"

#include "Core/Basis/BasisFactor.h"
#include "Formats/Nektar/CurvePoints.h"

#include <cmath>
#include <iomanip>

namespace pixelexact::testing
{
namespace
{
using nektar::Distribution;

constexpr std::pair<Distribution, const char*> kTriangles[] = {
  { Distribution::TriangleEquispaced, "NodalTriEvenlySpaced" },
  { Distribution::TriangleElectrostatic, "NodalTriElec" },
  { Distribution::TriangleFekete, "NodalTriFekete" },
};

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

/// From below: at the points of a grid.
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

/// A map of total order `order` whose derivatives are of the size of one.
Vec3 Polynomial(int order, double b, double c)
{
  const auto bend = [&](double u) { return std::pow(0.5 * b + 0.4 * c + u, order) / order; };
  return { b + 0.1 * bend(0.1), c - 0.2 * bend(0.3), 0.3 * bend(0.2) };
}

std::string Text(const Vec3& x)
{
  std::ostringstream text;
  text << std::setprecision(17) << x.x << " " << x.y << " " << x.z << " ";
  return text.str();
}

/// A tetrahedron whose face 0 and this face's edges are curved by the polynomial. The face's own
/// order of vertices begins at vertex `turn`.
std::string CurvedTetrahedron(int order, Distribution distribution, const char* type, int turn)
{
  constexpr double kCorners[3][2] = { { 0, 0 }, { 1, 0 }, { 0, 1 } };
  const auto at = [&](const LongVec3& weights) // of the face's vertices in its own order
  {
    const auto b = static_cast<double>(weights[(4 - turn) % 3]);
    const auto c = static_cast<double>(weights[(5 - turn) % 3]);
    return Text(Polynomial(order, b, c));
  };
  std::string vertices;
  std::string curves;
  const int edges[3][2] = { { 0, 1 }, { 1, 2 }, { 0, 2 } };
  for (int k = 0; k < 3; ++k)
  {
    vertices += "<V ID=\"" + std::to_string(k) + "\">" +
      Text(Polynomial(order, kCorners[k][0], kCorners[k][1])) + "</V>";
    curves += "<E ID=\"" + std::to_string(k) + "\" EDGEID=\"" + std::to_string(k) +
      "\" NUMPOINTS=\"" + std::to_string(order + 1) + "\" TYPE=\"GaussLobattoLegendre\">";
    for (const long double z : GaussLobattoPoints(order + 1))
    {
      const auto w = static_cast<double>((1 + z) / 2);
      const auto* from = kCorners[edges[k][0]];
      const auto* to = kCorners[edges[k][1]];
      curves +=
        Text(Polynomial(order, from[0] * (1 - w) + to[0] * w, from[1] * (1 - w) + to[1] * w));
    }
    curves += "</E>";
  }
  const auto points = TrianglePoints(distribution, order);
  curves += "<F ID=\"3\" FACEID=\"0\" NUMPOINTS=\"" + std::to_string(points.size()) + "\" TYPE=\"" +
    type + "\">";
  for (const LongVec3& point : points)
  {
    curves += at(point);
  }
  const char* faces[3] = { "0 1 2", "1 2 0", "2 0 1" };
  return Session("<VERTEX>" + vertices +
    "<V ID=\"3\">0 0 1</V></VERTEX><EDGE><E ID=\"0\">0 1</E><E ID=\"1\">1 2</E>"
    "<E ID=\"2\">0 2</E><E ID=\"3\">0 3</E><E ID=\"4\">1 3</E><E ID=\"5\">2 3</E></EDGE>"
    "<FACE><T ID=\"0\">" +
    faces[turn] +
    "</T><T ID=\"1\">0 4 3</T><T ID=\"2\">1 5 4</T><T ID=\"3\">2 5 3</T></FACE>"
    "<ELEMENT><A ID=\"0\">0 1 2 3</A></ELEMENT><CURVED>" +
    curves + "</F></CURVED>");
}
} // namespace

TEST(NektarTriangles, PointsAreInNektarsOrder)
{
  for (const auto& [distribution, name] : kTriangles)
  {
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
  // In the table's ten digits; Nektar++'s Fekete points of orders 6 and 9 have fewer that are
  // right.
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
  // Then each inner point's own function is flat there. That holds to the table's digits.
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

TEST(NektarTriangles, CurvedFacesReproducePolynomials)
{
  for (const auto& [distribution, name] : kTriangles)
  {
    for (const int n : { 1, 2, 3, 4, 5, 7, std::min(10, HighestOrder(distribution)) })
    {
      for (int turn = 0; turn < (n < 6 ? 3 : 1); ++turn)
      {
        const SolverModel model = ReadTexts(CurvedTetrahedron(n, distribution, name, turn));
        for (int k = 0; k < 12; ++k)
        {
          const double b = 0.05 + 0.9 * k / 12;
          const double c = (1 - b) * (k * 5 % 12) / 11;
          const Vec3 x = PointAt(model, 0, { 2 * b - 1, 2 * c - 1, -1 });
          const Vec3 expected = Polynomial(n, b, c);
          for (int d = 0; d < 3; ++d)
          {
            EXPECT_NEAR(x[d], expected[d], 2e-14) << name << " " << n << " turned " << turn;
          }
        }
      }
    }
  }
}

TEST(NektarTriangles, WhatIsNotTabulatedIsRefused)
{
  const auto refuse = [](int points, const std::string& type, const std::string& part)
  {
    std::string text;
    for (int i = 0; i < points; ++i)
    {
      text += "0 0 0 ";
    }
    const std::string good = CurvedTetrahedron(1, Distribution::TriangleEquispaced, "none", 0);
    const auto from = good.find("<F ");
    const auto to = good.find("</F>");
    ExpectRefusal(Replaced(good, good.substr(from, to - from),
                    "<F ID=\"0\" FACEID=\"0\" NUMPOINTS=\"" + std::to_string(points) +
                      "\" TYPE=\"" + type + "\">" + text),
      "", { "a.xml", "face 0", type, part });
  };
  refuse(66, "NodalTriFekete", "up to order 9");
  refuse(78, "NodalTriElec", "up to order 10");
  refuse(6, "NodalTriSPI", "NodalTriElec and NodalTriFekete are");
  refuse(16, "NodalTriElec", "no curve");
}
} // namespace pixelexact::testing
