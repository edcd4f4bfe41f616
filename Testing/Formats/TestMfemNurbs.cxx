// SPDX-License-Identifier: BSD-3-Clause
// NURBS meshes and grid functions of MFEM: closed forms, and what is refused. Values of MFEM's
// library are in Testing/Filters/TestNativeOracles.cxx.
#include "MfemTexts.h"

#include "Formats/FileText.h"

#include <cmath>

namespace pixelexact::testing
{
namespace
{
using namespace mfemtexts;

/// A square of one patch with given knot vectors, control points and weights; order 0: that of the
/// knot vectors.
std::string MakeNurbsSquare(
  const std::string& knots, const std::string& weights, const std::string& nodes, int order)
{
  return "MFEM NURBS mesh v1.0\ndimension\n2\nelements\n1\n7 3 0 1 2 3\nboundary\n4\n"
         "1 1 0 1\n2 1 1 2\n3 1 2 3\n4 1 3 0\nedges\n4\n0 0 1\n0 3 2\n1 0 3\n1 1 2\nvertices\n4\n"
         "knotvectors\n2\n" +
    knots + "\n" + weights + "\nFiniteElementSpace\nFiniteElementCollection: NURBS" +
    (order == 0 ? "" : std::to_string(order)) + "\nVDim: 2\nOrdering: 1\n" + nodes;
}

const std::string kLine = "1 2 0 0 1 1\n";
const std::string kSquareCorners = "0 0\n1 0\n1 1\n0 1\n";

std::string UnitSquare()
{
  return MakeNurbsSquare(kLine + kLine, "weights\n1 1 1 1", kSquareCorners, 1);
}

/// A quarter of the ring between the circles of radii 1 and 2; the arc runs from vertex 0 to 1.
std::string Ring(const std::string& middle)
{
  return MakeNurbsSquare("2 3 0 0 0 1 1 1\n" + kLine, "weights\n1 1 1 1 " + middle + " " + middle,
    "1 0\n0 1\n0 2\n2 0\n1 1\n2 2\n", 0);
}

constexpr const char* kSineOf45 = "0.70710678118654752440";

template <class Visit>
void ForLattice(Visit&& visit)
{
  for (int i = -4; i <= 4; ++i)
  {
    for (int j = -4; j <= 4; ++j)
    {
      visit(Vec3(i / 4.0, j / 4.0, 0.0));
    }
  }
}

TEST(MfemNurbs, RingIsRoundToTheLastDigits)
{
  const SolverModel model = ReadTexts(Ring(kSineOf45));
  ASSERT_EQ(model.notes.size(), 1u);
  ExpectMessage(model.notes[0], { "1 knot span", "rational", "at most" });
  double worst = 0.0;
  for (std::size_t e = 0; e < model.mesh.number.size(); ++e)
  {
    EXPECT_EQ(model.mesh.number[e], 0);
    EXPECT_EQ(model.mesh.attribute[e], 7);
    ForLattice(
      [&](const Vec3& xi)
      {
        const Vec3 x = PointAt(model, static_cast<int>(e), xi);
        worst = std::max(worst, std::fabs(std::hypot(x.x, x.y) - (1.5 + xi.y / 2)));
      });
  }
  EXPECT_LE(worst, 2e-15);
}

TEST(MfemNurbs, PartsMeet)
{
  const SolverModel model = ReadTexts(Ring(kSineOf45));
  const int parts = static_cast<int>(model.mesh.number.size());
  ASSERT_GT(parts, 1);
  for (int e = 0; e + 1 < parts; ++e)
  {
    for (const double y : { -1.0, -0.3, 0.4, 1.0 })
    {
      const Vec3 a = PointAt(model, e, Vec3(1.0, y, 0.0));
      const Vec3 b = PointAt(model, e + 1, Vec3(-1.0, y, 0.0));
      EXPECT_NEAR(a.x, b.x, 5e-16);
      EXPECT_NEAR(a.y, b.y, 5e-16);
    }
  }
}

TEST(MfemNurbs, PartsHaveTheirShareOfBoundaries)
{
  const SolverModel model = ReadTexts(Ring(kSineOf45));
  const auto parts = static_cast<std::ptrdiff_t>(model.mesh.number.size());
  const auto count = [&](int attribute)
  {
    return std::ranges::count_if(model.mesh.boundary,
      [attribute](const BoundaryFace& face) { return face.attribute == attribute; });
  };
  EXPECT_EQ(count(1), parts);
  EXPECT_EQ(count(2), 1);
  EXPECT_EQ(count(3), parts);
  EXPECT_EQ(count(4), 1);
}

TEST(MfemNurbs, EqualWeightsArePolynomials)
{
  for (const std::string weight : { "1", "0.3" })
  {
    std::string weights = "weights\n";
    for (int i = 0; i < 6; ++i)
    {
      weights += weight + " ";
    }
    const SolverModel model = ReadTexts(
      MakeNurbsSquare("2 3 0 0 0 1 1 1\n" + kLine, weights, "1 0\n0 1\n0 2\n2 0\n1 1\n2 2\n", 0));
    EXPECT_TRUE(model.notes.empty());
    ASSERT_EQ(model.mesh.number.size(), 1u);
    EXPECT_EQ(model.mesh.map.spaces[0].order, (std::array<std::uint8_t, 3>{ 2, 1, 1 }));
    // A parabola's middle is half the chord's and half the control point.
    EXPECT_NEAR(PointAt(model, 0, Vec3(0.0, -1.0, 0.0)).x, 0.75, 1e-15);
  }
}

/// The pipe's first half, along its axis, is a cylinder whose radius is 2 inside and 3 outside.
TEST(MfemNurbs, PipeIsRound)
{
  const std::string file = std::string(PIXELEXACT_DATA_DIR) + "/mfem_nurbs_pipe/mfem_nurbs_pipe";
  const SolverModel model =
    mfem::ReadFiles(file + ".mesh", { std::string(PIXELEXACT_DATA_DIR) + "/mfem_nurbs_pipe/h.gf" });
  double worst = 0.0;
  int cylinders = 0;
  for (std::size_t e = 0; e < model.mesh.number.size(); ++e)
  {
    if (model.mesh.number[e] % 2 == 1)
    {
      continue;
    }
    ++cylinders;
    ForLattice(
      [&](const Vec3& at)
      {
        const Vec3 x = PointAt(model, static_cast<int>(e), Vec3(at.x, at.y, at.y));
        worst = std::max(worst, std::fabs(std::hypot(x.x, x.y) - (2.5 + at.x / 2)));
      });
  }
  EXPECT_GE(cylinders, 4);
  EXPECT_LE(worst, 1e-14);
}

TEST(MfemNurbs, KnotsThatAreThereTwiceSplitAPatch)
{
  // Two spans of a broken line, of order 1 with a knot at 0.25.
  const SolverModel model = ReadTexts(MakeNurbsSquare(
    "1 3 0 0 0.25 1 1\n" + kLine, "unitweights", kSquareCorners + "0.5 0\n0.5 1\n", 1));
  ASSERT_EQ(model.mesh.number.size(), 2u);
  EXPECT_EQ(PointAt(model, 0, Vec3(1.0, -1.0, 0.0)).x, 0.5);
  EXPECT_EQ(PointAt(model, 1, Vec3(0.0, -1.0, 0.0)).x, 0.75);
}

/// At its only knot k the B-spline of a parabola is (1 - k) P1 + k P2.
TEST(MfemNurbs, KnotsRunAsEdgesAreListed)
{
  const std::string text = MakeNurbsSquare("2 4 0 0 0 0.25 1 1 1\n" + kLine, "unitweights",
    kSquareCorners + "0.3 0\n0.8 0\n0.8 1\n0.3 1\n", 0);
  const SolverModel upwards = ReadTexts(text);
  EXPECT_NEAR(PointAt(upwards, 0, Vec3(1.0, -1.0, 0.0)).x, 0.425, 1e-15);
  EXPECT_TRUE(upwards.notes.empty());
  const SolverModel downwards = ReadTexts(Replaced(text, "0 0 1\n0 3 2\n", "0 1 0\n0 2 3\n"));
  EXPECT_NEAR(PointAt(downwards, 0, Vec3(1.0, -1.0, 0.0)).x, 0.675, 1e-15);
  EXPECT_TRUE(downwards.notes.size() == 1);
  ExpectMessage(downwards.notes.at(0), { "knot vector 0", "symmetric", "4.9" });
}

TEST(MfemNurbs, FieldsOfOtherOrdersAndWeights)
{
  const std::string head = "MFEM FiniteElementSpace v1.0\nFiniteElementCollection: NURBS\nVDim: 1\n"
                           "Ordering: 0\n";
  const std::string end = "End: MFEM FiniteElementSpace v1.0\n";
  // Order 2 only along the first knot vector: numbers 4 and 5 are on edges 0 and 1.
  const std::string values = "0 1 1 0 0.5 0.5\n";
  const SolverModel plain =
    ReadTexts(UnitSquare(), { head + "NURBS_orders\n2\n1\n" + end + values });
  EXPECT_NEAR(ValueAt(plain, 0, 0, Vec3(0.5, 0.0, 0.0))[0], 0.75, 1e-15);
  EXPECT_EQ(plain.fields[0].values.spaces[0].order, (std::array<std::uint8_t, 3>{ 2, 1, 0 }));
  EXPECT_TRUE(plain.notes.empty());
  const SolverModel weighted = ReadTexts(UnitSquare(),
    { head + "NURBS_orders\n2\n1\nNURBS_weights\n1\n1\n1\n1\n2\n2\n" + end + values });
  // (2 * 2 t (1 - t) / 2 + t^2) / ((1 - t)^2 + 4 t (1 - t) + t^2) at t = 3/4
  EXPECT_NEAR(ValueAt(weighted, 0, 0, Vec3(0.5, 0.0, 0.0))[0], 0.9375 / 1.375, 1e-14);
  EXPECT_EQ(weighted.notes.size(), 1u);
  // By patches the values are in the order of a grid.
  const SolverModel patches = ReadTexts(
    UnitSquare(), { head + "NURBS_orders\n2\n1\n" + end + "NURBS_patches\n0 0.5 1 0 0.5 1\n" });
  EXPECT_EQ(ValueAt(patches, 0, 0, Vec3(0.3, 0.2, 0.0)), ValueAt(plain, 0, 0, Vec3(0.3, 0.2, 0.0)));
}

TEST(MfemNurbs, PolynomialFieldsOnParts)
{
  // The reference coordinate along the arc, on each part.
  const std::string field = "FiniteElementSpace\nFiniteElementCollection: H1_2D_P1\nVDim: 1\n"
                            "Ordering: 0\n0\n1\n1\n0\n";
  const SolverModel model = ReadTexts(Ring(kSineOf45), { field });
  const int parts = static_cast<int>(model.mesh.number.size());
  for (int e = 0; e < parts; ++e)
  {
    EXPECT_NEAR(ValueAt(model, 0, e, Vec3(0.0, 0.5, 0.0))[0], (e + 0.5) / parts, 1e-15);
  }
}

TEST(MfemNurbs, IdentifiedBoundaries)
{
  const std::string head =
    "MFEM FiniteElementSpace v1.0\nFiniteElementCollection: NURBS2\nVDim: 1\n"
    "Ordering: 0\nNURBS_order\n2\n";
  const std::string end = "End: MFEM FiniteElementSpace v1.0\n";
  // Nine control points, of which the three at x = 1 are those at x = 0.
  const std::string values = "1\n2\n3\n4\n5\n6\n";
  const SolverModel model =
    ReadTexts(UnitSquare(), { head + "NURBS_periodic\n1\n2\n1\n4\n" + end + values });
  for (const double y : { -1.0, -0.2, 0.7 })
  {
    EXPECT_NEAR(ValueAt(model, 0, 0, Vec3(-1.0, y, 0.0))[0],
      ValueAt(model, 0, 0, Vec3(1.0, y, 0.0))[0], 1e-14);
  }
  ExpectMessage(
    Message(UnitSquare(), { head + "NURBS_periodic\n1\n2\n1\n9\n" + end + values }), { "9" });
}

TEST(MfemNurbs, SpacingAndMissingEdges)
{
  std::string text = Replaced(UnitSquare(), "v1.0", "v1.1");
  text = Replaced(text, "weights\n", "spacing\n1\n0 5 3 1 1 0 1 10.0\nweights\n");
  EXPECT_EQ(ReadTexts(text).mesh.number.size(), 1u);
  text = Replaced(UnitSquare(), "edges\n4\n0 0 1\n0 3 2\n1 0 3\n1 1 2\n", "edges\n0\n");
  EXPECT_EQ(PointAt(ReadTexts(text), 0, Vec3(1.0, 1.0, 0.0)).x, 1.0);
}

TEST(MfemNurbs, RefusedByName)
{
  ExpectMessage(
    Message("MFEM NURBS NC-patch mesh v1.0\ndimension\n3\n"), { "NC-patch", "PrintVTU" });
  ExpectMessage(Message("MFEM NURBS mesh v1.2\n"), { "v1.2", "v1.1" });
  ExpectMessage(Message("MFEM NURBS mesh v1.0\ndimension\n1\n"), { "1-dimensional" });
  ExpectMessage(Message(Ring("0")), { "weight of control point 4", "not positive" });
  ExpectMessage(Message(Ring("-1")), { "weight of control point 4", "not positive" });
  ExpectMessage(Message(Ring("nan")), { "weight" });
  ExpectMessage(Message(Ring("1e9")), { "differ so much" });
  ExpectMessage(Message(Replaced(UnitSquare(), "1 2 0 0 1 1", "1 2 0 0 -1 1")), { "descend" });
  ExpectMessage(Message(Replaced(UnitSquare(), "1 2 0 0 1 1", "1 2 0 0 0 0")), { "no span" });
  ExpectMessage(Message(Replaced(UnitSquare(), "1 2 0 0 1 1", "2 2 0 0 0 1 1")), { "one more" });
  ExpectMessage(
    Message(Replaced(UnitSquare(), "1 2 0 0 1 1", "40 2 0 0 1 1")), { "order 40", "32" });
  ExpectMessage(
    Message(Replaced(UnitSquare(), "weights\n1 1 1 1", "weights\n1 1 1")), { "3 weights" });
  ExpectMessage(Message(Replaced(UnitSquare(), "1 1\n0 1\n", "1 1\n0\n")), { "values" });
  ExpectMessage(Message(Replaced(UnitSquare(), "1 1\n0 1\n", "1 nan\n0 1\n")), { "NaN" });
  ExpectMessage(Message(Replaced(UnitSquare(), "weights\n", "mesh_elements\n0\nweights\n")),
    { "piece", "PrintAsOne" });
  EXPECT_EQ(Message(Replaced(UnitSquare(), "weights\n", "mesh_elements\n1\n0\nweights\n")), "");
  ExpectMessage(Message(Replaced(UnitSquare(), "0 3 2", "1 3 2")), { "different knot vectors" });
  ExpectMessage(Message(Replaced(UnitSquare(), "1 1 2\nvertices", "1 1 3\nvertices")), { "edge" });
  ExpectMessage(Message(Replaced(UnitSquare(), "7 3 0 1 2 3", "7 3 0 1 2 2")), { "twice" });
  ExpectMessage(Message(Replaced(UnitSquare(), "2 1 1 2", "2 1 1 3")), { "boundary patch 1" });
  ExpectMessage(
    Message(Replaced(UnitSquare(), "vertices\n4", "vertices\n1000000000")), { "damaged" });
  const std::string surface = Replaced(
    Replaced(UnitSquare(), "VDim: 2", "VDim: 3"), kSquareCorners, "0 0 0\n1 0 0\n1 1 1\n0 1 0\n");
  EXPECT_EQ(Message(surface), "");
  const std::string field = "FiniteElementSpace\nFiniteElementCollection: ";
  const std::string rest = "\nVDim: 1\nOrdering: 0\n1\n2\n3\n";
  ExpectMessage(Message(UnitSquare(), { field + "NURBS_HDiv1" + rest }), { "u.gf", "NURBS_HDiv1" });
  ExpectMessage(Message(UnitSquare(), { field + "NURBS1" + rest }), { "u.gf", "3 values", "4" });
  ExpectMessage(Message(UnitSquare(), { field + "NURBS99" + rest }), { "u.gf", "32" });
  ExpectMessage(Message(UnitSquare(),
                  { "MFEM FiniteElementSpace v1.0\nFiniteElementCollection: NURBS1\nVDim: 1\n"
                    "Ordering: 0\nNURBS_order\n1\nNURBS_weights\n1\n1e6\n1\n1\n"
                    "End: MFEM FiniteElementSpace v1.0\n1\n2\n3\n4\n" }),
    { "u.gf", "differ so much" });
}

TEST(MfemNurbs, PatchesThatDisagree)
{
  const std::string text =
    "MFEM NURBS mesh v1.0\ndimension\n2\nelements\n1\n1 3 0 1 2 3\nboundary\n"
    "0\nedges\n0\nvertices\n4\npatches\nknotvectors\n2\n1 2 0 0 1 1\n"
    "1 2 0 0 1 1\ndimension\n2\n";
  const std::string points = "0 0 2\n2 0 2\n0 2 2\n2 2 2\n";
  // Homogeneous coordinates are divided by their weights.
  const SolverModel model = ReadTexts(text + "controlpoints\n" + points);
  EXPECT_EQ(PointAt(model, 0, Vec3(1.0, -1.0, 0.0)).x, 1.0);
  const SolverModel cartesian =
    ReadTexts(text + "controlpoints_cartesian\n0 0 2\n1 0 2\n0 1 2\n1 1 2\n");
  EXPECT_EQ(PointAt(cartesian, 0, Vec3(0.3, 0.4, 0.0)), PointAt(model, 0, Vec3(0.3, 0.4, 0.0)));
  ExpectMessage(Message(text + "points\n" + points), { "'points'" });
}
} // namespace
} // namespace pixelexact::testing
