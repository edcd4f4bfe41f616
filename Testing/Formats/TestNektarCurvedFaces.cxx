// SPDX-License-Identifier: BSD-3-Clause
#include "NektarTexts.h"

#include "Formats/Nektar/Geometry/CurvePoints.h"

#include <cmath>
#include <iomanip>
#include <sstream>

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

TEST(NektarCurvedFaces, ReproducePolynomials)
{
  for (const auto& [distribution, name] : kTriangles)
  {
    for (const int n : { 1, 2, 3, 4, 5, 7, std::min(10, HighestOrder(distribution)) })
    {
      for (int turn = 0; turn < (n < 6 ? 3 : 1); ++turn)
      {
        const SolverModel model = ReadSession(CurvedTetrahedron(n, distribution, name, turn));
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

TEST(NektarCurvedFaces, WhatIsNotTabulatedIsRefused)
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
