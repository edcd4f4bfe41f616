// SPDX-License-Identifier: BSD-3-Clause
// Gmsh's elements: where their nodes are, and which functions they have.
#include "GmshTexts.h"
#include "SolverModelViews.h"

#include "Formats/FileText.h"
#include "Formats/Gmsh/Basis.h"
#include "Formats/Gmsh/ElementType.h"

#include <filesystem>
#include <random>
#include <set>

namespace pixelexact::testing
{
namespace
{
using gmsh::ElementType;
using gmsh::FindType;

constexpr int kMaxTypes = 150;

SolverModel ReadData(const std::string& name)
{
  const std::string path = std::string(PIXELEXACT_DATA_DIR) + "/" + name + "/" + name + ".msh";
  const std::string text = ReadFileText(path);
  return gmsh::Read({ { path, text } });
}

/// Corners of our reference shapes in the order of VTK's linear cells, which is Gmsh's.
std::vector<Vec3> CornersOf(Shape shape)
{
  switch (shape)
  {
    case Shape::Hexahedron:
      return { { -1, -1, -1 }, { 1, -1, -1 }, { 1, 1, -1 }, { -1, 1, -1 }, { -1, -1, 1 },
        { 1, -1, 1 }, { 1, 1, 1 }, { -1, 1, 1 } };
    case Shape::Prism:
      return { { -1, 1, -1 }, { 1, 1, -1 }, { -1, 1, 1 }, { -1, -1, -1 }, { 1, -1, -1 },
        { -1, -1, 1 } };
    case Shape::Tetrahedron:
      return { { -1, -1, -1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } };
    default:
      return { { -1, -1, -1 }, { 1, -1, -1 }, { 1, 1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } };
  }
}

/// Points inside of a shape.
std::vector<Vec3> PointsIn(Shape shape, int count)
{
  std::mt19937 random(static_cast<unsigned>(shape) + 5);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  std::vector<Vec3> points;
  while (static_cast<int>(points.size()) < count)
  {
    const Vec3 xi(coordinate(random), coordinate(random), coordinate(random));
    if (Margin(shape, xi) >= 0.0)
    {
      points.push_back(xi);
    }
  }
  return points;
}

/// The place of a lattice node in xi.
LongVec3 NodeXi(Shape shape, const gmsh::Lattice& at, int order)
{
  const auto x = [&](int d) { return 2.0L * at[d] / order - 1; };
  return shape == Shape::Prism ? LongVec3{ x(0), -x(2), x(1) } : LongVec3{ x(0), x(1), x(2) };
}

/// A function of the element's space, other than the sum of its modes: (a + b xi1 + ...)^order
/// lies in the complete spaces of all shapes.
long double PowerOfPlane(const LongVec3& xi, int order)
{
  const long double plane = 0.3L + 0.4L * xi[0] - 0.25L * xi[1] + 0.35L * xi[2];
  long double power = 1.0L;
  for (int i = 0; i < order; ++i)
  {
    power *= plane;
  }
  return power;
}

double Apply(const ElementBasis& basis, const std::vector<double>& values, const Vec3& xi)
{
  const ChangeOfBasis& change = basis.parts[0];
  std::vector<double> canonical(static_cast<std::size_t>(change.Target().Modes()));
  change.Apply(values, 0.0, canonical);
  std::vector<long double> modes(canonical.size());
  EvaluateModes(change.Target(), { xi.x, xi.y, xi.z }, modes.data());
  long double sum = 0.0L;
  for (std::size_t m = 0; m < modes.size(); ++m)
  {
    sum += canonical[m] * modes[m];
  }
  return static_cast<double>(sum);
}
} // namespace

TEST(GmshElements, LatticesAreComplete)
{
  for (int number = 1; number < kMaxTypes; ++number)
  {
    const ElementType* type = FindType(number);
    if (type == nullptr || type->dimension != 3)
    {
      continue;
    }
    const auto nodes = gmsh::NodeOrder(type->shape, type->order);
    const std::set<gmsh::Lattice> different(nodes.begin(), nodes.end());
    EXPECT_EQ(different.size(), nodes.size()) << gmsh::Describe(number);
    EXPECT_EQ(type->complete, nodes.size() == static_cast<std::size_t>(type->nodes))
      << gmsh::Describe(number);
    for (const auto& node : nodes)
    {
      const LongVec3 xi = NodeXi(type->shape, node, type->order);
      EXPECT_GE(Margin(type->shape, Vec3(xi[0], xi[1], xi[2])), -1e-15) << gmsh::Describe(number);
    }
  }
}

TEST(GmshElements, EachFaceHasItsNumberInVtk)
{
  for (const Shape shape : { Shape::Tetrahedron, Shape::Hexahedron, Shape::Prism, Shape::Pyramid })
  {
    const auto& faces = gmsh::FacesOf(shape);
    std::set<int> numbers;
    for (const auto& face : faces)
    {
      numbers.insert(face.vtkFace);
    }
    EXPECT_EQ(numbers.size(), faces.size());
    EXPECT_EQ(*numbers.rbegin(), static_cast<int>(faces.size()) - 1);
  }
}

TEST(GmshElements, PolynomialsAreExact)
{
  for (int number = 1; number < kMaxTypes; ++number)
  {
    const ElementType* type = FindType(number);
    if (type == nullptr || type->dimension != 3 || !type->complete || type->order > 6)
    {
      continue;
    }
    const ElementBasis basis = gmsh::NodalBasis(*type);
    ASSERT_EQ(basis.sources, type->nodes);
    std::vector<double> values;
    for (const auto& node : gmsh::NodeOrder(type->shape, type->order))
    {
      values.push_back(
        static_cast<double>(PowerOfPlane(NodeXi(type->shape, node, type->order), type->order)));
    }
    for (const Vec3& xi : PointsIn(type->shape, 20))
    {
      const auto expected = static_cast<double>(PowerOfPlane({ xi.x, xi.y, xi.z }, type->order));
      EXPECT_NEAR(Apply(basis, values, xi), expected, 2e-13) << gmsh::Describe(number);
    }
  }
}

TEST(GmshElements, IncompleteElementsHaveTheQuadratics)
{
  for (const int number : { 17, 18, 19, 99, 100 })
  {
    const ElementType& type = *FindType(number);
    const ElementBasis basis = gmsh::NodalBasis(type);
    auto nodes = gmsh::NodeOrder(type.shape, type.order);
    nodes.resize(static_cast<std::size_t>(type.nodes));
    std::vector<double> values;
    for (const auto& node : nodes)
    {
      values.push_back(static_cast<double>(PowerOfPlane(NodeXi(type.shape, node, type.order), 2)));
    }
    for (const Vec3& xi : PointsIn(type.shape, 20))
    {
      EXPECT_NEAR(
        Apply(basis, values, xi), static_cast<double>(PowerOfPlane({ xi.x, xi.y, xi.z }, 2)), 1e-13)
        << gmsh::Describe(number);
    }
  }
  EXPECT_THROW(gmsh::NodalBasis(*FindType(32)), Unsupported);  // a tetrahedron of order 4
  EXPECT_THROW(gmsh::NodalBasis(*FindType(111)), Unsupported); // a prism of order 3
  EXPECT_THROW(gmsh::NodalBasis(*FindType(125)), Unsupported); // a pyramid of order 3
}

/// Gmsh placed the nodes of straight elements: the map must be the one between their corners.
TEST(GmshElements, GmshsOwnNodesAreWhereTheyShouldBe)
{
  const SolverModel model = ReadData("gmsh_straight_g6");
  ASSERT_EQ(model.mesh.number.size(), 4U);
  for (int e = 0; e < 4; ++e)
  {
    const Shape shape =
      model.mesh.map.spaces[static_cast<std::size_t>(model.mesh.map.spaceOf[e])].shape;
    const auto corners = CornersOf(shape);
    // Affine: from one corner along three edges.
    const std::array<std::size_t, 3> ends = shape == Shape::Hexahedron
      ? std::array<std::size_t, 3>{ 1, 3, 4 }
      : shape == Shape::Pyramid ? std::array<std::size_t, 3>{ 1, 3, 4 }
                                : std::array<std::size_t, 3>{ 1, 2, 3 };
    const Vec3 origin = PointAt(model, e, corners[0]);
    for (const Vec3& xi : PointsIn(shape, 50))
    {
      const Vec3 step = xi - corners[0];
      Vec3 expected = origin;
      for (const std::size_t end : ends)
      {
        const Vec3 edge = corners[end] - corners[0];
        const double part = (step.x * edge.x + step.y * edge.y + step.z * edge.z) / 4;
        expected += part * (PointAt(model, e, corners[end]) - origin);
      }
      const Vec3 x = PointAt(model, e, xi);
      for (int d = 0; d < 3; ++d)
      {
        EXPECT_NEAR(x[d], expected[d], 1e-14) << Name(shape);
      }
    }
  }
}

/// Curved neighbours of different shape have the same points on their common face.
TEST(GmshElements, NeighboursConform)
{
  const SolverModel model = ReadData("gmsh_zoo_g4");
  const auto find = [&model](Shape shape)
  {
    for (int e = 0; e < 4; ++e)
    {
      if (model.mesh.map.spaces[static_cast<std::size_t>(model.mesh.map.spaceOf[e])].shape == shape)
      {
        return e;
      }
    }
    return -1;
  };
  const int hexahedron = find(Shape::Hexahedron);
  const int pyramid = find(Shape::Pyramid);
  const int prism = find(Shape::Prism);
  const int tetrahedron = find(Shape::Tetrahedron);
  const auto expectSame = [&model](int a, const Vec3& xiA, int b, const Vec3& xiB)
  {
    const Vec3 x = PointAt(model, a, xiA);
    const Vec3 y = PointAt(model, b, xiB);
    for (int d = 0; d < 3; ++d)
    {
      EXPECT_NEAR(x[d], y[d], 1e-14);
    }
    EXPECT_NEAR(ValueAt(model, 0, a, xiA)[0], ValueAt(model, 0, b, xiB)[0], 1e-14);
  };
  for (const double a : { -0.9, -0.3, 0.1, 0.7 })
  {
    for (const double b : { -0.8, -0.2, 0.5, 0.95 })
    {
      expectSame(hexahedron, { a, b, 1 }, pyramid, { a, b, -1 });
      expectSame(hexahedron, { 1, a, b }, prism, { b, -a, -1 });
      const double r = (a + 1) / 2;
      const double s = (1 - r) * (b + 1) / 2;
      expectSame(
        tetrahedron, { 2 * r - 1, 2 * s - 1, -1 }, pyramid, { 1 - 2 * s, 2 * r - 1, 2 * s - 1 });
    }
  }
}
} // namespace pixelexact::testing
