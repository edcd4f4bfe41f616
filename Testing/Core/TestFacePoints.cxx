// SPDX-License-Identifier: BSD-3-Clause
// Watertight by construction: points on the faces, edges and vertices that curved elements share
// are found, points just outside of the mesh are found outside or lie within the derived tolerance.
// 1e6 points of each kind on each mesh: PIXELEXACT_FACE_POINTS=1000000 TestCore
// --gtest_filter='*FacePoints*'.
#include "CurvedMeshes.h"
#include "FaceCheck.h"

#include "Core/Location/Owners.h"
#include "Core/Math/Mat.h"

#include <gtest/gtest.h>

namespace pixelexact::testing
{
namespace
{
constexpr int kDefaultCount = 6000;
constexpr int kDefaultOwners = 1500;
constexpr int kBatch = 100000;

struct NamedMesh
{
  const char* name;
  CurvedMesh (*make)();
};

const NamedMesh kNamedMeshes[] = {
  { "Hexahedra", [] { return Blocks(3, kHexahedra); } },
  { "Prisms", [] { return Blocks(3, kPrisms); } },
  { "Tetrahedra", [] { return Blocks(2, kTetrahedra); } },
  { "Pyramids", [] { return Blocks(2, kPyramids); } },
  { "Mixed", [] { return Blocks(3, kMixed); } },
  { "MixedThin", [] { return Blocks(3, kMixed, kThinPlacement); } },
  { "MixedFar", [] { return Blocks(3, kMixed, kFarPlacement); } },
  { "HangingHexahedra", [] { return Hanging(kHexahedra); } },
  { "HangingMixed", [] { return Hanging(kMixed); } },
};

/// Takes `count` points from `make` through the check, a batch at a time.
template <class Make>
FaceReport CheckMany(const Locator& locator, int count, const Make& make)
{
  FaceReport total;
  std::vector<Vec3> points;
  for (int done = 0; done < count; done += kBatch)
  {
    points.clear();
    for (int i = 0; i < std::min(kBatch, count - done); ++i)
    {
      points.push_back(make());
    }
    total += CheckPoints(locator, points);
  }
  return total;
}

/// Moves x by some ulps, along the coordinate that leads out of the cube's face most directly.
Vec3 MovedByUlps(Random& random, const Placement& place, const LongVec3& u, int axis, Vec3 x)
{
  constexpr long double kStep = 1e-6L;
  Mat3 jacobian;
  for (int j = 0; j < 3; ++j)
  {
    LongVec3 forward = u;
    LongVec3 backward = u;
    forward[j] += kStep;
    backward[j] -= kStep;
    const LongVec3 a = place(forward);
    const LongVec3 b = place(backward);
    for (int d = 0; d < 3; ++d)
    {
      jacobian[j][d] = static_cast<double>((a[d] - b[d]) / (2 * kStep));
    }
  }
  const Mat3 inverse = glm::inverse(jacobian);
  int steepest = 0;
  for (int d = 1; d < 3; ++d)
  {
    steepest = std::fabs(inverse[d][axis]) > std::fabs(inverse[steepest][axis]) ? d : steepest;
  }
  const double outward = inverse[steepest][axis] * static_cast<double>(u[axis]);
  const auto ulps = static_cast<int>(random(1.0, 5.0));
  for (int i = 0; i < ulps; ++i)
  {
    x[steepest] = outward > 0.0 ? NextUp(x[steepest]) : NextDown(x[steepest]);
  }
  return x;
}

/// A point beyond the bent cube by 1 ulp to 1e-6 of its size.
Vec3 JustOutside(Random& random, const Placement& place)
{
  Vec3 start(Coordinate(random), Coordinate(random), Coordinate(random));
  const int moved = ToBoundary(random, start);
  const int first = __builtin_ctz(static_cast<unsigned>(moved));
  LongVec3 u = ToLong(start);
  if (random() < -0.5)
  {
    return MovedByUlps(random, place, u, first, ToDouble(place(u)));
  }
  const bool all = random() < 0.0;
  for (int d = 0; d < 3; ++d)
  {
    if (d == first || (all && (moved & 1 << d) != 0))
    {
      u[d] *= 1 + SmallDistance(random);
    }
  }
  return ToDouble(place(u));
}
} // namespace

class FacePoints : public ::testing::TestWithParam<NamedMesh>
{
protected:
  CurvedMesh Made = GetParam().make();
  Locator locator_{ Made.View() };
};

TEST_P(FacePoints, OnSharedFacesEdgesAndVerticesAreFound)
{
  const Mesh mesh = Made.View();
  LongMap map(mesh);
  Random random(51);
  const FaceReport report = CheckMany(locator_, FacePointCount(kDefaultCount),
    [&]
    {
      const auto element = static_cast<int>(random(0.0, mesh.Elements()));
      return ToDouble(map(element, OnBoundary(random, mesh.ShapeOf(element))));
    });
  report.Print(std::string(GetParam().name) + ", on faces");
  EXPECT_EQ(report.inside, report.points) << report.first;
  EXPECT_EQ(report.wrong, 0) << report.first;
}

TEST_P(FacePoints, JustOutsideOfTheMeshAreNotInAnElementThatDoesNotHoldThem)
{
  Random random(52);
  const FaceReport report = CheckMany(
    locator_, FacePointCount(kDefaultCount), [&] { return JustOutside(random, Made.Placed()); });
  report.Print(std::string(GetParam().name) + ", just outside");
  EXPECT_EQ(report.unknown, 0) << report.first;
  EXPECT_EQ(report.wrong, 0) << report.first;
  // Most are farther away than any tolerance.
  EXPECT_GT(report.outside, report.points / 2);
}

TEST_P(FacePoints, OnAndBesideSharedFacesTheMeshCoversOnce)
{
  const Mesh mesh = Made.View();
  LongMap map(mesh);
  Random random(54);
  std::vector<Vec3> points;
  for (int i = 0; i < FacePointCount(kDefaultOwners); ++i)
  {
    const auto element = static_cast<int>(random(0.0, mesh.Elements()));
    const Shape shape = mesh.ShapeOf(element);
    const LongVec3 centre = ToLong(Centre(shape));
    LongVec3 xi = OnBoundary(random, shape);
    // Inwards: the mesh may end at this face.
    const long double distance = i % 3 == 0 ? 0.0L : SmallDistance(random);
    for (int d = 0; d < 3; ++d)
    {
      xi[d] -= distance * (xi[d] - centre[d]);
    }
    points.push_back(ToDouble(map(element, xi)));
  }
  std::vector<Owners> owners(points.size());
  FindOwners(locator_, points, owners);
  std::int64_t counts[4] = {};
  std::string first;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    ++counts[static_cast<std::size_t>(owners[i].coverage)];
    if (owners[i].coverage != Coverage::Once && first.empty())
    {
      char text[200];
      std::snprintf(text, sizeof(text), "%s, %d preimages at %a %a %a", Name(owners[i].coverage),
        owners[i].preimages, points[i].x, points[i].y, points[i].z);
      first = text;
    }
  }
  std::printf("[ measured ] %-44s %8zu points: covered never %lld, once %lld, several times %lld, "
              "undecided %lld\n",
    (std::string(GetParam().name) + ", coverage").c_str(), points.size(),
    static_cast<long long>(counts[0]), static_cast<long long>(counts[1]),
    static_cast<long long>(counts[2]), static_cast<long long>(counts[3]));
  EXPECT_EQ(counts[1], static_cast<std::int64_t>(points.size())) << first;
}

// A part of 1e-7 from the apex of pyramids far off the origin, where Newton's iteration begins not
// to be trusted: boxes that are straight there are divided at that depth.
TEST(FacePointsAlone, NextToAnApexAPointIsDecidedWithinItsBudget)
{
  const CurvedMesh cube = Blocks(3, kMixed, kFarPlacement);
  const Mesh mesh = cube.View();
  const Locator locator(mesh);
  const Vec3 x(0x1.80100518eef8fp+1, -0x1.bf92c5f90a6adp+2, 0x1.4p+2);
  Owners owners;
  FindOwners(locator, std::span(&x, 1), std::span(&owners, 1));
  EXPECT_EQ(owners.coverage, Coverage::Once) << Name(owners.coverage);
  EXPECT_EQ(owners.preimages, 1);
}

INSTANTIATE_TEST_SUITE_P(Meshes, FacePoints, ::testing::ValuesIn(kNamedMeshes),
  [](const auto& test) { return std::string(test.param.name); });
} // namespace pixelexact::testing
