// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bernstein/AffineForm.h"

#include "Core/Math/Rounding.h"

#include <cmath>

namespace pixelexact
{
namespace
{
constexpr Interval kUnit{ -1.0, 1.0 };
/// Larger than any underflow of a few operations.
constexpr double kFormUnderflow = 0x1p-1060;

/// The interval from -r to r for a radius that was computed from magnitudes with at most 12
/// roundings.
Interval Within(double radius)
{
  const double r = radius * (1.0 + Gamma(16)) + kFormUnderflow;
  return { -r, r };
}

double LinearRadius(const AffineForm& f)
{
  return std::fabs(f.b[0]) + std::fabs(f.b[1]) + std::fabs(f.b[2]);
}

/// Returns -inf to inf where a coefficient is not finite.
AffineForm Checked(const AffineForm& f)
{
  // Sums of finite numbers that overflow are given up as well.
  if (std::isfinite(f.a + f.b[0] + f.b[1] + f.b[2]) && !f.e.IsEmpty())
  {
    return f;
  }
  AffineForm all;
  all.e = Interval::Everything();
  return all;
}

/// (b_f . t)(b_g . t) over the cube.
Interval QuadraticRange(const AffineForm& f, const AffineForm& g)
{
  double lower = 0.0;
  double upper = 0.0;
  double mixed = 0.0;
  double size = 0.0;
  for (std::size_t d = 0; d < 3; ++d)
  {
    const double square = f.b[d] * g.b[d];
    (square < 0.0 ? lower : upper) += square;
    size += std::fabs(square);
    for (std::size_t k = d + 1; k < 3; ++k)
    {
      const double dk = f.b[d] * g.b[k];
      const double kd = f.b[k] * g.b[d];
      mixed += std::fabs(dk + kd);
      size += std::fabs(dk) + std::fabs(kd);
    }
  }
  const double rounding = Gamma(16) * size + kFormUnderflow;
  return { lower - mixed - rounding, upper + mixed + rounding };
}

template <class Operation>
AffineForm TermByTerm(const AffineForm& f, const AffineForm& g, Operation&& apply)
{
  AffineForm h;
  h.a = apply(f.a, g.a);
  double size = std::fabs(h.a);
  for (std::size_t d = 0; d < 3; ++d)
  {
    h.b[d] = apply(f.b[d], g.b[d]);
    size += std::fabs(h.b[d]);
  }
  // One rounding of each sum, which does not underflow.
  h.e = apply(f.e, g.e) + Within(2.0 * kUnitRoundoff * size);
  return Checked(h);
}

/// The product without the quadratic term.
AffineForm LinearProduct(const AffineForm& f, const AffineForm& g)
{
  AffineForm h;
  h.a = f.a * g.a;
  double size = std::fabs(h.a);
  for (std::size_t d = 0; d < 3; ++d)
  {
    const double fg = f.a * g.b[d];
    const double gf = g.a * f.b[d];
    h.b[d] = fg + gf;
    size += std::fabs(fg) + std::fabs(gf);
  }
  // Two roundings of each term at most.
  h.e = f.e * (Interval(g.a) + Within(LinearRadius(g))) + g.e * f.Range() + Within(Gamma(3) * size);
  return h;
}
} // namespace

Interval AffineForm::Range() const
{
  return Interval(a) + Within(LinearRadius(*this)) + e;
}

AffineForm operator+(const AffineForm& f, const AffineForm& g)
{
  return TermByTerm(f, g, [](const auto& x, const auto& y) { return x + y; });
}

AffineForm operator-(const AffineForm& f, const AffineForm& g)
{
  return TermByTerm(f, g, [](const auto& x, const auto& y) { return x - y; });
}

AffineForm operator*(const AffineForm& f, const AffineForm& g)
{
  AffineForm h = LinearProduct(f, g);
  h.e += QuadraticRange(f, g);
  return Checked(h);
}

AffineForm Square(const AffineForm& f)
{
  AffineForm h = LinearProduct(f, f);
  h.e += Intersect(QuadraticRange(f, f), Square(Within(LinearRadius(f))));
  return Checked(h);
}

AffineForm Reciprocal(const AffineForm& f)
{
  const Interval range = f.Range();
  AffineForm h;
  if (!range.IsFinite() || range.Contains(0.0))
  {
    h.e = Interval::Everything();
    return h;
  }
  // With d = f - m: 1 / f = 1 / m - d / m^2 + d^2 / (m^2 f), exactly.
  const double m = range.Middle();
  const Interval r = Interval(1.0) / m;
  const Interval slope = -Square(r);
  const double s = -(1.0 / m) * (1.0 / m);
  AffineForm d = f - AffineForm(m);
  h.a = 1.0 / m + s * d.a;
  h.e = r + Interval(s) * d.a - h.a;
  for (std::size_t k = 0; k < 3; ++k)
  {
    h.b[k] = s * d.b[k];
    h.e += (Interval(s) * d.b[k] - h.b[k]) * kUnit;
  }
  const Interval all = Intersect(d.Range(), range - m);
  h.e += Interval(s) * d.e + (slope - s) * all + Square(all) * Square(r) / range;
  return Checked(h);
}
} // namespace pixelexact
