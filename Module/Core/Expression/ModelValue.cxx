// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/ModelValue.h"

#include "Core/Expression/NodeList.h"
#include "Core/Expression/TaylorCoefficient.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>

namespace pixelexact
{
namespace
{
constexpr std::size_t kPoints = std::size_t{ ChebyshevModel::kDegree } + 1;

ChebyshevModel NoModel()
{
  return ChebyshevModel(Interval::Everything());
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

/// An operation of one argument whose values are in `range`.
ChebyshevModel Composed(
  Operation operation, const ChebyshevModel& f, const Interval& range, double exponent = 0.0)
{
  const std::optional<Series> series = SeriesOf(operation, exponent, range);
  return series ? ValueOf(*series, f) : NoModel();
}

/// The range from the model's Bernstein form, which is sharper than `known` alone.
Interval RangeOf(const ModelValue& f)
{
  const Interval tight = Intersect(f.known.value, f.model.TightRange());
  return tight.IsEmpty() ? f.known.value : tight;
}

ChebyshevModel ReciprocalModel(const ModelValue& f)
{
  ChebyshevModel inverse = Reciprocal(f.model);
  return std::isfinite(inverse.error) ? inverse
                                      : Composed(Operation::Power, f.model, RangeOf(f), -1.0);
}

ChebyshevModel RootModel(const ModelValue& f)
{
  ChebyshevModel root = SquareRoot(f.model);
  return std::isfinite(root.error) ? root : Composed(Operation::Power, f.model, RangeOf(f), 0.5);
}

/// v^n for n >= 0.
ChebyshevModel WholePower(const ChebyshevModel& v, int n)
{
  ChebyshevModel power(1.0);
  ChebyshevModel square = v;
  for (int left = n; left > 0; left /= 2)
  {
    power = left % 2 == 1 ? power * square : power;
    square = left > 1 ? square * square : square;
  }
  return power;
}

ChebyshevModel PowerModel(const ModelValue& f, const ModelValue& exponent)
{
  constexpr double kMaxWhole = 64.0;
  const Interval& b = exponent.known.value;
  if (b.lower == b.upper && b.lower == std::floor(b.lower) && std::fabs(b.lower) <= kMaxWhole)
  {
    const int n = static_cast<int>(std::fabs(b.lower));
    const ModelValue power(WholePower(f.model, n));
    return b.lower < 0.0 ? ReciprocalModel(power) : power.model;
  }
  const Interval range = RangeOf(f);
  if (!(range.lower > 0.0))
  {
    return NoModel();
  }
  if (b.lower == b.upper)
  {
    return Composed(Operation::Power, f.model, range, b.lower);
  }
  const ChebyshevModel logarithm = exponent.model * Composed(Operation::Log, f.model, range);
  return Composed(Operation::Exp, logarithm, logarithm.TightRange());
}

/// atan2(y, x): pi / 2 - atan(x / y) where y > 0, -pi / 2 - atan(x / y) where y < 0, atan(y / x)
/// where x > 0.
ChebyshevModel AngleModel(const ModelValue& y, const ModelValue& x)
{
  const Interval ofY = RangeOf(y);
  const bool byX = ofY.Contains(0.0);
  if (byX && !(RangeOf(x).lower > 0.0))
  {
    return NoModel();
  }
  const ChebyshevModel ratio = byX ? y.model * ReciprocalModel(x) : x.model * ReciprocalModel(y);
  const ChebyshevModel angle = Composed(Operation::Atan, ratio, ratio.TightRange());
  const Interval quarter = Interval::Around(0.5 * std::numbers::pi, 2e-16);
  return byX ? angle : ChebyshevModel(ofY.lower > 0.0 ? quarter : -quarter) - angle;
}

/// The value in the middle of the square.
Interval AtMiddle(const ChebyshevModel& f)
{
  Interval sum(-f.error, f.error);
  // T_n(0) is 0 for odd n, and 1 and -1 in turn for even ones.
  for (int i = 0; i <= ChebyshevModel::kDegree; i += 2)
  {
    for (int j = 0; i + j <= ChebyshevModel::kDegree; j += 2)
    {
      const double sign = (i + j) % 4 == 0 ? 1.0 : -1.0;
      sum += Interval(sign * f.c[ChebyshevModel::Index(i, j)]);
    }
  }
  return sum;
}

/// An eigenvalue of a symmetric matrix xx, yy, zz, xy, yz, xz: Newton's iteration for a zero l of
/// the characteristic polynomial p. Where p' is at least m about l, within a distance of more than
/// |p(l)| / m, one zero is within |p(l)| / m of l. It is simple and continuous, so its number is
/// the same all over the square as in the middle.
ChebyshevModel EigenvalueModel(const Graph::Node& node, std::span<const ModelValue> m)
{
  std::array<KnownInterval, 6> atMiddle;
  std::ranges::transform(m, atMiddle.begin(),
    [](const ModelValue& entry) { return KnownInterval{ AtMiddle(entry.model) }; });
  const Interval middle = ApplyToIntervals(node, atMiddle).value;
  if (!middle.IsFinite() || std::ranges::any_of(m, &ModelValue::mayJump))
  {
    return NoModel();
  }
  const auto& [xx, yy, zz] = std::tie(m[0].model, m[1].model, m[2].model);
  const auto& [xy, yz, xz] = std::tie(m[3].model, m[4].model, m[5].model);
  const ChebyshevModel trace = xx + yy + zz;
  const ChebyshevModel minors = xx * yy - xy * xy + (yy * zz - yz * yz) + (xx * zz - xz * xz);
  const ChebyshevModel determinant =
    xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
  const auto slopeAt = [&](const ChebyshevModel& l)
  { return (3.0 * l - 2.0 * trace) * l + minors; };
  const auto valueAt = [&](const ChebyshevModel& l)
  { return ((l - trace) * l + minors) * l - determinant; };
  ChebyshevModel l(middle.Middle());
  constexpr int kSteps = 6;
  for (int step = 0; step < kSteps; ++step)
  {
    const ChebyshevModel inverse = Reciprocal(slopeAt(l).Polynomial());
    if (!std::isfinite(inverse.error))
    {
      return NoModel();
    }
    l = (l - valueAt(l).Polynomial() * inverse.Polynomial()).Polynomial();
  }
  const double left = valueAt(l).TightRange().Magnitude();
  const Interval slope = slopeAt(l).TightRange();
  // p'(l + d) = p'(l) + d p''(l) + 3 d^2.
  const double reach = Up(4.0 * left / slope.Mignitude());
  const Interval around(-reach, reach);
  const Interval bend = (6.0 * l - 2.0 * trace).TightRange();
  const double least = (slope + around * bend + Interval(3.0) * Square(around)).Mignitude();
  const double off = Up(left / least);
  const Interval place = AtMiddle(l);
  if (!(least > 0.0 && off < reach) || !(middle.lower > place.upper - reach) ||
    !(middle.upper < place.lower + reach))
  {
    return NoModel();
  }
  l.Widen(off);
  return l;
}

/// The model of a node; without a bound where there is none but the range.
ChebyshevModel ModelOf(const Graph::Node& node, std::span<const ModelValue> a)
{
  switch (node.operation)
  {
    case Operation::Negate:
      return -1.0 * a[0].model;
    case Operation::Divide:
      return a[0].model * ReciprocalModel(a[1]);
    case Operation::Sqrt:
      return RootModel(a[0]);
    case Operation::Power:
      return PowerModel(a[0], a[1]);
    case Operation::Atan2:
      return AngleModel(a[0], a[1]);
    case Operation::Eigenvalue:
      return EigenvalueModel(node, a);
    case Operation::Abs:
    {
      const Interval values = RangeOf(a[0]);
      return values.lower >= 0.0 ? a[0].model : values.upper <= 0.0 ? -1.0 * a[0].model : NoModel();
    }
    case Operation::Min:
    case Operation::Max:
    {
      const Interval above = RangeOf(ModelValue(a[0].model - a[1].model));
      const bool isSmaller = node.operation == Operation::Min;
      return above.lower >= 0.0 ? a[isSmaller ? 1 : 0].model
        : above.upper <= 0.0    ? a[isSmaller ? 0 : 1].model
                                : NoModel();
    }
    case Operation::Select:
      return !a[0].known.value.Contains(0.0)                             ? a[1].model
        : a[0].known.value.lower == 0.0 && a[0].known.value.upper == 0.0 ? a[2].model
                                                                         : NoModel();
    case Operation::Sign:
    case Operation::Floor:
    case Operation::Ceil:
    case Operation::Eigenvector:
      return NoModel();
    default:
      return IsTruth(node.operation) ? NoModel()
                                     : Composed(node.operation, a[0].model, RangeOf(a[0]));
  }
}
} // namespace

ModelValue::ModelValue(double value)
  : model(value)
  , known{ Interval(value), false }
{
}

ModelValue::ModelValue(const KnownInterval& interval)
  : model(interval.mayBeNaN ? Interval::Everything() : interval.value)
  , known(interval)
{
}

ModelValue::ModelValue(const ChebyshevModel& itsModel)
  : ModelValue(itsModel, { itsModel.TightRange(), false }, true)
{
}

ModelValue::ModelValue(
  const ChebyshevModel& itsModel, const KnownInterval& interval, bool areDefined)
  : model(itsModel)
  , known(interval)
{
  const Interval ofModel = model.Range();
  const Interval both = Intersect(known.value, ofModel);
  known.value = both.IsEmpty() ? known.value : both;
  known.mayBeNaN =
    !known.value.IsFinite() || (known.mayBeNaN && !(areDefined && ofModel.IsFinite()));
  if (known.mayBeNaN)
  {
    model = NoModel();
  }
  else if (!(model.error < known.value.RadiusAround(known.value.Middle())))
  {
    model = ChebyshevModel(known.value);
  }
}

namespace
{
ModelValue Combined(
  const ChebyshevModel& model, const Interval& range, const ModelValue& f, const ModelValue& g)
{
  ModelValue value(model, { range, f.known.mayBeNaN || g.known.mayBeNaN }, false);
  value.mayJump = f.mayJump || g.mayJump;
  return value;
}

ModelValue Square(const ModelValue& f)
{
  return Combined(f.model * f.model, Square(f.known.value), f, f);
}
} // namespace

ModelValue operator+(const ModelValue& f, const ModelValue& g)
{
  return Combined(f.model + g.model, SumOf(f.known.value, g.known.value), f, g);
}

ModelValue operator-(const ModelValue& f, const ModelValue& g)
{
  return Combined(f.model - g.model, f.known.value - g.known.value, f, g);
}

ModelValue operator*(const ModelValue& f, const ModelValue& g)
{
  return Combined(f.model * g.model, ProductOf(f.known.value, g.known.value), f, g);
}

ModelValue Reciprocal(const ModelValue& f)
{
  const std::array<ModelValue, 2> arguments{ ModelValue(1.0), f };
  return ApplyToModels(
    { .operation = Operation::Divide, .arguments = { 0, 1, -1, -1, -1, -1 } }, arguments);
}

ModelValue NormOf(std::span<const ModelValue> values)
{
  ModelValue sum(0.0);
  for (const ModelValue& value : values)
  {
    sum = sum + Square(value);
  }
  return ApplyToModels(
    { .operation = Operation::Sqrt, .arguments = { 0, -1, -1, -1, -1, -1 } }, std::span(&sum, 1));
}

ModelValue ApplyToModels(const Graph::Node& node, std::span<const ModelValue> values)
{
  const auto argument = [&](std::size_t k) -> const ModelValue&
  { return values[static_cast<std::size_t>(node.arguments[k])]; };
  switch (node.operation)
  {
    case Operation::Add:
      return argument(0) + argument(1);
    case Operation::Subtract:
      return argument(0) - argument(1);
    case Operation::Multiply:
      return node.arguments[0] == node.arguments[1] ? Square(argument(0))
                                                    : argument(0) * argument(1);
    default:
      break;
  }
  const NodeArguments arguments(node, values);
  const std::span<const ModelValue> of = arguments.Span();
  std::array<KnownInterval, Graph::kMaxArguments> known;
  std::ranges::transform(of, known.begin(),
    [](const ModelValue& one) {
      return KnownInterval{ RangeOf(one), one.known.mayBeNaN };
    });
  const KnownInterval range = ApplyToIntervals(node, std::span(known).first(of.size()));
  const bool areDefined =
    std::ranges::none_of(of, [](const ModelValue& one) { return one.known.mayBeNaN; });
  ModelValue value(ModelOf(node, of), range, areDefined);
  const bool isStep = IsTruth(node.operation) || node.operation == Operation::Select ||
    node.operation == Operation::Sign || node.operation == Operation::Floor ||
    node.operation == Operation::Ceil || node.operation == Operation::Atan2 ||
    node.operation == Operation::Eigenvector;
  const bool isConstant = value.known.value.lower == value.known.value.upper;
  value.mayJump = !isConstant && (isStep || std::ranges::any_of(of, &ModelValue::mayJump));
  return value;
}
} // namespace pixelexact
