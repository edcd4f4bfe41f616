// SPDX-License-Identifier: BSD-3-Clause
#include "NektarTexts.h"

namespace pixelexact::testing
{
TEST(NektarReader, StraightCube)
{
  const SolverModel model = ReadSession(Session(Cube()));
  const Vec3 x = PointAt(model, 0, { -0.5, 0.25, 1.0 });
  EXPECT_NEAR(x.x, 0.25, 1e-15);
  EXPECT_NEAR(x.y, 0.625, 1e-15);
  EXPECT_NEAR(x.z, 1.0, 1e-15);
  EXPECT_EQ(model.mesh.number.at(0), 5);
}

TEST(NektarReader, CurvedEdgeIsBlendedIntoTheCube)
{
  // Edge 0 (y = z = 0) is a parabola: y = -0.4 x (1 - x).
  const SolverModel model = ReadSession(Session(Cube(
    "<CURVED><E ID=\"0\" EDGEID=\"0\" NUMPOINTS=\"3\" TYPE=\"PolyEvenlySpaced\">0 0 0  0.5 -0.1 0 "
    "1 0 0</E></CURVED>")));
  const Vec3 xi(0.2, -0.4, 0.6);
  const Vec3 at = 0.5 * (xi + 1.0);
  const Vec3 x = PointAt(model, 0, xi);
  EXPECT_NEAR(x.x, at.x, 1e-15);
  EXPECT_NEAR(x.y, at.y - 0.4 * at.x * (1 - at.x) * (1 - at.y) * (1 - at.z), 1e-15);
  EXPECT_NEAR(x.z, at.z, 1e-15);
}

TEST(NektarReader, FieldPlainAndCompressed)
{
  // u = 1 + x + 2 y + 4 z by the vertex modes, p fastest.
  std::vector<double> values;
  std::string text;
  for (int k = 0; k < 8; ++k)
  {
    values.push_back(1.0 + (k & 1) + 2 * (k >> 1 & 1) + 4 * (k >> 2 & 1));
    text += std::to_string(values.back()) + " ";
  }
  const std::string order = "NUMMODESPERDIR=\"UNIORDER:2,2,2\" ID=\"5\" ";
  for (const std::string& field : { Field(kLinearHexahedron + order, text),
         Field(kLinearHexahedron + order + "COMPRESSED=\"B64Z-LittleEndian\" BITSIZE=\"64\"",
           Compressed(values)) })
  {
    const SolverModel model = ReadSession(Session(Cube()), field);
    EXPECT_NEAR(ValueAt(model, 0, 0, { 0.0, 0.5, -0.5 })[0], 1 + 0.5 + 1.5 + 1.0, 1e-14);
    EXPECT_EQ(model.time, 2.5);
    EXPECT_EQ(model.fields[0].name, "u");
  }
}

TEST(NektarReader, CompositesAreAttributesAndBoundary)
{
  const SolverModel model =
    ReadSession(Session(Cube("<COMPOSITE><C ID=\"3\" NAME=\"fluid\">H[5]</C><C ID=\"0\">F[2,4]</C>"
                             "</COMPOSITE>")));
  EXPECT_EQ(model.mesh.attribute.at(0), 3);
  EXPECT_EQ(model.mesh.groups.at(0).name, "fluid");
  ASSERT_EQ(model.mesh.boundary.size(), 2U);
  EXPECT_EQ(model.mesh.boundary[0].face, 1); // x = 1
  EXPECT_EQ(model.mesh.boundary[1].face, 0); // x = 0
}

TEST(NektarReader, DamagedSessions)
{
  const std::string good = Session(Cube());
  ExpectRefusal("", "", { "a.xml" });
  ExpectRefusal(good.substr(0, 400), "", { "a.xml", "cut short" });
  ExpectRefusal("<OTHER/>", "", { "NEKTAR" });
  ExpectRefusal("<NEKTAR><CONDITIONS/></NEKTAR>", "", { "GEOMETRY" });
  ExpectRefusal("<!DOCTYPE x [<!ENTITY a \"b\">]><NEKTAR>&a;</NEKTAR>", "", { "DOCTYPE" });
  ExpectRefusal("\x89HDF\r\n\x1a\n", "", { "a.xml", "HDF5" });
  ExpectRefusal("<NEKTAR><GEOMETRY DIM=\"1\" SPACE=\"1\"/></NEKTAR>", "", { "three-dimensional" });
  ExpectRefusal("<NEKTAR><GEOMETRY DIM=\"3\" SPACE=\"3\" HDF5FILE=\"a.nekg\"/></NEKTAR>", "",
    { "HDF5 file a.nekg", "not there" });
  const auto broken = [&](const std::string& from, const std::string& to)
  {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    return text;
  };
  ExpectRefusal(broken("0 1 2 3 4 5</H>", "0 1 2 3 4 9</H>"), "", { "element 5", "face 9" });
  ExpectRefusal(broken("<Q ID=\"5\">8 9 10 11", "<Q ID=\"5\">8 9 10 99"), "", { "edge 99" });
  ExpectRefusal(broken("<Q ID=\"5\">8 9 10 11", "<Q ID=\"5\">8 10 9 11"), "", { "do not meet" });
  ExpectRefusal(broken("0 1 2 3 4 5</H>", "0 2 1 3 4 5</H>"), "", { "element 5", "order" });
  ExpectRefusal(broken("<V ID=\"0\">0 0 0", "<V ID=\"0\">0 zero 0"), "", { "V ID=\"0\"", "zero" });
  ExpectRefusal(Session(Cube("<CURVED><E ID=\"0\" EDGEID=\"0\" NUMPOINTS=\"4\" "
                             "TYPE=\"PolyEvenlySpaced\">0 0 0 1 0 0</E></CURVED>")),
    "", { "4 points" });
  ExpectRefusal(Session(Cube("<CURVED><E ID=\"0\" EDGEID=\"0\" NUMPOINTS=\"2\" TYPE=\"Wavy\">0 0 0 "
                             "1 0 0</E></CURVED>")),
    "", { "edge 0", "Wavy" });
}

TEST(NektarReader, DamagedFields)
{
  const std::string session = Session(Cube());
  const auto field = [](
                       const std::string& attributes, const std::string& values = "1 2 3 4 5 6 7 8")
  { return Field(kLinearHexahedron + attributes, values); };
  ExpectRefusal(session, field("NUMMODESPERDIR=\"UNIORDER:2,2,2\" ID=\"5\"", "1 2 3"),
    { "u.fld", "3 coefficients", "8" });
  ExpectRefusal(session, field("NUMMODESPERDIR=\"UNIORDER:2,2,2\" ID=\"6\""),
    { "u.fld", "hexahedron 6", "do not belong together" });
  ExpectRefusal(session, field("NUMMODESPERDIR=\"UNIORDER:1000,2,2\" ID=\"5\""), { "'1000'" });
  ExpectRefusal(session, field("NUMMODESPERDIR=\"MIXORDER:2,2\" ID=\"5\""), { "2 numbers" });
  ExpectRefusal(
    session, field("NUMMODESPERDIR=\"UNIORDER:2,2,2\" ID=\"0-99999999999\""), { "list" });
  ExpectRefusal(session, "<NEKTAR/>", { "u.fld", "0 of the mesh's 1 elements" });
  ExpectRefusal(session,
    field(
      "NUMMODESPERDIR=\"UNIORDER:2,2,2\" ID=\"5\" COMPRESSED=\"B64Z-LittleEndian\" BITSIZE=\"64\"",
      "eJw!"),
    { "base64" });
  ExpectRefusal(session,
    field(
      "NUMMODESPERDIR=\"UNIORDER:2,2,2\" ID=\"5\" COMPRESSED=\"B64Z-LittleEndian\" BITSIZE=\"64\"",
      Compressed<double>({ 1, 2, 3, 4, 5, 6, 7, 8 }).substr(0, 20)),
    { "cut short" });
  ExpectRefusal(session,
    field(
      "NUMMODESPERDIR=\"UNIORDER:2,2,2\" ID=\"5\" COMPRESSED=\"B64Z-LittleEndian\" BITSIZE=\"64\"",
      Compressed(std::vector<double>(100000, 0.0))),
    { "expand" });
  ExpectRefusal(session,
    field("NUMMODESPERDIR=\"UNIORDER:2,2,2\" ID=\"5\" HOMOGENEOUSLENGTHS=\"1\""),
    { "homogeneous", "FieldConvert" });
  std::string other = field("NUMMODESPERDIR=\"UNIORDER:2,2,2\" ID=\"5\"");
  other.replace(other.find("Modified_A"), 10, "Fourier");
  ExpectRefusal(session, other, { "u.fld", "Fourier" });
}
} // namespace pixelexact::testing
