// SPDX-License-Identifier: BSD-3-Clause
// Location against brute force on real meshes: Newton's iteration of its own, in long double, from
// many starts in every element that may hold the point. Of the locator nothing is used but its
// answers.
#include "Core/FaceCheck.h"
#include "Core/LongVectors.h"
#include "HighOrderModel.h"
#include "Support.h"

#include <tbb/parallel_for.h>

#include <gtest/gtest.h>

#include <memory>
#include <numbers>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

/// Starts along each direction of the tensor cube.
constexpr int kStarts = 4;
constexpr std::size_t kSteps = 30;
/// An iterate this near to one of another start's goes the same way.
constexpr long double kSame = 0.05L;
constexpr long double kFar = 3.0L;

/// The map's linear part at a xi.
struct Tangent
{
  LongVec3 xi;
  LongVec3 x;
  std::array<LongVec3, 3> columns;

  Tangent(LongMap& map, int element, const LongVec3& at)
    : xi(at)
    , x(map(element, at))
    , columns(map.Columns(element, at, x))
  {
  }

  /// Newton's step towards the preimage of `target`; not finite where there is none.
  [[nodiscard]] LongVec3 Step(const LongVec3& target) const
  {
    const LongVec3 r = Minus(target, x);
    const auto& [a, b, c] = columns;
    const LongVec3 bc = Cross(b, c);
    const long double determinant = Dot(a, bc);
    return { Dot(r, bc) / determinant, Dot(r, Cross(c, a)) / determinant,
      Dot(r, Cross(a, b)) / determinant };
  }
};

/// Data of an element that brute force computes before it searches for points.
class SearchedElement
{
public:
  LongVec3 lower; ///< of samples
  LongVec3 upper;
  std::vector<Tangent> starts;

  SearchedElement(LongMap& map, const Mesh& mesh, int element)
    : Centre(map, element, ToLong(pixelexact::Centre(mesh.ShapeOf(element))))
    , Faces(BoundingPlanesOf(mesh.ShapeOf(element)))
    , Least(Faces.size(), kInfinity)
  {
    const Space& space = mesh.map.SpaceOf(element);
    const auto samples = [&space](int d) { return kDensity * std::max<int>(1, space.order[d]); };
    const auto at = [&](int d, int i)
    { return std::cos(std::numbers::pi_v<long double> * (2 * i + 1) / (2 * samples(d))); };
    lower.fill(kInfinity);
    upper.fill(-kInfinity);
    std::vector<long double> most(Faces.size(), -kInfinity);
    for (int i = 0; i < samples(0); ++i)
    {
      for (int j = 0; j < samples(1); ++j)
      {
        for (int k = 0; k < samples(2); ++k)
        {
          const LongVec3 eta{ at(0, i), at(1, j), at(2, k) };
          const LongVec3 xi = LongReference(space.shape, eta);
          const LongVec3 x = map(element, xi);
          for (int d = 0; d < 3; ++d)
          {
            lower[d] = std::min(lower[d], x[d]);
            upper[d] = std::max(upper[d], x[d]);
          }
          const LongVec3 deviation = Minus(Straight(x), xi);
          for (std::size_t f = 0; f < Faces.size(); ++f)
          {
            const long double along = Along(Faces[f], deviation);
            Least[f] = std::min(Least[f], along);
            most[f] = std::max(most[f], along);
          }
        }
      }
    }
    // A polynomial of degree n is at most 1 / cos(n pi / (2 N)) times as large as at N > n
    // Chebyshev points (Ehlich and Zeller, 1964); the deviation is one in each eta.
    const long double growth =
      std::pow(std::cos(std::numbers::pi_v<long double> / (2 * kDensity)), -3.0L);
    for (std::size_t f = 0; f < Faces.size(); ++f)
    {
      Least[f] -= (growth - 1) * (most[f] - Least[f]) / 2;
    }
    for (int start = 0; start < kStarts * kStarts * kStarts; ++start)
    {
      const auto along = [](int i) { return (2.0L * i + 1.0L) / kStarts - 1.0L; };
      const LongVec3 eta{ along(start % kStarts), along(start / kStarts % kStarts),
        along(start / kStarts / kStarts) };
      starts.emplace_back(map, element, LongReference(space.shape, eta));
    }
  }

  /// False where every preimage of x, which is Straight(x) less the deviation there, is beyond a
  /// face by more than any tolerance.
  [[nodiscard]] bool MayHold(const LongVec3& x) const
  {
    const LongVec3 xi = Straight(x);
    bool may = true;
    for (std::size_t f = 0; f < Faces.size(); ++f)
    {
      may = may && Faces[f].offset + Along(Faces[f], xi) - Least[f] > -0.01L;
    }
    return may;
  }

private:
  static constexpr int kDensity = 3;
  static constexpr long double kInfinity = std::numeric_limits<long double>::infinity();

  /// The preimage of x were the element straight.
  [[nodiscard]] LongVec3 Straight(const LongVec3& x) const
  {
    return Plus(Centre.xi, Centre.Step(x));
  }

  static long double Along(const BoundingPlane& face, const LongVec3& v)
  {
    return face.normal[0] * v[0] + face.normal[1] * v[1] + face.normal[2] * v[2];
  }

  Tangent Centre;
  std::vector<BoundingPlane> Faces;
  std::vector<long double> Least; ///< of the deviation, along each face's normal
};

using SearchedElements = std::vector<std::unique_ptr<const SearchedElement>>;

/// Finds the preimages of points in an element.
class BruteForceSearch
{
public:
  BruteForceSearch(const Mesh& mesh, const SearchedElements& elements)
    : Elements(elements)
    , Map(mesh)
    , Oracle(mesh)
  {
  }

  /// The side of the preimage that is farthest inside.
  [[nodiscard]] Side Find(int element, const Vec3& point)
  {
    const LongVec3 x = ToLong(point);
    const SearchedElement& searched = *Elements[static_cast<std::size_t>(element)];
    if (!searched.MayHold(x))
    {
      return Side::Beyond;
    }
    std::vector<LongVec3> first;
    for (const Tangent& start : searched.starts)
    {
      const LongVec3 xi = Plus(start.xi, start.Step(x));
      // Skips starts that are further away, because others lead to the shape, and NaN.
      if (Largest(xi) < kFar)
      {
        first.push_back(xi);
      }
    }
    // Starts nearest to the shape's centre come first, because they find most preimages in the
    // shape.
    std::ranges::sort(first, {}, [](const LongVec3& xi) { return Largest(xi); });
    Side best = Side::Beyond;
    std::vector<LongVec3> visited;
    for (const LongVec3& start : first)
    {
      std::vector<LongVec3> path;
      LongVec3 xi = start;
      const auto isKnown = [&]
      {
        return std::ranges::any_of(
          visited, [&xi](const LongVec3& other) { return Largest(Minus(xi, other)) < kSame; });
      };
      while (path.size() < kSteps && Largest(xi) < kFar && !isKnown())
      {
        path.push_back(xi);
        const LongVec3 delta = Tangent(Map, element, xi).Step(x);
        xi = Plus(xi, delta);
        // The remaining error is quadratic in the correction, plus 1e-8 of it from the differences.
        if (Largest(delta) < 1e-9L)
        {
          best = std::min(best, Oracle.SideOf(element, xi));
          break;
        }
      }
      if (best == Side::Inside)
      {
        break;
      }
      visited.insert(visited.end(), path.begin(), path.end());
    }
    return best;
  }

  [[nodiscard]] bool Holds(int element, const Vec3& xi, const Vec3& x)
  {
    return Oracle.Holds(element, xi, x);
  }

private:
  const SearchedElements& Elements;
  LongMap Map;
  FaceOracle Oracle;
};

/// The true location of a point.
struct Truth
{
  int holder = -1;     ///< the lowest-numbered element with a preimage in the shape
  bool atFace = false; ///< an element before that one holds it by its tolerance alone
  bool answerHolds = false;
};

/// Points all over the mesh's box, and points a little inside and outside of faces.
std::vector<Vec3> MakePoints(const Mesh& mesh, const SearchedElements& elements)
{
  Random random(7);
  LongMap map(mesh);
  LongVec3 lower = elements[0]->lower;
  LongVec3 upper = elements[0]->upper;
  for (const auto& element : elements)
  {
    for (int d = 0; d < 3; ++d)
    {
      lower[d] = std::min(lower[d], element->lower[d]);
      upper[d] = std::max(upper[d], element->upper[d]);
    }
  }
  std::vector<Vec3> points;
  for (int i = 0; i < 2000; ++i)
  {
    Vec3 x;
    for (int d = 0; d < 3; ++d)
    {
      x[d] = random(static_cast<double>(lower[d]), static_cast<double>(upper[d]));
    }
    points.push_back(x);
  }
  for (long double distance = 1e-15L; distance < 0.5L; distance *= 10.0L)
  {
    for (int i = 0; i < 140; ++i)
    {
      const auto element = static_cast<int>(random(0.0, mesh.Elements()));
      LongVec3 eta{ random(), random(), random() };
      const auto direction = static_cast<std::size_t>(random(0.0, 3.0));
      // Three in four outside.
      const long double at = i % 4 == 0 ? 1 - distance : 1 + distance;
      eta[direction] = random() < 0.0 ? -at : at;
      points.push_back(ToDouble(map(element, LongReference(mesh.ShapeOf(element), eta))));
    }
  }
  return points;
}

class BruteForce : public ::testing::TestWithParam<const char*>
{
};

TEST_P(BruteForce, AgreesOnInsideAndOutside)
{
  const auto grid = Converted(ReadGrid(std::filesystem::path(PIXELEXACT_DATA_DIR) / GetParam()));
  const auto model = HighOrderModel::From(grid);
  const Mesh& mesh = model->GetMesh();
  SearchedElements elements(static_cast<std::size_t>(mesh.Elements()));
  tbb::parallel_for(0, mesh.Elements(),
    [&](int e)
    {
      LongMap map(mesh);
      elements[static_cast<std::size_t>(e)] = std::make_unique<SearchedElement>(map, mesh, e);
    });
  const auto points = MakePoints(mesh, elements);
  std::vector<Verdict> verdict(points.size());
  std::vector<std::int32_t> element(points.size());
  std::vector<Vec3> xi(points.size());
  SampleTarget target;
  target.verdict = verdict;
  target.element = element;
  target.xi = xi;
  Sample(model->GetLocator(), nullptr, points, target);

  std::vector<Truth> truth(points.size());
  constexpr std::size_t kRun = 64;
  tbb::parallel_for(std::size_t{ 0 }, (points.size() + kRun - 1) / kRun,
    [&](std::size_t run)
    {
      BruteForceSearch search(mesh, elements);
      for (std::size_t i = run * kRun; i < std::min((run + 1) * kRun, points.size()); ++i)
      {
        for (int e = 0; e < mesh.Elements() && truth[i].holder < 0; ++e)
        {
          const Side side = search.Find(e, points[i]);
          truth[i].holder = side == Side::Inside ? e : -1;
          truth[i].atFace = truth[i].atFace || side == Side::AtFace;
        }
        truth[i].answerHolds =
          verdict[i] == Verdict::Inside && search.Holds(element[i], xi[i], points[i]);
      }
    });
  int inside = 0;
  int outside = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto& [holder, atFace, answerHolds] = truth[i];
    ASSERT_NE(verdict[i], Verdict::Unknown) << i;
    if (holder >= 0)
    {
      ++inside;
      ASSERT_EQ(verdict[i], Verdict::Inside) << "point " << i << ", held by element " << holder;
      EXPECT_LE(element[i], holder) << "point " << i;
    }
    else if (!atFace)
    {
      ++outside;
      EXPECT_EQ(verdict[i], Verdict::Outside) << "point " << i;
    }
    if (verdict[i] == Verdict::Inside)
    {
      EXPECT_TRUE(answerHolds) << "point " << i << ", element " << element[i];
    }
  }
  EXPECT_GT(inside, 1000);
  EXPECT_GT(outside, 200);
  EXPECT_GT(inside + outside, static_cast<int>(points.size()) * 9 / 10);
}

INSTANTIATE_TEST_SUITE_P(Data, BruteForce,
  ::testing::Values("toroid_hex_g3_p6.vtu", "escher_tet_g3_p3.vtu", "toroid_prism_g3_p4.vtu",
    "fichera_hex_g3_p4.vtu", "periodic_hex_dg_g3_p4.vtu", "dolfinx_hex_g2_p4.vtu"),
  [](const auto& file)
  {
    std::string name = file.param;
    return name.substr(0, name.find('.'));
  });
} // namespace
