// SPDX-License-Identifier: BSD-3-Clause
#include "MeshBuilder.h"

#include "Core/Location/PointKernels.h"
#include "Core/Location/Sample.h"

#include <tbb/global_control.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>

namespace pixelexact::testing
{
namespace
{
struct Samples
{
  explicit Samples(std::size_t count, std::size_t components = 0)
    : element(count)
    , xi(count)
    , verdict(count)
    , residual(count)
    , value(count * components)
    , gradient(3 * count * components)
  {
  }
  SampleTarget Target() { return { element, xi, verdict, residual, value, gradient }; }
  std::vector<std::int32_t> element;
  std::vector<Vec3> xi;
  std::vector<Verdict> verdict;
  std::vector<double> residual;
  std::vector<double> value;
  std::vector<double> gradient;
};

double MaxNorm(const Vec3& v)
{
  return std::max({ std::fabs(v.x), std::fabs(v.y), std::fabs(v.z) });
}

/// Two curved hexahedra that share the face xi1 = 1 of the first, xi1 = -1 of the second.
MeshBuilder TwoHexahedra()
{
  MeshBuilder mesh;
  const Space space = UniformSpace(Shape::Hexahedron, 4);
  const auto bend = [](const LongVec3& u) -> LongVec3
  {
    const auto [a, b, c] = u;
    return { a + 0.1L * b * b + 0.05L * c * c * c, b + 0.1L * a * c, c + 0.08L * a * b * b };
  };
  mesh.Add(space, [=](const LongVec3& xi) { return bend({ (xi[0] - 1) / 2, xi[1], xi[2] }); });
  mesh.Add(space, [=](const LongVec3& xi) { return bend({ (xi[0] + 1) / 2, xi[1], xi[2] }); });
  return mesh;
}
} // namespace

class LocatorShapes : public ::testing::TestWithParam<Shape>
{
};

TEST_P(LocatorShapes, FindsEveryInsidePoint)
{
  MeshBuilder mesh;
  mesh.Add(UniformSpace(GetParam(), 3), Curved);
  const Locator locator(mesh.View());
  Random random(31);
  std::vector<Vec3> xi;
  std::vector<Vec3> x;
  for (int i = 0; i < 20000; ++i)
  {
    xi.push_back(random.Inside(GetParam()));
    x.push_back(ToDouble(Curved(ToLong(xi.back()))));
  }
  Samples samples(x.size());
  Sample(locator, nullptr, x, samples.Target());
  std::vector<Vec3> forward(x.size());
  MapForward(mesh.View(), 0, samples.xi, forward);
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    ASSERT_EQ(samples.verdict[i], Verdict::Inside) << i;
    EXPECT_EQ(samples.element[i], 0);
    // The Jacobian is within 40 % of the identity: xi is as good as x, to a few roundings.
    EXPECT_LT(MaxNorm(samples.xi[i] - xi[i]), 4e-15);
    EXPECT_LT(MaxNorm(forward[i] - x[i]), 2e-15);
  }
  EXPECT_EQ(locator.Counters().unknown, 0);
}

TEST_P(LocatorShapes, ReportsOutsideForImagesOfOutsidePoints)
{
  MeshBuilder mesh;
  mesh.Add(UniformSpace(GetParam(), 3), Curved);
  const Locator locator(mesh.View());
  Random random(32);
  std::vector<Vec3> x;
  while (x.size() < 3000)
  {
    // Curved is injective on the cube enlarged to 1.5: its image of an outside xi is outside.
    const Vec3 xi(random(-1.5, 1.5), random(-1.5, 1.5), random(-1.5, 1.5));
    const double margin = Margin(GetParam(), xi);
    if (margin < -1e-12)
    {
      x.push_back(ToDouble(Curved(ToLong(xi))));
    }
  }
  // Close to all faces, down to 1e-12 of the size.
  for (double distance = 1e-12; distance < 0.1; distance *= 10.0)
  {
    for (int i = 0; i < 60; ++i)
    {
      Vec3 eta(random(), random(), random());
      // Only the hexahedron has a face at eta3 = 1.
      const int direction = i % 3;
      const bool upper = i % 2 == 0 && (direction < 2 || GetParam() == Shape::Hexahedron);
      eta[direction] = upper ? 1.0 + distance : -1.0 - distance;
      const Vec3 xi = TensorToReference(GetParam(), eta);
      // The same on all sides of where the collapsed directions end, a pyramid's apex.
      const Vec3 around = Vec3(-1.0, -1.0, 1.0) + distance * Vec3(random(), random(), random());
      // Towards collapsed edges the distance shrinks, down to what rounding allows as inside.
      for (const Vec3& point : { xi, around })
      {
        if (Margin(GetParam(), point) < -1e-13)
        {
          x.push_back(ToDouble(Curved(ToLong(point))));
        }
      }
    }
  }
  Samples samples(x.size());
  Sample(locator, nullptr, x, samples.Target());
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    ASSERT_EQ(samples.verdict[i], Verdict::Outside) << i;
    EXPECT_EQ(samples.element[i], -1);
  }
  EXPECT_EQ(locator.Counters().unknown, 0);
}

TEST_P(LocatorShapes, SizesAndOffsetsOverManyDecades)
{
  Random random(33);
  for (const double size : { 0x1p-498, 0x1p-100, 0x1p-20, 0x1p40, 0x1p498 })
  {
    MeshBuilder mesh;
    const auto map = [&](const LongVec3& xi)
    {
      LongVec3 x = Curved(xi);
      for (auto& c : x)
      {
        c *= size;
      }
      return x;
    };
    mesh.Add(UniformSpace(GetParam(), 3), map, Vec3(0.0), size);
    const Locator locator(mesh.View());
    std::vector<Vec3> x;
    for (int i = 0; i < 500; ++i)
    {
      x.push_back(ToDouble(map(ToLong(random.Inside(GetParam())))));
    }
    Samples samples(x.size());
    Sample(locator, nullptr, x, samples.Target());
    EXPECT_EQ(std::ranges::count(samples.verdict, Verdict::Inside), 500) << size;
  }
  // At 1e8 sizes from the origin, x determines xi only to 1e-8, and must still be found.
  MeshBuilder mesh;
  const Vec3 far(1e8, -1e8, 1e8);
  const auto map = [&](const LongVec3& xi)
  {
    LongVec3 x = Curved(xi);
    for (int d = 0; d < 3; ++d)
    {
      x[d] += far[d];
    }
    return x;
  };
  mesh.Add(UniformSpace(GetParam(), 3), map, far, 1.0);
  const Locator locator(mesh.View());
  std::vector<Vec3> x;
  for (int i = 0; i < 500; ++i)
  {
    x.push_back(ToDouble(map(ToLong(random.Inside(GetParam())))));
  }
  Samples samples(x.size());
  Sample(locator, nullptr, x, samples.Target());
  EXPECT_EQ(std::ranges::count(samples.verdict, Verdict::Inside), 500);
}

INSTANTIATE_TEST_SUITE_P(AllShapes, LocatorShapes, ::testing::ValuesIn(kShapes),
  [](const auto& shape) { return std::string(Name(shape.param)); });

/// A box with a point of the element at its corner is never rejected: neither where the element is
/// stretched so that the frame's rows cancel along a slanted face, nor where the box reaches far
/// away.
TEST_P(LocatorShapes, BoxesThatHoldAPointOfTheElementAreNear)
{
  Random random(36);
  for (const double stretch : { 1.0, 1e-4, 1e-8 })
  {
    // Turned, so that the stretch is along no axis.
    const auto map = [stretch](const LongVec3& xi) -> LongVec3
    {
      const long double a = xi[0] + xi[1] + xi[2];
      const long double b = (xi[0] - xi[1]) * stretch;
      const long double c = xi[2] - 0.5L * xi[1];
      return { 0.6L * a - 0.8L * b, 0.8L * a + 0.6L * b, c + 0.3L * a };
    };
    MeshBuilder builder;
    builder.Add(UniformSpace(GetParam(), 2), map);
    const Mesh mesh = builder.View();
    const ElementBounds bounds = MakeElementBounds(mesh, 0);
    const InverseProblem problem = MakeInverseProblem(mesh, 0, bounds);
    for (int i = 0; i < 4000; ++i)
    {
      // Half of them on faces, edges and vertices.
      Vec3 eta(random(-1.0, 1.0), random(-1.0, 1.0), random(-1.0, 1.0));
      for (int d = 0; d < 3 && i % 2 == 0; ++d)
      {
        eta[d] = random(-1.0, 1.0) < 0.0 ? eta[d] : std::copysign(1.0, eta[d]);
      }
      std::vector<Vec3> x(1);
      const Vec3 xi = TensorToReference(GetParam(), eta);
      MapForward(mesh, 0, std::span(&xi, 1), x);
      std::array<std::array<double, kLanePadding>, 6> lanes;
      for (std::size_t k = 0; k < kLanePadding; ++k)
      {
        const double size = std::pow(10.0, random(-9.0, 9.0));
        for (std::size_t d = 0; d < 3; ++d)
        {
          const double from = x[0][static_cast<int>(d)];
          const double to = from + random(-1.0, 1.0) * size;
          lanes[d][k] = std::min(from, to);
          lanes[3 + d][k] = std::max(from, to);
        }
      }
      const BoxLanes boxes{ { lanes[0].data(), lanes[1].data(), lanes[2].data() },
        { lanes[3].data(), lanes[4].data(), lanes[5].data() }, kLanePadding };
      ASSERT_EQ(GetPointKernels().near(bounds, problem, boxes).near, 0xffU) << stretch;
    }
  }
}

/// More chunks than are processed together, in random order.
TEST(Locator, OneBatchOfManyPointsFindsWhatSmallOnesDo)
{
  const MeshBuilder mesh = TwoHexahedra();
  const Locator locator(mesh.View());
  Random random(35);
  std::vector<Vec3> x(10000);
  for (Vec3& point : x)
  {
    point = { random(-1.3, 1.3), random(-1.3, 1.3), random(-1.3, 1.3) };
  }
  Samples whole(x.size());
  SampleTile(locator, nullptr, x, whole.Target());
  Samples parts(x.size());
  Sample(locator, nullptr, x, parts.Target());
  EXPECT_EQ(whole.verdict, parts.verdict);
  EXPECT_EQ(whole.element, parts.element);
  EXPECT_EQ(std::memcmp(whole.xi.data(), parts.xi.data(), x.size() * sizeof(Vec3)), 0);
  EXPECT_EQ(
    std::memcmp(whole.residual.data(), parts.residual.data(), x.size() * sizeof(double)), 0);
  EXPECT_GT(std::ranges::count(whole.verdict, Verdict::Inside), 2000);
}

TEST(Locator, SharedFacePointsBelongToTheLowestElementAndNoneIsLost)
{
  const MeshBuilder mesh = TwoHexahedra();
  const Locator locator(mesh.View());
  Random random(34);
  std::vector<Vec3> xi;
  for (int i = 0; i < 20000; ++i)
  {
    xi.emplace_back(1.0, random(), random());
  }
  std::vector<Vec3> x(xi.size());
  MapForward(mesh.View(), 0, xi, x);
  Samples samples(x.size());
  Sample(locator, nullptr, x, samples.Target());
  EXPECT_EQ(std::ranges::count(samples.verdict, Verdict::Inside), 20000);
  EXPECT_EQ(std::ranges::count(samples.element, 0), 20000);
}

TEST(Locator, ValuesAndGradientsOfAManufacturedField)
{
  const MeshBuilder mesh = TwoHexahedra();
  ExpansionBuilder values(2);
  for (int e = 0; e < 2; ++e)
  {
    // Linear in x through the map: u0 = 1 + 2 x - y, u1 = z.
    values.Add(UniformSpace(Shape::Hexahedron, 4),
      [e](const LongVec3& xi, long double* u)
      {
        const long double a = e == 0 ? (xi[0] - 1) / 2 : (xi[0] + 1) / 2;
        const auto [unused, b, c] = xi;
        u[0] = 1 + 2 * (a + 0.1L * b * b + 0.05L * c * c * c) - (b + 0.1L * a * c);
        u[1] = c + 0.08L * a * b * b;
      });
  }
  const Field field{ "u", values.View() };
  Validate(field, mesh.View());
  const Locator locator(mesh.View());
  Random random(35);
  std::vector<Vec3> x;
  for (int i = 0; i < 5000; ++i)
  {
    x.emplace_back(random(-0.7, 0.7), random(-0.7, 0.7), random(-0.7, 0.7));
  }
  Samples samples(x.size(), 2);
  Sample(locator, &field, x, samples.Target());
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    ASSERT_EQ(samples.verdict[i], Verdict::Inside);
    EXPECT_NEAR(samples.value[2 * i], 1.0 + 2.0 * x[i].x - x[i].y, 1e-14);
    EXPECT_NEAR(samples.value[2 * i + 1], x[i].z, 1e-14);
    const double expected[6] = { 2.0, -1.0, 0.0, 0.0, 0.0, 1.0 };
    for (int k = 0; k < 6; ++k)
    {
      EXPECT_NEAR(samples.gradient[6 * i + k], expected[k], 1e-13);
    }
  }
}

TEST(Locator, SameBitsForAnyBatchAndNumberOfThreads)
{
  const MeshBuilder mesh = TwoHexahedra();
  const Locator locator(mesh.View());
  const Field phi{ "Phi", mesh.View().map };
  Random random(36);
  std::vector<Vec3> x;
  for (int i = 0; i < 4000; ++i)
  {
    x.emplace_back(random(-1.2, 1.2), random(-1.2, 1.2), random(-1.2, 1.2));
  }
  Samples many(x.size(), 3);
  Sample(locator, &phi, x, many.Target());
  Samples serial(x.size(), 3);
  {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    Sample(locator, &phi, x, serial.Target());
  }
  EXPECT_EQ(
    std::memcmp(many.value.data(), serial.value.data(), many.value.size() * sizeof(double)), 0);
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    Samples alone(1, 3);
    SampleTile(locator, &phi, { &x[i], 1 }, alone.Target());
    ASSERT_EQ(alone.verdict[0], many.verdict[i]);
    ASSERT_EQ(alone.element[0], many.element[i]);
    ASSERT_EQ(std::memcmp(alone.value.data(), &many.value[3 * i], 3 * sizeof(double)), 0);
  }
}

TEST(Locator, SampleHonoursThePrecision)
{
  const MeshBuilder mesh = TwoHexahedra();
  ExpansionBuilder modes(1);
  for (int e = 0; e < 2; ++e)
  {
    modes.Add(UniformSpace(Shape::Hexahedron, 3),
      [](const LongVec3& xi, long double* value) { *value = 1.0L / 3 + xi[0] * xi[1] / 7; });
  }
  const Field field{ "u", modes.View() };
  const Locator locator(mesh.View());
  Random random(8);
  std::vector<Vec3> x;
  for (int i = 0; i < 5000; ++i)
  {
    x.emplace_back(random(-0.9, 0.9), random(-0.9, 0.9), random(-0.9, 0.9));
  }
  Samples samples(x.size(), 1);
  SampleTarget target = samples.Target();
  target.gradient = {};
  PrecisionCheck check;
  target.precision = Precision::Float;
  target.check = &check;
  Sample(locator, &field, x, target);
  EXPECT_GT(check.points, 0);
  EXPECT_GT(check.largest, 0.0);
  EXPECT_LT(check.largest, 1e-6);
}

TEST(Locator, NodesKnownToAPartOfTheElementLeaveNothingUnknown)
{
  // Nodes as in single precision far from the origin: the faces' tolerance exceeds a hundredth of a
  // straight element.
  for (const Shape shape : kShapes)
  {
    for (const double uncertainty : { 0.012, 0.03, 0.06 })
    {
      MeshBuilder mesh;
      mesh.Add(UniformSpace(shape, 1), [](const LongVec3& xi) { return xi; });
      mesh.Uncertainty[0] = uncertainty;
      const Mesh view = mesh.View();
      const Locator locator(view);
      std::vector<Vec3> points;
      for (int i = 0; i < 400; ++i)
      {
        points.push_back(Centre(shape) + Vec3(-1.2 + 0.003 * i, 0.01, 0.02));
      }
      Samples samples(points.size());
      Sample(locator, nullptr, points, samples.Target());
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        // The map is the identity.
        const double margin = Margin(shape, points[i]);
        EXPECT_NE(samples.verdict[i], Verdict::Unknown) << Name(shape) << points[i].x;
        EXPECT_TRUE(margin < 0.0 || samples.verdict[i] == Verdict::Inside) << Name(shape);
        EXPECT_TRUE(margin > -8.0 * uncertainty || samples.verdict[i] == Verdict::Outside);
        EXPECT_TRUE(
          samples.verdict[i] != Verdict::Inside || Margin(shape, samples.xi[i]) >= -0.0101);
      }
      EXPECT_LE(locator.Counters().mostBoxes, 64) << Name(shape);
    }
  }
}

TEST(Locator, PointsThatAreNoPoints)
{
  const MeshBuilder mesh = TwoHexahedra();
  const Locator locator(mesh.View());
  const double nan = std::nan("");
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Vec3> x{ { nan, 0.0, 0.0 }, { 0.0, infinity, 0.0 }, { 0.0, 0.0, -infinity },
    { 1e300, 1e300, 1e300 } };
  Samples samples(x.size());
  Sample(locator, nullptr, x, samples.Target());
  EXPECT_EQ(std::ranges::count(samples.verdict, Verdict::Outside), 4);
}

TEST(Locator, EmptyMeshHoldsNothing)
{
  const Locator locator{ Mesh{} };
  const std::vector<Vec3> x{ Vec3(0.0) };
  Samples samples(1);
  Sample(locator, nullptr, x, samples.Target());
  EXPECT_EQ(samples.verdict[0], Verdict::Outside);
  EXPECT_GT(locator.Bounds().lower.x, locator.Bounds().upper.x);
}

TEST(Locator, ZeroVolumeElementHidesNoNeighbour)
{
  MeshBuilder mesh;
  const Space space = UniformSpace(Shape::Hexahedron, 1);
  mesh.Add(space, [](const LongVec3& xi) -> LongVec3 { return { xi[0], xi[1], 0.0L }; });
  mesh.Add(space, [](const LongVec3& xi) { return xi; });
  const Locator locator(mesh.View());
  std::vector<Vec3> x;
  Random random(37);
  for (int i = 0; i < 200; ++i)
  {
    x.emplace_back(random(), random(), i % 2 == 0 ? 0.0 : random());
  }
  Samples samples(x.size());
  Sample(locator, nullptr, x, samples.Target());
  EXPECT_EQ(std::ranges::count(samples.verdict, Verdict::Inside), 200);
  EXPECT_EQ(std::ranges::count(samples.element, 1), 200);
}

TEST(Locator, LeftHandedElementIsFoundToo)
{
  MeshBuilder mesh;
  mesh.Add(UniformSpace(Shape::Tetrahedron, 3),
    [](const LongVec3& xi)
    {
      LongVec3 x = Curved(xi);
      x[0] = -x[0];
      return x;
    });
  const Locator locator(mesh.View());
  Random random(38);
  std::vector<Vec3> x;
  for (int i = 0; i < 1000; ++i)
  {
    x.push_back(ToDouble(Curved(ToLong(random.Inside(Shape::Tetrahedron)))));
    x.back().x = -x.back().x;
  }
  Samples samples(x.size());
  Sample(locator, nullptr, x, samples.Target());
  EXPECT_EQ(std::ranges::count(samples.verdict, Verdict::Inside), 1000);
}

TEST(Locator, StronglyBentElementLosesNoPoint)
{
  // Half a ring of order 8: the frame is useless, Newton from it fails for many points.
  MeshBuilder mesh;
  const Space space{ Shape::Hexahedron, Form::Collapsed, { 8, 2, 1 } };
  const auto map = [](const LongVec3& xi) -> LongVec3
  {
    // Taylor polynomials of cos and sin up to degree 8: a polynomial map, nearly a circle.
    const long double w = 2.2L * xi[0];
    long double cosine = 0.0L;
    long double sine = 0.0L;
    long double term = 1.0L;
    for (int k = 0; k <= 8; ++k)
    {
      (k % 2 == 0 ? cosine : sine) += (k % 4 < 2 ? term : -term);
      term = term * w / (k + 1);
    }
    const long double radius = 1.5L + 0.5L * xi[1];
    return { radius * cosine, radius * sine, xi[2] };
  };
  mesh.Add(space, map);
  const Locator locator(mesh.View());
  Random random(39);
  std::vector<Vec3> x;
  std::vector<Vec3> xi;
  for (int i = 0; i < 3000; ++i)
  {
    xi.push_back(random.Inside(Shape::Hexahedron));
    x.push_back(ToDouble(map(ToLong(xi.back()))));
  }
  const std::size_t inside = x.size();
  for (int i = 0; i < 300; ++i)
  {
    // Points in the ring's hole.
    x.emplace_back(random(-0.5, 0.5), random(-0.5, 0.5), random(-0.9, 0.9));
  }
  Samples samples(x.size());
  Sample(locator, nullptr, x, samples.Target());
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    ASSERT_EQ(samples.verdict[i], i < inside ? Verdict::Inside : Verdict::Outside) << i;
    if (i < inside)
    {
      EXPECT_LT(MaxNorm(samples.xi[i] - xi[i]), 1e-13);
    }
  }
  EXPECT_EQ(locator.Counters().unknown, 0);
}
} // namespace pixelexact::testing
