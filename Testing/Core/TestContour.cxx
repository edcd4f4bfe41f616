// SPDX-License-Identifier: BSD-3-Clause
// Contours as polylines, against closed forms.
#include "ContourCheck.h"
#include "CurvedMeshes.h"

#include "Core/Base/Error.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

namespace pixelexact::testing
{
namespace
{
void ExpectCircle(const ContourSet& set, const CutFunction& cut, double radius)
{
  ASSERT_EQ(set.lines.size(), 1U);
  EXPECT_TRUE(set.lines[0].closed);
  EXPECT_EQ(set.lines[0].vertices.front(), set.lines[0].vertices.back());
  const LineMeasure measure = Measure(set, set.lines[0], cut);
  EXPECT_NEAR(measure.length / (2.0 * kPi * radius), 1.0, 1e-9);
  EXPECT_NEAR(measure.area / (kPi * radius * radius), 1.0, 1e-9);
}

void ExpectOnCurve(const VertexErrors& errors)
{
  EXPECT_LT(errors.value, 2e-14L);
  EXPECT_LT(errors.cut, 2e-14L);
  EXPECT_LT(errors.place, 2e-15L * 4);
}

struct ShapeAndOrder
{
  Shape shape;
  int order;
};

class ContourInOneElement : public ::testing::TestWithParam<ShapeAndOrder>
{
};

TEST_P(ContourInOneElement, LoopThatNoFaceSees)
{
  const auto [shape, order] = GetParam();
  const Vec3 centre = Centre(shape);
  // The map has degree order / 2, so that the squared distance has the field's degree.
  const int bend = order / 2;
  const auto bent = [bend](const LongVec3& xi)
  {
    const auto [a, b, c] = xi;
    return bend == 1 ? LongVec3{ a + 0.1L * b, b - 0.2L * c, c + 0.1L * a }
      : bend == 2    ? LongVec3{ a + 0.1L * b * b, b - 0.05L * c * a, c + 0.1L * a * a }
                     : Curved(xi);
  };
  MeshBuilder builder;
  builder.Add(UniformSpace(shape, std::max(1, std::min(bend, 3))), bent);
  const Mesh mesh = builder.View();
  const LongVec3 middle = LongMap(mesh)(0, ToLong(centre));
  const auto f = [middle](const LongVec3& x) { return Dot(Minus(x, middle), Minus(x, middle)); };
  const ExpansionBuilder values = FieldOf(mesh, order, f);
  const PolynomialCut cut(ImplicitPolynomial::Plane(ToDouble(middle), { 0.0, 0.0, 1.0 }));
  const double radius = 0.15;
  const std::vector<double> levels{ radius * radius };
  const ContourSet set = ContoursOf(mesh, values, cut, levels, 1e-6);
  ExpectCircle(set, cut, radius);
  EXPECT_EQ(set.report.undecided, 0);
  EXPECT_TRUE(set.lines.at(0).certified);
  ExpectOnCurve(
    ErrorsOf(set, mesh, levels, f, [&](const LongVec3& x) { return x[2] - ToDouble(middle).z; }));
}

std::vector<ShapeAndOrder> ShapesAndOrders()
{
  std::vector<ShapeAndOrder> all;
  for (const Shape shape : kShapes)
  {
    for (int order = 2; order <= 8; ++order)
    {
      all.push_back({ shape, order });
    }
  }
  return all;
}
INSTANTIATE_TEST_SUITE_P(Shapes, ContourInOneElement, ::testing::ValuesIn(ShapesAndOrders()),
  [](const auto& tested)
  { return std::string(Name(tested.param.shape)) + std::to_string(tested.param.order); });

class ContourOnCurvedMesh : public ::testing::TestWithParam<Shape>
{
};

TEST_P(ContourOnCurvedMesh, Circle)
{
  const Shape shapes[] = { GetParam() };
  const CurvedMesh curved = Blocks(2, shapes);
  const Mesh mesh = curved.View();
  const auto f = [](const LongVec3& x) { return x[0] * x[0] + x[1] * x[1]; };
  const ExpansionBuilder values = FieldOf(mesh, 6, f);
  const PolynomialCut cut(ImplicitPolynomial::Plane({ 0.0, 0.0, 0.0625 }, { 0.0, 0.0, 1.0 }));
  const double radius = 0.625;
  const std::vector<double> levels{ radius * radius };
  const ContourSet set = ContoursOf(mesh, values, cut, levels, 1e-6);
  ExpectCircle(set, cut, radius);
  EXPECT_EQ(set.report.undecided, 0);
  EXPECT_EQ(set.report.unproven, 0);
  EXPECT_EQ(set.report.uncertified, 0);
  EXPECT_EQ(set.report.endsInside, 0);
  ExpectOnCurve(ErrorsOf(set, mesh, levels, f, [](const LongVec3& x) { return x[2] - 0.0625L; }));
}
INSTANTIATE_TEST_SUITE_P(Shapes, ContourOnCurvedMesh, ::testing::ValuesIn(kShapes),
  [](const auto& tested) { return std::string(Name(tested.param)); });

/// Far from the world's origin and small: what is lost are the digits of points, not those of xi.
TEST(Contour, SmallMeshesFarAway)
{
  for (const Shape shape : kShapes)
  {
    const Shape shapes[] = { shape };
    const Placement place{ { 0x1p-10L, 0x1p-10L, 0x1p-10L }, { 1000.0L, -2000.0L, 500.0L } };
    const CurvedMesh curved = Blocks(2, shapes, place);
    const Mesh mesh = curved.View();
    const auto f = [&place](const LongVec3& x)
    {
      const long double a = (x[0] - place.offset[0]) / place.scale[0];
      const long double b = (x[1] - place.offset[1]) / place.scale[1];
      return a * a + b * b;
    };
    const ExpansionBuilder values = FieldOf(mesh, 6, f);
    const PolynomialCut cut(
      ImplicitPolynomial::Plane({ 1000.0, -2000.0, 500.0 + 0x1p-14 }, { 0.0, 0.0, 1.0 }));
    const std::vector<double> levels{ 0.390625 };
    const ContourSet set = ContoursOf(mesh, values, cut, levels, 0x1p-30);
    ASSERT_EQ(set.lines.size(), 1U) << Name(shape);
    EXPECT_TRUE(set.lines[0].closed) << Name(shape);
    EXPECT_TRUE(set.lines[0].certified) << Name(shape);
    const VertexErrors errors =
      ErrorsOf(set, mesh, levels, f, [](const LongVec3& x) { return x[2] - 500.0L - 0x1p-14L; });
    EXPECT_LT(errors.value, 2e-13L) << Name(shape);
    EXPECT_LT(errors.cut, 0x1p-10L * 2e-14L) << Name(shape);
  }
}

MeshBuilder Stack(int count)
{
  MeshBuilder builder;
  for (int k = 0; k < count; ++k)
  {
    builder.Add(UniformSpace(Shape::Hexahedron, 1),
      [k](const LongVec3& xi) {
        return LongVec3{ xi[0], xi[1], xi[2] + 2.0L * k };
      },
      { 0.0, 0.0, 2.0 * k });
  }
  return builder;
}

TEST(Contour, SurfaceAlongAFaceIsDrawnOnce)
{
  const MeshBuilder builder = Stack(2);
  const Mesh mesh = builder.View();
  const auto f = [](const LongVec3& x) { return x[0] * x[0] + x[1] * x[1]; };
  const ExpansionBuilder values = FieldOf(mesh, 2, f);
  const PolynomialCut cut(ImplicitPolynomial::Plane({ 0.0, 0.0, 1.0 }, { 0.0, 0.0, 2.0 }));
  const ContourSet set = ContoursOf(mesh, values, cut, { 0.25 }, 1e-6);
  ExpectCircle(set, cut, 0.5);
  for (const ContourVertex& vertex : set.vertices)
  {
    EXPECT_EQ(vertex.element, 0);
  }
  // The contour that leaves the square is also found: four arcs from edge to edge.
  const ContourSet arcs = ContoursOf(mesh, values, cut, { 1.21 }, 1e-6);
  EXPECT_EQ(arcs.lines.size(), 4U);
}

/// A large hexahedron below z = 0 and four small ones above, one of them with the lowest number.
TEST(Contour, SurfaceAlongAHangingFaceIsDrawnOnce)
{
  MeshBuilder builder;
  const auto add = [&builder](double x, double y, double half, double z)
  {
    builder.Add(
      UniformSpace(Shape::Hexahedron, 1),
      [=](const LongVec3& xi) {
        return LongVec3{ x + half * xi[0], y + half * xi[1], z + half * xi[2] };
      },
      { x, y, z }, half);
  };
  add(-0.5, -0.5, 0.5, 0.5);
  add(0.0, 0.0, 1.0, -1.0);
  add(0.5, -0.5, 0.5, 0.5);
  add(-0.5, 0.5, 0.5, 0.5);
  add(0.5, 0.5, 0.5, 0.5);
  const Mesh mesh = builder.View();
  const ExpansionBuilder values = FieldOf(mesh, 2,
    [](const LongVec3& x)
    { return (x[0] - 0.1L) * (x[0] - 0.1L) + (x[1] - 0.05L) * (x[1] - 0.05L); });
  const PolynomialCut cut(ImplicitPolynomial::Plane({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }));
  const ContourSet set = ContoursOf(mesh, values, cut, { 0.25 }, 1e-6);
  ExpectCircle(set, cut, 0.5);
  EXPECT_EQ(set.report.uncertified, 0);
  for (const ContourVertex& vertex : set.vertices)
  {
    EXPECT_NE(vertex.element, 1);
  }
}

TEST(Contour, LinesThroughManyElements)
{
  const Shape shapes[] = { Shape::Hexahedron };
  const CurvedMesh curved = Blocks(3, shapes);
  const Mesh mesh = curved.View();
  const auto f = [](const LongVec3& x) { return x[0] + 2.0L * x[1]; };
  const ExpansionBuilder values = FieldOf(mesh, 3, f);
  const PolynomialCut cut(ImplicitPolynomial::Plane({ 0.0, 0.0, 0.1 }, { 0.0, 0.0, 1.0 }));
  const ContourSet set = ContoursOf(mesh, values, cut, { -0.4, 0.3 }, 1e-6);
  ASSERT_EQ(set.lines.size(), 2U);
  for (const ContourLine& line : set.lines)
  {
    EXPECT_FALSE(line.closed);
    EXPECT_TRUE(line.certified);
  }
  EXPECT_EQ(set.report.endsInside, 0);
}

TEST(Contour, LoopsCloserThanAnySampling)
{
  const MeshBuilder builder = Stack(1);
  const Mesh mesh = builder.View();
  // Two circles whose squared radii differ by 2 gap.
  for (const long double gap : { 1e-3L, 1e-5L })
  {
    const auto f = [](const LongVec3& x)
    {
      const long double g = x[0] * x[0] + x[1] * x[1] - 0.25L;
      return g * g;
    };
    const ExpansionBuilder values = FieldOf(mesh, 4, f);
    const PolynomialCut cut(ImplicitPolynomial::Plane({ 0.0, 0.0, 0.3 }, { 0.0, 0.0, 1.0 }));
    const ContourSet set = ContoursOf(mesh, values, cut, { static_cast<double>(gap * gap) }, 1e-5);
    ASSERT_EQ(set.lines.size(), 2U) << static_cast<double>(gap);
    double area = 0.0;
    for (const ContourLine& line : set.lines)
    {
      EXPECT_TRUE(line.closed);
      const double one = Measure(set, line, cut).area;
      area = area == 0.0 ? one : std::fabs(area - one);
    }
    EXPECT_NEAR(area, static_cast<double>(2.0L * gap) * kPi, 1e-10);
    EXPECT_EQ(set.report.uncertified, gap > 1e-4L ? 0 : 2);
  }
}

/// Disjoint lines that are closed or end at the boundary divide a square into one more region than
/// there are lines. The regions are counted by flooding pixels.
TEST(Contour, RandomFieldsHaveAsManyLinesAsRegions)
{
  constexpr int kPixels = 700;
  const MeshBuilder builder = Stack(1);
  const Mesh mesh = builder.View();
  for (int i = 0; i < 24; ++i)
  {
    const int order = 4 + i % 3;
    Random random(static_cast<std::uint64_t>(77 + i));
    ExpansionBuilder values = FieldOf(mesh, order, [](const LongVec3&) { return 0.0L; });
    for (double& coefficient : values.Coefficients)
    {
      coefficient = random();
    }
    const double z = -0.37 + 0.02 * i;
    const PolynomialCut cut(ImplicitPolynomial::Plane({ 0.0, 0.0, z }, { 0.0, 0.0, 1.0 }));
    const ContourSet set = ContoursOf(mesh, values, cut, { 0.05 }, 1e-3);
    const Field field{ "f", values.View() };
    EXPECT_EQ(set.lines.size() + 1, CountRegions(mesh, field, z, 0.05, kPixels)) << i;
    EXPECT_EQ(set.report.undecided, 0) << i;
    EXPECT_EQ(set.report.uncertified, 0) << i;
    EXPECT_EQ(set.report.endsInside, 0) << i;
  }
}

/// Lines that cut off a billionth of an element at its edge.
TEST(Contour, PiecesBesideAnEdge)
{
  const MeshBuilder builder = Stack(2);
  const Mesh mesh = builder.View();
  for (const double gap : { 1e-8, 1e-9, 8e-10, 1e-10, 1e-11, 1e-12, 1e-13 })
  {
    const ExpansionBuilder values =
      FieldOf(mesh, 1, [](const LongVec3& x) { return x[0] + 0.3L * x[2]; });
    const PolynomialCut cut(ImplicitPolynomial::Plane({ 0.0, 0.2, 0.0 }, { 0.0, 1.0, 0.0 }));
    // The contour passes (1 - gap, z = 1), in the lower element, which ends at the faces x = 1 and
    // z = 1.
    const ContourSet set = ContoursOf(mesh, values, cut, { 1.3 - gap, 1.3 + gap }, 1e-6);
    EXPECT_EQ(set.lines.size(), 2U) << gap;
    EXPECT_EQ(set.report.lost, 0) << gap;
    EXPECT_EQ(set.report.endsInside, 0) << gap;
  }
}

TEST(Contour, SaddleBesideItsValue)
{
  const MeshBuilder builder = Stack(1);
  const Mesh mesh = builder.View();
  const auto f = [](const LongVec3& x) { return (x[0] - 0.1L) * (x[1] + 0.2L); };
  const ExpansionBuilder values = FieldOf(mesh, 2, f);
  const PolynomialCut cut(ImplicitPolynomial::Plane({ 0.0, 0.0, 0.3 }, { 0.0, 0.0, 1.0 }));
  for (const double level : { 1e-9, -1e-9 })
  {
    const ContourSet set = ContoursOf(mesh, values, cut, { level }, 1e-6);
    ASSERT_EQ(set.lines.size(), 2U);
    for (const ContourLine& line : set.lines)
    {
      // A branch stays on one side of the saddle.
      const auto side = [&](std::int64_t id)
      { return set.vertices[static_cast<std::size_t>(id)].x.x > 0.1; };
      const bool first = side(line.vertices.front());
      for (const std::int64_t id : line.vertices)
      {
        EXPECT_EQ(side(id), first);
      }
      EXPECT_TRUE(line.certified);
    }
  }
  const ContourSet at = ContoursOf(mesh, values, cut, { 0.0 }, 1e-6);
  EXPECT_GT(at.report.undecided, 0);
  EXPECT_EQ(at.report.uncertified, static_cast<std::int64_t>(at.lines.size()));
}

TEST(Contour, EndsWhereTheFieldJumps)
{
  const MeshBuilder builder = Stack(2);
  const Mesh mesh = builder.View();
  ExpansionBuilder values(1);
  for (int e = 0; e < 2; ++e)
  {
    values.Add(UniformSpace(Shape::Hexahedron, 1),
      [e](const LongVec3& xi, long double* value) { *value = xi[0] + 1e-3L * e; });
  }
  const PolynomialCut cut(ImplicitPolynomial::Plane({ 0.0, 0.2, 0.0 }, { 0.0, 1.0, 0.0 }));
  const ContourSet set = ContoursOf(mesh, values, cut, { 0.25 }, 1e-6);
  EXPECT_EQ(set.lines.size(), 2U);
  EXPECT_EQ(set.report.endsInside, 2);
}

TEST(Contour, ConstantsAndWhatIsNoNumberAreTold)
{
  const MeshBuilder builder = Stack(2);
  const Mesh mesh = builder.View();
  ExpansionBuilder values =
    FieldOf(mesh, 2, [](const LongVec3& x) { return x[2] < 1.0L ? 0.5L : 0.5L; });
  const PolynomialCut cut(ImplicitPolynomial::Plane({ 0.0, 0.2, 0.0 }, { 0.0, 1.0, 0.0 }));
  const ContourSet constant = ContoursOf(mesh, values, cut, { 0.5 }, 1e-6);
  EXPECT_EQ(constant.report.constant, 2);
  EXPECT_TRUE(constant.lines.empty());
  values.Coefficients[0] = std::nan("");
  const ContourSet broken = ContoursOf(mesh, values, cut, { 0.5 }, 1e-6);
  EXPECT_EQ(broken.report.notFinite, 1);
  EXPECT_THROW(ContoursOf(mesh, values, cut, { std::nan("") }, 1e-6), InvalidData);
  EXPECT_THROW(ContoursOf(mesh, values, cut, { 0.5 }, 0.0), InvalidData);
}

/// NaN elements are reported for all values. Values that a magnitude cannot have are ignored.
TEST(Contour, WhatIsNoNumberIsToldWhateverTheValues)
{
  const MeshBuilder builder = Stack(2);
  const Mesh mesh = builder.View();
  ExpansionBuilder values(2);
  LongMap map(mesh);
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    values.Add(UniformSpace(mesh.ShapeOf(e), 2),
      [&](const LongVec3& xi, long double* v)
      {
        v[0] = map(e, xi)[0];
        v[1] = 1.0L;
      });
  }
  values.Coefficients[0] = std::nan("");
  const Field field{ "f", values.View() };
  const Locator locator(mesh);
  const FaceTable faces(locator.Index());
  const PolynomialCut cut(ImplicitPolynomial::Plane({ 0.0, 0.2, 0.0 }, { 0.0, 1.0, 0.0 }));
  for (const std::vector<double>& levels :
    { std::vector{ 0.0, 1.1 }, std::vector{ -1.0, 1.1 }, std::vector{ 1.1, 1.2 } })
  {
    const ContourSet set =
      TraceContours({ mesh, &field, -1, &cut }, locator, faces, { levels, 1e-6 });
    EXPECT_EQ(set.report.notFinite, 1) << levels[0];
    EXPECT_EQ(set.report.normsOfZero, levels[0] == 0.0 ? 1 : 0);
    EXPECT_FALSE(set.lines.empty());
  }
}

/// A quadric that does not return its polynomial.
class AnyCut final : public CutFunction
{
public:
  explicit AnyCut(const ImplicitPolynomial& form)
    : Form(form)
  {
  }
  void Values(std::span<const Vec3> x, std::span<double> values) const override
  {
    std::ranges::transform(
      x, values.begin(), [this](const Vec3& at) { return Form.ValueAround(at - Form.origin); });
  }
  void Gradients(std::span<const Vec3> x, std::span<Vec3> gradients) const override
  {
    std::ranges::transform(x, gradients.begin(),
      [this](const Vec3& at) { return Form.GradientAround(at - Form.origin); });
  }

private:
  ImplicitPolynomial Form;
};

TEST(Contour, QuadricsAndOtherFunctions)
{
  const Shape shapes[] = { Shape::Hexahedron, Shape::Prism };
  const CurvedMesh curved = Blocks(2, shapes);
  const Mesh mesh = curved.View();
  const ExpansionBuilder values = FieldOf(mesh, 3, [](const LongVec3& x) { return x[2]; });
  const auto ball = ImplicitPolynomial::Sphere({ 0.05, 0.0, -0.1 }, 0.7);
  const double radius = std::sqrt(0.49 - 0.25 * 0.25);
  const ContourSet exact = ContoursOf(mesh, values, PolynomialCut(ball), { 0.15 }, 1e-6);
  ASSERT_EQ(exact.lines.size(), 1U);
  EXPECT_TRUE(exact.lines[0].certified);
  EXPECT_NEAR(Measure(exact, exact.lines[0], PolynomialCut(ball)).length, 2.0 * kPi * radius, 1e-9);
  const ContourSet any = ContoursOf(mesh, values, AnyCut(ball), { 0.15 }, 1e-6);
  ASSERT_EQ(any.lines.size(), 1U);
  EXPECT_TRUE(any.lines[0].closed);
  EXPECT_FALSE(any.lines[0].certified);
  EXPECT_NEAR(Measure(any, any.lines[0], AnyCut(ball)).length, 2.0 * kPi * radius, 1e-9);
}

/// Where the field has the value on the whole surface, there is no line, and the report states it.
TEST(Contour, PlateausAreToldAndHaveNoLines)
{
  const MeshBuilder builder = Stack(1);
  const Mesh mesh = builder.View();
  const PolynomialCut plane(ImplicitPolynomial::Plane({ 0.0, 0.0, 0.25 }, { 0.0, 0.0, 1.0 }));
  const PolynomialCut slanted(ImplicitPolynomial::Plane({ 0.1, 0.2, 0.0 }, { 1.0, 2.0, 3.0 }));
  const PolynomialCut sphere(ImplicitPolynomial::Sphere(Vec3(0.0), std::sqrt(0.5)));
  struct Case
  {
    const CutFunction* cut;
    LongScalar f;
    double value;
  };
  for (const auto& [cut, f, value] : { Case{ &plane, [](const LongVec3& x) { return x[2]; }, 0.25 },
         Case{ &slanted, [](const LongVec3& x) { return 7 * (x[0] + 2 * x[1] + 3 * x[2]); }, 3.5 },
         Case{ &sphere, [](const LongVec3& x) { return Dot(x, x); }, 0.5 } })
  {
    for (const int order : { 2, 5, 8 })
    {
      const ContourSet set = ContoursOf(mesh, FieldOf(mesh, order, f), *cut, { value }, 1e-4);
      EXPECT_EQ(set.report.constant, 1) << order;
      EXPECT_TRUE(set.lines.empty()) << order;
    }
  }
  // A slightly different value has no lines, and is decided.
  const ContourSet beside = ContoursOf(
    mesh, FieldOf(mesh, 2, [](const LongVec3& x) { return x[2]; }), plane, { 0.25 + 1e-13 }, 1e-4);
  EXPECT_EQ(beside.report.constant, 0);
  EXPECT_TRUE(beside.lines.empty());
  EXPECT_EQ(beside.report.undecided, 0);
}

/// Chebyshev's T_8 has the value 1 at the ends and, touching it, at three places between.
TEST(Contour, LinesThatAreTouchedComeOnce)
{
  const auto t8 = [](long double x)
  {
    const long double t2 = 2 * x * x - 1;
    const long double t4 = 2 * t2 * t2 - 1;
    return 2 * t4 * t4 - 1;
  };
  const auto expectLines = [](const ContourSet& set, std::vector<double> places)
  {
    ASSERT_EQ(set.lines.size(), places.size());
    std::vector<double> found;
    for (const ContourLine& line : set.lines)
    {
      EXPECT_FALSE(line.closed);
      double least = 1.0;
      double most = -1.0;
      const double x = set.vertices[static_cast<std::size_t>(line.vertices.front())].x.x;
      for (const std::int64_t id : line.vertices)
      {
        const Vec3& at = set.vertices[static_cast<std::size_t>(id)].x;
        EXPECT_NEAR(at.x, x, 1e-7);
        least = std::min(least, at.y);
        most = std::max(most, at.y);
      }
      EXPECT_NEAR(least, -1.0, 1e-9);
      EXPECT_NEAR(most, 1.0, 1e-9);
      found.push_back(x);
    }
    std::ranges::sort(found);
    std::ranges::sort(places);
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      EXPECT_NEAR(found[k], places[k], 1e-7);
    }
    // The number of points is limited: a straight line needs few, and all open places lie on lines.
    EXPECT_LT(set.vertices.size(), 1000);
  };
  const MeshBuilder builder = Stack(1);
  const Mesh mesh = builder.View();
  const PolynomialCut cut(ImplicitPolynomial::Plane({ 0.0, 0.0, 0.25 }, { 0.0, 0.0, 1.0 }));
  const double half = std::sqrt(0.5);
  const ContourSet touched = ContoursOf(
    mesh, FieldOf(mesh, 8, [&](const LongVec3& x) { return t8(x[0]); }), cut, { 1.0 }, 1e-4);
  expectLines(touched, { -1.0, -half, 0.0, half, 1.0 });
  EXPECT_EQ(touched.report.touched, 3);
  EXPECT_GT(touched.report.undecided, 0);
  const ContourSet square = ContoursOf(mesh,
    FieldOf(mesh, 2, [](const LongVec3& x) { return (x[0] - 0.3L) * (x[0] - 0.3L); }), cut, { 0.0 },
    1e-4);
  expectLines(square, { 0.3 });
}

/// A touched circle is not followed, and a point that is touched is no line: both are undecided.
TEST(Contour, WhatIsTouchedAndNotFollowedIsUndecided)
{
  const MeshBuilder builder = Stack(1);
  const Mesh mesh = builder.View();
  const PolynomialCut cut(ImplicitPolynomial::Plane({ 0.0, 0.0, 0.25 }, { 0.0, 0.0, 1.0 }));
  const auto round = [](const LongVec3& x) { return x[0] * x[0] + x[1] * x[1] - 0.25L; };
  const ContourSet circle = ContoursOf(mesh,
    FieldOf(mesh, 4, [&](const LongVec3& x) { return round(x) * round(x); }), cut, { 0.0 }, 1e-6);
  EXPECT_TRUE(circle.lines.empty());
  EXPECT_EQ(circle.report.undecided, 1);
  const ContourSet point = ContoursOf(
    mesh, FieldOf(mesh, 2, [&](const LongVec3& x) { return round(x); }), cut, { -0.25 }, 1e-6);
  EXPECT_TRUE(point.lines.empty());
  EXPECT_EQ(point.report.undecided, 1);
}

/// A torus has an exact quartic, so its lines are certified as on a quadric.
TEST(Contour, LinesOnATorusAreCertified)
{
  const Shape shapes[] = { Shape::Hexahedron, Shape::Prism };
  const CurvedMesh curved = Blocks(2, shapes);
  const Mesh mesh = curved.View();
  const ExpansionBuilder values = FieldOf(mesh, 3, [](const LongVec3& x) { return x[2]; });
  const PolynomialCut torus(
    ImplicitPolynomial::Torus({ 0.05, 0.0, -0.1 }, { 0.0, 0.0, 2.0 }, 0.5, 0.25));
  const ContourSet set = ContoursOf(mesh, values, torus, { 0.05 }, 1e-6);
  ASSERT_EQ(set.lines.size(), 2U);
  EXPECT_EQ(set.report.uncertified, 0);
  EXPECT_EQ(set.report.undecided, 0);
  // At height 0.15 above the middle plane: circles of the radii 0.5 -+ 0.2.
  double length = 0.0;
  for (const ContourLine& line : set.lines)
  {
    EXPECT_TRUE(line.closed);
    length += Measure(set, line, torus).length;
  }
  EXPECT_NEAR(length, 2.0 * kPi * (0.3 + 0.7), 1e-8);
}

/// Contours of z = 0.15 on the faces of a box and on a disc: a rectangle of four lines, and a
/// chord.
TEST(Contour, LinesEndWhereClipsDo)
{
  const Shape shapes[] = { Shape::Hexahedron, Shape::Prism };
  const CurvedMesh curved = Blocks(2, shapes);
  const Mesh mesh = curved.View();
  const ExpansionBuilder values = FieldOf(mesh, 3, [](const LongVec3& x) { return x[2]; });
  const Field field{ "f", values.View() };
  const Locator locator(mesh);
  const FaceTable faces(locator.Index());
  const auto measure = [&](std::span<const SurfacePatch> patches)
  {
    const ContourSet set =
      TraceContours({ mesh, &field }, patches, locator, faces, { { 0.15 }, 1e-6 });
    EXPECT_EQ(set.report.uncertified + set.report.undecided + set.report.lost, 0);
    EXPECT_EQ(set.report.endsInside, 0);
    double length = 0.0;
    for (const ContourLine& line : set.lines)
    {
      length += Measure(set, line, PolynomialCut(patches[0].surface)).length;
    }
    return std::pair(set.lines.size(), length);
  };
  std::vector<ImplicitPolynomial> sides;
  for (int d = 0; d < 3; ++d)
  {
    for (const double sense : { -1.0, 1.0 })
    {
      Vec3 normal(0.0);
      normal[d] = sense;
      sides.push_back(ImplicitPolynomial::Plane(sense * Vec3(0.51, 0.43, 0.37), normal));
    }
  }
  for (const SurfacePatch& face : FacesOfBody(sides))
  {
    const auto [lines, length] = measure(std::span(&face, 1));
    const bool isAcross = face.surface.a.g.z == 0.0;
    EXPECT_EQ(lines, isAcross ? 1U : 0U);
    EXPECT_NEAR(length, !isAcross ? 0.0 : face.surface.a.g.x != 0.0 ? 0.86 : 1.02, 1e-9);
  }
  const SurfacePatch disc = DiscPatch({ 0.1, -0.05, 0.05 }, { 1.0, 1.0, 0.0 }, 0.5);
  const auto [lines, length] = measure(std::span(&disc, 1));
  EXPECT_EQ(lines, 1U);
  EXPECT_NEAR(length, 2.0 * std::sqrt(0.25 - 0.01), 1e-9);
}

/// A cut function without a value in a part of space.
class BrokenCut final : public CutFunction
{
public:
  void Values(std::span<const Vec3> x, std::span<double> values) const override
  {
    std::ranges::transform(x, values.begin(),
      [](const Vec3& at) { return at.x > 0.2 ? std::numeric_limits<double>::infinity() : at.y; });
  }
  void Gradients(std::span<const Vec3> /*x*/, std::span<Vec3> gradients) const override
  {
    std::ranges::fill(gradients, Vec3(0.0, 1.0, 0.0));
  }
};

TEST(Contour, FunctionsThatAreNotFinite)
{
  const Shape shapes[] = { Shape::Hexahedron };
  const CurvedMesh curved = Blocks(2, shapes);
  const Mesh mesh = curved.View();
  const ExpansionBuilder values = FieldOf(mesh, 3, [](const LongVec3& x) { return x[2]; });
  try
  {
    ContoursOf(mesh, values, BrokenCut(), { 0.15 }, 1e-6);
    FAIL() << "nothing was thrown";
  }
  catch (const InvalidData& error)
  {
    EXPECT_NE(std::string(error.what()).find("the cut function is inf at ("), std::string::npos)
      << error.what();
  }
}
} // namespace
} // namespace pixelexact::testing
