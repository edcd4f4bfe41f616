// SPDX-License-Identifier: BSD-3-Clause
#ifndef FieldsNamed_h
#define FieldsNamed_h

#include "HighOrderModel.h"

#include "vtkIndent.h"

#include <string>
#include <vector>

namespace pixelexact
{
/// The fields of these names; none: all, those that are defined by expressions, too. Throws as
/// HighOrderModel::GetField.
[[nodiscard]] std::vector<const Field*> FieldsNamed(
  const HighOrderModel& model, const std::vector<std::string>& names);

/// "Fields: u v", or "Fields: all": a line of PrintSelf.
void PrintFields(ostream& os, vtkIndent indent, const std::vector<std::string>& names);
} // namespace pixelexact
#endif
