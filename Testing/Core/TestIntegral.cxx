// SPDX-License-Identifier: BSD-3-Clause
// Integrals over cut-surfaces and faces: against closed forms and sums in long double, of the same
// body meshed in several ways, with any number of threads, wrong use.
#include "CurvedMeshes.h"
#include "IntegralCheck.h"

#include "Core/Base/Error.h"
#include "Core/Integral/IntegralCut.h"
#include "Core/Integral/Integrate.h"
#include "Core/Shape/ShapeFace.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace pixelexact::testing
{
namespace
{
ImplicitPolynomial Ball(const Vec3& centre, const Vec3& axes)
{
  ImplicitPolynomial form;
  form.origin = centre;
  form.a.q = { 1.0 / (axes.x * axes.x), 1.0 / (axes.y * axes.y), 1.0 / (axes.z * axes.z), 0, 0, 0 };
  form.a.c = -1.0;
  return form;
}

SurfaceIntegral Cut(const Mesh& mesh, const Field* field, const ImplicitPolynomial& form,
  const IntegralEffort& effort = {})
{
  const Locator locator(mesh);
  const FaceTable faces(locator.Index());
  const PolynomialSurface surface(form);
  return IntegrateCut({ mesh, field, &surface }, locator, faces, effort);
}

/// (x^2, 1, x y) on it.
ExpansionBuilder VectorOnCube()
{
  ExpansionBuilder values(3);
  values.Add(UniformSpace(Shape::Hexahedron, 2),
    [](const LongVec3& x, long double* v)
    {
      v[0] = x[0] * x[0];
      v[1] = 1.0L;
      v[2] = x[0] * x[1];
    });
  return values;
}

TEST(ChebyshevModel, HoldsWhatOperationsGive)
{
  Random random(7);
  const auto make = [&random](double first)
  {
    ChebyshevModel model;
    for (double& c : model.c)
    {
      c = random(-0.02, 0.02);
    }
    model.c[0] = first;
    return model;
  };
  const auto at = [](const ChebyshevModel& model, long double s, long double t)
  {
    long double sum = 0.0L;
    for (int i = 0; i <= ChebyshevModel::kDegree; ++i)
    {
      for (int j = 0; i + j <= ChebyshevModel::kDegree; ++j)
      {
        sum += static_cast<long double>(model.c[ChebyshevModel::Index(i, j)]) *
          std::cos(i * std::acos(s)) * std::cos(j * std::acos(t));
      }
    }
    return sum;
  };
  for (int trial = 0; trial < 20; ++trial)
  {
    const ChebyshevModel a = make(random(-3.0, 3.0));
    const ChebyshevModel b = make(2.0);
    const ChebyshevModel product = a * b;
    const ChebyshevModel sum = a + b;
    const ChebyshevModel inverse = Reciprocal(b);
    const ChebyshevModel root = SquareRoot(b);
    ASSERT_TRUE(std::isfinite(inverse.error) && std::isfinite(root.error));
    EXPECT_LT(inverse.error, 1e-2);
    const Interval tight = a.TightRange();
    EXPECT_TRUE(a.Range().Contains(tight));
    for (int k = 0; k < 20; ++k)
    {
      const long double s = random();
      const long double t = random();
      const long double f = at(a, s, t);
      const long double g = at(b, s, t);
      EXPECT_LE(std::fabs(at(product, s, t) - f * g), product.error);
      EXPECT_LE(std::fabs(at(sum, s, t) - f - g), sum.error);
      EXPECT_LE(std::fabs(at(inverse, s, t) - 1 / g), inverse.error);
      EXPECT_LE(std::fabs(at(root, s, t) - std::sqrt(g)), root.error);
      EXPECT_TRUE(tight.Contains(static_cast<double>(f)));
    }
  }
  EXPECT_FALSE(std::isfinite(Reciprocal(make(0.0)).error));
  EXPECT_FALSE(std::isfinite(SquareRoot(make(-1.0)).error));
}

TEST(Integral, PlanesThroughACube)
{
  const MeshBuilder cube = Cube();
  const ExpansionBuilder values = VectorOnCube();
  const Field field{ "u", values.View() };
  const double root = std::numbers::sqrt2;

  const SurfaceIntegral across = Cut(cube.View(), &field, PlaneForm({ 0, 0, 1 }, -0.25));
  EXPECT_TRUE(across.met);
  const double wanted[] = { 4.0, 4.0 / 3.0, 4.0, 0.0, 0.0 };
  for (std::size_t q = 0; q < 5; ++q)
  {
    ExpectHolds(across.sums[q], wanted[q], 1e-7, "z = 1/4");
  }

  // A hexagon, whose corners are on edges of the element.
  const SurfaceIntegral hexagon = Cut(cube.View(), &field, PlaneForm({ 1, 1, 1 }, 0.0));
  ExpectHolds(hexagon.sums[0], 3.0 * std::sqrt(3.0), 1e-7, "hexagon");

  // The plane passes through edges of the element, x = y; the flux is that of (x^2 - 1) / sqrt(2).
  const SurfaceIntegral diagonal = Cut(cube.View(), &field, PlaneForm({ 1, -1, 0 }, 0.0));
  ExpectHolds(diagonal.sums[0], 4.0 * root, 1e-7, "diagonal");
  ExpectHolds(diagonal.sums[1], 4.0 * root / 3.0, 1e-7, "diagonal, x^2");
  ExpectHolds(diagonal.sums[4], 4.0 / 3.0 - 4.0, 1e-7, "diagonal, flux");
}

TEST(Integral, AFaceInThePlaneCountsOnce)
{
  MeshBuilder builder;
  ExpansionBuilder values(3);
  for (const double z : { -1.0, 1.0 })
  {
    builder.Add(UniformSpace(Shape::Hexahedron, 1),
      [z](const LongVec3& xi) {
        return LongVec3{ xi[0], xi[1], xi[2] + z };
      },
      { 0, 0, z });
    values.Add(UniformSpace(Shape::Hexahedron, 1),
      [](const LongVec3&, long double* v)
      {
        v[0] = 0.0L;
        v[1] = 0.0L;
        v[2] = 1.0L;
      });
  }
  const Field field{ "u", values.View() };
  for (const double sense : { 1.0, -1.0 })
  {
    const SurfaceIntegral found = Cut(builder.View(), &field, PlaneForm({ 0, 0, sense }, 0.0));
    EXPECT_EQ(found.faces, 1);
    EXPECT_EQ(found.elements, 0);
    ExpectHolds(found.sums[0], 4.0, 1e-7, "the face between two");
    ExpectHolds(found.sums[4], sense * 4.0, 1e-7, "flux along the normal");
    const SurfaceIntegral end =
      Cut(builder.View(), &field, PlaneForm({ 0, 0, sense }, -2.0 * sense));
    ExpectHolds(end.sums[0], 4.0, 1e-7, "a face at the end");
    ExpectHolds(end.sums[4], sense * 4.0, 1e-7, "flux at the end");
  }
}

TEST(Integral, QuadricsInACube)
{
  const MeshBuilder cube = Cube();
  const Mesh mesh = cube.View();
  IntegralEffort effort;
  effort.tolerance = 1e-6;
  ExpectHolds(Cut(mesh, nullptr, Ball({ -1, -1, -1 }, Vec3(1.0)), effort).sums[0], kPi / 2.0, 1e-5,
    "an eighth of a sphere");
  ImplicitPolynomial cylinder;
  cylinder.a.q = { 1, 1, 0, 0, 0, 0 };
  cylinder.a.c = -0.49;
  ExpectHolds(
    Cut(mesh, nullptr, cylinder, effort).sums[0], 2.0 * kPi * 0.7 * 2.0, 1e-4, "cylinder");
  // The area of a spheroid with a = b = 0.5, c = 0.8.
  const double e = std::sqrt(1.0 - 0.25 / 0.64);
  const double spheroid = 2.0 * kPi * 0.25 * (1.0 + 0.8 / (0.5 * e) * std::asin(e));
  effort.tolerance = 1e-4;
  ExpectHolds(Cut(mesh, nullptr, Ball(Vec3(0.0), { 0.5, 0.5, 0.8 }), effort).sums[0], spheroid,
    1e-2, "spheroid");
}

TEST(Integral, ADiscThroughACurvedBottom)
{
  MeshBuilder builder;
  builder.Add(UniformSpace(Shape::Hexahedron, 2),
    [](const LongVec3& x) {
      return LongVec3{ x[0], x[1], x[2] + 0.2L * (x[0] * x[0] + x[1] * x[1]) };
    });
  ExpansionBuilder values(1);
  // x^2 + y^2.
  values.Add(UniformSpace(Shape::Hexahedron, 2),
    [](const LongVec3& x, long double* v) { v[0] = x[0] * x[0] + x[1] * x[1]; });
  const Field field{ "u", values.View() };
  // The bottom is -1 + (x^2 + y^2) / 5.
  const SurfaceIntegral found = Cut(builder.View(), &field, PlaneForm({ 0, 0, 1 }, 0.9));
  EXPECT_TRUE(found.met);
  ExpectHolds(found.sums[0], kPi / 2.0, 4e-8, "area");
  ExpectHolds(found.sums[1], kPi / 8.0, 4e-8, "x^2 + y^2");
}

/// The area of a plane in the bent cube by counting: rows of the plane, in which the ends of what
/// is inside are bisected in long double.
long double CountedArea(const Vec3& normal, double c, int rows)
{
  // Rows are turned away from the body's edges, along which a row would be in or out as a whole.
  // Inside by inverting Bend.
  const auto inside = [&](long double along, long double across)
  {
    const long double x = 0.9L * along - std::sqrt(0.19L) * across;
    const long double y = std::sqrt(0.19L) * along + 0.9L * across;
    const LongVec3 target{ x, y, -(c + normal.x * x + normal.y * y) / normal.z };
    LongVec3 u = target;
    for (int step = 0; step < 25; ++step)
    {
      const LongVec3 at = Bend(u);
      for (int d = 0; d < 3; ++d)
      {
        u[d] += target[d] - at[d];
      }
    }
    return std::fabs(u[0]) <= 1 && std::fabs(u[1]) <= 1 && std::fabs(u[2]) <= 1;
  };
  long double sum = 0.0L;
  const long double side = 2.0L;
  for (int row = 0; row < rows; ++row)
  {
    const long double y = -side + 2 * side * (row + 0.5L) / rows;
    bool before = false;
    constexpr int kSteps = 400;
    for (int k = 0; k <= kSteps; ++k)
    {
      const long double x = -side + 2 * side * k / kSteps;
      const bool now = inside(x, y);
      if (now != before)
      {
        long double in = now ? x : x - 2 * side / kSteps;
        long double out = now ? x - 2 * side / kSteps : x;
        for (int step = 0; step < 40; ++step)
        {
          const long double middle = (in + out) / 2;
          (inside(middle, y) ? in : out) = middle;
        }
        sum += now ? -in : in;
      }
      before = now;
    }
  }
  const long double slant =
    std::sqrt(normal.x * normal.x + normal.y * normal.y + normal.z * normal.z) /
    std::fabs(normal.z);
  return sum * 2 * side / rows * slant;
}

TEST(Integral, TheBentCubeMeshedInSeveralWays)
{
  const Vec3 normal{ 1, 1, 1 };
  const ImplicitPolynomial plane = PlaneForm(normal, -0.3);
  // Doubling the rows from 200 moves it by 1.5e-4.
  const auto counted = static_cast<double>(CountedArea(normal, -0.3, 400));
  IntegralEffort effort;
  effort.tolerance = 1e-5;
  Interval common = Interval::Everything();
  for (const Shape shape : kShapes)
  {
    const CurvedMesh mesh = Blocks(1, std::span(&shape, 1));
    const SurfaceIntegral found = Cut(mesh.View(), nullptr, plane, effort);
    EXPECT_TRUE(found.met) << Name(shape);
    EXPECT_EQ(found.notValid, 0);
    EXPECT_NEAR(found.sums[0].Middle(), counted, 1e-4) << Name(shape);
    common = Intersect(common, found.sums[0]);
  }
  EXPECT_FALSE(common.IsEmpty()) << "the meshes' areas contradict each other";
}

TEST(Integral, FacesAndTheDivergenceTheorem)
{
  // The flux of (x, 0, 0) out of the bent cube is its volume, for every division into elements.
  Interval common = Interval::Everything();
  IntegralEffort effort;
  for (const Shape shape : kShapes)
  {
    const CurvedMesh curved = Blocks(1, std::span(&shape, 1));
    const Mesh mesh = curved.View();
    ExpansionBuilder values(3);
    for (int e = 0; e < mesh.Elements(); ++e)
    {
      const Space& space = mesh.map.SpaceOf(e);
      const auto modes = static_cast<std::size_t>(space.Modes());
      values.Add(space, [](const LongVec3&, long double* v) { v[0] = v[1] = v[2] = 0.0L; });
      const double* const map = mesh.map.Coefficients(e);
      const auto at = static_cast<std::size_t>(values.Offset.back());
      const double size = mesh.size[static_cast<std::size_t>(e)];
      for (std::size_t m = 0; m < modes; ++m)
      {
        values.Coefficients[at + m] = size * map[m];
      }
      values.Coefficients[at] += mesh.centre[3 * static_cast<std::size_t>(e)];
    }
    const Field field{ "x", values.View() };
    const Locator locator(mesh);
    const FaceTable table(locator.Index());
    std::vector<ElementFace> faces;
    for (int e = 0; e < mesh.Elements(); ++e)
    {
      for (int f = 0; f < static_cast<int>(FacesOf(mesh.ShapeOf(e)).size()); ++f)
      {
        if (table.KindOf(e, f) == FaceKind::Boundary)
        {
          faces.push_back({ e, f });
        }
      }
    }
    const SurfaceIntegral found = IntegrateFaces({ mesh, &field, nullptr }, faces, effort);
    EXPECT_TRUE(found.met) << Name(shape);
    common = Intersect(common, found.sums.back());
    // Straight, the cube's volume is 8, and its bend's Jacobian is close to 1.
    EXPECT_NEAR(found.sums.back().Middle(), 8.0, 0.5);
  }
  EXPECT_FALSE(common.IsEmpty()) << "the volumes contradict each other";
}

TEST(Integral, MappedFieldsAreThoseOfTheWorld)
{
  // x = 2 xi: an H(div) field is F / 4, an H(curl) field F / 2, a density F / 8.
  MeshBuilder builder;
  builder.Add(
    UniformSpace(Shape::Hexahedron, 1), [](const LongVec3& xi) { return Times(2.0L, xi); },
    Vec3(0.0), 2.0);
  const ImplicitPolynomial plane = PlaneForm({ 0, 0, 1 }, -0.5);
  const std::pair<Mapping, double> cases[] = { { Mapping::Identity, 1.0 },
    { Mapping::Contravariant, 0.25 }, { Mapping::Covariant, 0.5 } };
  ExpansionBuilder values(3);
  values.Add(UniformSpace(Shape::Hexahedron, 1),
    [](const LongVec3&, long double* v)
    {
      v[0] = 1.0L;
      v[1] = 2.0L;
      v[2] = 3.0L;
    });
  for (const auto& [mapping, factor] : cases)
  {
    const Field field{ "u", values.View(), mapping };
    const SurfaceIntegral found = Cut(builder.View(), &field, plane);
    ExpectHolds(found.sums[0], 16.0, 1e-6, "area");
    for (int c = 0; c < 3; ++c)
    {
      ExpectHolds(found.sums[static_cast<std::size_t>(c) + 1], 16.0 * factor * (c + 1), 1e-6, "u");
    }
    ExpectHolds(found.sums[4], 48.0 * factor, 1e-6, "flux");
    const ElementFace top{ 0, 5 };
    const SurfaceIntegral face =
      IntegrateFaces({ builder.View(), &field, nullptr }, std::span(&top, 1), {});
    ExpectHolds(face.sums[4], 48.0 * factor, 1e-6, "flux through the top");
  }
  ExpansionBuilder density(1);
  density.Add(
    UniformSpace(Shape::Hexahedron, 1), [](const LongVec3&, long double* v) { v[0] = 8.0L; });
  const Field field{ "rho", density.View(), Mapping::Density };
  ExpectHolds(Cut(builder.View(), &field, plane).sums[1], 16.0, 1e-6, "density");
}

TEST(Integral, ThreadsChangeNothing)
{
  const CurvedMesh mesh = Blocks(2, kShapes);
  IntegralEffort effort;
  effort.tolerance = 1e-3;
  const ImplicitPolynomial plane = PlaneForm({ 1, 2, 3 }, -0.3);
  const SurfaceIntegral all = Cut(mesh.View(), nullptr, plane, effort);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const SurfaceIntegral alone = Cut(mesh.View(), nullptr, plane, effort);
  EXPECT_EQ(all.sums[0].lower, alone.sums[0].lower);
  EXPECT_EQ(all.sums[0].upper, alone.sums[0].upper);
  EXPECT_EQ(all.boxes, alone.boxes);
}

TEST(Integral, LittleTimeGivesWideBoundsThatHold)
{
  const MeshBuilder cube = Cube();
  IntegralEffort effort;
  effort.tolerance = 1e-14;
  effort.seconds = 1e-6;
  const SurfaceIntegral found = Cut(cube.View(), nullptr, Ball(Vec3(0.0), Vec3(0.5)), effort);
  EXPECT_FALSE(found.met);
  EXPECT_TRUE(found.timeIsOver);
  EXPECT_GT(found.unresolved, 0.0);
  EXPECT_TRUE(found.sums[0].Contains(kPi));
}

/// A hexahedron collapsed to a wedge, and one collapsed to a tetrahedron.
MeshBuilder Collapsed(bool toTetrahedron)
{
  MeshBuilder builder;
  builder.Add(UniformSpace(Shape::Hexahedron, 2),
    [=](const LongVec3& x)
    {
      const long double c = (1 + x[2]) / 2;
      const long double b = (1 + x[1]) / 2 * (toTetrahedron ? 1 - c : 1);
      return LongVec3{ (1 + x[0]) / 2 * (toTetrahedron ? 1 - c - b : 1 - b), b, c };
    });
  return builder;
}

TEST(Integral, CollapsedFacesHaveTheirArea)
{
  const std::vector<ElementFace> faces{ { 0, 0 }, { 0, 1 }, { 0, 2 }, { 0, 3 }, { 0, 4 },
    { 0, 5 } };
  ExpansionBuilder values(1);
  values.Add(
    UniformSpace(Shape::Hexahedron, 1), [](const LongVec3&, long double* v) { v[0] = 2.0L; });
  const Field field{ "u", values.View() };
  for (const bool toTetrahedron : { false, true })
  {
    const MeshBuilder builder = Collapsed(toTetrahedron);
    const double area =
      toTetrahedron ? 1.5 + std::sqrt(3.0) / 2.0 : 1.0 + 1.0 + 1.0 + std::sqrt(2.0);
    const SurfaceIntegral found = IntegrateFaces({ builder.View(), &field, nullptr }, faces, {});
    EXPECT_TRUE(found.met) << toTetrahedron;
    ExpectHolds(found.sums[0], area, 1e-6, "area");
    ExpectHolds(found.sums[1], 2.0 * area, 1e-6, "twice that");
  }
}

TEST(Integral, CutsThroughACollapsedEdge)
{
  const MeshBuilder builder = Collapsed(false);
  // Across the edge, along it, and through it: the plane then holds a face without area.
  ExpectHolds(
    Cut(builder.View(), nullptr, PlaneForm({ 0, 0, 1 }, -0.3)).sums[0], 0.5, 1e-7, "across");
  ExpectHolds(
    Cut(builder.View(), nullptr, PlaneForm({ 0, 1, 0 }, -0.9)).sums[0], 0.1, 1e-7, "along");
  IntegralEffort effort;
  effort.tolerance = 1e-4;
  effort.boxes = 20000;
  ExpectHolds(Cut(builder.View(), nullptr, PlaneForm({ 1, 0.5, 0 }, -0.5), effort).sums[0],
    std::sqrt(1.25), 1e-3, "through");
}

TEST(Integral, SheetsThatNearlyCoincideAndSmallSpheres)
{
  const MeshBuilder cube = Cube();
  IntegralEffort effort;
  effort.boxes = 5000;
  ImplicitPolynomial sheets;
  sheets.a.q = { 1, 0, 0, 0, 0, 0 };
  sheets.a.c = -1e-12;
  effort.tolerance = 1e-4;
  const SurfaceIntegral two = Cut(cube.View(), nullptr, sheets, effort);
  EXPECT_TRUE(two.met);
  EXPECT_LT(two.boxes, 1000);
  ExpectHolds(two.sums[0], 8.0, 1e-3, "two planes");
  // About a vertex and inside, down to where rounding is what is left.
  for (const double radius : { 1e-2, 1e-4, 1e-6 })
  {
    const double area = 4.0 * kPi * radius * radius;
    ExpectHolds(Cut(cube.View(), nullptr, Ball(Vec3(1.0), Vec3(radius)), effort).sums[0],
      area / 8.0, 1e-3 * area, "about a vertex");
    ExpectHolds(Cut(cube.View(), nullptr, Ball({ 0.3, 0.2, 0.1 }, Vec3(radius)), effort).sums[0],
      area, 1e-3 * area, "inside");
  }
  // Nothing narrower is promised, and the work ends.
  effort.tolerance = 1e-12;
  const SurfaceIntegral small = Cut(cube.View(), nullptr, Ball(Vec3(1.0), Vec3(1e-5)), effort);
  EXPECT_FALSE(small.met);
  EXPECT_GT(small.rounded, 0);
  EXPECT_TRUE(small.sums[0].Contains(kPi / 2.0 * 1e-10));
}

TEST(Integral, SizesThatOverflowAreRefused)
{
  for (const double size : { 0x1p-332, 0x1p332 })
  {
    MeshBuilder builder;
    builder.Add(
      UniformSpace(Shape::Hexahedron, 1),
      [size](const LongVec3& x) {
        return LongVec3{ x[0] * size, x[1] * size, x[2] * size };
      },
      Vec3(0.0), size);
    EXPECT_THROW(Cut(builder.View(), nullptr, Ball(Vec3(0.0), Vec3(0.5 * size))), Unsupported);
    const double area = 4.0 * size * size;
    ExpectHolds(Cut(builder.View(), nullptr, PlaneForm({ 0, 0, 1 }, 0.0)).sums[0], area,
      1e-7 * area, "plane");
  }
}

TEST(Integral, AFieldThatIsZeroHasTheIntegralZero)
{
  const MeshBuilder cube = Cube();
  ExpansionBuilder values(3);
  values.Add(UniformSpace(Shape::Hexahedron, 2),
    [](const LongVec3&, long double* v) { v[0] = v[1] = v[2] = 0.0L; });
  const Field field{ "u", values.View() };
  const std::vector<ElementFace> faces{ { 0, 0 }, { 0, 1 } };
  for (const SurfaceIntegral& found : { Cut(cube.View(), &field, PlaneForm({ 1, 2, 3 }, 0.1)),
         IntegrateFaces({ cube.View(), &field, nullptr }, faces, {}) })
  {
    for (std::size_t q = 1; q < found.sums.size(); ++q)
    {
      EXPECT_EQ(found.sums[q].lower, 0.0) << q;
      EXPECT_EQ(found.sums[q].upper, 0.0) << q;
    }
  }
}

TEST(Integral, WhatIsNotFiniteIsLeftOutAndCounted)
{
  const MeshBuilder cube = Cube();
  ExpansionBuilder values = VectorOnCube();
  values.Coefficients[0] = std::numeric_limits<double>::quiet_NaN();
  const Field field{ "u", values.View() };
  const SurfaceIntegral found = Cut(cube.View(), &field, PlaneForm({ 0, 0, 1 }, 0.0));
  EXPECT_EQ(found.notFinite, 1);
  EXPECT_EQ(found.sums[0].upper, 0.0);
}

TEST(Integral, WrongEffortIsRefused)
{
  const MeshBuilder cube = Cube();
  IntegralEffort effort;
  effort.tolerance = 0.0;
  EXPECT_THROW(Cut(cube.View(), nullptr, PlaneForm({ 0, 0, 1 }, 0.0), effort), InvalidData);
  effort.tolerance = 1e-3;
  effort.seconds = 0.0;
  EXPECT_THROW(Cut(cube.View(), nullptr, PlaneForm({ 0, 0, 1 }, 0.0), effort), InvalidData);
}
} // namespace
} // namespace pixelexact::testing
