// SPDX-License-Identifier: BSD-3-Clause
#include "LongVectors.h"
#include "SurfaceCheck.h"

#include "Trace/Surfaces/Quadric.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace pixelexact::testing
{
namespace
{
Float128 Cosine(Float128 x)
{
  Float128 sum = 1;
  Float128 term = 1;
  for (int n = 1; n < 24; ++n)
  {
    term = -term * x * x / static_cast<Float128>((2 * n - 1) * (2 * n));
    sum += term;
  }
  return sum;
}

const auto kSphere = [](const std::vector<Float128>& in, const auto& x)
{
  using T = std::decay_t<decltype(x[0])>;
  return Square(Less(x, in.data())) - T(in[3] * in[3]);
};
const auto kCylinder = [](const std::vector<Float128>& in, const auto& x)
{
  using T = std::decay_t<decltype(x[0])>;
  const auto y = Less(x, in.data());
  const Float128* a = in.data() + 3;
  const Point128<T> cross{ y[1] * T(a[2]) - y[2] * T(a[1]), y[2] * T(a[0]) - y[0] * T(a[2]),
    y[0] * T(a[1]) - y[1] * T(a[0]) };
  return Square(cross) - T(in[6] * in[6] * (a[0] * a[0] + a[1] * a[1] + a[2] * a[2]));
};
const auto kCone = [](const std::vector<Float128>& in, const auto& x)
{
  using T = std::decay_t<decltype(x[0])>;
  const auto y = Less(x, in.data());
  const Float128* a = in.data() + 3;
  // pi to 113 bits, as the sum of doubles.
  const Float128 pi = static_cast<Float128>(0x1.921fb54442d18p1) +
    static_cast<Float128>(0x1.1a62633145c07p-53) - static_cast<Float128>(0x1.f1976b7ed8fbcp-109);
  const Float128 cosine = Cosine(in[6] * pi / 180);
  const T along = DotWith(y, a);
  return T(cosine * cosine * (a[0] * a[0] + a[1] * a[1] + a[2] * a[2])) * Square(y) - along * along;
};
const auto kGeneral = [](const std::vector<Float128>& a, const auto& x)
{
  using T = std::decay_t<decltype(x[0])>;
  return T(a[0]) * x[0] * x[0] + T(a[1]) * x[1] * x[1] + T(a[2]) * x[2] * x[2] +
    T(a[3]) * x[0] * x[1] + T(a[4]) * x[1] * x[2] + T(a[5]) * x[0] * x[2] + T(a[6]) * x[0] +
    T(a[7]) * x[1] + T(a[8]) * x[2] + T(a[9]);
};

void CheckSpheres(SurfaceCheck& check, RaysAbout& random)
{
  for (int k = 0; k < 40; ++k)
  {
    const double radius = random.Decades(-6.0, 6.0);
    const Vec3 centre = random.Vector(k % 3 == 0 ? 0.0 : radius * random.Decades(-2.0, 5.0));
    const Quadric sphere = MakeSphere(centre, radius);
    check.Add(sphere, Definition{ Numbers({ centre }, { radius }), kSphere },
      RoundRays(random, centre, radius), centre, radius, random);
  }
}

void CheckCylinders(SurfaceCheck& check, RaysAbout& random)
{
  for (int k = 0; k < 30; ++k)
  {
    const double radius = random.Decades(-6.0, 6.0);
    const Vec3 point = random.Vector(k % 3 == 0 ? 0.0 : radius * random.Decades(-2.0, 5.0));
    Vec3 axis = random.Decades(-100.0, 100.0) * random.UnitVector();
    if (k % 4 == 0)
    {
      axis = Vec3(0.0);
      axis[k / 4 % 3] = random.Decades(-200.0, 200.0);
    }
    const Quadric cylinder = MakeCylinder(point, axis, radius);
    check.Add(cylinder, Definition{ Numbers({ point, axis }, { radius }), kCylinder },
      RoundRays(random, point, radius), point, radius, random);
  }
}

void CheckCones(SurfaceCheck& check, RaysAbout& random)
{
  for (int k = 0; k < 15; ++k)
  {
    const Vec3 apex = random.Vector(k % 3 == 0 ? 0.0 : random.Decades(-2.0, 5.0));
    const Vec3 axis =
      random.Decades(-100.0, 100.0) * (k % 4 == 0 ? Vec3(0.0, 1.0, 0.0) : random.UnitVector());
    const double angle = k % 5 == 0 ? random.Decades(-6.0, 0.0) : random.Numbers()(1.0, 89.9);
    const double size = random.Decades(-2.0, 2.0);
    // A needle is the small difference of the forms of its axis and of a sphere.
    const double preparation = 0x1p-92 * (1.0 + 500.0 / angle);
    check.Add(MakeCone(apex, axis, angle),
      Definition{ Numbers({ apex, axis }, { angle }), kCone, preparation },
      RoundRays(random, apex, size), apex, size, random);
  }
}

void CheckQuadrics(SurfaceCheck& check, RaysAbout& random)
{
  for (int k = 0; k < 36; ++k)
  {
    std::array<double, 10> a;
    for (double& number : a)
    {
      number = random.Numbers()() < -0.5 ? 0.0 : random.Numbers()();
    }
    // Paraboloids, planes, and forms at which nothing is centred.
    if (k % 6 == 0)
    {
      a[2] = a[4] = a[5] = 0.0;
      a[8] = -1.0;
    }
    if (k % 6 == 1)
    {
      std::fill_n(a.begin(), 6, 0.0);
      a[7] = 1.0;
    }
    a[0] += k % 6 == 3 ? 1.0 : 0.0;
    a[6] += k % 6 == 5 ? 1.0 : 0.0;
    const double scale = k % 2 == 0 ? 1.0 : random.Decades(-200.0, 200.0);
    for (double& number : a)
    {
      number *= scale;
    }
    const double size = random.Decades(-1.0, 1.0);
    check.Add(MakeQuadric(a), Definition{ std::vector<double>(a.begin(), a.end()), kGeneral },
      RoundRays(random, Vec3(0.0), size), Vec3(0.0), size, random);
  }
}

void CheckMoved(SurfaceCheck& check, RaysAbout& random)
{
  const auto moved = [](const std::vector<Float128>& in, const auto& x)
  {
    using T = std::decay_t<decltype(x[0])>;
    Point128<T> y;
    for (std::size_t i = 0; i < 3; ++i)
    {
      y[i] = DotWith(x, in.data() + 7 + 3 * i) + T(in[16 + i]);
    }
    return kCylinder(in, y);
  };
  for (int k = 0; k < 24; ++k)
  {
    const double radius = random.Decades(-3.0, 3.0);
    const Vec3 point = random.Vector(radius);
    const Vec3 axis = random.UnitVector();
    AffineMap map;
    for (int j = 0; j < 3; ++j)
    {
      map.linear[j] += random.Vector(0.6);
    }
    map.linear *= random.Decades(-2.0, 2.0);
    map.offset = random.Vector(radius * random.Decades(-1.0, 4.0));
    std::vector<double> numbers = Numbers({ point, axis }, { radius });
    for (int i = 0; i < 3; ++i)
    {
      numbers.insert(numbers.end(), { map.linear[0][i], map.linear[1][i], map.linear[2][i] });
    }
    numbers.insert(numbers.end(), { map.offset.x, map.offset.y, map.offset.z });
    const Vec3 centre = glm::inverse(map.linear) * (point - map.offset);
    const double size = radius / std::cbrt(std::fabs(glm::determinant(map.linear)));
    check.Add(MakeCylinder(point, axis, radius, map), Definition{ numbers, moved },
      RoundRays(random, centre, size), centre, size, random);
  }
}

} // namespace

TEST(Quadric, SpheresAreMetAsDefined)
{
  SurfaceCheck check(7);
  check.Run([&](RaysAbout& random) { CheckSpheres(check, random); });
  EXPECT_GT(check.Result().certain, 600);
  EXPECT_GT(check.Result().uncertain, 30);
  EXPECT_GT(check.Result().hits, 500);
}

TEST(Quadric, CylindersAreMetAsDefined)
{
  SurfaceCheck check(9);
  check.Run([&](RaysAbout& random) { CheckCylinders(check, random); });
  EXPECT_GT(check.Result().certain, 600);
  EXPECT_GT(check.Result().uncertain, 30);
  EXPECT_GT(check.Result().hits, 500);
}

TEST(Quadric, ConesAreMetAsDefined)
{
  SurfaceCheck check(5);
  check.Run([&](RaysAbout& random) { CheckCones(check, random); });
  EXPECT_GT(check.Result().certain, 600);
  EXPECT_GT(check.Result().uncertain, 30);
  EXPECT_GT(check.Result().hits, 500);
}

TEST(Quadric, FormsAreMetAsDefined)
{
  SurfaceCheck check(8);
  check.Run([&](RaysAbout& random) { CheckQuadrics(check, random); });
  EXPECT_GT(check.Result().certain, 600);
  EXPECT_GT(check.Result().uncertain, 30);
  EXPECT_GT(check.Result().hits, 500);
}

TEST(Quadric, MovedSurfacesAreMetAsDefined)
{
  SurfaceCheck check(5);
  check.Run([&](RaysAbout& random) { CheckMoved(check, random); });
  EXPECT_GT(check.Result().certain, 600);
  EXPECT_GT(check.Result().uncertain, 30);
  EXPECT_GT(check.Result().hits, 500);
}

TEST(Quadric, TouchesOnceAndLiesInNothing)
{
  const Ray along{ { -3.0, 1.0, 0.0 }, { 1.0, 0.0, 0.0 } };
  const auto touch = HitsOf(MakeSphere(Vec3(0.0), 1.0), along);
  ASSERT_EQ(touch.size(), 1U);
  EXPECT_EQ(touch[0].t, 3.0);
  EXPECT_EQ(touch[0].position, Vec3(0.0, 1.0, 0.0));
  // Hardly inside: two hits.
  const Ray inside{ { -3.0, std::nextafter(1.0, 0.0), 0.0 }, { 1.0, 0.0, 0.0 } };
  EXPECT_EQ(HitsOf(MakeSphere(Vec3(0.0), 1.0), inside).size(), 2U);
  // The origin is so far away that both hits have the same t.
  const Ray far{ { -0x1p60, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } };
  const auto both = HitsOf(MakeSphere(Vec3(0.0), 1.0), far);
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[0].t, both[1].t);
  EXPECT_EQ(both[0].position, Vec3(-1.0, 0.0, 0.0));
  EXPECT_EQ(both[1].position, Vec3(1.0, 0.0, 0.0));
  // A ray along a cylinder's generator, inside the cylinder, and outside.
  const Quadric cylinder = MakeCylinder(Vec3(0.0), { 1.0, 0.0, 0.0 }, 1.0);
  EXPECT_TRUE(HitsOf(cylinder, along).empty());
  EXPECT_TRUE(HitsOf(cylinder, { Vec3(0.0), { 1.0, 0.0, 0.0 } }).empty());
  EXPECT_TRUE(HitsOf(cylinder, { Vec3(2.0), { 1.0, 0.0, 0.0 } }).empty());
  // However long its axis is.
  for (const double length : { -3.0, 0.1, 1e150 })
  {
    const Quadric same = MakeCylinder(Vec3(0.0), { length, 0.0, 0.0 }, 1.0);
    EXPECT_TRUE(HitsOf(same, along).empty());
    EXPECT_TRUE(HitsOf(same, { Vec3(0.0), { 1.0, 0.0, 0.0 } }).empty());
  }
  // A ray along a paraboloid's axis.
  const Quadric bowl = MakeQuadric({ 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0 });
  const auto once = HitsOf(bowl, { { 1.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } });
  ASSERT_EQ(once.size(), 1U);
  EXPECT_EQ(once[0].position, Vec3(1.0, 1.0, 2.0));
}

TEST(Quadric, MayBeOfAnySize)
{
  for (const double size : { 1e-100, 1e-30, 1e30, 1e100 })
  {
    const Vec3 right(1.0, 0.0, 0.0);
    const Ray ray{ { -3.0 * size, 0.0, 0.0 }, right };
    const Vec3 up(0.0, 1.0, 0.0);
    for (const Quadric& quadric : { MakeSphere(Vec3(0.0), size), MakeCylinder(Vec3(0.0), up, size),
           MakeCone(size * up, up, 45.0),
           MakeQuadric({ 1.0 / size, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -size }) })
    {
      const auto hits = HitsOf(quadric, ray);
      ASSERT_EQ(hits.size(), 2U);
      EXPECT_NEAR(hits[0].t / size, 2.0, 1e-14);
      EXPECT_NEAR(hits[1].t / size, 4.0, 1e-14);
      EXPECT_NEAR(glm::length(quadric.Normal({ hits[0].position })), 1.0, 1e-15);
    }
  }
}

TEST(Quadric, KeepsToTheRaysEnds)
{
  const Quadric sphere = MakeSphere(Vec3(0.0), 1.0);
  const Ray ray{ { -3.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } };
  const auto count = [&](double near, double far) { return HitsOf(sphere, ray, near, far).size(); };
  EXPECT_EQ(count(2.0, 4.0), 2U);
  EXPECT_EQ(count(NextUp(2.0), 4.0), 1U);
  EXPECT_EQ(HitsOf(sphere, ray, NextUp(2.0), 4.0)[0].position, Vec3(1.0, 0.0, 0.0));
  EXPECT_EQ(count(2.0, NextDown(4.0)), 1U);
  EXPECT_EQ(count(NextUp(2.0), NextDown(4.0)), 0U);
  EXPECT_EQ(count(5.0, 4.0), 0U);
}

TEST(Quadric, NormalsAreUnitGradients)
{
  const auto normal = [](const Quadric& quadric, const Vec3& x)
  { return quadric.Normal(SurfacePoint{ x }); };
  const Vec3 of = normal(MakeSphere({ 1.0, 2.0, 3.0 }, 5.0), { 4.0, 6.0, 3.0 });
  EXPECT_LE(glm::length(of - Vec3(0.6, 0.8, 0.0)), 4.0 * kUnitRoundoff);
  EXPECT_EQ(glm::length(normal(MakeCone(Vec3(0.0), { 0.0, 1.0, 0.0 }, 30.0), Vec3(0.0))), 1.0);
  for (const double scale : { 1e-200, 1e200 })
  {
    const Quadric plane = MakeQuadric({ 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, scale, 0.0, 0.0, -scale });
    EXPECT_EQ(std::fabs(normal(plane, { 1.0, 7.0, 8.0 }).x), 1.0);
  }
  const Vec3 small = normal(MakeSphere(Vec3(0.0), 1e-90), { 1e-90, 0.0, 0.0 });
  EXPECT_EQ(std::fabs(small.x), 1.0);
}

TEST(Quadric, RefusesWhatIsNoSurface)
{
  const auto of = [](const auto& make) { return MessageOf(make); };
  EXPECT_EQ(of([] { MakeSphere(Vec3(0.0), 0.0); }),
    "sphere: its radius is not positive; give one that is.");
  EXPECT_EQ(of([] { MakeSphere(Vec3(0.0), kNaN); }),
    "sphere: its radius is not positive; give one that is.");
  EXPECT_EQ(of([] { MakeSphere(Vec3(0.0), 1e101); }),
    "sphere: its radius is out of range; give one between 1e-100 and 1e100.");
  EXPECT_EQ(of([] { MakeSphere(Vec3(0.0, kNaN, 0.0), 1.0); }),
    "sphere: a coordinate of its position is not a finite number.");
  EXPECT_EQ(of([] { MakeCylinder(Vec3(0.0), Vec3(0.0), 1.0); }),
    "cylinder: its axis is zero; give a direction.");
  EXPECT_EQ(of([] { MakeCylinder(Vec3(0.0), Vec3(kNoHit), 1.0); }),
    "cylinder: a coordinate of its axis is not a finite number.");
  for (const double angle : { 0.0, 90.0, kNaN })
  {
    EXPECT_EQ(of([=] { MakeCone(Vec3(0.0), Vec3(1.0), angle); }),
      "cone: its angle is not between 0 and 90 degrees; give one that is.");
  }
  EXPECT_EQ(of([] { MakeQuadric({}); }),
    "quadric: its function is constant; give a coefficient of x, y or z.");
  EXPECT_EQ(of(
              [] {
                MakeQuadric({ 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 4.0 });
              }),
    "quadric: its function is constant; give a coefficient of x, y or z.");
  EXPECT_EQ(of([] { MakeQuadric({ kNaN }); }), "quadric: a coefficient is not a finite number.");
  AffineMap flat;
  flat.linear[2] = flat.linear[1];
  EXPECT_EQ(of([=] { MakeSphere(Vec3(0.0), 1.0, flat); }),
    "sphere: its transform has no inverse; give one that does not flatten space.");
  flat.offset.x = kNaN;
  EXPECT_EQ(of([=] { MakeSphere(Vec3(0.0), 1.0, flat); }),
    "sphere: a number of its transform is not finite.");
}
} // namespace pixelexact::testing
