// SPDX-License-Identifier: BSD-3-Clause
// Plane meshes of MFEM, by closed forms: fields that are polynomials in x and y.
#include "MfemTexts.h"

#include "Formats/MFEM/Elements/Collection.h"
#include "Formats/MFEM/Meshes/RefinementTree.h"
#include "Formats/MFEM/Reader.h"

#include <gtest/gtest.h>

#include <set>

namespace pixelexact::testing
{
namespace
{
using mfem::Collection;
using mfem::Geometry;
using namespace mfemtexts;

/// A rectangle [0, 2] x [0, 1] of a quadrilateral and two triangles, right of x = 1.
std::string Mixed(const std::string& vertices = "2\n0 0\n1 0\n1 1\n0 1\n2 0\n2 1\n")
{
  return "MFEM mesh v1.0\ndimension\n2\nelements\n3\n1 3 0 1 2 3\n2 2 1 4 2\n3 2 4 5 2\n"
         "boundary\n4\n7 1 3 0\n8 1 4 5\n9 1 1 2\n6 1 3 1\nvertices\n6\n" +
    vertices;
}

std::string MakeFieldText(
  const std::string& collection, int vdim, const std::vector<double>& values)
{
  std::string text = "FiniteElementSpace\nFiniteElementCollection: " + collection +
    "\nVDim: " + std::to_string(vdim) + "\nOrdering: 1\n\n";
  for (const double value : values)
  {
    text += std::to_string(value) + "\n";
  }
  return text;
}

/// A vector that is constant in space.
constexpr double kConstant[2] = { 2.0, -3.0 };
} // namespace

TEST(MfemPlane, ElementsAreSolidsOfASlab)
{
  const SolverModel model = ReadTexts(Mixed());
  ASSERT_TRUE(model.mesh.slab.has_value());
  EXPECT_EQ(model.mesh.slab->middle, 0.0);
  EXPECT_EQ(model.mesh.slab->thickness, 1.0 / 32); // the shorter side is 1
  const Mesh mesh = ViewOf(model.mesh);
  EXPECT_EQ(mesh.ShapeOf(0), Shape::Hexahedron);
  EXPECT_EQ(mesh.ShapeOf(1), Shape::Prism);
  const Vec3 q = PointAt(model, 0, { -0.5, 0.5, 0.0 });
  EXPECT_EQ(q, Vec3(0.25, 0.75, 0.0));
  EXPECT_EQ(PointAt(model, 0, { 0, 0, 1 }).z, 1.0 / 64);
  const Vec3 t = PointAt(model, 1, { 0.0, 0.0, -0.5 });
  EXPECT_EQ(t, Vec3(1.5, 0.25, 0.0));
  EXPECT_EQ(PointAt(model, 1, { 0, 1, -0.5 }).z, -1.0 / 64);
  EXPECT_EQ(model.mesh.attribute, (std::vector<std::int32_t>{ 1, 2, 3 }));
}

TEST(MfemPlane, BoundarySegmentsAreSides)
{
  const SolverModel model = ReadTexts(Mixed());
  // x = 0 of the quadrilateral, the second triangle's first edge, x = 1 from both sides.
  ASSERT_EQ(model.mesh.boundary.size(), 4U);
  const auto& b = model.mesh.boundary;
  EXPECT_EQ(std::tuple(b[0].element, b[0].face, b[0].attribute), std::tuple(0, 0, 7));
  EXPECT_EQ(std::tuple(b[1].element, b[1].face, b[1].attribute), std::tuple(2, 2, 8));
  EXPECT_EQ(std::tuple(b[2].element, b[2].face, b[2].attribute), std::tuple(0, 1, 9));
  EXPECT_EQ(std::tuple(b[3].element, b[3].face, b[3].attribute), std::tuple(1, 4, 9));
  ASSERT_EQ(model.notes.size(), 1U); // a diagonal
  ExpectMessage(model.notes[0], { "1 of 4 boundary elements" });
}

/// Unknowns of all entities, in MFEM's numbering: 6 vertices; edges 01 12 23 30, 14 42, 45 52; the
/// insides.
TEST(MfemPlane, QuadraticFieldsAreReproduced)
{
  const auto f = [](double x, double y) { return 1 + 2 * x - y + x * y + 3 * x * x - 2 * y * y; };
  const std::vector<double> values{ f(0, 0), f(1, 0), f(1, 1), f(0, 1), f(2, 0), f(2, 1), f(0.5, 0),
    f(1, 0.5), f(0.5, 1), f(0, 0.5), f(1.5, 0), f(1.5, 0.5), f(2, 0.5), f(1.5, 1), f(0.5, 0.5) };
  const SolverModel model = ReadTexts(
    Mixed(), { MakeFieldText("H1_2D_P2", 1, values), MakeFieldText("Quadratic", 1, values) });
  for (std::size_t field = 0; field < 2; ++field)
  {
    for (int e = 0; e < 3; ++e)
    {
      for (const Vec3& xi : kInside)
      {
        const Vec3 x = PointAt(model, e, xi);
        EXPECT_NEAR(ValueAt(model, field, e, xi)[0], f(x.x, x.y), 4e-15) << e;
      }
    }
  }
  EXPECT_TRUE(model.fields[0].continuous);
}

/// Unknowns of vector spaces are tangential or normal components of a constant, by edges as in the
/// test above. Directions are those of the first element that contains an edge, from lower to
/// higher vertex number.
TEST(MfemPlane, ConstantVectorsOfLowestOrder)
{
  const double points[6][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 2, 0 }, { 2, 1 } };
  const int edges[8][2] = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 0, 3 }, { 1, 4 }, { 2, 4 }, { 4, 5 },
    { 2, 5 } };
  std::vector<double> tangential;
  std::vector<double> normal;
  for (const auto& [a, b] : edges)
  {
    const double tx = points[b][0] - points[a][0];
    const double ty = points[b][1] - points[a][1];
    tangential.push_back(kConstant[0] * tx + kConstant[1] * ty);
    normal.push_back(kConstant[0] * ty - kConstant[1] * tx);
  }
  const SolverModel model = ReadTexts(Mixed(),
    { MakeFieldText("ND_2D_P1", 1, tangential), MakeFieldText("RT_2D_P0", 1, normal),
      MakeFieldText("RT0_2D", 1, normal) });
  for (std::size_t field = 0; field < model.fields.size(); ++field)
  {
    for (int e = 0; e < 3; ++e)
    {
      const auto value = ValueAt(model, field, e, kInside[0]);
      EXPECT_NEAR(value[0], kConstant[0], 1e-14) << field << " " << e;
      EXPECT_NEAR(value[1], kConstant[1], 1e-14) << field << " " << e;
      EXPECT_EQ(value[2], 0.0);
    }
  }
}

/// Densities: one per area of each element, 1 in the unit square and 1/2 in the triangles.
TEST(MfemPlane, DensitiesArePerArea)
{
  const SolverModel model =
    ReadTexts(Mixed(), { MakeFieldText("L2Int_2D_P0", 1, { 1.0, 1.0, 1.0 }) });
  EXPECT_NEAR(ValueAt(model, 0, 0, kInside[0])[0], 1.0, 1e-15);
  EXPECT_NEAR(ValueAt(model, 0, 1, kInside[0])[0], 1.0, 1e-15); // det J of MFEM's map is 1
  const SolverModel twice = ReadTexts(Mixed("2\n0 0\n2 0\n2 2\n0 2\n4 0\n4 2\n"),
    { MakeFieldText("L2Int_2D_P0", 1, { 1.0, 1.0, 1.0 }) });
  EXPECT_NEAR(ValueAt(twice, 0, 0, kInside[0])[0], 0.25, 1e-15);
  EXPECT_NEAR(ValueAt(twice, 0, 2, kInside[0])[0], 0.25, 1e-15);
}

/// All functions of a nodal or Bernstein basis sum to one, and a basis has the number of unknowns
/// of its entities.
TEST(MfemPlane, BasesOfAllOrders)
{
  for (const std::string kind : { "H1_2D_P", "H1Pos_2D_P", "H1@U_2D_P", "L2_2D_P", "L2_T2_2D_P" })
  {
    for (int p = 1; p <= 8; ++p)
    {
      const Collection collection = Collection::Parse(kind + std::to_string(p), 2);
      for (const Geometry g : { Geometry::Triangle, Geometry::Square })
      {
        const auto& basis = collection.Basis(g);
        const int corners = g == Geometry::Triangle ? 3 : 4;
        EXPECT_EQ(basis.sources,
          corners *
              (collection.Unknowns(Geometry::Point) + collection.Unknowns(Geometry::Segment)) +
            collection.Unknowns(g));
        std::vector<double> modes(basis.GetSpace().Modes());
        basis.parts[0].Apply(std::vector<double>(basis.sources, 1.0), 0.0, modes);
        EXPECT_NEAR(modes[0], 1.0, 1e-12);
        modes[0] = 0.0;
        for (const double mode : modes)
        {
          EXPECT_NEAR(mode, 0.0, 1e-12);
        }
      }
    }
  }
  for (const std::string kind : { "ND_2D_P", "RT_2D_P" })
  {
    for (int p = 1; p <= 5; ++p)
    {
      const Collection collection = Collection::Parse(kind + std::to_string(p), 2);
      for (const Geometry g : { Geometry::Triangle, Geometry::Square })
      {
        const int corners = g == Geometry::Triangle ? 3 : 4;
        EXPECT_EQ(collection.Basis(g).sources,
          corners * collection.Unknowns(Geometry::Segment) + collection.Unknowns(g));
      }
    }
  }
}

TEST(MfemPlane, HilbertCurvesVisitNeighbours)
{
  std::set<std::array<int, 4>> curves;
  for (int state = 0; state < 8; ++state)
  {
    const auto curve = mfem::PlaneHilbertCurve(state);
    EXPECT_EQ(std::set<int>(curve.child.begin(), curve.child.end()).size(), 4U);
    curves.insert(curve.child);
    for (int i = 0; i < 4; ++i)
    {
      ASSERT_TRUE(curve.state[i] >= 0 && curve.state[i] < 8);
      if (i < 3)
      {
        EXPECT_EQ((curve.child[i + 1] - curve.child[i] + 4) % 2, 1);
        // A child is left at the corner where the next one is entered: the curve of a child ends
        // at its last corner, one step from its first.
        const auto here = mfem::PlaneHilbertCurve(curve.state[i]).child;
        const auto next = mfem::PlaneHilbertCurve(curve.state[i + 1]).child;
        const auto at = [](int corner) {
          return std::array{ corner == 1 || corner == 2, corner > 1 };
        };
        const auto end = at(here[3]);
        const auto begin = at(next[0]);
        const auto from = at(curve.child[i]);
        const auto to = at(curve.child[i + 1]);
        for (std::size_t d = 0; d < 2; ++d)
        {
          // In units of a grandchild, neighbours differ by one in one direction.
          const int gap = 2 * (to[d] - from[d]) + (begin[d] - end[d]);
          EXPECT_LE(std::abs(gap), to[d] == from[d] ? 0 : 1) << state << " " << i;
        }
      }
    }
  }
  EXPECT_EQ(curves.size(), 8U);
}

/// One square divided into two by two, one of these divided again: the leaves are in the order of
/// the curve, and hanging vertices are at the middles.
TEST(MfemPlane, RefinedSquareWithoutNodes)
{
  const std::string mesh =
    "MFEM NC mesh v1.0\ndimension\n2\nelements\n5\n-1 1 3 3 1 2 3 4\n0 1 3 0 0 4 8 7\n"
    "0 2 3 0 4 1 5 8\n0 3 3 0 8 5 2 6\n0 4 3 0 7 8 6 3\nboundary\n1\n5 1 4 1\n"
    "vertex_parents\n5\n4 0 1\n5 1 2\n6 2 3\n7 3 0\n8 4 6\nroot_state\n1\n3\n"
    "coordinates\n4\n2\n0 0\n1 0\n1 1\n0 1\n";
  const SolverModel model = ReadTexts(mesh);
  // State 3 goes around from corner 1 against the clock's other way: 1, 0, 3, 2.
  EXPECT_EQ(model.mesh.attribute, (std::vector<std::int32_t>{ 2, 1, 4, 3 }));
  EXPECT_EQ(PointAt(model, 0, { 0, 0, 0 }), Vec3(0.75, 0.25, 0.0));
  ASSERT_EQ(model.mesh.boundary.size(), 1U);
  EXPECT_EQ(model.mesh.boundary[0].element, 0);
  EXPECT_EQ(model.mesh.boundary[0].face, 2); // y = 0
}

TEST(MfemPlane, PlanesInSpace)
{
  const SolverModel model = ReadTexts(Mixed("3\n0 0 5\n1 0 5\n1 1 5\n0 1 5\n2 0 5\n2 1 5\n"));
  EXPECT_EQ(model.mesh.slab->middle, 5.0);
  EXPECT_EQ(PointAt(model, 0, { 0, 0, 0 }), Vec3(0.5, 0.5, 5.0));
}

TEST(MfemPlane, SurfacesInSpaceAreFacesOfSolids)
{
  const SolverModel model = ReadTexts(Mixed("3\n0 0 5\n1 0 6\n1 1 8\n0 1 5\n2 0 5\n2 1 6\n"));
  ASSERT_TRUE(model.mesh.slab->inSpace);
  ASSERT_EQ(model.mesh.map.SpaceOf(0).shape, Shape::Hexahedron);
  const Vec3 middle = PointAt(model, 0, { 0, 0, 1 });
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(middle[c], Vec3(0.5, 0.5, 6.0)[c], 4e-15);
  }
}

TEST(MfemPlane, RefusalsNameTheReason)
{
  ExpectMessage(Message(Mixed("1\n0\n1\n1\n0\n2\n2\n")), { "line", "1-dimensional space" });
  ExpectMessage(
    Message(Mixed(), { MakeFieldText("H1_3D_P1", 1, { 1, 2, 3, 4, 5, 6 }) }), { "3-D", "2-D" });
  ExpectMessage(Message(Mixed(), { MakeFieldText("Const3D", 1, { 1, 2, 3 }) }), { "3-D", "2-D" });
  ExpectMessage(Message(Mixed(), { MakeFieldText("CrouzeixRaviart", 1, { 1 }) }), { "project" });
  std::string mesh = Mixed();
  mesh.replace(mesh.find("1 3 0"), 3, "1 4");
  ExpectMessage(Message(mesh), { "line 6", "geometry type 4", "plane elements" });
  mesh = Mixed();
  mesh.replace(mesh.find("7 1 3"), 3, "7 2");
  ExpectMessage(Message(mesh), { "geometry type 2", "segments" });
}
} // namespace pixelexact::testing
