// SPDX-License-Identifier: BSD-3-Clause
// Two-dimensional sessions of Nektar++, by closed forms.
#include "NektarTexts.h"

#include <cmath>

namespace pixelexact::testing
{
namespace
{
/// [0, 2] x [0, 1]: the quadrilateral 7 on the left, the triangle 9 with vertices (1, 0), (2, 0),
/// (1, 1) to its right. Edge 3 of the quadrilateral, at y = 1, is the parabola y = 1 + x (1 - x).
std::string Plane(const std::string& z = "0", const std::string& more = "")
{
  return "<NEKTAR><GEOMETRY DIM=\"2\" SPACE=\"2\"><VERTEX>"
         "<V ID=\"0\">0 0 " +
    z + "</V><V ID=\"1\">1 0 " + z + "</V><V ID=\"2\">1 1 " + z + "</V><V ID=\"3\">0 1 " + z +
    "</V><V ID=\"4\">2 0 " + z +
    "</V></VERTEX><EDGE><E ID=\"0\">0 1</E><E ID=\"1\">1 2</E><E ID=\"2\">2 3</E>"
    "<E ID=\"3\">3 0</E><E ID=\"4\">1 4</E><E ID=\"5\">4 2</E></EDGE>"
    "<ELEMENT><Q ID=\"7\">0 1 2 3</Q><T ID=\"9\">4 5 1</T></ELEMENT>"
    "<CURVED><E ID=\"0\" EDGEID=\"2\" NUMPOINTS=\"3\" TYPE=\"PolyEvenlySpaced\">1 1 " +
    z + " 0.5 1.25 " + z + " 0 1 " + z +
    "</E></CURVED><COMPOSITE><C ID=\"0\" NAME=\"fluid\"> Q[7] </C><C ID=\"1\"> T[9] </C>"
    "<C ID=\"2\" NAME=\"wall\"> E[0,4] </C><C ID=\"3\"> E[1] </C></COMPOSITE>" +
    more + "</GEOMETRY></NEKTAR>";
}

/// Triangles come first, as 3-D shapes by their tags.
constexpr int kTriangle = 0;
constexpr int kQuadrilateral = 1;

std::string Blocks(const std::string& quadrilateral, const std::string& triangle)
{
  return "<NEKTAR><ELEMENTS FIELDS=\"u\" SHAPE=\"Quadrilateral\" ID=\"7\" " + quadrilateral +
    "</ELEMENTS><ELEMENTS FIELDS=\"u\" SHAPE=\"Triangle\" ID=\"9\" " + triangle +
    "</ELEMENTS></NEKTAR>";
}

} // namespace

TEST(NektarPlane, ElementsAreSolidsOfASlab)
{
  const SolverModel model = ReadSession(Plane());
  ASSERT_TRUE(model.mesh.slab.has_value());
  EXPECT_EQ(model.mesh.slab->middle, 0.0);
  EXPECT_EQ(model.mesh.number, (std::vector<std::int64_t>{ 9, 7 }));
  for (const Vec3& xi : kInside)
  {
    // x = s, y = t (1 + s (1 - s)): the curve is filled linearly towards the opposite edge.
    const double s = (1 + xi.x) / 2;
    const double t = (1 + xi.y) / 2;
    const Vec3 q = PointAt(model, kQuadrilateral, xi);
    EXPECT_NEAR(q.x, s, 1e-15);
    EXPECT_NEAR(q.y, t * (1 + s * (1 - s)), 1e-15);
    const Vec3 triangle = PointAt(model, kTriangle, xi);
    EXPECT_NEAR(triangle.x, 1 + s, 1e-15);
    EXPECT_NEAR(triangle.y, (1 + xi.z) / 2, 1e-15);
  }
}

TEST(NektarPlane, CompositesAreAttributesAndSides)
{
  const SolverModel model = ReadSession(Plane());
  EXPECT_EQ(model.mesh.attribute, (std::vector<std::int32_t>{ 1, 0 }));
  EXPECT_EQ(model.mesh.groups.at(2).name, "wall");
  EXPECT_TRUE(model.mesh.groups.at(2).boundary);
  const auto has = [&](int element, int face, int attribute)
  {
    return std::ranges::count_if(model.mesh.boundary,
      [&](const BoundaryFace& b)
      { return b.element == element && b.face == face && b.attribute == attribute; });
  };
  EXPECT_EQ(model.mesh.boundary.size(), 4U);
  EXPECT_EQ(has(kQuadrilateral, 2, 2), 1); // y = 0
  EXPECT_EQ(has(kTriangle, 2, 2), 1);
  EXPECT_EQ(has(kQuadrilateral, 1, 3), 1); // x = 1, from both sides
  EXPECT_EQ(has(kTriangle, 4, 3), 1);
}

/// Vertex modes: of the quadrilateral p fastest, of the triangle (0, 0), the top (0, 1), (1, 0).
TEST(NektarPlane, ModifiedBasis)
{
  const SolverModel model = ReadSession(Plane(),
    Blocks("BASIS=\"Modified_A,Modified_A\" NUMMODESPERDIR=\"UNIORDER:2,2\">1 2 4 8",
      "BASIS=\"Modified_A,Modified_B\" NUMMODESPERDIR=\"UNIORDER:2,2\">2 8 5"));
  EXPECT_EQ(model.fields.at(0).basis, "Modified_A x Modified_A");
  for (const Vec3& xi : kInside)
  {
    const double s = (1 + xi.x) / 2;
    const double t = (1 + xi.y) / 2;
    EXPECT_NEAR(ValueAt(model, 0, kQuadrilateral, xi)[0],
      (1 - s) * (1 - t) + 2 * s * (1 - t) + 4 * (1 - s) * t + 8 * s * t, 1e-14);
    EXPECT_NEAR(ValueAt(model, 0, kTriangle, xi)[0], 2 + 3 * s + 6 * (1 + xi.z) / 2, 1e-14);
  }
}

TEST(NektarPlane, OrdersPerDirectionAndOrthogonalBasis)
{
  // Three modes along xi1, two along xi2: P_2(xi1) xi2, scaled; the triangle's constant.
  const SolverModel model = ReadSession(Plane(),
    Blocks("BASIS=\"Ortho_A,Ortho_A\" NUMMODESPERDIR=\"MIXORDER:3,2\">0 0 0 0 0 1",
      "BASIS=\"Ortho_A,Ortho_B\" NUMMODESPERDIR=\"UNIORDER:2,3\">1 0 0 0 0"));
  const double xi = 0.3;
  EXPECT_NEAR(ValueAt(model, 0, kQuadrilateral, { xi, -0.4, 0.9 })[0],
    std::sqrt(2.5) * (3 * xi * xi - 1) / 2 * std::sqrt(1.5) * -0.4, 1e-14);
  EXPECT_NEAR(ValueAt(model, 0, kTriangle, kInside[0])[0], std::sqrt(0.5), 1e-15);
  const Space& space = model.fields[0].values.spaces[model.fields[0].values.spaceOf[kTriangle]];
  EXPECT_EQ(space.order, (std::array<std::uint8_t, 3>{ 1, 0, 2 }));
}

TEST(NektarPlane, PlanesInSpaceAndRefusals)
{
  EXPECT_EQ(ReadSession(Plane("0.5")).mesh.slab->middle, 0.5);
  EXPECT_EQ(ReadSession(Plane("1e-310")).mesh.slab->middle, 0.0);
  EXPECT_TRUE(ReadSession(Replaced(Plane(), "1 0 0</V>", "1 0 1</V>")).mesh.slab->inSpace);
  ExpectRefusal(Replaced(Plane(), "SPACE=\"2\"", "SPACE=\"1\""), "", { "two- and three-dim" });
  ExpectRefusal(Replaced(Plane(), "5 1</T>", "2 1</T>"), "", { "do not meet" });
  ExpectRefusal(Replaced(Plane(), "4 5 1</T>", "4 6 1</T>"), "", { "edge 6", "not there" });
  ExpectRefusal(Plane(),
    Field(kLinearHexahedron + "ID=\"7\" NUMMODESPERDIR=\"UNIORDER:2,2,2\"", "1 2 3 4 5 6 7 8"),
    { "hexahedron 7", "do not belong together" });
  ExpectRefusal(Session(Cube()),
    Field("SHAPE=\"Quadrilateral\" BASIS=\"Modified_A,Modified_A\" ID=\"5\" "
          "NUMMODESPERDIR=\"UNIORDER:2,2\"",
      "1 2 3 4"),
    { "quadrilateral 5", "do not belong together" });
  ExpectRefusal(Plane(),
    Blocks("BASIS=\"Modified_A\" NUMMODESPERDIR=\"UNIORDER:2,2\">1 2 4 8", ">"),
    { "two families" });
  ExpectRefusal(Plane(),
    Blocks("BASIS=\"Modified_A,Modified_A\" NUMMODESPERDIR=\"UNIORDER:2,2,2\">1 2 4 8", ">"),
    { "two directions" });
}
} // namespace pixelexact::testing
