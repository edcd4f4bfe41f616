// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/ModelValue.h"

#include "Core/Expression/FunctionModel.h"
#include "Core/Expression/NodeList.h"
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
ChebyshevModel NoModel()
{
  return ChebyshevModel(Interval::Everything());
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
  return std::isfinite(inverse.error)
    ? inverse
    : ComposeFunction(Operation::Power, f.model, RangeOf(f), -1.0);
}

ChebyshevModel RootModel(const ModelValue& f)
{
  ChebyshevModel root = SquareRoot(f.model);
  return std::isfinite(root.error) ? root
                                   : ComposeFunction(Operation::Power, f.model, RangeOf(f), 0.5);
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
    return ComposeFunction(Operation::Power, f.model, range, b.lower);
  }
  const ChebyshevModel logarithm = exponent.model * ComposeFunction(Operation::Log, f.model, range);
  return ComposeFunction(Operation::Exp, logarithm, logarithm.TightRange());
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
  const ChebyshevModel angle = ComposeFunction(Operation::Atan, ratio, ratio.TightRange());
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
                                     : ComposeFunction(node.operation, a[0].model, RangeOf(a[0]));
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

/// Computes a node from its arguments; sums and products have their own ways.
ModelValue ApplyFunctionTo(const Graph::Node& node, std::span<const ModelValue> of)
{
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

ModelValue Square(const ModelValue& f)
{
  return Combined(f.model * f.model, Square(f.known.value), f, f);
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
  return ApplyNode(node, values, ApplyFunctionTo);
}
} // namespace pixelexact
