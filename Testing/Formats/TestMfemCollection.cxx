// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Collection.h"

#include "Core/Base/Error.h"
#include "Core/Basis/BasisFactor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

// Values of MFEM's bases at points of its unit elements, by way of the canonical coefficients.
namespace pixelexact::mfem
{
namespace
{
using Point = std::array<long double, 3>;

constexpr std::array kSolids{ Geometry::Tetrahedron, Geometry::Cube, Geometry::Prism,
  Geometry::Pyramid };

LongVec3 ToXi(Geometry solid, const Point& x)
{
  if (solid == Geometry::Prism)
  {
    return { 2 * x[0] - 1, 1 - 2 * x[2], 2 * x[1] - 1 };
  }
  return { 2 * x[0] - 1, 2 * x[1] - 1, 2 * x[2] - 1 };
}

/// Points inside of the unit element, of no symmetry.
std::vector<Point> Inside(Geometry solid)
{
  std::vector<Point> points;
  for (int i = 0; i < 7; ++i)
  {
    Point x{ 0.11L + 0.12L * i, 0.87L - 0.11L * i, 0.09L + 0.117L * ((3 * i) % 7) };
    if (solid == Geometry::Tetrahedron || solid == Geometry::Pyramid)
    {
      x[0] *= 1 - x[2];
      x[1] *= 1 - x[2];
    }
    if (solid == Geometry::Tetrahedron || solid == Geometry::Prism)
    {
      x[0] *= 1 - x[1] / (solid == Geometry::Prism ? 1 : 1 - x[2]);
    }
    points.push_back(x);
  }
  return points;
}

/// One part's value for given source coefficients.
long double Value(
  const ChangeOfBasis& part, Geometry solid, const std::vector<double>& source, const Point& x)
{
  const int modes = part.Target().Modes();
  std::vector<double> canonical(modes);
  part.Apply(source, 0.0, canonical);
  std::vector<long double> mode(modes);
  EvaluateModes(part.Target(), ToXi(solid, x), mode.data());
  return std::inner_product(mode.begin(), mode.end(), canonical.begin(), 0.0L);
}

std::vector<double> Unit(int n, int at)
{
  std::vector<double> unit(n, 0.0);
  unit[at] = 1.0;
  return unit;
}

std::vector<Point> Vertices(Geometry solid)
{
  switch (solid)
  {
    case Geometry::Tetrahedron:
      return { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    case Geometry::Cube:
      return { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
        { 1, 1, 1 }, { 0, 1, 1 } };
    case Geometry::Prism:
      return { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 0, 1, 1 } };
    default:
      return { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  }
}

/// MFEM's edges.
std::vector<std::array<int, 2>> Edges(Geometry solid)
{
  switch (solid)
  {
    case Geometry::Tetrahedron:
      return { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };
    case Geometry::Cube:
      return { { 0, 1 }, { 1, 2 }, { 3, 2 }, { 0, 3 }, { 4, 5 }, { 5, 6 }, { 7, 6 }, { 4, 7 },
        { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } };
    case Geometry::Prism:
      return { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 3, 4 }, { 4, 5 }, { 5, 3 }, { 0, 3 }, { 1, 4 },
        { 2, 5 } };
    default:
      return { { 0, 1 }, { 1, 2 }, { 3, 2 }, { 0, 3 }, { 0, 4 }, { 1, 4 }, { 2, 4 }, { 3, 4 } };
  }
}

/// MFEM's faces.
std::vector<std::vector<int>> Faces(Geometry solid)
{
  switch (solid)
  {
    case Geometry::Tetrahedron:
      return { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };
    case Geometry::Cube:
      return { { 3, 2, 1, 0 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 0, 4, 7 },
        { 4, 5, 6, 7 } };
    case Geometry::Prism:
      return { { 0, 2, 1 }, { 3, 4, 5 }, { 0, 1, 4, 3 }, { 1, 2, 5, 4 }, { 2, 0, 3, 5 } };
    default:
      return { { 3, 2, 1, 0 }, { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 } };
  }
}

Geometry FaceGeometry(const std::vector<int>& face)
{
  return face.size() == 3 ? Geometry::Triangle : Geometry::Square;
}

/// The unknowns of an element by its entities.
int Counted(const Collection& collection, Geometry solid)
{
  int sum = collection.Unknowns(solid) +
    static_cast<int>(Vertices(solid).size()) * collection.Unknowns(Geometry::Point) +
    static_cast<int>(Edges(solid).size()) * collection.Unknowns(Geometry::Segment);
  for (const auto& face : Faces(solid))
  {
    sum += collection.Unknowns(FaceGeometry(face));
  }
  return sum;
}

bool HasBasis(const Collection& collection, Geometry solid)
{
  try
  {
    return collection.Basis(solid).sources > 0;
  }
  catch (const Unsupported&)
  {
    return false;
  }
}
} // namespace

TEST(MfemCollection, CountsUnknownsByEntities)
{
  for (const char* name : { "H1_3D_P1", "H1_3D_P2", "H1_3D_P5", "H1Pos_3D_P4", "H1@U_3D_P3",
         "L2_3D_P0", "L2_3D_P3", "L2_T2_3D_P2", "Linear", "Quadratic", "Cubic", "Const3D",
         "LinearDiscont3D", "QuadraticDiscont3D", "ND_3D_P1", "ND_3D_P2", "ND_3D_P3", "RT_3D_P0",
         "RT_3D_P1", "RT_3D_P2", "ND1_3D", "RT0_3D", "RT1_3D", "H1_3D_P4_Pyr0", "L2_3D_P2_Pyr0" })
  {
    const auto collection = Collection::Parse(name);
    for (const Geometry solid : kSolids)
    {
      if (HasBasis(collection, solid))
      {
        EXPECT_EQ(collection.Basis(solid).sources, Counted(collection, solid)) << name;
      }
    }
  }
}

TEST(MfemCollection, ScalarBasesSumToOne)
{
  for (const char* name : { "H1_3D_P1", "H1_3D_P3", "H1_3D_P6", "H1Pos_3D_P4", "H1@U_3D_P3",
         "H1@c_3D_P5", "L2_3D_P0", "L2_3D_P3", "L2_T1_3D_P4", "L2_T2_3D_P3", "L2_T3_3D_P2",
         "L2_T4_3D_P2", "L2_T5_3D_P2", "L2_T7_3D_P3", "Linear", "Quadratic", "Cubic", "Const3D",
         "LinearDiscont3D", "QuadraticDiscont3D" })
  {
    const auto collection = Collection::Parse(name);
    for (const Geometry solid : kSolids)
    {
      if (!HasBasis(collection, solid))
      {
        continue;
      }
      const auto& basis = collection.Basis(solid);
      const std::vector<double> ones(basis.sources, 1.0);
      for (const auto& x : Inside(solid))
      {
        EXPECT_NEAR(Value(basis.parts[0], solid, ones, x), 1.0L, 1e-13L) << name;
      }
    }
  }
}

TEST(MfemCollection, NodesOfOrderThreeFollowEntities)
{
  // Gauss-Lobatto points of order 3 on [0,1], and the thirds.
  const long double gl = (1 - 1 / std::sqrt(5.0L)) / 2;
  for (const auto& [name, a] : { std::pair{ "H1_3D_P3", gl }, std::pair{ "H1@U_3D_P3", 1 / 3.0L },
         std::pair{ "Cubic", 1 / 3.0L } })
  {
    const auto collection = Collection::Parse(name);
    for (const Geometry solid : kSolids)
    {
      if (!HasBasis(collection, solid))
      {
        continue;
      }
      const auto& basis = collection.Basis(solid);
      const auto vertices = Vertices(solid);
      std::vector<Point> nodes = vertices;
      const auto between = [&](const std::vector<std::pair<int, long double>>& weights)
      {
        Point x{};
        for (const auto& [vertex, weight] : weights)
        {
          for (int d = 0; d < 3; ++d)
          {
            x[d] += weight * vertices[vertex][d];
          }
        }
        nodes.push_back(x);
      };
      for (const auto& [from, to] : Edges(solid))
      {
        between({ { from, 1 - a }, { to, a } });
        between({ { from, a }, { to, 1 - a } });
      }
      for (const auto& f : Faces(solid))
      {
        if (f.size() == 3)
        {
          between({ { f[0], 1 / 3.0L }, { f[1], 1 / 3.0L }, { f[2], 1 / 3.0L } });
          continue;
        }
        for (const long double v : { a, 1 - a })
        {
          for (const long double u : { a, 1 - a })
          {
            between({ { f[0], (1 - u) * (1 - v) }, { f[1], u * (1 - v) }, { f[2], u * v },
              { f[3], (1 - u) * v } });
          }
        }
      }
      for (std::size_t n = 0; n < nodes.size(); ++n)
      {
        for (std::size_t k = 0; k < nodes.size(); ++k)
        {
          EXPECT_NEAR(Value(basis.parts[0], solid, Unit(basis.sources, int(n)), nodes[k]),
            n == k ? 1 : 0, 1e-13L)
            << name << " on " << int(solid) << ", unknown " << n << " at node " << k;
        }
      }
    }
  }
}

TEST(MfemCollection, DiscontinuousNodesLieLexicographically)
{
  const auto collection = Collection::Parse("L2_3D_P1");
  const long double a = (1 - 1 / std::sqrt(3.0L)) / 2;
  const std::vector<double> linear{ 0, 1, 10, 11, 100, 101, 110, 111 };
  const auto& cube = collection.Basis(Geometry::Cube);
  const Point at{ a, 1 - a, 1 - a };
  EXPECT_NEAR(Value(cube.parts[0], Geometry::Cube, linear, at), 110, 1e-12L);
  // A tetrahedron's nodes: barycentric in proportion to a, a, a and 1 - a.
  const auto& tetrahedron = collection.Basis(Geometry::Tetrahedron);
  const long double sum = 1 + 2 * a;
  const Point second{ (1 - a) / sum, a / sum, a / sum };
  EXPECT_NEAR(Value(tetrahedron.parts[0], Geometry::Tetrahedron, Unit(4, 1), second), 1, 1e-13L);
  EXPECT_NEAR(Value(tetrahedron.parts[0], Geometry::Tetrahedron, Unit(4, 0), second), 0, 1e-13L);
}

TEST(MfemCollection, BernsteinCoefficientsOfCoordinatesAreTheirLattice)
{
  const auto collection = Collection::Parse("L2_T2_3D_P3");
  const auto& basis = collection.Basis(Geometry::Prism);
  std::vector<double> source;
  for (int k = 0; k <= 3; ++k)
  {
    for (int j = 0; j <= 3; ++j)
    {
      for (int i = 0; i + j <= 3; ++i)
      {
        source.push_back((i + 10 * j + 100 * k) / 3.0);
      }
    }
  }
  for (const auto& x : Inside(Geometry::Prism))
  {
    EXPECT_NEAR(
      Value(basis.parts[0], Geometry::Prism, source, x), x[0] + 10 * x[1] + 100 * x[2], 1e-12L);
  }
}

TEST(MfemCollection, DensitiesAreScaledToTheUnitElement)
{
  const auto collection = Collection::Parse("L2Int_3D_P1");
  EXPECT_EQ(collection.GetMapping(), Mapping::Density);
  for (const Geometry solid : kSolids)
  {
    const auto& basis = collection.Basis(solid);
    EXPECT_NEAR(
      Value(basis.parts[0], solid, std::vector<double>(basis.sources, 1.0), Inside(solid).front()),
      0.125L, 1e-14L);
  }
}

TEST(MfemCollection, OrdersOfOrientationsAreSignedPermutations)
{
  for (const char* name : { "H1_3D_P5", "ND_3D_P3", "RT_3D_P2", "Cubic", "RT1_3D" })
  {
    const auto collection = Collection::Parse(name);
    for (const auto& [geometry, orientations] :
      { std::pair{ Geometry::Triangle, 6 }, std::pair{ Geometry::Square, 8 } })
    {
      for (int o = 0; o < orientations; ++o)
      {
        std::set<int> seen;
        for (const int n : collection.UnknownOrder(geometry, o))
        {
          seen.insert(n < 0 ? -1 - n : n);
        }
        EXPECT_EQ(static_cast<int>(seen.size()), collection.Unknowns(geometry));
        EXPECT_TRUE(seen.empty() || *seen.rbegin() + 1 == collection.Unknowns(geometry));
      }
    }
  }
}

TEST(MfemCollection, OrdersAreThoseOfMfemsTables)
{
  const auto order = [](const char* name, Geometry geometry, int o)
  {
    const auto collection = Collection::Parse(name);
    const auto span = collection.UnknownOrder(geometry, o);
    return std::vector<int>(span.begin(), span.end());
  };
  // Written out in the sources of MFEM's legacy collections.
  EXPECT_EQ(order("Cubic", Geometry::Segment, -1), (std::vector{ 1, 0 }));
  EXPECT_EQ(order("Cubic", Geometry::Square, 2), (std::vector{ 2, 0, 3, 1 }));
  EXPECT_EQ(order("Cubic", Geometry::Square, 5), (std::vector{ 3, 1, 2, 0 }));
  EXPECT_EQ(order("RT1_3D", Geometry::Square, 1), (std::vector{ -1, -3, -2, -4 }));
  EXPECT_EQ(order("RT1_3D", Geometry::Square, 6), (std::vector{ 1, 3, 0, 2 }));
  EXPECT_EQ(order("RT1_3D", Geometry::Square, 7), (std::vector{ -3, -4, -1, -2 }));
  EXPECT_EQ(order("RT0_3D", Geometry::Triangle, 3), (std::vector{ -1 }));
  EXPECT_EQ(order("ND1_3D", Geometry::Segment, -1), (std::vector{ -1 }));
}

TEST(MfemCollection, RefusesWithRemedy)
{
  for (const char* name : { "NURBS2", "H1_Trace_3D_P2", "H1_2D_P2", "H1Ser_3D_P2", "RT_R2D_2D_P1",
         "H1@g_3D_P2", "L2_T8_3D_P1", "H1_3D_P99", "Const2D", "ND_2D_P1", "H1_3D_P2_Pyr7" })
  {
    EXPECT_THROW((void)Collection::Parse(name), Unsupported) << name;
  }
  for (const char* name : { "", "H1", "H1_", "H1_3D", "H1_3D_P", "H1_3D_P2x", "H1_3D_P0",
         "H1_3D_P-1", "H1_3D_P99999999999999999999", "H1@", "L2_T99_3D_P1", "Linear ", "bogus",
         "ND_3D_P0", "RT@GZ_3D_P1" })
  {
    EXPECT_THROW((void)Collection::Parse(name), InvalidData) << name;
  }
}
} // namespace pixelexact::mfem
