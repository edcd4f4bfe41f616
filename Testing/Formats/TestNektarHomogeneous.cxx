// SPDX-License-Identifier: BSD-3-Clause
// Fourier's functions along z over two-dimensional meshes.
#include "NektarTexts.h"

#include "Formats/Nektar/Homogeneous/FourierLayers.h"

#include <cmath>
#include <numbers>

namespace pixelexact::testing
{
namespace
{
using nektar::FourierLayers;
using nektar::Periodic;

constexpr double kLength = 3.0;

/// The unit square, quadrilateral 7, and the triangle 9 with vertices (1, 0), (2, 0), (1, 1) to its
/// right, with a wall below.
const std::string kPlane =
  "<NEKTAR><GEOMETRY DIM=\"2\" SPACE=\"2\"><VERTEX><V ID=\"0\">0 0 0</V><V ID=\"1\">1 0 0</V>"
  "<V ID=\"2\">1 1 0</V><V ID=\"3\">0 1 0</V><V ID=\"4\">2 0 0</V></VERTEX>"
  "<EDGE><E ID=\"0\">0 1</E><E ID=\"1\">1 2</E><E ID=\"2\">2 3</E><E ID=\"3\">3 0</E>"
  "<E ID=\"4\">1 4</E><E ID=\"5\">4 2</E></EDGE>"
  "<ELEMENT><Q ID=\"7\">0 1 2 3</Q><T ID=\"9\">4 5 1</T></ELEMENT><CURVED/>"
  "<COMPOSITE><C ID=\"0\"> Q[7] </C><C ID=\"1\"> T[9] </C><C ID=\"2\"> E[0,4] </C></COMPOSITE>"
  "</GEOMETRY></NEKTAR>";

/// A block of `u` of order 1 with these functions of z and coefficients.
std::string Block(const std::string& shape, int id, const std::string& functions, int count,
  const std::string& values, const std::string& last = "Fourier")
{
  const std::string families =
    shape == "Triangle" ? "Modified_A,Modified_B," : "Modified_A,Modified_A,";
  return "<ELEMENTS FIELDS=\"u\" SHAPE=\"" + shape + "-HomogenousExp1D\" BASIS=\"" + families +
    last + "\" HOMOGENEOUSLENGTHS=\"3\" HOMOGENEOUSZIDS=\"" + functions +
    "\" NUMMODESPERDIR=\"UNIORDER:2,2," + std::to_string(count) + "\" ID=\"" + std::to_string(id) +
    "\">" + values + "</ELEMENTS>";
}

std::string MakeFieldFile(const std::string& blocks)
{
  return "<NEKTAR>" + blocks + "</NEKTAR>";
}

double Wave(int k, double z)
{
  return 2 * std::numbers::pi * k * z / kLength;
}
} // namespace

TEST(NektarHomogeneous, PolynomialsAreAsNearAsIsProven)
{
  const Periodic along{ kLength, { 0, 1, 2, 3, 6, 7 } };
  const FourierLayers layers(along);
  EXPECT_EQ(layers.Layers(), 3);
  for (const int order : { 2, 6, 10, 16, 22 })
  {
    double worst = 0.0;
    for (std::size_t f = 0; f < along.functions.size(); ++f)
    {
      const double loss = layers.Loss(f, order);
      double error = 0.0;
      for (int layer = 0; layer < layers.Layers(); ++layer)
      {
        for (double x = -1.0; x <= 1.0; x += 0.125)
        {
          long double value = 0.0L;
          for (int n = 0; n <= order; ++n)
          {
            value += layers.Coefficient(layer, f, n) *
              std::legendre(static_cast<unsigned>(n), static_cast<long double>(x));
          }
          const double z = layers.Middle(layer) + layers.Half() * x;
          const int k = along.functions[f] / 2;
          const double exact =
            along.functions[f] % 2 == 0 ? std::cos(Wave(k, z)) : -std::sin(Wave(k, z));
          EXPECT_NEAR(layers.Value(f, z), exact, 1e-14);
          error = std::max(error, std::fabs(static_cast<double>(value) - exact));
        }
      }
      EXPECT_LE(error, loss + 1e-14) << "function " << along.functions[f] << ", order " << order;
      worst = std::max(worst, error);
    }
    // The bound is of use: the last function comes near it.
    EXPECT_GE(worst + 1e-15, 0.1 * layers.Loss(5, order)) << order;
  }
}

TEST(NektarHomogeneous, TrianglesAndQuadrilateralsInLayers)
{
  // Order 1 in the plane, with one value at all vertices: 2 + cos(wave 1) - 3 sin(wave 2) there.
  const std::string four = " 2 2 2 2 1 1 1 1 3 3 3 3 ";
  const std::string three = " 2 2 2 1 1 1 3 3 3 ";
  const SolverModel model = ReadSession(kPlane,
    MakeFieldFile(
      Block("Quadrilateral", 7, "0,2,5", 3, four) + Block("Triangle", 9, "0,2,5", 3, three)));
  ASSERT_FALSE(model.mesh.slab.has_value());
  // Two layers of the triangle, which comes first, and the quadrilateral.
  EXPECT_EQ(model.mesh.number, (std::vector<std::int64_t>{ 9, 7, 19, 17 }));
  EXPECT_EQ(model.mesh.attribute, (std::vector<std::int32_t>{ 1, 0, 1, 0 }));
  EXPECT_EQ(model.mesh.boundary.size(), 4U);
  ASSERT_EQ(model.notes.size(), 1U);
  EXPECT_NE(model.notes[0].find("length 3, 3 Fourier functions"), std::string::npos);
  for (int e = 0; e < 4; ++e)
  {
    for (const Vec3& xi : { Vec3(-0.6, 0.3, -0.7), Vec3(-0.2, -0.9, 0.1), Vec3(0.4, 0.8, -0.9) })
    {
      const Vec3 x = PointAt(model, e, xi);
      EXPECT_GE(x.z, e < 2 ? 0.0 : kLength / 2);
      EXPECT_LE(x.z, e < 2 ? kLength / 2 : kLength);
      EXPECT_NEAR(ValueAt(model, 0, e, xi)[0],
        2 + std::cos(Wave(1, x.z)) - 3 * std::sin(Wave(2, x.z)), 6e-13);
    }
  }
}

TEST(NektarHomogeneous, OneWaveAlone)
{
  // FourierSingleMode numbers its two functions as Fourier does.
  const SolverModel model = ReadSession(kPlane,
    MakeFieldFile(Block("Quadrilateral", 7, "2,3", 2, " 1 1 1 1 0 0 0 0 ", "FourierSingleMode") +
      Block("Triangle", 9, "2,3", 2, " 1 1 1 0 0 0 ", "FourierSingleMode")));
  const Vec3 x = PointAt(model, 1, { 0.1, 0.2, 0.3 });
  EXPECT_NEAR(ValueAt(model, 0, 1, { 0.1, 0.2, 0.3 })[0], std::cos(Wave(1, x.z)), 2e-13);
}

TEST(NektarHomogeneous, HalfModes)
{
  // Function 0 of a half mode is cos(pi x), x from -1 to 1 along the length.
  const SolverModel model = ReadSession(kPlane,
    MakeFieldFile(Block("Quadrilateral", 7, "0", 1, " 1 1 1 1 ", "FourierHalfModeRe") +
      Block("Triangle", 9, "0", 1, " 1 1 1 ", "FourierHalfModeRe")));
  ASSERT_EQ(model.mesh.number.size(), 2U);
  for (int e = 0; e < 2; ++e)
  {
    const Vec3 xi(0.1, 0.2, -0.7);
    EXPECT_NEAR(ValueAt(model, 0, e, xi)[0], -std::cos(Wave(1, PointAt(model, e, xi).z)), 2e-13);
  }
  ASSERT_EQ(model.notes.size(), 2U);
  EXPECT_NE(model.notes[1].find("realmodetoimag"), std::string::npos);
}

TEST(NektarHomogeneous, ImaginaryHalfModes)
{
  // All fields are sines, as those of a real half mode are with realmodetoimag.
  const SolverModel model = ReadSession(kPlane,
    MakeFieldFile(Block("Quadrilateral", 7, "0", 1, " 1 1 1 1 ", "FourierHalfModeIm") +
      Block("Triangle", 9, "0", 1, " 1 1 1 ", "FourierHalfModeIm")));
  ASSERT_EQ(model.mesh.number.size(), 2U);
  for (int e = 0; e < 2; ++e)
  {
    const Vec3 xi(0.1, 0.2, -0.7);
    EXPECT_NEAR(ValueAt(model, 0, e, xi)[0], -std::sin(Wave(1, PointAt(model, e, xi).z)), 2e-13);
  }
  ASSERT_EQ(model.notes.size(), 2U);
  EXPECT_NE(model.notes[1].find("fields are sines of z"), std::string::npos);
}

TEST(NektarHomogeneous, StripsWhereTheSessionPutsThem)
{
  const std::string session = Replaced(kPlane, "</GEOMETRY>",
    "</GEOMETRY><CONDITIONS><PARAMETERS><P> DistStrip = 2*5 </P></PARAMETERS></CONDITIONS>");
  const auto strip = [](int id, const std::string& block)
  {
    return Replaced(Replaced(block, "Exp1D", "Exp1D-Strips"), "HOMOGENEOUSZIDS",
      "HOMOGENEOUSSIDS=\"" + std::to_string(id) + "\" HOMOGENEOUSZIDS");
  };
  // 2 + cos(wave 1) in strip 0, 5 - sin(wave 1) in strip 3; what is between was not computed.
  const std::string blocks =
    strip(3, Block("Quadrilateral", 7, "0,2,3", 3, " 5 5 5 5 0 0 0 0 1 1 1 1 ")) +
    strip(0, Block("Quadrilateral", 7, "0,2,3", 3, " 2 2 2 2 1 1 1 1 0 0 0 0 ")) +
    strip(0, Block("Triangle", 9, "0,2,3", 3, " 2 2 2 1 1 1 0 0 0 ")) +
    strip(3, Block("Triangle", 9, "0,2,3", 3, " 5 5 5 0 0 0 1 1 1 "));
  const SolverModel model = ReadSession(session, MakeFieldFile(blocks));
  EXPECT_EQ(model.mesh.number, (std::vector<std::int64_t>{ 9, 7, 19, 17 }));
  EXPECT_EQ(model.mesh.boundary.size(), 4U);
  for (int e = 0; e < 4; ++e)
  {
    const double begin = e < 2 ? 0.0 : 30.0;
    for (const Vec3& xi : { Vec3(-0.6, 0.3, -0.7), Vec3(0.4, 0.8, -0.9) })
    {
      const double z = PointAt(model, e, xi).z;
      EXPECT_GE(z, begin);
      EXPECT_LE(z, begin + kLength);
      const double expected = e < 2 ? 2 + std::cos(Wave(1, z)) : 5 - std::sin(Wave(1, z - begin));
      EXPECT_NEAR(ValueAt(model, 0, e, xi)[0], expected, 6e-13);
    }
  }
  ASSERT_EQ(model.notes.size(), 2U);
  EXPECT_NE(model.notes[1].find("2 strips, from z = 0 to 33"), std::string::npos);
  ExpectRefusal(kPlane, MakeFieldFile(blocks), { "u.fld", "DistStrip", "session" });
  ExpectRefusal(session,
    MakeFieldFile(strip(3, Block("Quadrilateral", 7, "0", 1, " 5 5 5 5 ")) +
      strip(0, Block("Triangle", 9, "0", 1, " 2 2 2 "))),
    { "2 strips", "missing" });
  ExpectRefusal(session,
    MakeFieldFile(strip(3, Block("Quadrilateral", 7, "0", 1, " 5 5 5 5 ")) +
      strip(3, Block("Quadrilateral", 7, "0", 1, " 5 5 5 5 "))),
    { "element 7", "twice" });
  ExpectRefusal(session,
    MakeFieldFile(Replaced(
      strip(3, Block("Quadrilateral", 7, "0", 1, " 5 5 5 5 ")), "SIDS=\"3\"", "SIDS=\"3,4\"")),
    { "one strip" });
}

TEST(NektarHomogeneous, TwoDirectionsOverALine)
{
  const std::string line =
    "<NEKTAR><GEOMETRY DIM=\"1\" SPACE=\"1\"><VERTEX><V ID=\"0\">1 0 0</V><V ID=\"1\">2 0 0</V>"
    "<V ID=\"2\">4 0 0</V></VERTEX><ELEMENT><S ID=\"3\">0 1</S><S ID=\"5\">1 2</S></ELEMENT>"
    "<COMPOSITE><C ID=\"0\"> S[3,5] </C><C ID=\"1\"> V[0] </C><C ID=\"2\"> V[2] </C></COMPOSITE>"
    "</GEOMETRY><CONDITIONS><SOLVERINFO><I PROPERTY=\"HOMOGENEOUS\" VALUE=\"2D\"/></SOLVERINFO>"
    "</CONDITIONS></NEKTAR>";
  // Order 1 along x: x * (1 + 2 cos(wave 1 of y)) - sin(wave 1 of z) cos(wave 1 of y) / 2, for
  // waves of lengths 3 and 7.
  const auto coefficients = [](double a, double b)
  {
    const auto pair = [](double u, double v)
    { return std::to_string(u) + " " + std::to_string(v) + " "; };
    return pair(a, b) + pair(0, 0) + pair(2 * a, 2 * b) + pair(0, 0) + // function 0 of z
      pair(0, 0) + pair(0, 0) + pair(0, 0) + pair(0, 0) +              // function 1
      pair(0, 0) + pair(0, 0) + pair(0, 0) + pair(0, 0) +              // function 2
      pair(0, 0) + pair(0, 0) + pair(0.5, 0.5) + pair(0, 0);           // function 3
  };
  const std::string block =
    "<ELEMENTS FIELDS=\"u\" SHAPE=\"Segment-HomogenousExp2D\" BASIS=\"Modified_A,Fourier,Fourier\" "
    "HOMOGENEOUSLENGTHS=\"3,7\" HOMOGENEOUSYIDS=\"0,1,2,3,0,1,2,3,0,1,2,3,0,1,2,3\" "
    "HOMOGENEOUSZIDS=\"0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3\" NUMMODESPERDIR=\"UNIORDER:2,4,4\" "
    "ID=\"3,5\">" +
    coefficients(1, 2) + coefficients(2, 4) + "</ELEMENTS>";
  const auto exact = [](const Vec3& x)
  {
    const double y = std::cos(2 * std::numbers::pi * x.y / 3);
    return x.x * (1 + 2 * y) - std::sin(2 * std::numbers::pi * x.z / 7) * y / 2;
  };
  for (const std::string& text :
    { block, Replaced(Replaced(block, "HOMOGENEOUSYIDS", "A"), "HOMOGENEOUSZIDS", "B") })
  {
    const SolverModel model = ReadSession(line, MakeFieldFile(text));
    ASSERT_FALSE(model.mesh.slab.has_value());
    ASSERT_EQ(model.mesh.number.size(), 2U);
    EXPECT_EQ(model.mesh.boundary.size(), 2U);
    for (int e = 0; e < 2; ++e)
    {
      for (const Vec3& xi : { Vec3(-0.6, 0.3, -0.7), Vec3(0.2, -0.9, 0.1), Vec3(1, 0.8, -1) })
      {
        const Vec3 x = PointAt(model, e, xi);
        EXPECT_NEAR(x.x, e == 0 ? 1.5 + xi.x / 2 : 3 + xi.x, 1e-14);
        EXPECT_NEAR(x.y, 1.5 * (1 + xi.y), 1e-14);
        EXPECT_NEAR(x.z, 3.5 * (1 + xi.z), 1e-14);
        EXPECT_NEAR(ValueAt(model, 0, e, xi)[0], exact(x), 2e-12);
      }
    }
    ASSERT_EQ(model.notes.size(), 1U);
    EXPECT_NE(model.notes[0].find("lengths 3 x 7, 4 x 4 Fourier functions"), std::string::npos);
  }
  const auto refuse = [&line](const std::string& text, const std::vector<std::string>& parts)
  { ExpectRefusal(line, MakeFieldFile(text), parts); };
  refuse(Replaced(block, "0,1,2,3,0", "0,1,3,2,0"), { "YIDS", "fastest" });
  refuse(Replaced(block, "\"3,7\"", "\"3\""), { "two numbers" });
  refuse(Replaced(block, "Modified_A,Fourier", "Modified_A,Modified_A"), { "Exp2D" });
  refuse(Replaced(block, "Exp2D", "Exp1D"), { "Segment-HomogenousExp1D" });
  ExpectRefusal(kPlane, MakeFieldFile(block), { "segment 3", "do not belong together" });
  ExpectRefusal(Replaced(line, "<V ID=\"1\">2 0", "<V ID=\"1\">2 1"), MakeFieldFile(block),
    { "vertex 1", "along x" });
  ExpectRefusal(Replaced(line, "\"2D\"", "\"1D\""), MakeFieldFile(block), { "dimension 1" });
  ExpectRefusal(
    Replaced(line, "PROPERTY=\"HOM", "PROPERTY=\"OM"), MakeFieldFile(block), { "one-dimensional" });
}

TEST(NektarHomogeneous, RefusesWithReasons)
{
  const std::string four = " 1 1 1 1 ";
  const auto refuse = [](const std::string& blocks, const std::vector<std::string>& parts)
  { ExpectRefusal(kPlane, MakeFieldFile(blocks), parts); };
  const std::string block = Block("Quadrilateral", 7, "0", 1, four);
  refuse(Block("Quadrilateral", 7, "0", 1, four, "Legendre"),
    { "u.fld", "Legendre", "NekMesh -m extrude", "interpfield" });
  refuse(Block("Quadrilateral", 7, "1", 1, four, "FourierHalfModeIm"), { "one function", "0" });
  refuse(Block("Quadrilateral", 7, "1", 1, four, "FourierHalfModeRe"), { "one function", "0" });
  refuse(Replaced(block, "Exp1D", "Exp1D-Strips"), { "HOMOGENEOUSSIDS" });
  refuse(Replaced(block, "Exp1D", "Exp2D"), { "Exp2D" });
  refuse(Replaced(block, "Quadrilateral", "Segment"), { "Segment" });
  refuse(Replaced(block, "HOMOGENEOUSLENGTHS=\"3\"", "HOMOGENEOUSLENGTHS=\"0\""), { "above 0" });
  refuse(Replaced(block, "HOMOGENEOUSZIDS=\"0\"", "HOMOGENEOUSZIDS=\"0,0\""), { "twice" });
  refuse(Replaced(block, "HOMOGENEOUSZIDS=\"0\"", "HOMOGENEOUSZIDS=\"5000\""), { "1023" });
  refuse(Replaced(block, " 1 1 1 1 ", " 1 1 1 "), { "3 coefficients", "have 4" });
  refuse(
    block + Block("Triangle", 9, "2", 1, " 1 1 1 "), { "differ in their homogeneous functions" });
}
} // namespace pixelexact::testing
