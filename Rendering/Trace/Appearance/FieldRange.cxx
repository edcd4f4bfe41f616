// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Appearance/FieldRange.h"

#include "Core/Base/Error.h"
#include "Core/Element/MeshRanges.h"
#include "Trace/Scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
constexpr RangeEffort kEffort{ 1e-3, 200 };
/// Relative to a field's largest coefficient: an upper bound of the rounding of values, and half
/// the width of a range that shows them in one colour.
constexpr double kRounding = 1e-12;
constexpr double kOneColour = 5e-7;
/// Shifts the range, because two colours of a table meet in the middle of a range.
constexpr double kAside = 0.998;

double LargestOf(const Field& field)
{
  double largest = 0.0;
  for (const double coefficient : field.values.coefficients)
  {
    // Infinite and NaN coefficients affect only their own elements.
    const double size = std::fabs(coefficient);
    largest = size <= std::numeric_limits<double>::max() ? std::max(largest, size) : largest;
  }
  return largest;
}

/// The largest coefficient; for an expression, the larger magnitude of the range's ends.
double LargestOf(const Field& field, const std::array<double, 2>& range)
{
  return field.function != nullptr ? std::max(std::fabs(range[0]), std::fabs(range[1]))
                                   : LargestOf(field);
}

bool IsOneValue(const std::array<double, 2>& range, double largest)
{
  return range[1] - range[0] <= kRounding * largest;
}
} // namespace

RangeQuestion QuestionOf(const Field& field, int component)
{
  RangeQuestion question;
  question.field = &field;
  // For one component, kMagnitude is the signed value.
  if (component == kMagnitude && field.values.components > 1)
  {
    question.quantity = Quantity::Magnitude;
  }
  else
  {
    question.component = std::max(component, 0);
  }
  return question;
}

Interval ProvenRange(const Mesh& mesh, const Field& field, int component)
{
  return RangeOf(mesh, QuestionOf(field, component), kEffort).range.outer;
}

std::optional<std::array<double, 2>> FieldRange(
  const Mesh& mesh, const Field& field, int component, const std::function<void(double)>& progress)
{
  const Interval range =
    RangeOf(mesh, QuestionOf(field, component), RangeEffort{}, progress).range.outer;
  if (range.IsEmpty())
  {
    return std::nullopt;
  }
  if (!range.IsFinite())
  {
    throw Error(
      "field '" + field.name + "' could not be bounded; choose the range of the cut, or give one");
  }
  return std::array{ range.lower, range.upper };
}

std::optional<std::array<double, 2>> AttainedRange(
  const Mesh& mesh, const Field& field, int component)
{
  const CertifiedRange range = RangeOf(mesh, QuestionOf(field, component), kEffort).range;
  if (range.attained.lower <= range.attained.upper)
  {
    return std::array{ range.attained.lower, range.attained.upper };
  }
  // The field is constant up to rounding: 0 if it may be 0.
  if (range.outer.lower <= range.outer.upper)
  {
    return range.outer.Contains(0.0) ? std::array{ 0.0, 0.0 }
                                     : std::array{ range.outer.lower, range.outer.upper };
  }
  return std::nullopt;
}

bool IsOneValue(const Field& field, const std::array<double, 2>& range)
{
  return IsOneValue(range, LargestOf(field, range));
}

std::array<double, 2> BeyondRounding(const Field& field, const std::array<double, 2>& range)
{
  const double largest = LargestOf(field, range);
  if (!IsOneValue(range, largest))
  {
    return range;
  }
  const double middle = 0.5 * range[0] + 0.5 * range[1];
  const double half = kOneColour * largest;
  return { middle - kAside * half, middle + half };
}
} // namespace pixelexact
