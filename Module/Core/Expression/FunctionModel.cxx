// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/FunctionModel.h"

#include "Core/Expression/IntervalOperations.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

// Taylor coefficients follow from recurrences in interval arithmetic (R. Moore, Interval Analysis,
// 1966, chapter 11).
namespace pixelexact
{
namespace
{
using Coefficients = std::vector<Interval>;

Interval Number(std::size_t k)
{
  return Interval(static_cast<double>(k));
}

Interval OverFactorial(const Interval& value, std::size_t n)
{
  Interval quotient = value;
  for (std::size_t k = 2; k <= n; ++k)
  {
    quotient = quotient / Number(k);
  }
  return quotient;
}

/// x^exponent.
Interval Raised(const Interval& x, const Interval& exponent)
{
  const Graph::Node power{ .operation = Operation::Power };
  const std::array<KnownInterval, 2> arguments{ KnownInterval{ x }, KnownInterval{ exponent } };
  const KnownInterval raised = ApplyToIntervals(power, arguments);
  return raised.mayBeNaN ? Interval::Everything() : raised.value;
}

/// binomial(exponent, n) x^(exponent - n).
Interval OfPower(double exponent, std::size_t n, const Interval& x)
{
  if (x.Contains(0.0) || (x.lower < 0.0 && exponent != std::floor(exponent)))
  {
    return Interval::Everything();
  }
  Interval factor(1.0);
  for (std::size_t k = 0; k < n; ++k)
  {
    factor = factor * (Interval(exponent) - Number(k)) / Number(k + 1);
  }
  // Whole powers are products; others need no exact exponent.
  const bool isWhole = exponent == std::floor(exponent);
  const double left = exponent - static_cast<double>(n);
  return factor * Raised(x, isWhole ? Interval(left) : Interval(exponent) - Number(n));
}

/// The coefficients to n of w^exponent for w = w0 + w1 d + w2 d^2, whose power starts with `first`:
/// k w0 s_k = sum over j of (exponent j - (k - j)) w_j s_(k-j).
Coefficients PowerOfQuadratic(
  const std::array<Interval, 3>& w, double exponent, const Interval& first, std::size_t n)
{
  Coefficients s{ first };
  for (std::size_t k = 1; k <= n; ++k)
  {
    Interval sum(0.0);
    for (std::size_t j = 1; j <= 2 && j <= k; ++j)
    {
      sum += (Interval(exponent) * Number(j) - Number(k - j)) * w[j] * s[k - j];
    }
    s.push_back(sum / (Number(k) * w[0]));
  }
  return s;
}

/// tan and tanh, whose derivative is 1 + sign f^2.
Interval OfTangent(const Interval& value, double sign, std::size_t n)
{
  Coefficients f{ value };
  for (std::size_t k = 0; k < n; ++k)
  {
    Interval square(0.0);
    for (std::size_t j = 0; j <= k; ++j)
    {
      square += f[j] * f[k - j];
    }
    f.push_back((Interval(k == 0 ? 1.0 : 0.0) + Interval(sign) * square) / Number(k + 1));
  }
  return f[n];
}

/// The error function, whose derivative is 2 / sqrt(pi) exp(-x^2).
Interval OfErrorFunction(const Interval& x, std::size_t n)
{
  Coefficients e{ FunctionOf(Operation::Exp, -Square(x)) };
  for (std::size_t k = 1; k < n; ++k)
  {
    Interval sum = Interval(-2.0) * x * e[k - 1];
    if (k >= 2)
    {
      sum = sum - Interval(2.0) * e[k - 2];
    }
    e.push_back(sum / Number(k));
  }
  return Interval::Around(2.0 * std::numbers::inv_sqrtpi, 1e-15) * e[n - 1] / Number(n);
}
} // namespace

Interval TaylorCoefficient(Operation operation, double exponent, std::size_t n, const Interval& x)
{
  const Interval one(1.0);
  const auto value = [&x](Operation of) { return FunctionOf(of, x); };
  // The derivative of order n of sin is sin, cos, -sin, -cos in turn.
  const auto wave = [&](std::size_t turn)
  {
    return OverFactorial(value(turn % 2 == 0 ? Operation::Sin : Operation::Cos), n) *
      Interval(turn % 4 < 2 ? 1.0 : -1.0);
  };
  switch (operation)
  {
    case Operation::Power:
      return OfPower(exponent, n, x);
    case Operation::Exp:
      return OverFactorial(value(Operation::Exp), n);
    case Operation::Log:
      return x.lower > 0.0 ? OfPower(-1.0, n - 1, x) / Number(n) : Interval::Everything();
    case Operation::Sin:
      return wave(n);
    case Operation::Cos:
      return wave(n + 1);
    case Operation::Sinh:
      return OverFactorial(value(n % 2 == 0 ? Operation::Sinh : Operation::Cosh), n);
    case Operation::Cosh:
      return OverFactorial(value(n % 2 == 0 ? Operation::Cosh : Operation::Sinh), n);
    case Operation::Tan:
      return OfTangent(value(Operation::Tan), 1.0, n);
    case Operation::Tanh:
      return OfTangent(value(Operation::Tanh), -1.0, n);
    case Operation::Atan:
    {
      const Interval square = one + Square(x);
      return PowerOfQuadratic(
               { square, Interval(2.0) * x, one }, -1.0, one / square, n - 1)[n - 1] /
        Number(n);
    }
    case Operation::Asin:
    case Operation::Acos:
    {
      const Interval square = one - Square(x);
      if (!(square.lower > 0.0))
      {
        return Interval::Everything();
      }
      const Interval slope = PowerOfQuadratic(
        { square, Interval(-2.0) * x, -one }, -0.5, one / Sqrt(square), n - 1)[n - 1];
      return (operation == Operation::Asin ? slope : -slope) / Number(n);
    }
    case Operation::Erf:
      return OfErrorFunction(x, n);
    default:
      return Interval::Everything();
  }
}

namespace
{
constexpr std::size_t kPoints = std::size_t{ ChebyshevModel::kDegree } + 1;

Interval ValueAt(Operation operation, double exponent, const Interval& x)
{
  return operation == Operation::Power ? Raised(x, exponent) : FunctionOf(operation, x);
}

/// A function of one variable on [middle - radius, middle + radius] as a Chebyshev series.
struct Series
{
  double middle;
  double radius;
  std::array<double, kPoints> c{};
  double error = 0.0; ///< bounds the remainder and all rounding
};

/// Interpolates an operation at Chebyshev's points of a range; none where it is not smooth there.
std::optional<Series> SeriesOf(Operation operation, double exponent, const Interval& range)
{
  if (!range.IsFinite())
  {
    return std::nullopt;
  }
  Series series{ .middle = range.Middle(), .radius = range.RadiusAround(range.Middle()) };
  const Interval next = TaylorCoefficient(operation, exponent, kPoints, range);
  if (!next.IsFinite() || !std::isfinite(series.radius))
  {
    return std::nullopt;
  }
  std::array<double, kPoints> values{};
  double inValues = 0.0;
  double largest = 0.0;
  const auto angle = [](std::size_t k)
  { return (2.0 * static_cast<double>(k) + 1.0) * std::numbers::pi / (2.0 * kPoints); };
  for (std::size_t k = 0; k < kPoints; ++k)
  {
    const double at = series.middle + series.radius * std::cos(angle(k));
    const Interval place =
      Interval::Around(at, 8.0 * kUnitRoundoff * (std::fabs(series.middle) + series.radius));
    const Interval value = ValueAt(operation, exponent, place);
    if (!value.IsFinite())
    {
      return std::nullopt;
    }
    values[k] = value.Middle();
    inValues = std::max(inValues, value.RadiusAround(values[k]));
    largest = std::max(largest, std::fabs(values[k]));
  }
  for (std::size_t j = 0; j < kPoints; ++j)
  {
    double sum = 0.0;
    for (std::size_t k = 0; k < kPoints; ++k)
    {
      sum += values[k] * std::cos(static_cast<double>(j) * angle(k));
    }
    series.c[j] = sum * (j == 0 ? 1.0 : 2.0) / static_cast<double>(kPoints);
  }
  // |f - p| <= radius^n |f^(n)| / n! / 2^(n - 1), n points. Each coefficient is a mean of the
  // values with weights of at most 2, and the cosines are off by some roundings.
  const double remainder = Up(std::pow(series.radius, static_cast<double>(kPoints)) *
    next.Magnitude() * std::ldexp(1.0, 1 - static_cast<int>(kPoints)));
  constexpr double kCosineRounding = 64.0 * kUnitRoundoff;
  series.error = Up(remainder +
    2.0 * static_cast<double>(kPoints) * (inValues + (kCosineRounding + Gamma(32)) * largest));
  return series;
}

/// The series at the values of a model, by Clenshaw's recurrence.
ChebyshevModel ValueOf(const Series& series, const ChebyshevModel& f)
{
  if (series.radius == 0.0)
  {
    ChebyshevModel constant(series.c[0]);
    constant.Widen(series.error);
    return constant;
  }
  const ChebyshevModel t =
    (f - ChebyshevModel(series.middle)) * ChebyshevModel(Interval(1.0) / Interval(series.radius));
  const ChebyshevModel twice = 2.0 * t;
  ChebyshevModel above;
  ChebyshevModel sum;
  for (std::size_t j = kPoints - 1; j > 0; --j)
  {
    const ChebyshevModel next = twice * sum - above + ChebyshevModel(series.c[j]);
    above = sum;
    sum = next;
  }
  ChebyshevModel value = t * sum - above + ChebyshevModel(series.c[0]);
  value.Widen(series.error);
  return value;
}
} // namespace

ChebyshevModel ComposeFunction(
  Operation operation, const ChebyshevModel& f, const Interval& range, double exponent)
{
  const std::optional<Series> series = SeriesOf(operation, exponent, range);
  return series ? ValueOf(*series, f) : ChebyshevModel(Interval::Everything());
}
} // namespace pixelexact
