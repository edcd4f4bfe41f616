// SPDX-License-Identifier: BSD-3-Clause
#ifndef FieldSum_h
#define FieldSum_h

#include "Core/Element/Mesh.h"

#include <string>
#include <vector>

namespace pixelexact
{
class HighOrderModel;

/// A field and its factor in a sum.
struct Summand
{
  const Field* field = nullptr;
  double factor = 1.0;
};

/// Reads a sum of the model's fields with numbers as factors, such as 'u_real'*(0.5) - 2*v. Each
/// such text is an expression of the same value (expressions.md). Empty where the text is something
/// else; the result refers to fields of the model.
[[nodiscard]] std::vector<Summand> SumOfFields(
  const HighOrderModel& model, const std::string& text);
} // namespace pixelexact
#endif
