// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/BoxValue.h"

#include "Core/Expression/BoxRounding.h"
#include "Core/Expression/NodeList.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>

namespace pixelexact
{
namespace
{
/// The affine form of a scalar of which only a range is known.
AffineForm FormOf(const Interval& range)
{
  AffineForm form;
  if (range.IsFinite())
  {
    form.a = range.Middle();
  }
  form.e = range - Interval(form.a);
  return form;
}

/// The mean value form of a function with these slopes over the range of `f`; none where it is not
/// bounded. `atMiddle` holds the value at the middle.
std::optional<AffineForm> Linearised(
  const BoxValue& f, const Interval& slope, const Interval& atMiddle)
{
  if (!slope.IsFinite() || !atMiddle.IsFinite())
  {
    return std::nullopt;
  }
  const double middle = f.known.value.Middle();
  const double s = slope.Middle();
  const AffineForm way = f.form - AffineForm(middle);
  AffineForm form = AffineForm(atMiddle.Middle()) + AffineForm(s) * way;
  form.e += (atMiddle - Interval(atMiddle.Middle())) +
    (slope - Interval(s)) * Intersect(way.Range(), f.known.value - Interval(middle));
  return form;
}

std::optional<AffineForm> FunctionForm(Operation operation, const BoxValue& f)
{
  const Interval& range = f.known.value;
  if (!range.IsFinite())
  {
    return std::nullopt;
  }
  if (operation == Operation::Abs && !(range.lower < 0.0 && range.upper > 0.0))
  {
    return range.lower >= 0.0 ? f.form : AffineForm(0.0) - f.form;
  }
  return Linearised(f, SlopeOf(operation, range), FunctionOf(operation, Interval(range.Middle())));
}

std::optional<AffineForm> PowerForm(const BoxValue& f, const BoxValue& exponent)
{
  const Interval& b = exponent.known.value;
  if (b.lower != b.upper)
  {
    return std::nullopt;
  }
  if (b.lower == std::floor(b.lower) && std::fabs(b.lower) <= 64.0)
  {
    AffineForm power(1.0);
    for (int k = 0; k < static_cast<int>(std::fabs(b.lower)) / 2; ++k)
    {
      power = power * Square(f.form);
    }
    power = std::fmod(b.lower, 2.0) != 0.0 ? power * f.form : power;
    return b.lower < 0.0 ? Reciprocal(power) : power;
  }
  const Interval& a = f.known.value;
  if (!a.IsFinite() || !(a.lower > 0.0))
  {
    return std::nullopt;
  }
  const auto power = [](const Interval& base, double to)
  { return FunctionOf(Operation::Exp, Interval(to) * FunctionOf(Operation::Log, base)); };
  return Linearised(f, b * power(a, b.lower) / a, power(Interval(a.Middle()), b.lower));
}

std::optional<AffineForm> FormOf(const Graph::Node& node, std::span<const BoxValue> a)
{
  switch (node.operation)
  {
    case Operation::Negate:
      return AffineForm(0.0) - a[0].form;
    case Operation::Multiply: // a square
      return Square(a[0].form);
    case Operation::Divide:
      return a[0].form * Reciprocal(a[1].form);
    case Operation::Power:
      return PowerForm(a[0], a[1]);
    case Operation::Min:
    case Operation::Max:
    case Operation::Select:
    {
      const BoxValue* const chosen = Chosen(node, a);
      return chosen != nullptr ? std::optional(chosen->form) : std::nullopt;
    }
    case Operation::Atan2:
    case Operation::Eigenvalue:
    case Operation::Eigenvector:
      return std::nullopt;
    default:
      return IsTruth(node.operation) ? std::nullopt : FunctionForm(node.operation, a[0]);
  }
}
} // namespace

BoxValue::BoxValue(const KnownInterval& interval)
  : form(FormOf(interval.value))
  , known(interval)
{
}

BoxValue::BoxValue(const AffineForm& itsForm, const KnownInterval& interval)
  : form(itsForm)
  , known(interval)
{
  const Interval both = Intersect(known.value, form.Range());
  // An enclosure does not hold NaN, so that the two may not intersect.
  known.value = both.IsEmpty() ? known.value : both;
  known.mayBeNaN = known.mayBeNaN || !known.value.IsFinite();
  if (!form.e.IsFinite())
  {
    form = FormOf(known.value);
  }
}

namespace
{
/// Covers the rounding of a form's coefficients and radius, relative to the sum of the magnitudes
/// that they are computed from: at most 16 roundings each, and those of the bound itself.
constexpr double kFormRounding = 0x1p-47;
/// Larger than any underflow of a few operations.
constexpr double kFormUnderflow = 0x1p-1060;

// std::min and std::max branch on doubles in memory.
double Lower(double a, double b)
{
  return a < b ? a : b;
}
double Upper(double a, double b)
{
  return a > b ? a : b;
}

/// ProductOf without branches. NaN where a product is not finite.
Interval BoundedProduct(const Interval& a, const Interval& b)
{
  const double p = a.lower * b.lower;
  const double q = a.lower * b.upper;
  const double r = a.upper * b.lower;
  const double s = a.upper * b.upper;
  const double unbounded = 0.0 * ((p + q) + (r + s));
  const double lower = rounding::Below(Lower(Lower(p, q), Lower(r, s))) + unbounded;
  const double upper = rounding::Above(Upper(Upper(p, q), Upper(r, s))) + unbounded;
  const bool isNotNegative = a.lower >= 0.0 && b.lower >= 0.0;
  return { isNotNegative && lower < 0.0 ? 0.0 : lower, upper };
}

/// An affine form with a remainder in [-r, r]. Its operations have no branches.
struct Centred
{
  double a;
  double b[3];
  double linear; ///< |b| summed
  double r;      ///< NaN or infinite where the form has no bound

  explicit Centred(const AffineForm& form)
    : b{ form.b[0], form.b[1], form.b[2] }
    , linear(std::fabs(b[0]) + std::fabs(b[1]) + std::fabs(b[2]))
  {
    const double middle = 0.5 * (form.e.lower + form.e.upper);
    a = form.a + middle;
    r = Upper(form.e.upper - middle, middle - form.e.lower) +
      kFormRounding * (middle == 0.0 ? 0.0 : std::fabs(form.a) + std::fabs(middle));
  }
  [[nodiscard]] double Size() const { return std::fabs(a) + linear; }
};

Centred SumOf(const Centred& f, const Centred& g, double sign)
{
  Centred h = f;
  h.a += sign * g.a;
  for (std::size_t d = 0; d < 3; ++d)
  {
    h.b[d] += sign * g.b[d];
  }
  h.linear = std::fabs(h.b[0]) + std::fabs(h.b[1]) + std::fabs(h.b[2]);
  h.r = (f.r + g.r + kFormRounding * h.Size()) * (1.0 + kFormRounding) + kFormUnderflow;
  return h;
}

/// A square's quadratic part is between 0 and the square of the linear one's largest value.
Centred SquareOf(const Centred& f)
{
  Centred h = f;
  for (std::size_t d = 0; d < 3; ++d)
  {
    h.b[d] = 2.0 * f.a * f.b[d];
  }
  const double quadratic = 0.5 * f.linear * f.linear;
  h.a = f.a * f.a + quadratic;
  h.linear = std::fabs(h.b[0]) + std::fabs(h.b[1]) + std::fabs(h.b[2]);
  h.r = (quadratic + 2.0 * f.r * f.Size() + f.r * f.r + kFormRounding * f.Size() * f.Size()) *
      (1.0 + kFormRounding) +
    kFormUnderflow;
  return h;
}

Centred ProductOf(const Centred& f, const Centred& g)
{
  Centred h = f;
  double squares[3];
  for (std::size_t d = 0; d < 3; ++d)
  {
    h.b[d] = f.a * g.b[d] + g.a * f.b[d];
    squares[d] = f.b[d] * g.b[d];
  }
  // A square t_d^2 is in [0, 1], a product of two different ones in [-1, 1].
  h.a = f.a * g.a + 0.5 * (squares[0] + squares[1] + squares[2]);
  const double quadratic =
    0.5 * (std::fabs(squares[0]) + std::fabs(squares[1]) + std::fabs(squares[2])) +
    std::fabs(f.b[0] * g.b[1] + f.b[1] * g.b[0]) + std::fabs(f.b[0] * g.b[2] + f.b[2] * g.b[0]) +
    std::fabs(f.b[1] * g.b[2] + f.b[2] * g.b[1]);
  h.linear = std::fabs(h.b[0]) + std::fabs(h.b[1]) + std::fabs(h.b[2]);
  h.r = (quadratic + f.r * g.Size() + g.r * f.Size() + f.r * g.r +
          kFormRounding * f.Size() * g.Size()) *
      (1.0 + kFormRounding) +
    kFormUnderflow;
  return h;
}

/// `known` encloses the same scalar. `propagated`: the error that the arguments' errors cause.
BoxValue Finished(const Centred& form, const Interval& known, const BoxValue& f, const BoxValue& g,
  double propagated)
{
  BoxValue value;
  value.form.a = form.a;
  std::copy_n(form.b, 3, value.form.b.begin());
  value.form.e = { -form.r, form.r };
  const double reach =
    (form.linear + form.r + kFormRounding * std::fabs(form.a)) * (1.0 + kFormRounding) +
    kFormUnderflow;
  value.known.value = { Upper(known.lower, form.a - reach), Lower(known.upper, form.a + reach) };
  value.known.mayBeNaN = f.known.mayBeNaN || g.known.mayBeNaN;
  value.error = RoundedError(propagated, kUnitRoundoff, value.known.value);
  value.mayJump = f.mayJump || g.mayJump;
  return value;
}

/// Whether Finished holds for a form and an interval: both are bounded, and they meet.
bool IsBounded(const Centred& form, const Interval& known)
{
  const double reach = form.linear + form.r;
  // The comparisons are written so that a NaN is not bounded.
  return std::fabs(form.a) + reach < kInfinity && known.upper - known.lower < kInfinity &&
    known.lower <= form.a + reach && known.upper >= form.a - reach;
}

/// `propagated`: the error that the arguments' errors cause.
BoxValue Finished(const AffineForm& form, const Interval& interval, const BoxValue& f,
  const BoxValue& g, double propagated)
{
  BoxValue value(form, { interval, f.known.mayBeNaN || g.known.mayBeNaN });
  value.error = RoundedError(propagated, kUnitRoundoff, value.known.value);
  value.mayJump = f.mayJump || g.mayJump;
  return value;
}

/// Computes a node from its arguments; sums and products have faster ways below.
BoxValue ApplyFunction(const Graph::Node& node, std::span<const BoxValue> arguments)
{
  std::array<KnownInterval, Graph::kMaxArguments> storage;
  std::ranges::transform(arguments, storage.begin(), &BoxValue::known);
  const std::span known = std::span(storage).first(arguments.size());
  KnownInterval interval = ApplyToIntervals(node, known);
  const std::optional<AffineForm> form = FormOf(node, arguments);
  // A bounded form of defined arguments proves that the scalar is defined.
  interval.mayBeNaN = interval.mayBeNaN &&
    !(form && form->e.IsFinite() && std::ranges::none_of(known, &KnownInterval::mayBeNaN));
  BoxValue value = form ? BoxValue(*form, interval) : BoxValue(interval);
  value.error = RoundingOf(node, arguments, value.known.value);
  value.mayJump = MayJump(node, arguments, value.known.value);
  return value;
}

BoxValue Applied(Operation operation, std::initializer_list<BoxValue> arguments)
{
  Graph::Node node{ .operation = operation };
  // The arguments have distinct numbers: a product of equal numbers is a square.
  node.arguments[0] = 0;
  node.arguments[1] = arguments.size() > 1 ? 1 : -1;
  return ApplyFunction(node, { arguments.begin(), arguments.size() });
}
} // namespace

// The operations of most nodes, without the graph's dispatch.

BoxValue operator+(const BoxValue& f, const BoxValue& g)
{
  const Centred form = SumOf(Centred(f.form), Centred(g.form), 1.0);
  const Interval known = SumOf(f.known.value, g.known.value);
  const double propagated = f.error + g.error;
  return IsBounded(form, known) ? Finished(form, known, f, g, propagated)
                                : Finished(f.form + g.form, known, f, g, propagated);
}

BoxValue operator-(const BoxValue& f, const BoxValue& g)
{
  const Centred form = SumOf(Centred(f.form), Centred(g.form), -1.0);
  const Interval known = f.known.value - g.known.value;
  const double propagated = f.error + g.error;
  return IsBounded(form, known) ? Finished(form, known, f, g, propagated)
                                : Finished(f.form - g.form, known, f, g, propagated);
}

BoxValue operator*(const BoxValue& f, const BoxValue& g)
{
  const Centred form = ProductOf(Centred(f.form), Centred(g.form));
  const Interval known = BoundedProduct(f.known.value, g.known.value);
  const double propagated =
    f.known.value.Magnitude() * g.error + g.known.value.Magnitude() * f.error + f.error * g.error;
  return IsBounded(form, known)
    ? Finished(form, known, f, g, propagated)
    : Finished(f.form * g.form, ProductOf(f.known.value, g.known.value), f, g, propagated);
}

BoxValue Square(const BoxValue& f)
{
  const Centred form = SquareOf(Centred(f.form));
  const Interval known = Square(f.known.value);
  const double most = f.known.value.Magnitude();
  if (IsBounded(form, known))
  {
    return Finished(form, known, f, f, 2.0 * most * f.error + f.error * f.error);
  }
  const Graph::Node node{ .operation = Operation::Multiply, .arguments = { 0, 0, -1, -1, -1, -1 } };
  return ApplyFunction(node, std::array{ f, f });
}

BoxValue Reciprocal(const BoxValue& f)
{
  return Applied(Operation::Divide, { BoxValue(1.0), f });
}

BoxValue Sqrt(const BoxValue& f)
{
  return Applied(Operation::Sqrt, { f });
}

BoxValue NormOf(std::span<const BoxValue> values)
{
  BoxValue sum(0.0);
  for (const BoxValue& value : values)
  {
    sum = sum + Square(value);
  }
  return Sqrt(sum);
}

BoxValue ApplyToBoxes(const Graph::Node& node, std::span<const BoxValue> values)
{
  return ApplyNode(node, values, ApplyFunction);
}
} // namespace pixelexact
