// SPDX-License-Identifier: BSD-3-Clause
// All preimages, in elements that fold, overlap, leave gaps or merely touch; oracles are closed
// forms.
#include "MeshBuilder.h"

#include "Core/Location/Owners.h"

#include <glm/common.hpp>
#include <gtest/gtest.h>

namespace pixelexact::testing
{
namespace
{
class Collector final : public PreimageSink
{
public:
  void Found(int /*index*/, const pixelexact::Preimage& preimage) override
  {
    All.push_back(preimage);
  }
  void Undecided(int /*index*/, int /*element*/) override { ++Open; }

  std::vector<pixelexact::Preimage> All;
  int Open = 0;
};

Collector CollectOwners(const Locator& locator, const Vec3& x)
{
  Collector collector;
  locator.LocateAll(std::span(&x, 1), collector);
  return collector;
}

bool IsAmong(const std::vector<Vec3>& points, const Vec3& xi)
{
  return std::ranges::any_of(points,
    [&](const Vec3& p)
    {
      const Vec3 apart = glm::abs(p - xi);
      return std::max({ apart.x, apart.y, apart.z }) < 1e-9;
    });
}

/// Every expected preimage once, and no other. Points whose preimages are near a face or a fold are
/// left out: there, rounding decides.
void ExpectPreimages(const Collector& found, const std::vector<Vec3>& expected)
{
  EXPECT_EQ(found.Open, 0);
  ASSERT_EQ(found.All.size(), expected.size());
  for (const pixelexact::Preimage& preimage : found.All)
  {
    EXPECT_TRUE(IsAmong(expected, preimage.xi));
    EXPECT_FALSE(preimage.onFace);
  }
  for (const Vec3& xi : expected)
  {
    EXPECT_TRUE(std::ranges::any_of(
      found.All, [&](const pixelexact::Preimage& p) { return IsAmong({ xi }, p.xi); }));
  }
}
} // namespace

/// x = (a^2 + s a, b + a / 8, c): two sheets where a -> -s - a stays in the shape.
TEST(Owners, EveryPreimageOfAFoldedElement)
{
  for (const Shape shape : kShapes)
  {
    constexpr double kShift = 0.3;
    MeshBuilder mesh;
    mesh.Add(UniformSpace(shape, 2),
      [](const LongVec3& xi) -> LongVec3 {
        return { xi[0] * xi[0] + kShift * xi[0], xi[1] + xi[0] / 8, xi[2] };
      });
    const Mesh view = mesh.View();
    const Locator locator(view);
    Random random(11);
    int twice = 0;
    for (int i = 0; i < 400; ++i)
    {
      const Vec3 xi = random.Inside(shape);
      const Vec3 x(xi.x * xi.x + kShift * xi.x, xi.y + xi.x / 8, xi.z);
      const double other = -kShift - xi.x;
      const Vec3 second(other, x.y - other / 8, x.z);
      if (std::fabs(Margin(shape, xi)) < 1e-6 || std::fabs(Margin(shape, second)) < 1e-6 ||
        std::fabs(xi.x - other) < 1e-4)
      {
        continue;
      }
      std::vector<Vec3> expected{ xi };
      if (Margin(shape, second) > 0.0)
      {
        expected.push_back(second);
        ++twice;
      }
      ExpectPreimages(CollectOwners(locator, x), expected);
    }
    EXPECT_GT(twice, 20) << Name(shape);
  }
}

/// The square of a complex number: the Jacobian is singular on a line, around which the map winds
/// twice.
TEST(Owners, BothPreimagesAroundABranchLine)
{
  MeshBuilder mesh;
  mesh.Add(UniformSpace(Shape::Hexahedron, 2),
    [](const LongVec3& xi) -> LongVec3 {
      return { xi[0] * xi[0] - xi[1] * xi[1], 2 * xi[0] * xi[1], xi[2] };
    });
  const Mesh view = mesh.View();
  const Locator locator(view);
  Random random(12);
  for (int i = 0; i < 400; ++i)
  {
    const Vec3 xi(random(-0.999, 0.999), random(-0.999, 0.999), random(-0.999, 0.999));
    if (std::hypot(xi.x, xi.y) < 1e-3)
    {
      continue;
    }
    const Vec3 x(xi.x * xi.x - xi.y * xi.y, 2 * xi.x * xi.y, xi.z);
    ExpectPreimages(CollectOwners(locator, x), { xi, { -xi.x, -xi.y, xi.z } });
  }
}

/// Points outside of all elements are proven to have no preimage, also near a fold.
TEST(Owners, NoneOutsideOfAFoldedElement)
{
  MeshBuilder mesh;
  mesh.Add(UniformSpace(Shape::Hexahedron, 3),
    [](const LongVec3& xi) -> LongVec3 {
      return { xi[0] * xi[0], xi[1], xi[2] + xi[0] * xi[0] * xi[0] / 4 };
    });
  const Mesh view = mesh.View();
  const Locator locator(view);
  Random random(13);
  for (int i = 0; i < 400; ++i)
  {
    const Vec3 x(random(-1.2, 1.2), random(-1.2, 1.2), random(-1.3, 1.3));
    std::vector<Vec3> expected;
    for (const double a : { std::sqrt(std::max(x.x, 0.0)), -std::sqrt(std::max(x.x, 0.0)) })
    {
      const Vec3 xi(a, x.y, x.z - a * a * a / 4);
      if (x.x >= 0.0 && Margin(Shape::Hexahedron, xi) > 0.0)
      {
        expected.push_back(xi);
      }
    }
    if (std::fabs(x.x) < 1e-6)
    {
      continue;
    }
    ExpectPreimages(CollectOwners(locator, x), expected);
  }
}

TEST(Owners, ReportGapsOverlapsAndSharedFaces)
{
  // Three unit cubes in a row: the second is 0.25 into the first, the third 0.25 off the second.
  MeshBuilder mesh;
  for (const double start : { 0.0, 0.75, 2.0, 3.0 })
  {
    mesh.Add(UniformSpace(Shape::Hexahedron, 1),
      [=](const LongVec3& xi) -> LongVec3 {
        return { start + (xi[0] + 1) / 2, (xi[1] + 1) / 2, (xi[2] + 1) / 2 };
      });
  }
  const Mesh view = mesh.View();
  const Locator locator(view);
  struct Case
  {
    double x;
    Coverage coverage;
    int elements;
  };
  std::vector<Vec3> points;
  const std::vector<Case> cases{ { 0.5, Coverage::Once, 1 }, { 0.9, Coverage::Several, 2 },
    { 1.5, Coverage::Once, 1 }, { 1.9, Coverage::None, 0 }, { 2.5, Coverage::Once, 1 },
    { 3.0, Coverage::Once, 2 }, { 4.1, Coverage::None, 0 }, { 1.0, Coverage::Once, 2 } };
  for (const Case& c : cases)
  {
    points.emplace_back(c.x, 0.5, 0.5);
  }
  points.emplace_back(std::numeric_limits<double>::quiet_NaN(), 0.5, 0.5);
  std::vector<Owners> owners(points.size());
  FindOwners(locator, points, owners);
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    EXPECT_EQ(owners[i].coverage, cases[i].coverage) << cases[i].x;
    EXPECT_EQ(owners[i].elements, cases[i].elements) << cases[i].x;
    EXPECT_EQ(owners[i].preimages, cases[i].elements) << cases[i].x;
  }
  EXPECT_EQ(owners.back().coverage, Coverage::None);
  std::vector<Owners> wrong(3);
  EXPECT_ANY_THROW(FindOwners(locator, points, wrong));
}

/// Curved elements of all shapes: inside exactly one preimage, wherever the point.
TEST(Owners, OncePerPointInSoundElements)
{
  for (const Shape shape : kShapes)
  {
    for (const int order : { 3, 7 })
    {
      MeshBuilder mesh;
      mesh.Add(UniformSpace(shape, order), Curved);
      const Mesh view = mesh.View();
      const Locator locator(view);
      Random random(14);
      std::vector<Vec3> points;
      std::vector<Vec3> at;
      for (int i = 0; i < 300; ++i)
      {
        // Some close to collapsed edges and vertices.
        Vec3 eta(random(), random(), random());
        if (i % 3 == 0)
        {
          eta.z = 1.0 - std::pow(10.0, random(-12.0, -1.0));
        }
        if (i % 4 == 0)
        {
          eta.y = 1.0 - std::pow(10.0, random(-12.0, -1.0));
        }
        at.push_back(TensorToReference(shape, eta));
        points.push_back(ToDouble(Curved(ToLong(at.back()))));
      }
      std::vector<Owners> owners(points.size());
      FindOwners(locator, points, owners);
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        EXPECT_EQ(owners[i].preimages, 1)
          << Name(shape) << ' ' << order << " at " << at[i].x << ' ' << at[i].y << ' ' << at[i].z;
        EXPECT_EQ(owners[i].coverage, Coverage::Once);
      }
    }
  }
}
} // namespace pixelexact::testing
