// SPDX-License-Identifier: BSD-3-Clause
// How far triangles and Bezier patches are off chords.
#include "ChordCheck.h"
#include "Solids.h"

#include "Trace/Surfaces/BezierPatches.h"
#include "Trace/Surfaces/Disc.h"

#include <array>
#include <limits>
#include <vector>

namespace pixelexact::testing
{
namespace
{
double SagittaOf(const Surface& surface, const Ray& a, const Ray& b)
{
  const auto from = FirstHit(surface, a);
  const auto to = FirstHit(surface, b);
  EXPECT_TRUE(from && to);
  return from && to ? surface.Sagitta(a, *from, b, *to) : std::nan("");
}

/// The side of a convex body, from its triangles' planes.
LongSide ConvexSide(const std::vector<Triangles::Triangle>& all)
{
  struct Face
  {
    LongVec3 point;
    LongVec3 normal;
  };
  std::vector<Face> faces;
  for (const auto& [a, b, c] : all)
  {
    const LongVec3 p = ToLong(a);
    const LongVec3 normal = Unit(Cross(Minus(ToLong(b), p), Minus(ToLong(c), p)));
    faces.push_back({ p, Dot(normal, p) < 0 ? Times(-1, normal) : normal });
  }
  return [faces](const LongVec3& x)
  {
    long double largest = -1e30L;
    for (const Face& face : faces)
    {
      largest = std::max(largest, Dot(face.normal, Minus(x, face.point)));
    }
    return largest;
  };
}

/// Heights at the corners of n x n squares of [-1.2, 1.2]^2, each cut in two triangles.
class Terrain
{
public:
  explicit Terrain(int n)
    : N(n)
  {
    Random random(31);
    for (int i = 0; i < (n + 1) * (n + 1); ++i)
    {
      Heights.push_back(0.15 * random());
    }
  }

  [[nodiscard]] Vec3 Corner(int i, int j) const
  {
    return { Place(i), Place(j),
      Heights[static_cast<std::size_t>(i) * (static_cast<std::size_t>(N) + 1) +
        static_cast<std::size_t>(j)] };
  }
  [[nodiscard]] std::vector<Triangles::Triangle> All() const
  {
    std::vector<Triangles::Triangle> all;
    for (int i = 0; i < N; ++i)
    {
      for (int j = 0; j < N; ++j)
      {
        all.push_back({ Corner(i, j), Corner(i + 1, j), Corner(i + 1, j + 1) });
        all.push_back({ Corner(i, j), Corner(i + 1, j + 1), Corner(i, j + 1) });
      }
    }
    return all;
  }
  [[nodiscard]] long double Side(const LongVec3& x) const
  {
    const auto cell = [&](long double at)
    {
      int i = 0;
      while (i + 1 < N && Place(i + 1) < at)
      {
        ++i;
      }
      return i;
    };
    const int i = cell(x[0]);
    const int j = cell(x[1]);
    const LongVec3 p = ToLong(Corner(i, j));
    const LongVec3 q = ToLong(Corner(i + 1, j + 1));
    const long double u = (x[0] - p[0]) / (q[0] - p[0]);
    const long double v = (x[1] - p[1]) / (q[1] - p[1]);
    const LongVec3 third = ToLong(u > v ? Corner(i + 1, j) : Corner(i, j + 1));
    const long double height = u > v ? p[2] + u * (third[2] - p[2]) + v * (q[2] - third[2])
                                     : p[2] + v * (third[2] - p[2]) + u * (q[2] - third[2]);
    return x[2] - height;
  }

private:
  [[nodiscard]] double Place(int i) const { return 2.4 * i / N - 1.2; }

  int N;
  std::vector<double> Heights;
};

/// The point of a Bezier curve, by de Casteljau's algorithm.
template <class PointAt>
long double CurveAt(int degree, const PointAt& pointAt, long double s, long double* slope = nullptr)
{
  std::array<long double, 10> points;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(degree); ++k)
  {
    points[k] = pointAt(static_cast<int>(k));
  }
  for (auto level = static_cast<std::size_t>(degree); level > 0; --level)
  {
    if (level == 1 && slope)
    {
      *slope = degree * (points[1] - points[0]);
    }
    for (std::size_t k = 0; k < level; ++k)
    {
      points[k] += s * (points[k + 1] - points[k]);
    }
  }
  return points[0];
}

/// 2 x 2 patches over [-1.2, 1.2]^2: x depends on u alone, y on v alone, by curves that bend; of
/// any heights.
class Hills
{
public:
  Hills(int n, int m, double height)
    : Degree{ n, m }
  {
    Random random(41);
    for (int i = 0; i <= 2 * n; ++i)
    {
      for (int j = 0; j <= 2 * m; ++j)
      {
        Heights.push_back(height * random());
      }
    }
    for (int d = 0; d < 2; ++d)
    {
      for (int k = 0; k <= 2 * Degree[d]; ++k)
      {
        const bool isEnd = k % Degree[d] == 0;
        Places[d].push_back(
          1.2 * (k - Degree[d]) / Degree[d] + (isEnd ? 0.0 : 0.3 / Degree[d] * random()));
      }
    }
  }

  [[nodiscard]] std::vector<BezierPatch> All() const
  {
    std::vector<BezierPatch> all;
    for (int p = 0; p < 4; ++p)
    {
      BezierPatch patch{ { Degree[0], Degree[1] }, {} };
      for (int i = 0; i <= Degree[0]; ++i)
      {
        for (int j = 0; j <= Degree[1]; ++j)
        {
          const int at[2] = { (p / 2) * Degree[0] + i, (p % 2) * Degree[1] + j };
          patch.points.emplace_back(Places[0][static_cast<std::size_t>(at[0])],
            Places[1][static_cast<std::size_t>(at[1])], Height(at[0], at[1]));
        }
      }
      all.push_back(patch);
    }
    return all;
  }

  [[nodiscard]] long double Side(const LongVec3& x) const
  {
    int begin[2];
    long double at[2];
    for (int d = 0; d < 2; ++d)
    {
      const auto axis = static_cast<std::size_t>(d);
      begin[d] = x[axis] > 0 ? Degree[d] : 0;
      at[d] = 0.5L;
      for (int step = 0; step < 12; ++step)
      {
        long double slope = 0;
        const long double place = CurveAt(
          Degree[d],
          [&](int k)
          { return Places[d][static_cast<std::size_t>(begin[d]) + static_cast<std::size_t>(k)]; },
          at[d], &slope);
        at[d] += (x[axis] - place) / slope;
      }
    }
    const auto row = [&](int i)
    {
      return CurveAt(
        Degree[1], [&](int j) { return Height(begin[0] + i, begin[1] + j); }, at[1]);
    };
    return x[2] - CurveAt(Degree[0], row, at[0]);
  }

private:
  [[nodiscard]] double Height(int i, int j) const
  {
    return Heights[static_cast<std::size_t>(i) * (2 * static_cast<std::size_t>(Degree[1]) + 1) +
      static_cast<std::size_t>(j)];
  }

  int Degree[2];
  std::vector<double> Heights;
  std::vector<double> Places[2];
};
} // namespace

TEST(SagittaOfTriangles, HoldsSignsInLongDouble)
{
  const auto ball = Ball(2);
  const Triangles ofBall(ball);
  EXPECT_TRUE(ofBall.HasSagitta());
  const ChordTally round = CheckChords(ofBall, ConvexSide(ball), 32);
  round.Tell("ball");
  EXPECT_GT(round.closeKnown, 0.97 * round.close);
  EXPECT_GT(round.tight, 0.97 * round.closeKnown);
  const Terrain terrain(12);
  const Triangles ofTerrain(terrain.All());
  const ChordTally rough = CheckChords(
    ofTerrain, [&](const LongVec3& x) { return terrain.Side(x); }, 33);
  rough.Tell("terrain");
  EXPECT_GT(rough.known, 1000);
  EXPECT_GT(rough.closeKnown, 0.97 * rough.close);
  EXPECT_GT(rough.tight, 0.97 * rough.closeKnown);
}

/// Two triangles that share an edge differ from the chord by the edge's distance. Where they share
/// none, three share one, or one hides behind the other, there is no bound.
TEST(SagittaOfTriangles, OfACrease)
{
  const Vec3 p(0.0, -1.0, 0.5);
  const Vec3 q(0.0, 1.0, 0.5);
  const Vec3 left(-1.0, 0.0, 0.0);
  const Vec3 right(1.0, 0.0, 0.0);
  const Vec3 down(0.0, 0.0, -1.0);
  const Ray a{ Vec3(-0.01, 0.1, 3.0), down };
  const Ray b{ Vec3(0.01, 0.1, 3.0), down };
  EXPECT_NEAR(SagittaOf(Triangles({ { p, q, left }, { q, right, p } }), a, b), 0.005, 1e-11);
  const Vec3 moved(0.0, 1.0, 0.5 + 1e-15);
  EXPECT_FALSE(std::isfinite(SagittaOf(Triangles({ { p, q, left }, { moved, right, p } }), a, b)));
  // Among three triangles, the one with the other hit.
  const Vec3 below(0.0, 0.0, -1.0);
  EXPECT_NEAR(
    SagittaOf(Triangles({ { p, q, left }, { q, right, p }, { p, q, below } }), a, b), 0.005, 1e-11);
  // A corner in the rays' plane.
  const Ray c{ Vec3(-0.01, 1.0, 3.0), down };
  const Ray d{ Vec3(-0.02, 1.0, 3.0), down };
  const Triangles tip({ { p, Vec3(0.0, 3.0, 0.5), left }, { Vec3(0.0, 3.0, 0.5), p, right } });
  EXPECT_LT(SagittaOf(tip, c, d), 1e-12);
}

TEST(SagittaOfPatches, HoldsSignsInLongDouble)
{
  struct Case
  {
    const char* name;
    int degree[2];
    double height;
    double tight;
  };
  // Flat surfaces do not differ from chords.
  for (const Case& one : { Case{ "bicubic", { 3, 3 }, 0.3, 0.95 },
         Case{ "flat bicubic", { 3, 3 }, 0.0, 0.7 }, Case{ "degrees 2 and 5", { 2, 5 }, 0.4, 0.95 },
         Case{ "degree 1", { 1, 1 }, 0.5, 0.95 }, Case{ "degree 9", { 9, 9 }, 0.3, 0.9 } })
  {
    SCOPED_TRACE(one.name);
    const Hills hills(one.degree[0], one.degree[1], one.height);
    const BezierPatches patches(hills.All());
    EXPECT_TRUE(patches.HasSagitta());
    const ChordTally tally = CheckChords(
      patches, [&](const LongVec3& x) { return hills.Side(x); }, 42, 1000);
    tally.Tell(one.name);
    EXPECT_GT(tally.known, 300);
    EXPECT_GT(tally.closeKnown, 0.9 * tally.close);
    EXPECT_GT(tally.tight, one.tight * tally.closeKnown);
  }
}

/// Across an edge that two patches share; not where a point of it differs.
TEST(SagittaOfPatches, AcrossSeams)
{
  auto all = Hills(3, 3, 0.3).All();
  const Vec3 down(0.0, 0.0, -1.0);
  const Ray a{ Vec3(-1e-3, 0.4, 3.0), down };
  const Ray b{ Vec3(1e-3, 0.4, 3.0), down };
  EXPECT_LT(SagittaOf(BezierPatches(all), a, b), 1e-2);
  // Turned: the other way round along the edge.
  BezierPatch turned = all[3];
  for (std::size_t i = 0; i < 4; ++i)
  {
    std::reverse(turned.points.begin() + static_cast<std::ptrdiff_t>(4 * i),
      turned.points.begin() + static_cast<std::ptrdiff_t>(4 * i + 4));
  }
  EXPECT_NEAR(SagittaOf(BezierPatches(std::vector{ all[1], turned }), a, b),
    SagittaOf(BezierPatches(all), a, b), 1e-12);
  all[3].points[1].z += 1e-12;
  EXPECT_FALSE(std::isfinite(SagittaOf(BezierPatches(all), a, b)));
}

/// A disc lies in a plane, but ends.
TEST(SagittaOfDiscs, IsNoneBetweenItsPoints)
{
  const Disc disc(Vec3(0.0), Vec3(0.2, 0.1, 1.0), 1.0);
  EXPECT_TRUE(disc.HasSagitta());
  EXPECT_FALSE(disc.IsPlane());
  const Vec3 down(0.0, 0.0, -1.0);
  EXPECT_EQ(SagittaOf(disc, { Vec3(-0.9, 0.0, 3.0), down }, { Vec3(0.3, 0.4, 3.0), down }), 0.0);
}
} // namespace pixelexact::testing
