// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/BoxValue.h"

#include "Core/Math/Rounding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <optional>

namespace pixelexact
{
namespace
{
/// The form of a scalar of which a range alone is known.
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

/// Holds the derivative of an operation of one argument; everything where it is not known.
Interval SlopeOf(Operation operation, const Interval& a)
{
  const Interval one(1.0);
  const auto root = [&] { return Sqrt(one - Square(a)); };
  switch (operation)
  {
    case Operation::Sqrt:
      return a.lower > 0.0 ? Interval(0.5) / Sqrt(a) : Interval::Everything();
    case Operation::Exp:
      return FunctionOf(Operation::Exp, a);
    case Operation::Log:
      return one / a;
    case Operation::Sin:
      return FunctionOf(Operation::Cos, a);
    case Operation::Cos:
      return -FunctionOf(Operation::Sin, a);
    case Operation::Tan:
      return one + Square(FunctionOf(Operation::Tan, a));
    case Operation::Asin:
      return one / root();
    case Operation::Acos:
      return Interval(-1.0) / root();
    case Operation::Atan:
      return one / (one + Square(a));
    case Operation::Sinh:
      return FunctionOf(Operation::Cosh, a);
    case Operation::Cosh:
      return FunctionOf(Operation::Sinh, a);
    case Operation::Tanh:
      return one - Square(FunctionOf(Operation::Tanh, a));
    case Operation::Erf:
      return Interval::Around(2.0 / std::sqrt(std::numbers::pi), 1e-15) *
        FunctionOf(Operation::Exp, -Square(a));
    default:
      return Interval::Everything();
  }
}

/// The mean value form of a function with these slopes over the range of `f`; nothing where it is
/// not bounded. `atMiddle` holds the value at the middle.
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

/// The one of two arguments that is chosen on all of the box; null where that is not known.
const BoxValue* Chosen(const Graph::Node& node, std::span<const BoxValue> a)
{
  const auto isBelow = [](const BoxValue& f, const BoxValue& g)
  { return f.known.value.upper <= g.known.value.lower; };
  switch (node.operation)
  {
    case Operation::Min:
      return isBelow(a[0], a[1]) ? &a[0] : isBelow(a[1], a[0]) ? &a[1] : nullptr;
    case Operation::Max:
      return isBelow(a[0], a[1]) ? &a[1] : isBelow(a[1], a[0]) ? &a[0] : nullptr;
    default: // Select
    {
      const Interval& condition = a[0].known.value;
      const bool isZero = condition.lower == 0.0 && condition.upper == 0.0;
      return !condition.Contains(0.0) ? &a[1] : isZero ? &a[2] : nullptr;
    }
  }
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
/// What a condition may be where it is computed from arguments that are off.
Interval ConditionWithErrors(const Graph::Node& node, std::span<const BoxValue> a)
{
  std::array<KnownInterval, Graph::kMaxArguments> wide;
  std::ranges::transform(a, wide.begin(),
    [](const BoxValue& one) -> KnownInterval
    {
      return { Interval{ rounding::Below(one.known.value.lower - one.error),
                 rounding::Above(one.known.value.upper + one.error) },
        one.known.mayBeNaN };
    });
  return ApplyToIntervals(node, std::span(wide).first(a.size())).value;
}

bool IsStep(Operation operation)
{
  return IsTruth(operation) || operation == Operation::Sign || operation == Operation::Floor ||
    operation == Operation::Ceil;
}

/// What the errors of the arguments of a function become: by its slope over all that may be
/// computed of them.
double PropagatedBy(Operation operation, const BoxValue& f)
{
  if (f.error == 0.0)
  {
    return 0.0;
  }
  const Interval wide = f.known.value + Interval(-f.error, f.error);
  const double bySlope = SlopeOf(operation, wide).Magnitude() * f.error;
  // |sqrt(a + e) - sqrt(a)| <= sqrt(|e|).
  return operation == Operation::Sqrt ? std::min(bySlope, std::sqrt(f.error)) : bySlope;
}

double PropagatedByPower(const BoxValue& f, const BoxValue& exponent, const Interval& result)
{
  if (f.error == 0.0 && exponent.error == 0.0)
  {
    return 0.0;
  }
  const Interval base = f.known.value + Interval(-f.error, f.error);
  const Interval& to = exponent.known.value;
  const auto whole = [](double v) { return v == std::floor(v) && v >= 1.0 && v <= 64.0; };
  if (exponent.error == 0.0 && to.lower == to.upper && whole(to.lower))
  {
    return to.lower * std::pow(base.Magnitude(), to.lower - 1.0) * f.error * (1.0 + 0x1p-40);
  }
  const double least = base.Mignitude();
  if (!(least > 0.0) || !(base.lower > 0.0))
  {
    return kInfinity;
  }
  const double size = 2.0 * result.Magnitude();
  return size *
    (to.Magnitude() * f.error / least +
      FunctionOf(Operation::Log, base).Magnitude() * exponent.error);
}

/// With the rounding of the operation itself, relative to its result.
double RoundedError(double propagated, double own, const Interval& result)
{
  // Covers the rounding of the bound.
  constexpr double kAbove = 1.0 + 0x1p-40;
  const double error = (propagated + own * (result.Magnitude() + propagated)) * kAbove + 0x1p-1060;
  // Written so that a NaN is not a bound.
  return error >= 0.0 ? error : kInfinity;
}

/// A bound of the error of the double that is computed for a node, from those of its arguments.
/// `result` holds the exact values.
double RoundingOf(const Graph::Node& node, std::span<const BoxValue> a, const Interval& result)
{
  constexpr double kOfFunction = 0x1p-48;
  const auto size = [&a](std::size_t k) { return a[k].known.value.Magnitude(); };
  double propagated = 0.0;
  double own = kUnitRoundoff;
  switch (node.operation)
  {
    case Operation::Negate:
    case Operation::Abs:
      return a[0].error;
    case Operation::Min:
    case Operation::Max:
      return std::max(a[0].error, a[1].error);
    case Operation::Select:
    {
      const Interval condition =
        ConditionWithErrors({ .operation = Operation::Or }, std::array{ a[0], a[0] });
      const double either = std::max(a[1].error, a[2].error);
      return condition.lower == condition.upper ? either : either + result.Width();
    }
    case Operation::Multiply:
      propagated = size(0) * a[1].error + size(1) * a[0].error + a[0].error * a[1].error;
      break;
    case Operation::Divide:
    {
      const double least = a[1].known.value.Mignitude() - a[1].error;
      propagated = least > 0.0 ? (a[0].error + result.Magnitude() * a[1].error) / least : kInfinity;
      break;
    }
    case Operation::Power:
      propagated = PropagatedByPower(a[0], a[1], result);
      own = kOfFunction;
      break;
    case Operation::Atan2:
    {
      const double y = a[0].known.value.Mignitude();
      const double x = a[1].known.value.Mignitude();
      const double least = (x * x + y * y) * 0.5;
      propagated = a[0].error + a[1].error == 0.0 ? 0.0
        : a[0].error + a[1].error < 0.25 * std::sqrt(least)
        ? (size(1) * a[0].error + size(0) * a[1].error) / (0.25 * least)
        : kInfinity;
      own = kOfFunction;
      break;
    }
    case Operation::Eigenvalue:
      own = 0x1p-42;
      for (std::size_t k = 0; k < a.size(); ++k)
      {
        propagated += (k < 3 ? 1.0 : 2.0) * (a[k].error + own * size(k));
      }
      break;
    case Operation::Eigenvector:
      return kInfinity;
    default:
      if (IsStep(node.operation))
      {
        return ConditionWithErrors(node, a).Width();
      }
      propagated = PropagatedBy(node.operation, a[0]);
      own = node.operation == Operation::Sqrt ? kUnitRoundoff : kOfFunction;
  }
  return RoundedError(propagated, own, result);
}

bool MayJump(const Graph::Node& node, std::span<const BoxValue> a, const Interval& result)
{
  const bool isOfJumps = std::ranges::any_of(a, &BoxValue::mayJump);
  switch (node.operation)
  {
    case Operation::Select:
    {
      const BoxValue* const chosen = Chosen(node, a);
      return chosen == nullptr || chosen->mayJump;
    }
    case Operation::Atan2:
      return isOfJumps || (a[1].known.value.lower <= 0.0 && a[0].known.value.Contains(0.0));
    case Operation::Eigenvector:
      return true;
    default:
      return isOfJumps || (IsStep(node.operation) && result.lower != result.upper);
  }
}
} // namespace

BoxValue::BoxValue(const KnownInterval& interval)
  : form(FormOf(interval.value))
  , known(interval)
{
}

BoxValue::BoxValue(const AffineForm& itsForm)
  : BoxValue(itsForm, { Interval::Everything(), false })
{
}

BoxValue::BoxValue(const AffineForm& itsForm, const KnownInterval& interval)
  : form(itsForm)
  , known(interval)
{
  const Interval both = Intersect(known.value, form.Range());
  // Neither holds what is NaN: they need not meet then.
  known.value = both.IsEmpty() ? known.value : both;
  known.mayBeNaN = known.mayBeNaN || !known.value.IsFinite();
  if (!form.e.IsFinite())
  {
    form = FormOf(known.value);
  }
}

namespace
{
/// `propagated`: what becomes of the arguments' errors.
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
  // Distinct ones: the product of one and the same is a square.
  node.arguments[0] = 0;
  node.arguments[1] = arguments.size() > 1 ? 1 : -1;
  return ApplyToBoxes(node, { arguments.begin(), arguments.size() });
}
} // namespace

// What most nodes are, without a detour by the graph's operations.

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
  // A bounded form of what is defined proves that the scalar is defined.
  interval.mayBeNaN = interval.mayBeNaN &&
    !(form && form->e.IsFinite() && std::ranges::none_of(known, &KnownInterval::mayBeNaN));
  BoxValue value = form ? BoxValue(*form, interval) : BoxValue(interval);
  value.error = RoundingOf(node, arguments, value.known.value);
  value.mayJump = MayJump(node, arguments, value.known.value);
  return value;
}
} // namespace pixelexact
