// SPDX-License-Identifier: BSD-3-Clause
#include "Stability/RoundingTape.h"

#include "Core/Math/Rounding.h"
#include "Stability/ModesVisit.h"

#include <algorithm>
#include <cmath>

namespace pixelexact::testing
{
namespace
{
struct Operation
{
  int left;  ///< operand's number, -1 for a constant
  int right; ///< the same
  double byLeft;
  double byRight;
  double rounding; ///< bound of its error
};

/// The operations of the evaluation in progress, one list per thread.
std::vector<Operation>& Tape()
{
  thread_local std::vector<Operation> tape;
  return tape;
}

double RoundingOf(double value)
{
  return kUnitRoundoff * std::fabs(value) + std::numeric_limits<double>::denorm_min();
}

/// A double that remembers where it comes from.
struct Traced
{
  double value = 0.0;
  int number = -1;
};

Traced Record(double value, Traced a, double byA, Traced b, double byB)
{
  Tape().push_back({ a.number, b.number, byA, byB, RoundingOf(value) });
  return { value, static_cast<int>(Tape().size()) - 1 };
}

Traced operator+(Traced a, Traced b)
{
  return Record(a.value + b.value, a, 1.0, b, 1.0);
}
Traced operator-(Traced a, Traced b)
{
  return Record(a.value - b.value, a, 1.0, b, -1.0);
}
Traced operator*(Traced a, Traced b)
{
  return Record(a.value * b.value, a, b.value, b, a.value);
}
Traced operator/(Traced a, Traced b)
{
  const double quotient = a.value / b.value;
  return Record(quotient, a, 1.0 / b.value, b, -quotient / b.value);
}
Traced MulAdd(Traced a, Traced b, Traced c)
{
  return a * b + c;
}
Traced NegMulAdd(Traced a, Traced b, Traced c)
{
  return c - a * b;
}
Traced CollapsedQuotient(Traced y, Traced t)
{
  return t.value == 0.0 ? Traced{} : y / t;
}
Traced SafeReciprocal(Traced t)
{
  return Traced{ 1.0 } / t;
}

double BoundOf(Traced result)
{
  const auto& tape = Tape();
  if (result.number < 0)
  {
    return 0.0;
  }
  std::vector<double> weight(tape.size(), 0.0);
  weight[result.number] = 1.0;
  double bound = 0.0;
  for (int k = result.number; k >= 0; --k)
  {
    const auto& operation = tape[k];
    bound += std::fabs(weight[k]) * operation.rounding;
    if (operation.left >= 0)
    {
      weight[operation.left] += weight[k] * operation.byLeft;
    }
    if (operation.right >= 0)
    {
      weight[operation.right] += weight[k] * operation.byRight;
    }
  }
  return bound;
}

/// Coefficients brought down to where derivatives along the way cannot overflow, and the exact
/// factor that brings results back.
struct Scaled
{
  Scaled(const Space& space, const double* from)
    : coefficients(from, from + space.Modes())
  {
    double largest = 0.0;
    for (const double c : coefficients)
    {
      largest = std::max(largest, std::fabs(c));
    }
    factor = largest > 0x1p400 ? 0x1p600 : 1.0;
    for (double& c : coefficients)
    {
      c /= factor;
    }
  }
  std::vector<double> coefficients;
  double factor;
};

std::array<Traced, 3> Constants(const Vec3& xi)
{
  return { Traced{ xi.x }, Traced{ xi.y }, Traced{ xi.z } };
}
} // namespace
} // namespace pixelexact::testing

namespace pixelexact::HWY_NAMESPACE
{
template <>
struct NumberTraits<testing::Traced>
{
  using Scalar = double;
  static testing::Traced Splat(double value) { return { value }; }
  /// A constant of a recurrence, rounded once.
  static testing::Traced SplatScalar(double value)
  {
    return testing::Record(value, {}, 0.0, {}, 0.0);
  }
};
} // namespace pixelexact::HWY_NAMESPACE

namespace pixelexact::testing
{
double ValueRounding(const Space& space, const double* coefficients, const Vec3& xi)
{
  Tape().clear();
  const Scaled scaled(space, coefficients);
  return VisitModes<Traced, false>(space, Constants(xi),
    [&](const auto& modes)
    { return scaled.factor * BoundOf(modes.Value(scaled.coefficients.data())); });
}

std::array<double, 4> GradientRounding(
  const Space& space, const double* coefficients, const Vec3& xi)
{
  Tape().clear();
  const Scaled scaled(space, coefficients);
  return VisitModes<Traced, true>(space, Constants(xi),
    [&](const auto& modes)
    {
      const auto e = modes.Evaluate(scaled.coefficients.data());
      const double f = scaled.factor;
      return std::array<double, 4>{ f * BoundOf(e.value), f * BoundOf(e.gradient[0]),
        f * BoundOf(e.gradient[1]), f * BoundOf(e.gradient[2]) };
    });
}
} // namespace pixelexact::testing
