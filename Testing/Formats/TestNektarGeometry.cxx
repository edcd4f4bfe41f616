// SPDX-License-Identifier: BSD-3-Clause
#include "NektarTexts.h"

namespace pixelexact::testing
{
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
    const int column = k % 3;
    const int row = k / 3;
    points.push_back({ 3 + k, { 0.5 * column, 0.5 * row, k == 4 ? 1.1 : 1.0 } });
  }
  std::vector<std::int64_t> index(points.size());
  for (std::size_t k = 0; k < index.size(); ++k)
  {
    index[k] = static_cast<std::int64_t>(k);
  }
  std::string packed = "<CURVED COMPRESSED=\"B64Z-LittleEndian\" BITSIZE=\"64\"><E>";
  packed += Compressed(std::vector<Record>{ { 0, 0, 3, 0, 0, 17 } }) + "</E><F>";
  packed += Compressed(std::vector<Record>{ { 1, 5, 9, 0, 3, 4 } }) + "</F>";
  packed += "<DATAPOINTS ID=\"0\"><INDEX>" + Compressed(index) + "</INDEX>";
  packed += "<POINTS>" + Compressed(points) + "</POINTS></DATAPOINTS></CURVED>";
  const std::string place = "XSCALE=\"2\" YSCALE=\"3\" ZSCALE=\"5\" XMOVE=\"10\" YMOVE=\"20\" "
                            "ZMOVE=\"30\"";
  const std::string unpacked = "<CURVED>" + edge + face + "</CURVED>";
  for (const std::string& curved : { unpacked, packed })
  {
    const SolverModel plain = ReadSession(Session(Cube(curved)));
    const SolverModel placed = ReadSession(Session(Placed(place, curved)));
    const bool moved =
      !placed.notes.empty() && placed.notes[0].find("Nektar++ itself leaves") != std::string::npos;
    EXPECT_EQ(moved, curved == unpacked);
    EXPECT_TRUE(plain.notes.empty());
    const SolverModel turned = ReadSession(Session(Placed(place + " ZROT=\"PI/2\"", curved)));
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
  // Comments may be anywhere.
  const SolverModel model =
    ReadSession(Replaced(good, "<V ID=\"6\">1 1 1", "<V ID=\"6\">1 <!-- x -- y --> 1<!-- z -->1"));
  EXPECT_EQ(Corner(model).y, 1);
}

TEST(NektarGeometry, HomogeneousSessionsAndHdf5NameWhatToDo)
{
  const std::string flat = "<NEKTAR><GEOMETRY DIM=\"2\" SPACE=\"2\"/></NEKTAR>";
  const std::string conditions = "<NEKTAR><CONDITIONS><SOLVERINFO><I PROPERTY=\"Homogeneous\" "
                                 "VALUE=\"1D\"/></SOLVERINFO></CONDITIONS></NEKTAR>";
  ExpectRefusal({ { "a.xml", flat }, { "b.xml", Replaced(conditions, "1D", "2D") } },
    { "a.xml", "HOMOGENEOUS (2D)", "NekMesh -m extrude", "interpfield" });
  ExpectRefusal({ { "a.xml", flat } }, { "a.xml", "no triangles" });
  ExpectRefusal({ { "a.xml", "<NEKTAR><GEOMETRY DIM=\"1\" SPACE=\"2\"/></NEKTAR>" } },
    { "two- and three-dimensional" });
  ExpectRefusal(
    { { "case/a.xml", "<NEKTAR><GEOMETRY DIM=\"3\" SPACE=\"3\" HDF5FILE=\"a.nekg\"/></NEKTAR>" } },
    { "HDF5 file a.nekg", "not there" });
  ExpectRefusal({ { "a.nekg", "\x89HDF\r\n\x1a\n" } }, { "a.nekg", "HDF5" });
  ExpectRefusal(Session(Cube()),
    "<NEKTAR><ELEMENTS FIELDS=\"u\" SHAPE=\"Quadrilateral-HomogenousExp1D\"/></NEKTAR>",
    { "u.fld", "homogeneous", "Fourier", "interpfield" });
}
} // namespace pixelexact::testing
