// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/IntervalOperations.h"

#include "Core/Expression/SymmetricEigen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace pixelexact
{
namespace
{
/// The assumed relative error of values of the C library.
constexpr double kOfLibrary = 0x1p-49;
/// And of values that underflow: 16 times the least number.
constexpr double kOfUnderflow = 0x1p-1070;

Interval Widened(double lower, double upper)
{
  if (std::isnan(lower) || std::isnan(upper))
  {
    return Interval::Everything();
  }
  // An infinite value may have overflowed.
  constexpr double kLargest = std::numeric_limits<double>::max();
  const double below = std::clamp(lower, -kLargest, kLargest);
  const double above = std::clamp(upper, -kLargest, kLargest);
  return { std::isinf(lower) && lower < 0.0
      ? lower
      : rounding::Below(below - kOfLibrary * std::fabs(below) - kOfUnderflow),
    std::isinf(upper) && upper > 0.0
      ? upper
      : rounding::Above(above + kOfLibrary * std::fabs(above) + kOfUnderflow) };
}

/// Encloses the values of a function that grows.
template <class Function>
Interval Growing(const Interval& a, const Function& function)
{
  return a.IsFinite() ? Widened(function(a.lower), function(a.upper)) : Interval::Everything();
}

/// Encloses the values of sin, shifted by so many quarters of a turn; -1 and 1 where `a` may
/// contain their places.
Interval Wave(const Interval& a, double quarters, double lower, double upper)
{
  // Beyond this the turns are not counted.
  constexpr double kMaxAngle = 0x1p20;
  if (!a.IsFinite() || a.Magnitude() > kMaxAngle)
  {
    return { -1.0, 1.0 };
  }
  constexpr double kSlack = 1e-9; // of a turn
  const auto meets = [&](double at)
  {
    const double turn = 2.0 * std::numbers::pi;
    const double first = (a.lower + quarters * std::numbers::pi / 2 - at) / turn;
    const double last = (a.upper + quarters * std::numbers::pi / 2 - at) / turn;
    return std::floor(last + kSlack) >= std::ceil(first - kSlack);
  };
  const Interval ends = Widened(std::min(lower, upper), std::max(lower, upper));
  return { meets(-std::numbers::pi / 2) ? -1.0 : std::max(-1.0, ends.lower),
    meets(std::numbers::pi / 2) ? 1.0 : std::min(1.0, ends.upper) };
}

bool IsWithin(const Interval& a, double lower, double upper)
{
  return a.lower >= lower && a.upper <= upper;
}

Interval PowerOf(const Interval& a, const Interval& b)
{
  if (b.lower == b.upper && b.lower == std::floor(b.lower) && std::fabs(b.lower) <= 64.0)
  {
    const int exponent = static_cast<int>(std::fabs(b.lower));
    Interval result(1.0);
    for (int k = 0; k < exponent / 2; ++k)
    {
      result = ProductOf(result, Square(a));
    }
    result = exponent % 2 == 1 ? result * a : result;
    return b.lower < 0.0 ? Interval(1.0) / result : result;
  }
  if (!(a.lower > 0.0) || !a.IsFinite() || !b.IsFinite())
  {
    return Interval::Everything();
  }
  const Interval logarithm = Growing(a, [](double v) { return std::log(v); });
  return Growing(b * logarithm, [](double v) { return std::exp(v); });
}

/// 1, 0, or both.
Interval Truth(bool surely, bool possibly)
{
  return { surely ? 1.0 : 0.0, possibly ? 1.0 : 0.0 };
}

Interval LogicOf(Operation operation, const Interval& a, const Interval& b)
{
  const bool isZeroA = a.lower == 0.0 && a.upper == 0.0;
  const bool isZeroB = b.lower == 0.0 && b.upper == 0.0;
  switch (operation)
  {
    case Operation::Less:
      return Truth(a.upper < b.lower, a.lower < b.upper);
    case Operation::AtMost:
      return Truth(a.upper <= b.lower, a.lower <= b.upper);
    case Operation::Equal:
    case Operation::NotEqual:
    {
      const bool same = a.lower == a.upper && b.lower == b.upper && a.lower == b.lower;
      const bool apart = a.upper < b.lower || b.upper < a.lower;
      return operation == Operation::Equal ? Truth(same, !apart) : Truth(apart, !same);
    }
    case Operation::And:
      return Truth(!a.Contains(0.0) && !b.Contains(0.0), !isZeroA && !isZeroB);
    case Operation::Or:
      return Truth(!a.Contains(0.0) || !b.Contains(0.0), !isZeroA || !isZeroB);
    default: // Not
      return Truth(isZeroA, a.Contains(0.0));
  }
}

/// Encloses atan2(y, x). Over a rectangle that does not meet x <= 0, y = 0 the extreme angles are
/// those of its corners.
Interval AngleOf(const Interval& y, const Interval& x)
{
  if (!y.IsFinite() || !x.IsFinite())
  {
    return Interval::Everything();
  }
  constexpr double kHalfTurn = std::numbers::pi;
  if (x.lower <= 0.0 && y.Contains(0.0))
  {
    return Widened(-kHalfTurn, kHalfTurn);
  }
  const auto corners = { std::atan2(y.lower, x.lower), std::atan2(y.lower, x.upper),
    std::atan2(y.upper, x.lower), std::atan2(y.upper, x.upper) };
  return Widened(std::min(corners), std::max(corners));
}

/// By Weyl's inequality, eigenvalues change by no more than the norm of the matrix's change.
Interval EigenvalueOf(std::span<const Interval> entries, int number)
{
  std::array<double, 6> middle{};
  double moved = 0.0;
  double size = 0.0;
  for (std::size_t k = 0; k < middle.size(); ++k)
  {
    if (!entries[k].IsFinite())
    {
      return Interval::Everything();
    }
    middle[k] = entries[k].Middle();
    moved += (k < 3 ? 1.0 : 2.0) * entries[k].RadiusAround(middle[k]);
    size += (k < 3 ? 1.0 : 2.0) * std::fabs(middle[k]);
  }
  // SymmetricEigen makes 90 rotations at most, each off by less than 16 roundings of the size.
  constexpr double kOfRotations = 0x1p-42;
  return Interval::Around(
    SymmetricEigen(middle).Value(number), (moved + kOfRotations * size) * (1.0 + 0x1p-40));
}

Interval ValueOf(const Graph::Node& node, std::span<const Interval> a)
{
  switch (node.operation)
  {
    case Operation::Negate:
      return -a[0];
    case Operation::Add:
      return SumOf(a[0], a[1]);
    case Operation::Subtract:
      return a[0] - a[1];
    case Operation::Multiply:
      return node.arguments[0] == node.arguments[1] ? Square(a[0]) : ProductOf(a[0], a[1]);
    case Operation::Divide:
      return a[0] / a[1];
    case Operation::Power:
      return PowerOf(a[0], a[1]);
    case Operation::Min:
      return { std::min(a[0].lower, a[1].lower), std::min(a[0].upper, a[1].upper) };
    case Operation::Max:
      return { std::max(a[0].lower, a[1].lower), std::max(a[0].upper, a[1].upper) };
    case Operation::Select:
      return !a[0].Contains(0.0)                 ? a[1]
        : a[0].lower == 0.0 && a[0].upper == 0.0 ? a[2]
                                                 : Join(a[1], a[2]);
    case Operation::Eigenvalue:
      return EigenvalueOf(a, node.a);
    case Operation::Eigenvector:
      return { -1.0, 1.0 };
    case Operation::Atan2:
      return AngleOf(a[0], a[1]);
    default:
      return IsTruth(node.operation) ? LogicOf(node.operation, a[0], a[1])
                                     : FunctionOf(node.operation, a[0]);
  }
}
} // namespace

Interval FunctionOf(Operation operation, const Interval& a)
{
  switch (operation)
  {
    case Operation::Sqrt:
      return a.lower >= 0.0 ? Sqrt(a) : Interval::Everything();
    case Operation::Exp:
      return Growing(a, [](double v) { return std::exp(v); });
    case Operation::Log:
      return a.lower > 0.0 ? Growing(a, [](double v) { return std::log(v); })
                           : Interval::Everything();
    case Operation::Sin:
      return Wave(a, 0.0, std::sin(a.lower), std::sin(a.upper));
    case Operation::Cos:
      return Wave(a, 1.0, std::cos(a.lower), std::cos(a.upper));
    case Operation::Asin:
      return IsWithin(a, -1.0, 1.0) ? Growing(a, [](double v) { return std::asin(v); })
                                    : Interval::Everything();
    case Operation::Acos:
      return IsWithin(a, -1.0, 1.0) ? Widened(std::acos(a.upper), std::acos(a.lower))
                                    : Interval::Everything();
    case Operation::Atan:
      return Growing(a, [](double v) { return std::atan(v); });
    case Operation::Sinh:
      return Growing(a, [](double v) { return std::sinh(v); });
    case Operation::Cosh:
    {
      const Interval size = Abs(a);
      return size.IsFinite() ? Widened(std::cosh(size.lower), std::cosh(size.upper))
                             : Interval::Everything();
    }
    case Operation::Tanh:
      return Growing(a, [](double v) { return std::tanh(v); });
    case Operation::Erf:
      return Growing(a, [](double v) { return std::erf(v); });
    case Operation::Abs:
      return Abs(a);
    case Operation::Sign:
      return { a.lower > 0.0 ? 1.0
          : a.lower == 0.0   ? 0.0
                             : -1.0,
        a.upper < 0.0      ? -1.0
          : a.upper == 0.0 ? 0.0
                           : 1.0 };
    case Operation::Floor:
      return { std::floor(a.lower), std::floor(a.upper) };
    case Operation::Ceil:
      return { std::ceil(a.lower), std::ceil(a.upper) };
    default: // Tan, which grows where the cosine has no zero
      return FunctionOf(Operation::Cos, a).Contains(0.0)
        ? Interval::Everything()
        : Growing(a, [](double v) { return std::tan(v); });
  }
}

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

KnownInterval ApplyToIntervals(const Graph::Node& node, std::span<const KnownInterval> arguments)
{
  std::array<Interval, Graph::kMaxArguments> values;
  std::ranges::transform(arguments, values.begin(), &KnownInterval::value);
  const bool anyNaN = std::ranges::any_of(arguments, &KnownInterval::mayBeNaN);
  if (IsTruth(node.operation))
  {
    return { anyNaN ? Interval(0.0, 1.0) : ValueOf(node, values) };
  }
  if (node.operation == Operation::Select)
  {
    if (arguments[0].mayBeNaN)
    {
      return { Join(values[1], values[2]), true };
    }
    const bool mayBeSecond = values[0].lower != 0.0 || values[0].upper != 0.0;
    return { ValueOf(node, values),
      (mayBeSecond && arguments[1].mayBeNaN) ||
        (values[0].Contains(0.0) && arguments[2].mayBeNaN) };
  }
  const Interval value = ValueOf(node, values);
  return { value, anyNaN || !value.IsFinite() };
}
} // namespace pixelexact
