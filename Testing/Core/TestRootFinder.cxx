// SPDX-License-Identifier: BSD-3-Clause
// The root engine against systems whose roots are known, or found by brute force in 113 bits.
#include "MeshBuilder.h"
#include "QuadSystem.h"

#include "Core/Base/Error.h"
#include "Core/Bernstein/RootFinder.h"

#include <gtest/gtest.h>

namespace pixelexact::testing
{
namespace
{
bool HoldsPoint(const ParameterIntervals& box, int n, const QuadPoint& t)
{
  for (std::size_t d = 0; d < static_cast<std::size_t>(n); ++d)
  {
    if (t[d] < Float128(box[d].lower) || t[d] > Float128(box[d].upper))
    {
      return false;
    }
  }
  return true;
}

bool HoldsPoint(const ParameterBox& box, int n, const QuadPoint& t)
{
  ParameterIntervals intervals;
  for (std::size_t d = 0; d < 3; ++d)
  {
    intervals[d] = { box.lower[d], box.upper[d] };
  }
  return HoldsPoint(intervals, n, t);
}

/// Every root once and only once, or in an undecided box; no enclosure without a root. A multiple
/// root must not be isolated.
struct RootTally
{
  int isolated = 0;
  int undecided = 0;
};
RootTally ExpectSound(const RootSearchResult& result, int n, const std::vector<QuadPoint>& roots,
  const std::vector<int>& multiplicity = {})
{
  RootTally tally;
  std::vector<int> held(result.roots.size(), 0);
  for (std::size_t r = 0; r < roots.size(); ++r)
  {
    int enclosures = 0;
    for (std::size_t i = 0; i < result.roots.size(); ++i)
    {
      if (HoldsPoint(result.roots[i].enclosure, n, roots[r]))
      {
        ++enclosures;
        ++held[i];
      }
    }
    const bool open = std::ranges::any_of(
      result.undecided, [&](const ParameterBox& box) { return HoldsPoint(box, n, roots[r]); });
    EXPECT_LE(enclosures, 1) << "root " << r << " is listed twice";
    EXPECT_TRUE(enclosures == 1 || open)
      << "root " << r << " is lost: " << static_cast<double>(roots[r][0]) << ' '
      << static_cast<double>(roots[r][1]) << ' ' << static_cast<double>(roots[r][2]);
    for (const ParameterBox& box : result.empty)
    {
      EXPECT_FALSE(enclosures == 0 && HoldsPoint(box, n, roots[r])) << "root in an empty box";
    }
    if (!multiplicity.empty() && multiplicity[r] > 1)
    {
      EXPECT_EQ(enclosures, 0) << "a multiple root is said to be simple";
    }
    tally.isolated += enclosures;
    tally.undecided += enclosures == 0 ? 1 : 0;
  }
  for (std::size_t i = 0; i < held.size(); ++i)
  {
    EXPECT_EQ(held[i], 1) << "enclosure " << i << " holds " << held[i] << " known roots";
  }
  return tally;
}

/// (t_d - r_0) (t_d - r_1) ...
QuadPolynomial Product(int direction, const std::vector<Float128>& roots)
{
  QuadPolynomial product = QuadPolynomial::Constant(1);
  for (const Float128 root : roots)
  {
    product = product * (QuadPolynomial::Variable(direction) + QuadPolynomial::Constant(-root));
  }
  return product;
}

bool InUnitInterval(Float128 t)
{
  return t >= 0 && t <= 1;
}
} // namespace

TEST(RootFinder, SeparateRootsOfOnePolynomial)
{
  Random random(1);
  int isolated = 0;
  int undecided = 0;
  for (int degree = 1; degree <= 16; ++degree)
  {
    for (int repeat = 0; repeat < 20; ++repeat)
    {
      std::vector<Float128> all;
      std::vector<QuadPoint> inside;
      for (int i = 0; i < degree; ++i)
      {
        // One root in each of `degree` equal parts of [-0.2, 1.2].
        const double part = 1.4 / degree;
        all.emplace_back(-0.2 + part * (i + random(0.2, 0.8)));
        if (InUnitInterval(all.back()))
        {
          inside.push_back({ all.back(), 0, 0 });
        }
      }
      const QuadSystem system({ Product(0, all) });
      const auto result = FindRoots(system.Rounded(), { .keepEmpty = true });
      const RootTally tally = ExpectSound(result, 1, inside);
      isolated += tally.isolated;
      undecided += tally.undecided;
      EXPECT_FALSE(result.budgetSpent);
    }
  }
  // Coefficients in double isolate roots as far apart as these at every degree.
  EXPECT_EQ(undecided, 0);
  EXPECT_GT(isolated, 1500);
}

TEST(RootFinder, ClustersAndMultipleRoots)
{
  Random random(2);
  for (int degree = 2; degree <= 16; ++degree)
  {
    for (int repeat = 0; repeat < 20; ++repeat)
    {
      std::vector<Float128> all;
      const double centre = random(0.1, 0.9);
      const double gap = repeat % 4 == 0 ? 0.0 : std::pow(10.0, random(-12.0, -2.0));
      all.emplace_back(centre);
      all.push_back(Float128(centre) + Float128(gap));
      for (int i = 2; i < degree; ++i)
      {
        all.emplace_back(random(-0.5, 1.5));
      }
      std::vector<QuadPoint> inside;
      std::vector<int> multiplicity;
      for (std::size_t i = gap == 0.0 ? 1 : 0; i < all.size(); ++i)
      {
        if (InUnitInterval(all[i]))
        {
          inside.push_back({ all[i], 0, 0 });
          multiplicity.push_back(i == 1 && gap == 0.0 ? 2 : 1);
        }
      }
      const QuadSystem system({ Product(0, all) });
      const auto result = FindRoots(system.Rounded(), { .keepEmpty = true });
      ExpectSound(result, 1, inside, multiplicity);
      EXPECT_FALSE(result.budgetSpent) << degree << ' ' << gap;
    }
  }
}

TEST(RootFinder, NearMissesAreNotInvented)
{
  Random random(3);
  int proven = 0;
  for (int repeat = 0; repeat < 200; ++repeat)
  {
    const double centre = random(0.0, 1.0);
    const Float128 gap = Float128(std::pow(10.0, random(-9.0, -1.0)));
    const auto t = QuadPolynomial::Variable(0) + QuadPolynomial::Constant(-Float128(centre));
    const QuadSystem system({ t * t + QuadPolynomial::Constant(gap * gap) });
    const auto result = FindRoots(system.Rounded());
    EXPECT_TRUE(result.roots.empty());
    proven += result.IsComplete() ? 1 : 0;
    // Coefficients of size 1, with rounding 1e-16, distinguish a gap of 1e-7 from a double root.
    if (gap > Float128(1e-7))
    {
      EXPECT_TRUE(result.IsComplete()) << static_cast<double>(gap);
    }
  }
  EXPECT_GT(proven, 100);
}

/// A(t) p(t) with p_k = product of (t_k - roots) and A diagonally dominant: the roots are the grid.
TEST(RootFinder, GridsOfRootsBehindAMixingMatrix)
{
  Random random(4);
  for (int n = 2; n <= 3; ++n)
  {
    for (int degree = 1; degree <= (n == 2 ? 15 : 5); ++degree)
    {
      for (int repeat = 0; repeat < (n == 2 ? 3 : 2); ++repeat)
      {
        std::vector<std::vector<Float128>> roots(3);
        std::vector<QuadPolynomial> p;
        for (int k = 0; k < n; ++k)
        {
          auto& mine = roots[static_cast<std::size_t>(k)];
          for (int i = 0; i < degree; ++i)
          {
            mine.emplace_back(-0.2 + 1.4 / degree * (i + random(0.2, 0.8)));
          }
          // Values of size 1 whatever the degree.
          p.push_back(Product(k, mine) * QuadPolynomial::Constant(std::pow(2.5, degree)));
        }
        std::vector<QuadPolynomial> mixed;
        for (int k = 0; k < n; ++k)
        {
          QuadPolynomial f = p[static_cast<std::size_t>(k)];
          for (int j = 0; j < n; ++j)
          {
            const auto factor = QuadPolynomial::Constant(Float128(random(-0.2, 0.2))) +
              QuadPolynomial::Variable((j + 1) % n) *
                QuadPolynomial::Constant(Float128(random(-0.2, 0.2)));
            f = f + factor * p[static_cast<std::size_t>(j)];
          }
          mixed.push_back(f);
        }
        std::vector<QuadPoint> inside;
        const std::vector<Float128> none{ Float128(0) };
        for (const Float128 a : roots[0])
        {
          for (const Float128 b : roots[1])
          {
            for (const Float128 c : n == 3 ? roots[2] : none)
            {
              if (InUnitInterval(a) && InUnitInterval(b) && InUnitInterval(c))
              {
                inside.push_back({ a, b, c });
              }
            }
          }
        }
        const auto result =
          FindRoots(QuadSystem(mixed).Rounded(), { .budget = 200000, .keepEmpty = true });
        const RootTally tally = ExpectSound(result, n, inside);
        EXPECT_EQ(tally.undecided, 0) << n << " variables, degree " << degree;
        EXPECT_TRUE(result.IsComplete()) << n << " variables, degree " << degree;
      }
    }
  }
}

/// Equations that differ by a millionth of their size: what a stretched element's map is.
TEST(RootFinder, NearlyDependentEquations)
{
  Random random(9);
  for (int degree = 1; degree <= 4; ++degree)
  {
    std::vector<std::vector<Float128>> roots(2);
    std::vector<QuadPolynomial> p;
    for (int k = 0; k < 2; ++k)
    {
      for (int i = 0; i < degree; ++i)
      {
        roots[static_cast<std::size_t>(k)].emplace_back((i + random(0.2, 0.8)) / degree);
      }
      p.push_back(Product(k, roots[static_cast<std::size_t>(k)]) *
        QuadPolynomial::Constant(std::pow(2.5, degree)));
    }
    const std::vector<QuadPolynomial> mixed{ p[0] + p[1],
      p[0] + QuadPolynomial::Constant(Float128(1.0 + 0x1p-20)) * p[1] };
    std::vector<QuadPoint> inside;
    for (const Float128 a : roots[0])
    {
      for (const Float128 b : roots[1])
      {
        inside.push_back({ a, b, Float128(0) });
      }
    }
    const auto result = FindRoots(QuadSystem(mixed).Rounded(), { .budget = 20000 });
    const RootTally tally = ExpectSound(result, 2, inside);
    EXPECT_EQ(tally.undecided, 0) << "degree " << degree;
    EXPECT_TRUE(result.IsComplete()) << "degree " << degree;
  }
}

/// Random coefficients; roots are searched for by Newton's iteration from a grid of starts.
TEST(RootFinder, RandomSystemsAgainstBruteForce)
{
  Random random(5);
  int found = 0;
  for (int repeat = 0; repeat < 80; ++repeat)
  {
    const int n = 2 + repeat % 2;
    std::vector<QuadPolynomial> f;
    for (int k = 0; k < n; ++k)
    {
      QuadPolynomial polynomial;
      for (std::size_t d = 0; d < static_cast<std::size_t>(n); ++d)
      {
        polynomial.degree[d] = 1 + static_cast<int>(random(0.0, n == 2 ? 5.0 : 3.0));
      }
      for (std::size_t i = 0; i < CoefficientCount(polynomial.degree); ++i)
      {
        polynomial.power.emplace_back(random());
      }
      // Makes the polynomial zero at a point of the cube, so that there is a root.
      const QuadPoint through{ Float128(0.4), Float128(0.6), Float128(n == 3 ? 0.3 : 0.0) };
      polynomial.power[0] -= polynomial.Value(through);
      f.push_back(polynomial);
    }
    const QuadSystem system(f);
    const auto result = FindRoots(system.Rounded(), { .budget = 100000, .keepEmpty = true });
    std::vector<QuadPoint> roots;
    constexpr int kStarts = 4;
    for (int s = 0; s < (n == 2 ? kStarts * kStarts : kStarts * kStarts * kStarts); ++s)
    {
      const QuadPoint start{ Float128((s % kStarts + 0.5) / kStarts),
        Float128((s / kStarts % kStarts + 0.5) / kStarts),
        Float128(n == 3 ? (s / kStarts / kStarts + 0.5) / kStarts : 0.0) };
      const auto root = system.Newton(start);
      if (!root || !InUnitInterval((*root)[0]) || !InUnitInterval((*root)[1]) ||
        !InUnitInterval((*root)[2]))
      {
        continue;
      }
      const bool isNew = std::ranges::none_of(roots,
        [&](const QuadPoint& known)
        {
          return Magnitude(known[0] - (*root)[0]) + Magnitude(known[1] - (*root)[1]) +
            Magnitude(known[2] - (*root)[2]) <
            Float128(1e-20);
        });
      if (isNew)
      {
        roots.push_back(*root);
      }
    }
    // Roots that the engine found and the starts did not are confirmed by Newton's iteration from
    // there.
    for (const IsolatedRoot& isolated : result.roots)
    {
      const QuadPoint middle{ isolated.enclosure[0].Middle(), isolated.enclosure[1].Middle(),
        isolated.enclosure[2].Middle() };
      const auto root = system.Newton(middle);
      ASSERT_TRUE(root.has_value());
      EXPECT_TRUE(HoldsPoint(isolated.enclosure, n, *root));
      if (std::ranges::none_of(roots,
            [&](const QuadPoint& known) { return HoldsPoint(isolated.enclosure, n, known); }))
      {
        roots.push_back(*root);
      }
    }
    std::erase_if(roots,
      [&](const QuadPoint& t)
      { return !InUnitInterval(t[0]) || !InUnitInterval(t[1]) || !InUnitInterval(t[2]); });
    ExpectSound(result, n, roots);
    EXPECT_TRUE(result.IsComplete()) << repeat;
    found += static_cast<int>(result.roots.size());
  }
  EXPECT_GT(found, 80);
}

/// Two circles: apart, touching, crossing.
TEST(RootFinder, TangentCurves)
{
  const auto x = QuadPolynomial::Variable(0);
  const auto y = QuadPolynomial::Variable(1);
  const auto circle = [&](double cx, double cy, Float128 r)
  {
    const auto dx = x + QuadPolynomial::Constant(-Float128(cx));
    const auto dy = y + QuadPolynomial::Constant(-Float128(cy));
    return dx * dx + dy * dy + QuadPolynomial::Constant(-r * r);
  };
  for (const double off : { 1e-2, 1e-4, 1e-6, 1e-8, 0.0, -1e-8, -1e-6, -1e-4, -1e-2 })
  {
    const QuadSystem system(
      { circle(0.25, 0.5, Float128(0.25)), circle(0.75, 0.5, Float128(0.25) + Float128(off)) });
    const auto result = FindRoots(system.Rounded());
    EXPECT_FALSE(result.budgetSpent) << off;
    const int expected = off > 0.0 ? 2 : 0;
    if (std::fabs(off) > 1e-12)
    {
      EXPECT_EQ(result.roots.size(), static_cast<std::size_t>(expected)) << off;
      EXPECT_TRUE(result.IsComplete()) << off;
    }
    else
    {
      EXPECT_TRUE(result.roots.empty());
      EXPECT_EQ(result.undecided.size(), 1U);
    }
  }
}

TEST(RootFinder, RootsOnTheBoundary)
{
  for (const double at : { 0.0, 1.0 })
  {
    const QuadSystem system({ Product(0, { Float128(at), Float128(0.5) }) });
    const auto result = FindRoots(system.Rounded());
    ASSERT_EQ(result.roots.size(), 2U);
    EXPECT_TRUE(result.IsComplete());
    for (const IsolatedRoot& root : result.roots)
    {
      EXPECT_NE(root.enclosure[0].Contains(at), root.enclosure[0].Contains(0.5));
    }
  }
  // Just beyond: proven outside.
  const QuadSystem beyond({ Product(0, { Float128(1.0) + Float128(1e-12), Float128(-1e-12) }) });
  const auto result = FindRoots(beyond.Rounded());
  EXPECT_TRUE(result.roots.empty());
  EXPECT_TRUE(result.IsComplete());
}

TEST(RootFinder, OtherNumbersOfEquations)
{
  // Two equations in three variables: their curve is covered. Three in two: no solution.
  const auto x = QuadPolynomial::Variable(0);
  const auto y = QuadPolynomial::Variable(1);
  const auto z = QuadPolynomial::Variable(2);
  const auto f = (x * x + y * y + QuadPolynomial::Constant(Float128(-0.5))).Rounded();
  const auto g = (z + x * QuadPolynomial::Constant(Float128(-0.5))).Rounded();
  const TensorPolynomial curve[] = { f, g };
  const auto cover = FindRoots(PolynomialSystem(3, curve), { .smallest = 0.05 });
  EXPECT_TRUE(cover.roots.empty());
  EXPECT_FALSE(cover.budgetSpent);
  for (int i = 0; i <= 100; ++i)
  {
    const double angle = i * 0.5 * 3.14159265358979 / 100;
    const QuadPoint on{ Float128(std::sqrt(0.5) * std::cos(angle)),
      Float128(std::sqrt(0.5) * std::sin(angle)),
      Float128(0.5 * std::sqrt(0.5) * std::cos(angle)) };
    if (InUnitInterval(on[0]) && InUnitInterval(on[1]))
    {
      EXPECT_TRUE(std::ranges::any_of(
        cover.undecided, [&](const ParameterBox& box) { return HoldsPoint(box, 3, on); }));
    }
  }
  const TensorPolynomial many[] = { f, (x + QuadPolynomial::Constant(Float128(-0.5))).Rounded(),
    (y + QuadPolynomial::Constant(Float128(-0.25))).Rounded() };
  EXPECT_TRUE(FindRoots(PolynomialSystem(2, many)).IsComplete());
}

TEST(RootFinder, NothingIsProvenOfWhatIsNotKnown)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const TensorPolynomial& f :
    { TensorPolynomial{ { 2, 0, 0 }, { 1.0, nan, 1.0 }, 0.0 },
      TensorPolynomial{ { 2, 0, 0 }, { 1.0, 1.0, 1.0 }, 1.5 },
      TensorPolynomial{ { 2, 0, 0 }, { 1.0, std::numeric_limits<double>::infinity(), 1.0 }, 0.0 },
      TensorPolynomial{ { 0, 0, 0 }, { 0.0 }, 0.0 } })
  {
    const auto result = FindRoots(PolynomialSystem(1, std::span(&f, 1)), { .budget = 100 });
    EXPECT_TRUE(result.roots.empty());
    EXPECT_FALSE(result.IsComplete());
  }
}

TEST(RootFinder, RefusesWhatIsNoSystem)
{
  const TensorPolynomial line{ { 1, 0, 0 }, { -1.0, 1.0 }, 0.0 };
  const TensorPolynomial wrong{ { 1, 1, 0 }, { -1.0, 1.0 }, 0.0 };
  const TensorPolynomial high{ { kMaxDegree + 1, 0, 0 }, std::vector<double>(kMaxDegree + 2, 1.0),
    0.0 };
  EXPECT_THROW(PolynomialSystem(0, std::span(&line, 1)), InvalidData);
  EXPECT_THROW(PolynomialSystem(1, {}), InvalidData);
  EXPECT_THROW(PolynomialSystem(2, std::span(&wrong, 1)), InvalidData);
  EXPECT_THROW(PolynomialSystem(1, std::span(&wrong, 1)), InvalidData);
  EXPECT_THROW(PolynomialSystem(1, std::span(&high, 1)), InvalidData);
}
} // namespace pixelexact::testing
