// SPDX-License-Identifier: BSD-3-Clause
#include "RayCheck.h"
#include "SurfaceCheck.h"

#include "Core/Index/Segment.h"
#include "Trace/Surfaces/Quadric.h"
#include "Trace/Surfaces/SearchedSurface.h"
#include "Trace/Surfaces/Torus.h"

#include <cmath>
#include <functional>
#include <limits>

namespace pixelexact::testing
{
namespace
{
class CallableFunction final : public SampledFunction
{
public:
  explicit CallableFunction(std::function<double(const Vec3&)> f)
    : F(std::move(f))
  {
  }
  void Evaluate(std::span<const Vec3> x, std::span<double> values) const override
  {
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      values[i] = F(x[i]);
    }
  }
  void Gradients(std::span<const Vec3> x, std::span<Vec3> gradients) const override
  {
    std::ranges::transform(x, gradients.begin(), [](const Vec3& at) { return 2.0 * at; });
  }

private:
  std::function<double(const Vec3&)> F;
};

constexpr Box3 kBox{ Vec3(-3.0), Vec3(3.0) };

std::shared_ptr<const SampledFunction> Make(std::function<double(const Vec3&)> f)
{
  return std::make_shared<CallableFunction>(std::move(f));
}

/// The hits of a surface in closed form, where it leaves no two closer than a search may overlook.
void ExpectHitsOf(const Surface& closed, const SampledFunction& f, const SearchedSurface& searched)
{
  RandomRays random(9);
  int compared = 0;
  for (int k = 0; k < 3000; ++k)
  {
    const Vec3 origin = random.Vector(5.0);
    const Ray ray{ origin, glm::normalize(random.Vector(1.2) - origin) };
    const auto expected = HitsOf(closed, ray);
    bool apart = true;
    for (std::size_t i = 1; i < expected.size(); ++i)
    {
      apart = apart && expected[i].t - expected[i - 1].t > 12.0 / 100.0;
    }
    if (!apart || ClipRay(kBox, ray.origin, ray.direction, kNearest, kFarthest) == std::nullopt)
    {
      continue;
    }
    const auto found = HitsOf(searched, ray);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      // The tolerance is the uncertainty from the function's own rounding.
      const double step = 1e-3;
      double before = 0.0;
      double after = 0.0;
      const Vec3 ends[2] = { expected[i].position - step * ray.direction,
        expected[i].position + step * ray.direction };
      f.Evaluate({ ends, 1 }, { &before, 1 });
      f.Evaluate({ ends + 1, 1 }, { &after, 1 });
      const double slope = std::fabs(after - before) / (2.0 * step);
      EXPECT_NEAR(found[i].t, expected[i].t, 1e-14 + 1e-13 / slope);
      EXPECT_EQ(found[i].status, HitStatus::Numeric);
      ++compared;
    }
  }
  EXPECT_GT(compared, 500);
}
} // namespace

TEST(SearchedSurface, FindsWhatClosedFormsHave)
{
  const auto sphere = Make([](const Vec3& x) { return glm::dot(x, x) - 1.0; });
  ExpectHitsOf(MakeSphere(Vec3(0.0), 1.0), *sphere, { sphere, kBox });
  const auto torus = Make(
    [](const Vec3& x)
    {
      const double off = std::hypot(x.x, x.y) - 1.0;
      return off * off + x.z * x.z - 0.09;
    });
  ExpectHitsOf(Torus(Vec3(0.0), { 0.0, 0.0, 1.0 }, 1.0, 0.3), *torus, { torus, kBox });
}

TEST(SearchedSurface, ZerosAtSamplesCountOnce)
{
  // Samples at whole numbers.
  const Box3 box{ Vec3(0.0), Vec3(8.0) };
  const Ray ray{ Vec3(0.0, 4.0, 4.0), { 1.0, 0.0, 0.0 } };
  const auto at = [&](std::function<double(double)> f, int samples = 9)
  {
    std::vector<double> t;
    const SearchedSurface surface(
      Make([f = std::move(f)](const Vec3& x) { return f(x.x); }), box, samples);
    for (const Hit& hit : HitsOf(surface, { { -1.0, 4.0, 4.0 }, ray.direction }))
    {
      t.push_back(hit.t - 1.0);
    }
    return t;
  };
  const auto expect = [&](const std::function<double(double)>& f, const std::vector<double>& zeros)
  {
    // The samples' own rounding is not to matter.
    const auto found = at([&f](double x) { return std::fabs(f(x)) < 1e-12 ? 0.0 : f(x); });
    ASSERT_EQ(found.size(), zeros.size());
    for (std::size_t i = 0; i < zeros.size(); ++i)
    {
      EXPECT_NEAR(found[i], zeros[i], 1e-14);
    }
  };
  expect([](double x) { return x - 3.0; }, { 3.0 });
  expect([](double x) { return x; }, { 0.0 });
  expect([](double x) { return x - 8.0; }, { 8.0 });
  expect([](double x) { return (x - 2.0) * (x - 5.0); }, { 2.0, 5.0 });
  // Touched, not crossed: seen where a sample lies.
  expect([](double x) { return (x - 4.0) * (x - 4.0); }, { 4.0 });
  expect([](double x) { return (x - 4.5) * (x - 4.5); }, {});
  // Two roots between samples are missed, until there are more samples.
  const auto pair = [](double x) { return (x - 4.25) * (x - 4.75); };
  expect(pair, {});
  EXPECT_EQ(at(pair, 17).size(), 2U);
  // A jump, a pole, and where there is no function.
  ASSERT_EQ(at([](double x) { return x < M_PI ? -1.0 : 2.0; }).size(), 1U);
  EXPECT_NEAR(at([](double x) { return x < M_PI ? -1.0 : 2.0; })[0], M_PI, 1e-14);
  EXPECT_EQ(at([](double x) { return std::log(x - 2.5); }).size(), 1U);
  EXPECT_EQ(at([](double) { return std::nan(""); }).size(), 0U);
}

TEST(SearchedSurface, LooksUpToWhereTheFunctionEnds)
{
  const Box3 box{ Vec3(0.0), Vec3(8.0) };
  const Ray ray{ Vec3(0.0, 4.0, 4.0), { 1.0, 0.0, 0.0 } };
  const auto at = [&](double zero, double from, double to)
  {
    const SearchedSurface surface(
      Make([=](const Vec3& x) { return x.x > from && x.x < to ? x.x - zero : std::nan(""); }), box,
      9);
    return HitsOf(surface, ray);
  };
  // Roots between the last sample and the end, on both sides.
  ASSERT_EQ(at(3.2, 1.5, 3.2001).size(), 1U);
  EXPECT_NEAR(at(3.2, 1.5, 3.2001)[0].t, 3.2, 1e-14);
  ASSERT_EQ(at(3.2, 3.1999, 5.5).size(), 1U);
  EXPECT_NEAR(at(3.2, 3.1999, 5.5)[0].t, 3.2, 1e-14);
  EXPECT_EQ(at(3.2, 1.5, 3.1999).size(), 0U);
}

TEST(SearchedSurface, EndsOfTheIntervalAndOfTheBox)
{
  const SearchedSurface surface(Make([](const Vec3& x) { return std::sin(M_PI * x.x); }), kBox);
  const Ray ray{ Vec3(-2.5, 0.0, 0.0), { 1.0, 0.0, 0.0 } };
  // The last one at the box's end.
  EXPECT_EQ(HitsOf(surface, ray).size(), 6U);
  EXPECT_EQ(HitsOf(surface, ray, 1.0, 2.0).size(), 1U);
  EXPECT_EQ(HitsOf(surface, ray, 6.0, 7.0).size(), 0U);
  EXPECT_EQ(HitsOf(surface, { Vec3(0.0, 4.0, 0.0), { 1.0, 0.0, 0.0 } }).size(), 0U);
}

TEST(SearchedSurface, NormalsFollowTheGradient)
{
  const SearchedSurface surface(Make([](const Vec3& x) { return glm::dot(x, x) - 1.0; }), kBox);
  SurfacePoint point;
  point.position = { 0.0, -1.0, 0.0 };
  EXPECT_EQ(surface.Normal(point), Vec3(0.0, -1.0, 0.0));
  point.position = Vec3(0.0);
  EXPECT_EQ(surface.Normal(point), Vec3(0.0));
}

TEST(SearchedSurface, NonsenseIsRefused)
{
  const auto f = Make([](const Vec3&) { return 1.0; });
  const auto refusal = [&](const Box3& box, int samples)
  { return MessageOf([&] { SearchedSurface(f, box, samples); }); };
  EXPECT_NE(refusal({ Vec3(1.0), Vec3(-1.0) }, 10).find("box"), std::string::npos);
  EXPECT_NE(refusal({ Vec3(0.0), Vec3(std::numeric_limits<double>::infinity()) }, 10).find("box"),
    std::string::npos);
  EXPECT_NE(refusal(kBox, 1).find("samples"), std::string::npos);
  EXPECT_NE(MessageOf([&] { SearchedSurface(nullptr, kBox); }).find("function"), std::string::npos);
}
} // namespace pixelexact::testing
