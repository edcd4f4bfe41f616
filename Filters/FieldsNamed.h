// SPDX-License-Identifier: BSD-3-Clause
#ifndef FieldsNamed_h
#define FieldsNamed_h

#include "HighOrderModel.h"

#include <string>
#include <vector>

namespace pixelexact
{
/// The fields of these names; none: all. Throws InvalidData for a name that is not there, with
/// those that are.
[[nodiscard]] std::vector<const Field*> FieldsNamed(
  const HighOrderModel& model, const std::vector<std::string>& names);
} // namespace pixelexact
#endif
