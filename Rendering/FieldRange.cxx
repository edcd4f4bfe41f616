// SPDX-License-Identifier: BSD-3-Clause
#include "FieldRange.h"

#include "Core/Element/MeshRanges.h"
#include "Trace/Scene.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
constexpr RangeEffort kEffort{ 1e-3, 200 };
}

RangeQuestion QuestionOf(const Field& field, int component)
{
  RangeQuestion question;
  question.field = &field;
  // Of one component the tracer shows the value itself.
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

std::optional<std::array<double, 2>> FieldRange(const Mesh& mesh, const Field& field, int component)
{
  const CertifiedRange range = RangeOf(mesh, QuestionOf(field, component), kEffort).range;
  if (range.attained.lower <= range.attained.upper)
  {
    return std::array{ range.attained.lower, range.attained.upper };
  }
  // A constant, up to rounding.
  if (range.outer.lower <= range.outer.upper)
  {
    return std::array{ range.outer.lower, range.outer.upper };
  }
  return std::nullopt;
}
} // namespace pixelexact
