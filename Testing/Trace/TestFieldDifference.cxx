// SPDX-License-Identifier: BSD-3-Clause
// Differences of two fields on two meshes, against closed forms of both.
#include "Block.h"

#include "Core/Base/Error.h"
#include "Trace/Compare/FieldDifference.h"
#include "Trace/Surfaces/ElementFaces.h"
#include "Trace/Surfaces/Quadric.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <array>
#include <cstring>
#include <vector>

namespace pixelexact::testing
{
namespace
{
constexpr int kDifferenceWidth = 61;
constexpr int kDifferenceHeight = 47;

long double Other(const LongVec3& x)
{
  return 2 + x[0] * x[1] - 3 * x[2] + x[1] * x[1];
}

/// One bent element about [-0.5, 1.5] x [-1, 1] x [-1, 1], with known fields. Its faces in x are
/// flat.
class Slab
{
public:
  Slab()
  {
    const Space space = UniformSpace(Shape::Hexahedron, 4);
    Elements.Add(space, Map);
    Scalar.Add(space, [](const LongVec3& xi, long double* u) { u[0] = Other(Map(xi)); });
    Vector.Add(space,
      [](const LongVec3& xi, long double* u)
      {
        const LongVec3 x = Map(xi);
        u[0] = x[0];
        u[1] = -x[1];
        u[2] = 2 * x[2];
      });
    scalar_ = { "w", Scalar.View() };
    vector_ = { "v", Vector.View() };
    locator_ = std::make_unique<Locator>(Elements.View());
  }

  static LongVec3 Map(const LongVec3& xi)
  {
    return { 0.5L + xi[0], xi[1] + 0.1L * (1 - xi[1] * xi[1]) * xi[0], xi[2] };
  }

  Field scalar_;
  Field vector_;
  std::unique_ptr<Locator> locator_;

private:
  MeshBuilder Elements;
  ExpansionBuilder Scalar{ 1 };
  ExpansionBuilder Vector{ 3 };
};

std::shared_ptr<const Surface> Sphere(const Vec3& centre, double radius)
{
  return std::make_shared<Quadric>(MakeSphere(centre, radius));
}

CameraView MakeSlantedView()
{
  CameraView view;
  view.position = { 2.1, -1.7, 4.2 };
  view.focalPoint = { 0.2, 0.1, 0.0 };
  view.viewAngle = 38.0;
  return view;
}

std::int64_t CountOf(const FieldDifference& found, DifferenceSide side)
{
  return std::ranges::count(found.side, static_cast<std::uint8_t>(side));
}

bool SameBits(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}
} // namespace

TEST(FieldDifference, IsThatOfTheClosedFormsAndWithinItsBounds)
{
  Block block;
  block.MakeCurved();
  const Slab slab;
  const DifferenceScene scene{ { block.scene_.locator, &block.field_ },
    { slab.locator_.get(), &slab.scalar_ },
    std::make_shared<Plane>(Vec3(0.0, 0.0, 0.25), Vec3(0.0, 0.0, 1.0)) };
  const CameraView view = MakeSlantedView();
  const FieldDifference found =
    TraceDifference(scene, { view, kDifferenceWidth, kDifferenceHeight });
  const SampleBuffers& centres = found.frame.centres;
  long double squares = 0;
  long double largest = 0;
  std::int64_t both = 0;
  for (int k = 0; k < kDifferenceWidth * kDifferenceHeight; ++k)
  {
    const auto i = static_cast<std::size_t>(k);
    const LongRay ray = RayThrough(view, kDifferenceWidth, kDifferenceHeight,
      k % kDifferenceWidth + 0.5L, k / kDifferenceWidth + 0.5L);
    const long double t = (0.25L - ray.origin[2]) / ray.direction[2];
    const LongVec3 x = Plus(ray.origin, Times(t, ray.direction));
    const bool inHeight = std::fabs(x[1]) < 1;
    const bool inFirst = inHeight && std::fabs(x[0]) < 1;
    const bool inSecond = inHeight && std::fabs(x[0] - 0.5L) < 1;
    const DifferenceSide side = inFirst && inSecond ? DifferenceSide::Both
      : inFirst                                     ? DifferenceSide::First
      : inSecond                                    ? DifferenceSide::Second
                                                    : DifferenceSide::Nothing;
    ASSERT_EQ(static_cast<DifferenceSide>(found.side[i]), side) << k;
    ASSERT_EQ(found.seen[i], inFirst ? 1 : inSecond ? 2 : 0);
    ASSERT_EQ(std::isnan(found.first[i]), !inFirst);
    ASSERT_EQ(std::isnan(found.second[i]), !inSecond);
    const long double truth = Block::CurvedAt(x) - Other(x);
    if (inFirst)
    {
      ASSERT_NEAR(found.first[i], static_cast<double>(Block::CurvedAt(x)), 1e-13);
    }
    if (inSecond)
    {
      ASSERT_NEAR(found.second[i], static_cast<double>(Other(x)), 1e-13);
    }
    if (side != DifferenceSide::Both)
    {
      ASSERT_TRUE(std::isnan(centres.value[i])) << k;
      continue;
    }
    ++both;
    squares += truth * truth;
    largest = std::max(largest, std::fabs(truth));
    ASSERT_NEAR(centres.value[i], static_cast<double>(truth), 2e-13) << k;
    // Uses the position that was found, whose own rounding the bounds do not cover.
    const LongVec3 at = ToLong(centres.position[i]);
    const long double there = Block::CurvedAt(at) - Other(at);
    ASSERT_LE(centres.valueLower[i], there);
    ASSERT_GE(centres.valueUpper[i], there);
    ASSERT_LT(centres.valueUpper[i] - centres.valueLower[i], 1e-12);
  }
  ASSERT_GT(both, 300);
  const DifferenceNumbers numbers = NumbersOf(found);
  EXPECT_EQ(numbers.both, both);
  EXPECT_EQ(numbers.onlyFirst, CountOf(found, DifferenceSide::First));
  EXPECT_EQ(numbers.onlySecond, CountOf(found, DifferenceSide::Second));
  EXPECT_GT(numbers.onlyFirst, 100);
  EXPECT_GT(numbers.onlySecond, 100);
  EXPECT_EQ(numbers.both + numbers.onlyFirst + numbers.onlySecond + numbers.nothing,
    kDifferenceWidth * kDifferenceHeight);
  EXPECT_NEAR(numbers.rootMeanSquare, static_cast<double>(std::sqrt(squares / both)), 1e-12);
  EXPECT_NEAR(numbers.largest, static_cast<double>(largest), 1e-12);
  EXPECT_TRUE(numbers.largestTrue.Contains(numbers.largest));
  EXPECT_LT(numbers.largestTrue.Width(), 1e-12);
  EXPECT_EQ(numbers.unbounded, 0);
  EXPECT_GT(numbers.largestBound, 0.0);
  EXPECT_LT(numbers.largestBound, 1e-12);
  const auto pixel = static_cast<std::size_t>(numbers.largestPixel);
  EXPECT_EQ(std::fabs(centres.value[pixel]), numbers.largest);
  EXPECT_EQ(numbers.largestAt, centres.position[pixel]);
}

TEST(FieldDifference, TheNearestPointInEitherMeshIsSeen)
{
  Block block;
  block.MakeCurved();
  const Slab slab;
  // Its nearer side leaves the first mesh, and is only in the second one.
  const Vec3 centre(0.9, 0.0, 0.0);
  const double radius = 0.5;
  CameraView view;
  view.position = { 6.0, 0.0, 0.0 };
  view.focalPoint = centre;
  view.viewUp = { 0.0, 0.0, 1.0 };
  view.viewAngle = 14.0;
  const Camera camera(view, kDifferenceWidth, kDifferenceHeight);
  const DifferenceScene scene{ { block.scene_.locator, &block.field_ },
    { slab.locator_.get(), &slab.scalar_ }, Sphere(centre, radius) };
  const FieldDifference found = TraceDifference(scene, camera, Buffer::None, false);
  const std::int64_t onlySecond = CountOf(found, DifferenceSide::Second);
  EXPECT_GT(onlySecond, 300);
  EXPECT_EQ(CountOf(found, DifferenceSide::First), 0);
  for (std::size_t i = 0; i < found.side.size(); ++i)
  {
    if (found.side[i] == static_cast<std::uint8_t>(DifferenceSide::Second))
    {
      EXPECT_GT(found.frame.centres.position[i].x, 1.0 - 1e-12);
    }
  }
  // The other way round the same pixels are the other one's.
  const DifferenceScene swapped{ scene.second, scene.first, scene.surface };
  const FieldDifference turned = TraceDifference(swapped, camera, Buffer::None, false);
  EXPECT_EQ(CountOf(turned, DifferenceSide::First), onlySecond);
  for (std::size_t i = 0; i < found.side.size(); ++i)
  {
    if (found.side[i] == static_cast<std::uint8_t>(DifferenceSide::Both))
    {
      ASSERT_EQ(found.frame.centres.value[i], -turned.frame.centres.value[i]);
    }
  }
}

TEST(FieldDifference, OfAMeshItsOwnFacesAreSeen)
{
  const Slab slab;
  Block block;
  block.MakeCurved();
  const std::array<ElementFace, 1> face{ ElementFace{ 0, 1 } };
  const DifferenceScene scene{ { slab.locator_.get(), &slab.scalar_ },
    { block.scene_.locator, &block.field_ },
    std::make_shared<ElementFaces>(slab.locator_->Index(), face) };
  CameraView view;
  view.position = { -6.0, 0.3, 0.2 };
  view.focalPoint = { 0.0, 0.0, 0.0 };
  view.viewUp = { 0.0, 0.0, 1.0 };
  view.viewAngle = 25.0;
  const FieldDifference found =
    TraceDifference(scene, { view, kDifferenceWidth, kDifferenceHeight });
  const DifferenceNumbers numbers = NumbersOf(found);
  EXPECT_GT(numbers.both, 300);
  EXPECT_EQ(numbers.onlySecond, 0);
  for (std::size_t i = 0; i < found.side.size(); ++i)
  {
    if (found.side[i] == static_cast<std::uint8_t>(DifferenceSide::Both))
    {
      const LongVec3 x = ToLong(found.frame.centres.position[i]);
      const long double truth = Other(x) - Block::CurvedAt(x);
      ASSERT_NEAR(found.frame.centres.value[i], static_cast<double>(truth), 1e-13);
      ASSERT_LE(found.frame.centres.valueLower[i], truth);
      ASSERT_GE(found.frame.centres.valueUpper[i], truth);
    }
  }
}

TEST(FieldDifference, MagnitudesAreThoseOfTheDifference)
{
  Block block;
  const Slab slab;
  const Field& first = block.Add(3,
    [](const LongVec3& x, long double* u)
    {
      u[0] = x[1];
      u[1] = x[0] * x[0];
      u[2] = x[2] - 1;
    });
  const DifferenceScene scene{ { block.scene_.locator, &first },
    { slab.locator_.get(), &slab.vector_ },
    std::make_shared<Plane>(Vec3(0.0, 0.0, 0.3), Vec3(0.0, 0.0, 1.0)), kMagnitude };
  const FieldDifference found =
    TraceDifference(scene, ViewAlongZ(kDifferenceWidth, kDifferenceHeight));
  std::int64_t both = 0;
  for (std::size_t i = 0; i < found.side.size(); ++i)
  {
    if (found.side[i] != static_cast<std::uint8_t>(DifferenceSide::Both))
    {
      continue;
    }
    ++both;
    const LongVec3 x = ToLong(found.frame.centres.position[i]);
    const LongVec3 off{ x[1] - x[0], x[0] * x[0] + x[1], x[2] - 1 - 2 * x[2] };
    const long double truth = std::sqrt(Dot(off, off));
    ASSERT_NEAR(found.frame.centres.value[i], static_cast<double>(truth), 1e-14);
    ASSERT_LE(found.frame.centres.valueLower[i], truth);
    ASSERT_GE(found.frame.centres.valueUpper[i], truth);
  }
  EXPECT_GT(both, 300);
}

TEST(FieldDifference, OfAFieldFromItselfIsZero)
{
  Block block;
  const DifferenceScene scene{ { block.scene_.locator, &block.field_ },
    { block.scene_.locator, &block.field_ },
    std::make_shared<Plane>(Vec3(0.0), Vec3(0.1, 0.2, 1.0)) };
  const DifferenceNumbers numbers =
    NumbersOf(TraceDifference(scene, ViewAlongZ(kDifferenceWidth, kDifferenceHeight)));
  EXPECT_GT(numbers.both, 1000);
  EXPECT_EQ(numbers.largest, 0.0);
  EXPECT_EQ(numbers.provenApart, 0);
  EXPECT_EQ(numbers.onlyFirst + numbers.onlySecond + numbers.unknown, 0);
}

TEST(FieldDifference, NotANumberIsCountedAndLeavesTheMeans)
{
  Block block;
  DifferenceScene scene{ { block.scene_.locator, &block.field_ },
    { block.scene_.locator, &block.field_ },
    std::make_shared<Plane>(Vec3(0.0, 0.0, -0.5), Vec3(0.0, 0.0, 1.0)), 1 };
  const FieldDifference found =
    TraceDifference(scene, ViewAlongZ(kDifferenceWidth, kDifferenceHeight));
  const DifferenceNumbers numbers = NumbersOf(found);
  EXPECT_GT(numbers.notFinite, 100);
  EXPECT_LT(numbers.notFinite, numbers.both);
  EXPECT_EQ(numbers.largest, 0.0);
  EXPECT_EQ(found.frame.counters.nonFinite, numbers.notFinite);
}

TEST(FieldDifference, ThreadsChangeNoBitAndProgressAborts)
{
  Block block;
  block.MakeCurved();
  const Slab slab;
  const DifferenceScene scene{ { block.scene_.locator, &block.field_ },
    { slab.locator_.get(), &slab.scalar_ }, Sphere(Vec3(0.5, 0.1, 0.0), 0.8) };
  const Camera camera(MakeSlantedView(), kDifferenceWidth, kDifferenceHeight);
  const FieldDifference many = TraceDifference(scene, camera);
  {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const FieldDifference alone = TraceDifference(scene, camera);
    EXPECT_TRUE(SameBits(many.frame.centres.value, alone.frame.centres.value));
    EXPECT_TRUE(SameBits(many.frame.centres.valueUpper, alone.frame.centres.valueUpper));
    EXPECT_EQ(many.side, alone.side);
  }
  const FieldDifference aborted =
    TraceDifference(scene, camera, Buffer::None, true, [](double part) { return part < 0.15; });
  EXPECT_EQ(aborted.frame.centres.Size(), 0U);
}

TEST(FieldDifference, FieldsThatDoNotFitAreRefused)
{
  Block block;
  const Slab slab;
  DifferenceScene scene{ { block.scene_.locator, &block.field_ },
    { slab.locator_.get(), &slab.scalar_ }, std::make_shared<Plane>(Vec3(0.0), Vec3(1.0)) };
  EXPECT_THROW((void)TraceDifference(scene, ViewAlongZ(8, 8)), Error);
  scene.second = scene.first;
  scene.component = 2;
  EXPECT_THROW((void)TraceDifference(scene, ViewAlongZ(8, 8)), Error);
}
} // namespace pixelexact::testing
