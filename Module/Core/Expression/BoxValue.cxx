// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/BoxValue.h"

#include "Core/Expression/BoxRounding.h"
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
/// `propagated`: the error that the arguments' errors cause.
BoxValue Finished(const AffineForm& form, const Interval& interval, const BoxValue& f,
  const BoxValue& g, double propagated)
{
  BoxValue value(form, { interval, f.known.mayBeNaN || g.known.mayBeNaN });
  value.error = RoundedError(propagated, kUnitRoundoff, value.known.value);
  value.mayJump = f.mayJump || g.mayJump;
  return value;
}

BoxValue Applied(Operation operation, std::initializer_list<BoxValue> arguments)
{
  Graph::Node node{ .operation = operation };
  // The arguments have distinct numbers: a product of equal numbers is a square.
  node.arguments[0] = 0;
  node.arguments[1] = arguments.size() > 1 ? 1 : -1;
  return ApplyToBoxes(node, { arguments.begin(), arguments.size() });
}
} // namespace

// The operations of most nodes, without the graph's dispatch.

BoxValue operator+(const BoxValue& f, const BoxValue& g)
{
  return Finished(f.form + g.form, SumOf(f.known.value, g.known.value), f, g, f.error + g.error);
}

BoxValue operator-(const BoxValue& f, const BoxValue& g)
{
  return Finished(f.form - g.form, f.known.value - g.known.value, f, g, f.error + g.error);
}

BoxValue operator*(const BoxValue& f, const BoxValue& g)
{
  return Finished(f.form * g.form, ProductOf(f.known.value, g.known.value), f, g,
    f.known.value.Magnitude() * g.error + g.known.value.Magnitude() * f.error + f.error * g.error);
}

BoxValue Square(const BoxValue& f)
{
  const Graph::Node node{ .operation = Operation::Multiply, .arguments = { 0, 0, -1, -1, -1, -1 } };
  return ApplyToBoxes(node, std::array{ f, f });
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

BoxValue ApplyToBoxes(const Graph::Node& node, std::span<const BoxValue> arguments)
{
  switch (node.operation)
  {
    case Operation::Add:
      return arguments[0] + arguments[1];
    case Operation::Subtract:
      return arguments[0] - arguments[1];
    case Operation::Multiply:
      if (node.arguments[0] != node.arguments[1])
      {
        return arguments[0] * arguments[1];
      }
      break;
    default:
      break;
  }
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
} // namespace pixelexact
