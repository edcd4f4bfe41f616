// SPDX-License-Identifier: BSD-3-Clause
#include "NektarTexts.h"

#include "Formats/Nektar/Expression.h"

#include <cmath>
#include <numbers>

namespace pixelexact::testing
{
namespace
{
constexpr double kPi = std::numbers::pi;

/// The unit cube whose list of vertices has these attributes.
std::string Placed(const std::string& attributes, const std::string& more = "")
{
  return Replaced(Cube(more), "<VERTEX>", "<VERTEX " + attributes + ">");
}

Vec3 Corner(const SolverModel& model)
{
  return PointAt(model, 0, { 1.0, 1.0, 1.0 });
}

/// Cubes of unit size one above the other, from z = first to z = last, numbered from 500 on, with
/// the numbers that all cubes of the stack would have.
std::string Stack(int first, int last, const std::string& more = "")
{
  std::string vertices;
  std::string edges;
  std::string faces;
  std::string solids;
  const auto entity = [](const char* tag, int id, const std::vector<int>& parts)
  {
    std::string text = std::string("<") + tag + " ID=\"" + std::to_string(id) + "\">";
    for (const int part : parts)
    {
      text += std::to_string(part) + " ";
    }
    return text + "</" + tag + ">";
  };
  for (int z = first; z <= last; ++z)
  {
    for (int k = 0; k < 4; ++k)
    {
      vertices += entity("V", 4 * z + k, { k == 1 || k == 2 ? 1 : 0, k / 2, z });
      edges += entity("E", 100 + 4 * z + k, { 4 * z + k, 4 * z + (k + 1) % 4 });
    }
    faces += entity("Q", 300 + z, { 100 + 4 * z, 101 + 4 * z, 102 + 4 * z, 103 + 4 * z });
    for (int k = 0; k < 4 && z < last; ++k)
    {
      edges += entity("E", 200 + 4 * z + k, { 4 * z + k, 4 * (z + 1) + k });
      faces += entity("Q", 400 + 4 * z + k,
        { 100 + 4 * z + k, 200 + 4 * z + (k + 1) % 4, 104 + 4 * z + k, 200 + 4 * z + k });
    }
  }
  for (int z = first; z < last; ++z)
  {
    const int side = 400 + 4 * z;
    solids += entity("H", 500 + z, { 300 + z, side, side + 1, side + 2, side + 3, 301 + z });
  }
  return Session("<VERTEX>" + vertices + "</VERTEX><EDGE>" + edges + "</EDGE><FACE>" + faces +
    "</FACE><ELEMENT>" + solids + "</ELEMENT>" + more);
}

void ExpectRefusal(const std::vector<NamedText>& sessions, const std::vector<std::string>& parts)
{
  try
  {
    nektar::Read(sessions, {});
    ADD_FAILURE() << "was read";
  }
  catch (const Error& error)
  {
    for (const auto& part : parts)
    {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos)
        << "'" << part << "' in: " << error.what();
    }
  }
}
} // namespace

TEST(NektarGeometry, ScalesAreExpressions)
{
  const SolverModel model =
    ReadTexts(Session(Placed("XSCALE=\"2*PI\" YSCALE=\"1/(2*PI)\" ZSCALE=\" 1e-1 \" XMOVE=\"-2^2\" "
                             "ZMOVE=\"sqrt(2)\"")));
  const Vec3 corner = Corner(model);
  EXPECT_NEAR(corner.x, 2 * kPi - 4, 1e-15 * 8);
  EXPECT_NEAR(corner.y, 1 / (2 * kPi), 1e-16);
  EXPECT_NEAR(corner.z, 0.1 + std::sqrt(2.0), 1e-15);
}

TEST(NektarGeometry, ExpressionsUseTheSessionsParameters)
{
  const std::string conditions =
    "<NEKTAR><CONDITIONS><PARAMETERS><P> Half = 1.5 </P><!-- between --><P>Lx = 2*Half*PI</P>"
    "<P> Re = awgn(1) </P></PARAMETERS></CONDITIONS></NEKTAR>";
  const std::string mesh = Session(Placed("XSCALE=\"Lx\""));
  const SolverModel model = nektar::Read({ { "mesh.xml", mesh }, { "run.xml", conditions } }, {});
  EXPECT_NEAR(Corner(model).x, 3 * kPi, 2e-15);
  ExpectRefusal({ { "mesh.xml", mesh } }, { "mesh.xml", "XSCALE", "'Lx'" });
  ExpectRefusal({ { "mesh.xml", Session(Placed("XSCALE=\"Re\"")) }, { "run.xml", conditions } },
    { "XSCALE", "'Re'" });
}

TEST(NektarGeometry, ExpressionsFollowNektarsRules)
{
  const auto value = [](std::string_view text)
  { return nektar::Evaluate(text, [](std::string_view) { return std::nullopt; }); };
  // By hand, from the grammar of Nektar++'s interpreter; the first three are its own tests.
  EXPECT_EQ(value("-2"), -2);
  EXPECT_EQ(value("5*(-(2^2)^4)"), -1280);
  EXPECT_EQ(value("2^2^4"), 65536);
  EXPECT_EQ(value("-2^2"), -4);
  EXPECT_EQ(value("3*-2^2"), 12);
  EXPECT_EQ(value("2^-2^2"), 16);
  EXPECT_EQ(value("1--2"), 3);
  EXPECT_EQ(value("8-4-2"), 2);
  EXPECT_EQ(value("8/4/2"), 1);
  EXPECT_EQ(value("-7 % 4 * 2"), -6);
  EXPECT_EQ(value("1 + 2 <= 3"), 1);
  EXPECT_EQ(value("(2 > 3) == 0"), 1);
  EXPECT_EQ(value("+2 + .5 + 5. + 1E1"), 17.5);
  EXPECT_EQ(value("max(1, min(7, 3)) + abs(-2) + sign(-5)"), 4);
  EXPECT_NEAR(value("ang(0, 2) + atan2(1, 0)"), kPi, 1e-15);
  EXPECT_NEAR(value("rad(3, 4) + fmod(5.2, 3.2)"), 7, 1e-15);
  EXPECT_NEAR(value("PI_2 * E ^ 2 / SQRT1_2"), kPi / 2 * std::exp(2.0) * std::sqrt(2.0), 1e-13);
}

TEST(NektarGeometry, ExpressionsThatAreNoneAreRefused)
{
  const auto refuse = [](const std::string& text, const std::string& part)
  {
    const std::string escaped = text == "1<" ? "1&lt;" : text;
    ExpectRefusal(
      { { "a.xml", Session(Placed("YMOVE=\"" + escaped + "\"")) } }, { "a.xml", "YMOVE", part });
  };
  for (const char* text : { "", "1 2", "2PI", "1e", "2*-PI", "+PI", "(1", "1)", "1<", "1,2", "()",
         "sin()", "sin(1", "1 && 1", "0x10", "1;2", "nan" })
  {
    refuse(text, "no expression");
  }
  refuse("twice(1)", "'twice' of 1 argument");
  refuse("atan2(1)", "'atan2' of 1 argument");
  refuse("awgn(1)", "awgn");
  refuse("x", "'x'");
  refuse("1/0", "not finite");
  refuse("1e999", "range");
  refuse(std::string(300, '1'), "256");
  refuse(std::string(100, '(') + "1" + std::string(100, ')'), "32");
}

TEST(NektarGeometry, CurvesAreScaledMovedAndTurnedWithTheVertices)
{
  const std::string edge = "<E ID=\"0\" EDGEID=\"0\" NUMPOINTS=\"3\" TYPE=\"PolyEvenlySpaced\">"
                           "0 0 0  0.5 -0.1 0  1 0 0</E>";
  // The top bulges: z = 1 + 0.1 at its centre.
  const std::string face =
    "<F ID=\"1\" FACEID=\"5\" NUMPOINTS=\"9\" TYPE=\"GaussLobattoLegendre\">0 0 1 .5 0 1 1 0 1 "
    "0 .5 1 .5 .5 1.1 1 .5 1 0 1 1 .5 1 1 1 1 1</F>";
  using Record = std::array<std::int64_t, 6>;
  struct PointRecord
  {
    std::int64_t id;
    double x[3];
  };
  std::vector<PointRecord> points{ { 0, { 0, 0, 0 } }, { 1, { .5, -.1, 0 } }, { 2, { 1, 0, 0 } } };
  for (int k = 0; k < 9; ++k)
  {
    points.push_back({ 3 + k, { k % 3 / 2.0, k / 3 / 2.0, k == 4 ? 1.1 : 1.0 } });
  }
  std::vector<std::int64_t> index(points.size());
  for (std::size_t k = 0; k < index.size(); ++k)
  {
    index[k] = static_cast<std::int64_t>(k);
  }
  const std::string packed = "<CURVED COMPRESSED=\"B64Z-LittleEndian\" BITSIZE=\"64\"><E>" +
    Compressed(std::vector<Record>{ { 0, 0, 3, 0, 0, 17 } }) + "</E><F>" +
    Compressed(std::vector<Record>{ { 1, 5, 9, 0, 3, 4 } }) + "</F><DATAPOINTS ID=\"0\"><INDEX>" +
    Compressed(index) + "</INDEX><POINTS>" + Compressed(points) + "</POINTS></DATAPOINTS></CURVED>";
  const std::string place = "XSCALE=\"2\" YSCALE=\"3\" ZSCALE=\"5\" XMOVE=\"10\" YMOVE=\"20\" "
                            "ZMOVE=\"30\"";
  for (const std::string& curved : { "<CURVED>" + edge + face + "</CURVED>", packed })
  {
    const SolverModel plain = ReadTexts(Session(Cube(curved)));
    const SolverModel placed = ReadTexts(Session(Placed(place, curved)));
    const SolverModel turned = ReadTexts(Session(Placed(place + " ZROT=\"PI/2\"", curved)));
    for (const Vec3& xi : { Vec3(0.2, -0.4, 0.6), Vec3(0, -1, -1), Vec3(0, 0, 1) })
    {
      const Vec3 x = PointAt(plain, 0, xi);
      const Vec3 expected(2 * x.x + 10, 3 * x.y + 20, 5 * x.z + 30);
      const Vec3 y = PointAt(placed, 0, xi);
      const Vec3 z = PointAt(turned, 0, xi);
      for (int d = 0; d < 3; ++d)
      {
        EXPECT_NEAR(y[d], expected[d], 1e-14);
      }
      EXPECT_NEAR(z.x, -expected.y, 1e-14);
      EXPECT_NEAR(z.y, expected.x, 1e-14);
      EXPECT_NEAR(z.z, expected.z, 1e-14);
    }
    EXPECT_NEAR(PointAt(placed, 0, { 0, -1, -1 }).y, 20 - 0.3, 1e-14);
    EXPECT_NEAR(PointAt(placed, 0, { 0, 0, 1 }).z, 30 + 5.5, 1e-14);
  }
}

TEST(NektarGeometry, PartsOfAMeshAreReadTogether)
{
  const std::string groups =
    "<COMPOSITE><C ID=\"1\" NAME=\"fluid\">H[500-501]</C><C ID=\"2\">F[300,302]</C></COMPOSITE>";
  const auto part = [](int z)
  {
    return "<COMPOSITE><C ID=\"1\" NAME=\"fluid\">H[" + std::to_string(500 + z) +
      "]</C><C ID=\"2\">F[" + std::to_string(300 + 2 * z) + "]</C></COMPOSITE>";
  };
  const std::string lower = Stack(0, 1, part(0));
  const std::string upper = Stack(1, 2, part(1));
  const SolverModel whole = ReadTexts(Stack(0, 2, groups));
  const auto attribute = [](int id)
  {
    return kLinearHexahedron + "NUMMODESPERDIR=\"UNIORDER:2,2,2\" ID=\"" + std::to_string(id) +
      "\"";
  };
  const std::string first = Field(attribute(500), "1 2 3 4 5 6 7 8");
  const std::string second = Field(attribute(501), "11 12 13 14 15 16 17 18");
  const SolverModel parts = nektar::Read({ { "P0000000.xml", lower }, { "P0000001.xml", upper } },
    { { "P0000000.fld", first }, { "P0000001.fld", second } });
  ASSERT_EQ(parts.mesh.number, (std::vector<std::int64_t>{ 500, 501 }));
  for (int e = 0; e < 2; ++e)
  {
    EXPECT_EQ(parts.mesh.corners[e], whole.mesh.corners[e]);
    EXPECT_EQ(parts.mesh.attribute[e], 1);
    EXPECT_EQ(PointAt(parts, e, { 0, 0, 1 }).z, e + 1);
  }
  ASSERT_EQ(parts.mesh.groups.size(), 2U);
  EXPECT_EQ(parts.mesh.groups[0].name, "fluid");
  ASSERT_EQ(parts.mesh.boundary.size(), 2U);
  EXPECT_EQ(parts.mesh.boundary[1].element, 1);
  EXPECT_NEAR(ValueAt(parts, 0, 1, { -1, -1, -1 })[0], 11, 1e-14);
  // Parts may overlap.
  EXPECT_EQ(
    nektar::Read({ { "a.xml", Stack(0, 2) }, { "b.xml", upper } }, {}).mesh.number.size(), 2U);
}

TEST(NektarGeometry, MeshesThatDoNotFitAreRefused)
{
  const std::string lower = Stack(0, 1);
  const std::string upper = Stack(1, 2);
  ExpectRefusal({ { "a.xml", lower }, { "b.xml", Replaced(upper, ">0 0 1 <", ">0 0 1.5 <") } },
    { "b.xml", "vertex 4", "one mesh" });
  ExpectRefusal(
    { { "a.xml", lower }, { "b.xml", Session(Placed("XMOVE=\"1\"")) } }, { "b.xml", "vertex" });
  ExpectRefusal({ { "a.xml", upper }, { "b.xml", Replaced(upper, ">4 5 <", ">5 4 <") } },
    { "b.xml", "edge 104" });
  ExpectRefusal(
    { { "a.xml", Stack(0, 1, "<COMPOSITE><C ID=\"0\" NAME=\"a\">H[500]</C></COMPOSITE>") },
      { "b.xml", Stack(1, 2, "<COMPOSITE><C ID=\"0\" NAME=\"b\">H[501]</C></COMPOSITE>") } },
    { "b.xml", "composite" });
  const auto curve = [](const char* middle)
  {
    return std::string("<CURVED><E ID=\"0\" EDGEID=\"104\" NUMPOINTS=\"3\" "
                       "TYPE=\"PolyEvenlySpaced\">0 0 1 0.5 ") +
      middle + " 1 1 0 1</E></CURVED>";
  };
  ExpectRefusal({ { "a.xml", Stack(0, 1, curve("0.1")) }, { "b.xml", Stack(1, 2, curve("0")) } },
    { "b.xml", "edge 104", "twice" });
  EXPECT_NO_THROW(nektar::Read(
    { { "a.xml", Stack(0, 1, curve("0.1")) }, { "b.xml", Stack(1, 2, curve("0.1")) } }, {}));
  // Twice within a file: neither is dropped.
  ExpectRefusal({ { "a.xml", Replaced(lower, "</VERTEX>", "</VERTEX><VERTEX/>") } }, { "VERTEX" });
  ExpectRefusal(
    { { "a.xml", Replaced(lower, "</GEOMETRY>", "</GEOMETRY><GEOMETRY/>") } }, { "GEOMETRY" });
  ExpectRefusal({ { "a.xml", lower + upper.substr(upper.find("<NEKTAR>")) } }, { "NEKTAR" });
}

TEST(NektarGeometry, NumbersAreReadWholeOrRefused)
{
  const std::string good = Session(Cube());
  const auto refuse = [&](const std::string& from, const std::string& to, const std::string& part) {
    ExpectRefusal({ { "a.xml", Replaced(good, from, to) } }, { "a.xml", part });
  };
  refuse("DIM=\"3\"", "DIM=\"3D\"", "DIM");
  refuse("SPACE=\"3\"", "SPACE=\"3.5\"", "SPACE");
  refuse("<V ID=\"0\">0 0 0", "<V ID=\"0\">0 0-0", "V ID=\"0\"");
  refuse("<V ID=\"0\">0 0 0", "<V ID=\"0\">0 0.0.0", "V ID=\"0\"");
  refuse("<V ID=\"0\">0 0 0", "<V ID=\"0\">0 +-0 0", "V ID=\"0\"");
  refuse("<E ID=\"0\">0 1", "<E ID=\"0\">0-1", "whole numbers");
  refuse("<E ID=\"0\">0 1", "<E ID=\"0x0\">0 1", "0x0");
  const auto composite = [&](const std::string& text)
  {
    ExpectRefusal(
      { { "a.xml", Session(Cube("<COMPOSITE>" + text + "</COMPOSITE>")) } }, { "a.xml", "<C ID" });
  };
  composite("<C ID=\"0\">H[5,]</C>");
  composite("<C ID=\"0\">H[5;6]</C>");
  composite("<C ID=\"9999999999\">H[5]</C>");
  refuse("<V ID=\"0\">0 0 0", "<V ID=\"0\">0 nan 0", "element 5");
  // Comments stand anywhere.
  const SolverModel model =
    ReadTexts(Replaced(good, "<V ID=\"6\">1 1 1", "<V ID=\"6\">1 <!-- x -- y --> 1<!-- z -->1"));
  EXPECT_EQ(Corner(model).y, 1);
}

TEST(NektarGeometry, HomogeneousSessionsAndHdf5NameWhatToDo)
{
  const std::string flat = "<NEKTAR><GEOMETRY DIM=\"2\" SPACE=\"2\"/></NEKTAR>";
  const std::string conditions = "<NEKTAR><CONDITIONS><SOLVERINFO><I PROPERTY=\"Homogeneous\" "
                                 "VALUE=\"1D\"/></SOLVERINFO></CONDITIONS></NEKTAR>";
  ExpectRefusal({ { "a.xml", flat }, { "b.xml", conditions } },
    { "a.xml", "homogeneous", "1D", "NekMesh -m extrude", "interpfield" });
  ExpectRefusal(
    { { "a.xml",
      Replaced(conditions, "<CONDITIONS>", "<GEOMETRY DIM=\"2\" SPACE=\"2\"/><CONDITIONS>") } },
    { "NekMesh -m extrude" });
  ExpectRefusal({ { "a.xml", flat } }, { "three-dimensional" });
  ExpectRefusal(
    { { "case/a.xml", "<NEKTAR><GEOMETRY DIM=\"3\" SPACE=\"3\" HDF5FILE=\"a.nekg\"/></NEKTAR>" } },
    { "HDF5", "NekMesh a.xml new.xml" });
  ExpectRefusal({ { "a.nekg", "\x89HDF\r\n\x1a\n" } }, { "HDF5", "out.fld:fld:format=Xml" });
  testing::ExpectRefusal(Session(Cube()),
    "<NEKTAR><ELEMENTS FIELDS=\"u\" SHAPE=\"Quadrilateral-HomogenousExp1D\"/></NEKTAR>",
    { "u.fld", "homogeneous", "interpfield" });
}
} // namespace pixelexact::testing
