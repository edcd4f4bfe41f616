// SPDX-License-Identifier: BSD-3-Clause
// Elements made to break the proofs of location. What is accepted must be a preimage within the
// documented bound (kMaxMiss), whatever the element; and an answer must not depend on what else
// was asked.
#include "LongMap.h"

#include "Core/Element/Kernels.h"
#include "Core/Location/Sample.h"

#include <tbb/global_control.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

namespace pixelexact::testing
{
namespace
{
struct LocatedPoints
{
  std::vector<std::int32_t> element;
  std::vector<Vec3> xi;
  std::vector<Verdict> verdict;
};

LocatedPoints LocatePoints(const Locator& locator, std::span<const Vec3> x)
{
  LocatedPoints answers{ std::vector<std::int32_t>(x.size()), std::vector<Vec3>(x.size()),
    std::vector<Verdict>(x.size()) };
  SampleTarget target;
  target.element = answers.element;
  target.xi = answers.xi;
  target.verdict = answers.verdict;
  Sample(locator, nullptr, x, target);
  return answers;
}

/// The distance of Phi(xi) from x, relative to the allowed one.
double Miss(const Locator& locator, LongMap& map, int element, const Vec3& xi, const Vec3& x)
{
  const LongVec3 image = map(element, ToLong(xi));
  const auto& bounds = locator.Index().BoundsOf(element);
  const double size = locator.GetMesh().size[static_cast<std::size_t>(element)];
  double most = 0.0;
  for (int d = 0; d < 3; ++d)
  {
    const auto apart = static_cast<double>(std::fabs(image[d] - static_cast<long double>(x[d])));
    // Half of the uncertainty is the rounding of the two evaluations.
    most = std::max(most, apart / (size * (kMaxMiss + 1.0) * bounds.uncertainty[d]));
  }
  return most;
}

void ExpectHonest(const Mesh& mesh, std::span<const Vec3> x, const std::string& what)
{
  const Locator locator(mesh);
  LongMap map(mesh);
  const LocatedPoints answers = LocatePoints(locator, x);
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    if (answers.verdict[i] == Verdict::Inside)
    {
      EXPECT_LE(Miss(locator, map, answers.element[i], answers.xi[i], x[i]), 1.0)
        << what << ", point " << i;
    }
  }
}

/// x = 5/8 a^3 + eps a: valid, and det J = eps in the middle.
MeshBuilder PinchedHexahedron(long double eps)
{
  MeshBuilder mesh;
  mesh.Add(UniformSpace(Shape::Hexahedron, 3),
    [=](const LongVec3& xi) -> LongVec3 {
      return { 0.625L * xi[0] * xi[0] * xi[0] + eps * xi[0], xi[1] + 0.1L * xi[0], xi[2] };
    });
  return mesh;
}

/// A hexahedron with one face collapsed to an edge: x = (1 + a) / 2, y = (1 + a) b / 2, z = c.
MeshBuilder CollapsedHexahedron()
{
  MeshBuilder mesh;
  mesh.Add(UniformSpace(Shape::Hexahedron, 2),
    [](const LongVec3& xi) -> LongVec3 {
      return { (1 + xi[0]) / 2, (1 + xi[0]) * xi[1] / 2, xi[2] };
    });
  return mesh;
}

/// Points within 1e-16 to 1e-1 of the collapsed edge, and on it.
std::vector<Vec3> PointsNearTheEdge(int count)
{
  Random random(5);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i)
  {
    const double distance = i % 8 == 0 ? 0.0 : std::pow(10.0, random(-16.0, -1.0));
    const double angle = random(-3.1, 3.1);
    points.emplace_back(distance * std::cos(angle), distance * std::sin(angle), random());
  }
  return points;
}
} // namespace

TEST(Adversarial, NothingIsTakenForAPreimageThatIsNone)
{
  Random random(3);
  for (int power = 33; power <= 51; power += 2)
  {
    const MeshBuilder mesh = PinchedHexahedron(std::exp2(static_cast<long double>(-power)));
    const Mesh view = mesh.View();
    LongMap map(view);
    std::vector<Vec3> x;
    for (int i = 0; i < 400; ++i)
    {
      const LongVec3 xi{ std::pow(10.0L, static_cast<long double>(random(-9.0, -1.0))) *
          (i % 2 == 0 ? 1.0L : -1.0L),
        random(), random() };
      x.push_back(ToDouble(map(0, xi)));
    }
    ExpectHonest(view, x, "eps = 2^-" + std::to_string(power));
  }
}

// Just beyond a face that is also the element's box: a chunk of points may lie in all that the
// frame allows, and in part beyond the box.
TEST(Adversarial, PointsAtTheElementsBoxAreAnsweredAlikeAloneAndTogether)
{
  for (const Shape shape : { Shape::Tetrahedron, Shape::Prism })
  {
    MeshBuilder mesh;
    mesh.Add(UniformSpace(shape, 2),
      [](const LongVec3& xi) -> LongVec3
      {
        const auto [a, b, c] = xi;
        return { a + 0.25L * c * c, (0.5L * (1 + a) + 0x1p-8L) * b + 0.5L * a + 0.125L * c * c,
          c + 0.3L * a };
      });
    const Mesh view = mesh.View();
    const Locator locator(view);
    Random random(0);
    std::vector<Vec3> xi(512);
    for (Vec3& point : xi)
    {
      point = random.Inside(shape);
      const double part = random(0.0, 1.0);
      const double beyond = std::pow(10.0, random(-15.5, -13.0));
      if (part < 0.5)
      {
        point[part < 0.3 ? 0 : (part < 0.4 ? 2 : 1)] = -1.0 - beyond;
      }
      if (random(0.0, 1.0) < 0.3)
      {
        point.x = random() < 0.0 ? std::min(point.x, -1.0) : point.x;
        point.z = shape == Shape::Tetrahedron ? -1.0 - point.x - point.y : -point.x;
      }
    }
    std::vector<Vec3> x(xi.size());
    MapForward(view, 0, xi, x);
    const LocatedPoints together = LocatePoints(locator, x);
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      const LocatedPoints alone = LocatePoints(locator, std::span(&x[i], 1));
      EXPECT_EQ(together.verdict[i], alone.verdict[0]) << Name(shape) << ", point " << i;
    }
  }
}

TEST(Adversarial, RandomGeometryIsAnsweredHonestly)
{
  Random random(7);
  for (const Shape shape : kShapes)
  {
    for (const int order : { 2, 4, 8 })
    {
      MeshBuilder mesh;
      mesh.Add(UniformSpace(shape, order), [](const LongVec3& xi) { return xi; });
      for (double& c : mesh.Phi.Coefficients)
      {
        c += 0.3 * random() / order;
      }
      const Mesh view = mesh.View();
      std::vector<Vec3> x;
      for (int i = 0; i < 60; ++i)
      {
        x.emplace_back(random(), random(), random());
      }
      ExpectHonest(view, x, std::string(Name(shape)) + " of order " + std::to_string(order));
    }
  }
}

TEST(Adversarial, AnswersDoNotDependOnWhatElseIsAsked)
{
  const MeshBuilder mesh = CollapsedHexahedron();
  const std::vector<Vec3> x = PointsNearTheEdge(600);
  const Locator first(mesh.View());
  const LocatedPoints together = LocatePoints(first, x);
  std::vector<Vec3> reversed(x.rbegin(), x.rend());
  const Locator second(mesh.View());
  const LocatedPoints backwards = LocatePoints(second, reversed);
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    const std::size_t j = x.size() - 1 - i;
    ASSERT_EQ(together.verdict[i], backwards.verdict[j]) << i;
    if (together.verdict[i] == Verdict::Inside)
    {
      EXPECT_EQ(together.xi[i], backwards.xi[j]) << i;
    }
    if (i % 10 == 0)
    {
      const Locator alone(mesh.View());
      EXPECT_EQ(LocatePoints(alone, std::span(&x[i], 1)).verdict[0], together.verdict[i]) << i;
    }
  }
}

TEST(Adversarial, TheTreesLimitChangesNoAnswer)
{
  const MeshBuilder mesh = CollapsedHexahedron();
  const std::vector<Vec3> x = PointsNearTheEdge(600);
  Locator locator(mesh.View());
  const LocatedPoints much = LocatePoints(locator, x);
  EXPECT_GT(locator.Index().TreeBytes(), 0U);
  locator.Index().SetTreeLimit(0);
  const LocatedPoints none = LocatePoints(locator, x);
  EXPECT_EQ(much.verdict, none.verdict);
}

// Each point took all that it may, and the tree gigabytes.
TEST(Adversarial, NothingIsSoughtForLongInElementsWithoutThickness)
{
  MeshBuilder mesh;
  mesh.Add(UniformSpace(Shape::Hexahedron, 2),
    [](const LongVec3& xi) -> LongVec3 {
      return { xi[0] + 0.2L * xi[1] * xi[1], xi[1], 0.0L };
    });
  Random random(3);
  std::vector<Vec3> onSheet;
  std::vector<Vec3> beside;
  for (int i = 0; i < 600; ++i)
  {
    const Vec3 xi = random.Inside(Shape::Hexahedron);
    onSheet.emplace_back(xi.x + 0.2 * xi.y * xi.y, xi.y, 0.0);
    beside.push_back(onSheet.back() + Vec3(0.0, 0.0, random() < 0.0 ? -1e-9 : 1e-9));
    beside.emplace_back(1.19, 0.5 * xi.y, 0.0); // in the element's box
  }
  Locator locator(mesh.View());
  locator.Index().SetTreeLimit(std::size_t{ 1 } << 40U);
  const LocatedPoints there = LocatePoints(locator, onSheet);
  EXPECT_EQ(std::ranges::count(there.verdict, Verdict::Unknown), 600);
  const LocatedPoints out = LocatePoints(locator, beside);
  EXPECT_EQ(std::ranges::count(out.verdict, Verdict::Outside), 1200);
  EXPECT_LT(locator.Index().TreeBytes(), std::size_t{ 64 } << 20U);
}
} // namespace pixelexact::testing
