// SPDX-License-Identifier: BSD-3-Clause
// The study's references against closed forms that share nothing with the code under test.
#include "Stability/Elements.h"
#include "Stability/EvaluationStudy.h"
#include "Stability/Reference.h"
#include "Stability/RoundingTape.h"

#include "Core/Basis/ModeBound.h"

#include <gtest/gtest.h>
#include <mpfr.h>

namespace pixelexact::testing
{
namespace
{
/// A number of 600 bits.
class Big
{
public:
  Big(double value = 0.0)
  {
    mpfr_init2(V, 600);
    mpfr_set_d(V, value, MPFR_RNDN);
  }
  Big(const Big& other)
    : Big()
  {
    mpfr_set(V, other.V, MPFR_RNDN);
  }
  Big& operator=(const Big& other)
  {
    mpfr_set(V, other.V, MPFR_RNDN);
    return *this;
  }
  ~Big() { mpfr_clear(V); }

  Big& operator+=(const Big& b)
  {
    mpfr_add(V, V, b.V, MPFR_RNDN);
    return *this;
  }
  Big& operator-=(const Big& b)
  {
    mpfr_sub(V, V, b.V, MPFR_RNDN);
    return *this;
  }
  Big& operator*=(const Big& b)
  {
    mpfr_mul(V, V, b.V, MPFR_RNDN);
    return *this;
  }
  Big& operator/=(const Big& b)
  {
    mpfr_div(V, V, b.V, MPFR_RNDN);
    return *this;
  }
  friend Big operator+(Big a, const Big& b) { return a += b; }
  friend Big operator-(Big a, const Big& b) { return a -= b; }
  friend Big operator*(Big a, const Big& b) { return a *= b; }
  friend Big operator/(Big a, const Big& b) { return a /= b; }
  explicit operator double() const { return mpfr_get_d(V, MPFR_RNDN); }

private:
  mpfr_t V;
};

/// Exact: the three parts of a Quad are doubles.
Big ToBig(Quad value)
{
  Big sum;
  for (int part = 0; part < 3; ++part)
  {
    const auto leading = static_cast<double>(value);
    sum += leading;
    value = value - Quad(leading);
  }
  return sum;
}

Big Binomial(int n, int k)
{
  Big b = 1.0;
  for (int i = 1; i <= k; ++i)
  {
    b = b * Big(n - k + i) / Big(i);
  }
  return b;
}

/// h^0, h^1, ...
std::vector<Big> Powers(const Big& h, int count)
{
  std::vector<Big> powers{ Big(1.0) };
  while (static_cast<int>(powers.size()) < count)
  {
    powers.push_back(powers.back() * h);
  }
  return powers;
}

/// P_n^{(alpha,0)}(z) = sum over s of C(n+alpha, n-s) C(n, s) ((z-1)/2)^s ((z+1)/2)^{n-s}, kept by
/// alpha and n.
class JacobiSums
{
public:
  explicit JacobiSums(const Big& z)
    : Lower(Powers((z - Big(1.0)) / Big(2.0), kMaxOrder + 1))
    , Upper(Powers((z + Big(1.0)) / Big(2.0), kMaxOrder + 1))
  {
  }

  const Big& operator()(int alpha, int n)
  {
    const auto [entry, isNew] = Known.try_emplace({ alpha, n });
    for (int s = 0; isNew && s <= n; ++s)
    {
      entry->second += Binomial(n + alpha, n - s) * Binomial(n, s) * Lower[s] * Upper[n - s];
    }
    return entry->second;
  }

private:
  std::vector<Big> Lower;
  std::vector<Big> Upper;
  std::map<std::pair<int, int>, Big> Known;
};

/// The modes of Space.h at a xi off what the shape collapses.
class ClosedForm
{
public:
  ClosedForm(const Space& space, const Vec3& xi)
    : space_(space)
    , Eta(ToEta(space.shape, xi))
    , Sums{ JacobiSums(Eta[0]), JacobiSums(Eta[1]), JacobiSums(Eta[2]) }
    , H2(Powers((Big(1.0) - Eta[1]) / Big(2.0), kMaxOrder + 1))
    , H3(Powers((Big(1.0) - Eta[2]) / Big(2.0), kMaxOrder + 1))
  {
  }

  Big operator()(int p, int q, int r)
  {
    const int m = std::max(p, q);
    const bool plain = space_.shape == Shape::Hexahedron || space_.form == Form::Tensor;
    if (plain)
    {
      return Sums[0](0, p) * Sums[1](0, q) * Sums[2](0, r);
    }
    switch (space_.shape)
    {
      case Shape::Prism:
        return Sums[0](0, p) * Sums[1](0, q) * H3[p] * Sums[2](2 * p + 1, r);
      case Shape::Tetrahedron:
        return Sums[0](0, p) * H2[p] * Sums[1](2 * p + 1, q) * H3[p + q] *
          Sums[2](2 * p + 2 * q + 2, r);
      default:
        return Sums[0](0, p) * Sums[1](0, q) * H3[m] * Sums[2](2 * m + 2, r);
    }
  }

private:
  static std::array<Big, 3> ToEta(Shape shape, const Vec3& xi)
  {
    const Big one = 1.0;
    const Big a = xi.x;
    const Big b = xi.y;
    const Big c = xi.z;
    const auto ratio = [&](const Big& x, const Big& width)
    { return Big(2.0) * (one + x) / width - one; };
    switch (shape)
    {
      case Shape::Hexahedron:
        return { a, b, c };
      case Shape::Prism:
        return { ratio(a, one - c), b, c };
      case Shape::Tetrahedron:
        return { ratio(a, Big(0.0) - b - c), ratio(b, one - c), c };
      default:
        return { ratio(a, one - c), ratio(b, one - c), c };
    }
  }

  Space space_;
  std::array<Big, 3> Eta;
  std::array<JacobiSums, 3> Sums;
  std::vector<Big> H2;
  std::vector<Big> H3;
};
} // namespace

TEST(Reference, ModesOfOrder32AgreeWithExplicitSums)
{
  Random random(61);
  for (const Space& space : EvaluationSpaces(kMaxOrder))
  {
    for (int trial = 0; trial < 2; ++trial)
    {
      const Vec3 xi = TensorToReference(
        space.shape, { random(-0.99, 0.99), random(-0.99, 0.99), random(-0.99, 0.99) });
      const auto modes = Modes(space, ToQuad(xi));
      ClosedForm closed(space, xi);
      double worst = 0.0;
      ForEachMode(space,
        [&](int p, int q, int r, int mode)
        {
          const auto off = static_cast<double>(ToBig(modes[mode]) - closed(p, q, r));
          Raise(worst, std::fabs(off) / ModeBound(space, p, q, r));
        });
      // Quad's 2^-113 is 1e-34; the recurrences lose about the square of the order.
      EXPECT_LT(worst, 1e-30) << Name(space.shape);
    }
  }
}

TEST(Reference, GradientsAreTheSlopesOfValues)
{
  Random random(62);
  for (const Space& space : EvaluationSpaces(9))
  {
    std::vector<double> coefficients(space.Modes());
    for (double& c : coefficients)
    {
      c = random();
    }
    const QuadVec3 xi =
      ToQuad(TensorToReference(space.shape, { random(-0.9, 0.9), random(-0.9, 0.9), 0.3 }));
    const auto sample = Evaluate(space, coefficients.data(), xi);
    for (std::size_t d = 0; d < 3; ++d)
    {
      const Quad step = 1e-10;
      QuadVec3 up = xi;
      QuadVec3 down = xi;
      up[d] = up[d] + step;
      down[d] = down[d] - step;
      const Quad slope = (Evaluate(space, coefficients.data(), up).value -
                           Evaluate(space, coefficients.data(), down).value) /
        (2 * step);
      // The third derivative, of order 9^6, times the square of the step.
      EXPECT_LT(std::fabs(static_cast<double>(slope - sample.gradient[d])), 1e-13);
    }
  }
}

TEST(Reference, TapeBoundsWhatRoundingDoes)
{
  // x^2 of two roundings: of the recurrence's constant 3/2 none, of 1/2 none, of x itself none.
  const Space space{ Shape::Hexahedron, Form::Collapsed, { 1, 0, 0 } };
  const double coefficients[2] = { 1.0, 1.0 };
  // 1 + xi1: the products by the other directions' constant modes round as well.
  const double bound = ValueRounding(space, coefficients, { 0.3, 0.0, 0.0 });
  EXPECT_GT(bound, 0.5 * 1.3 * 0x1p-53);
  EXPECT_LT(bound, 10.0 * 1.3 * 0x1p-53);
}

TEST(Elements, SpiralTurnsOneWayAndItsTurnsStayApart)
{
  for (const double turns : { 0.5, 1.0, 1.5, 2.0, 2.5 })
  {
    constexpr int kSteps = 2000;
    std::vector<double> angle;
    std::vector<double> radius;
    for (int k = 0; k <= kSteps; ++k)
    {
      const auto [x, y] = SpiralMidline(turns, 2.0L * k / kSteps - 1);
      auto at = static_cast<double>(std::atan2(y, x));
      while (!angle.empty() && at < angle.back())
      {
        at += 2.0 * 3.14159265358979;
      }
      angle.push_back(at);
      radius.push_back(static_cast<double>(std::hypot(x, y)));
      if (k > 0)
      {
        ASSERT_LT(angle[k] - angle[k - 1], 0.1) << turns;
      }
    }
    for (std::size_t inner = 0, outer = 0; inner < angle.size(); ++inner)
    {
      while (outer < angle.size() && angle[outer] < angle[inner] + 2.0 * 3.14159265358979)
      {
        ++outer;
      }
      if (outer < angle.size())
      {
        // 1.132 and 0.868 are where points beyond the faces end.
        ASSERT_GT(0.868 * radius[outer], 1.132 * radius[inner]) << turns;
      }
    }
  }
}
} // namespace pixelexact::testing
