// SPDX-License-Identifier: BSD-3-Clause
#include "MfemElements.h"

#include "Formats/MFEM/Elements/VectorUnknowns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace pixelexact::mfem
{
namespace
{
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
TEST(MfemCollection, VectorBasesReproduceLinearFields)
{
  const auto field = [](const auto& x)
  {
    return Point{ 1 + 2 * x[0] - x[1] + 3 * x[2], -2 + x[0] + 5 * x[1] - x[2],
      4 - 3 * x[0] + x[1] + 2 * x[2] };
  };
  for (const char* text :
    { "ND_3D_P2", "ND_3D_P4", "ND@Uo_3D_P2", "RT_3D_P1", "RT_3D_P3", "RT@co_3D_P2", "RT1_3D" })
  {
    const auto collection = Collection::Parse(text);
    const auto name = ParseCollectionName(text, 3);
    for (const Geometry solid : { Geometry::Tetrahedron, Geometry::Cube, Geometry::Prism })
    {
      if (!HasBasis(collection, solid))
      {
        continue;
      }
      std::vector<double> source;
      for (const VectorUnknown& unknown : VectorUnknowns(name, solid))
      {
        const Point v = field(unknown.node);
        source.push_back(static_cast<double>(
          std::inner_product(v.begin(), v.end(), unknown.direction.begin(), 0.0L)));
      }
      for (const auto& x : Inside(solid))
      {
        const Point value = UnitVector(collection, solid, source, x);
        for (int d = 0; d < 3; ++d)
        {
          EXPECT_NEAR(value[d], field(x)[d], 2e-13L) << text << " on " << int(solid);
        }
      }
    }
  }
}

TEST(MfemCollection, MixesAsWritten)
{
  const auto collection = Collection::Parse("ND_3D_P2");
  EXPECT_TRUE(collection.MixesTriangleUnknowns());
  EXPECT_FALSE(Collection::Parse("ND_3D_P1").MixesTriangleUnknowns());
  EXPECT_FALSE(Collection::Parse("RT_3D_P2").MixesTriangleUnknowns());
  // A triangle seen with corners (a, b, c) as (b, a, c): along a to b and a to c become a to b
  // backwards, and b to c.
  const std::array<double, 4> expected{ -1, 0, -1, 1 };
  EXPECT_EQ(collection.TriangleMixing(1), expected);
}

TEST(MfemCollection, RefusesOrdersThatWouldTakeTooLong)
{
  EXPECT_THROW((void)Collection::Parse("H1_3D_P30").Basis(Geometry::Tetrahedron), Unsupported);
  EXPECT_THROW((void)Collection::Parse("ND_3D_P20").Basis(Geometry::Prism), Unsupported);
  EXPECT_THROW((void)Collection::Parse("RT_3D_P9").Basis(Geometry::Pyramid), Unsupported);
  // (p + 1)^2 (p + 3) along the triangle, (p + 1) (p + 2)^2 / 2 across.
  EXPECT_EQ(Collection::Parse("RT_3D_P15").Basis(Geometry::Prism).sources, 6920);
  EXPECT_EQ(Collection::Parse("H1_3D_P32").Basis(Geometry::Cube).sources, 33 * 33 * 33);
}
} // namespace pixelexact::mfem
