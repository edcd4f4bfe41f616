// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/BoxRounding.h"

#include "Core/Math/Rounding.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Encloses the values of a condition that is computed from arguments with errors.
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

/// Bounds the error of a function of an argument with an error, by the function's slope over all
/// possible computed arguments.
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
  // The error of b log a. Its exponential changes by at most twice as much, as long as that is
  // small.
  const double relative = to.Magnitude() * f.error / least +
    FunctionOf(Operation::Log, base).Magnitude() * exponent.error;
  return relative <= 0.25 ? 2.0 * result.Magnitude() * relative : kInfinity;
}
} // namespace

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
} // namespace pixelexact
