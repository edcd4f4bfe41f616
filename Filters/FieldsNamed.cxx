// SPDX-License-Identifier: BSD-3-Clause
#include "FieldsNamed.h"

#include "Core/Base/Error.h"

namespace pixelexact
{
std::vector<const Field*> FieldsNamed(
  const HighOrderModel& model, const std::vector<std::string>& names)
{
  std::vector<const Field*> fields;
  for (const auto& name : names)
  {
    const Field* field = model.FindField(name);
    if (!field)
    {
      std::string known;
      for (const auto& other : model.Fields())
      {
        known += (known.empty() ? "" : ", ") + other.name;
      }
      throw InvalidData("there is no high-order field '" + name +
        "'; the grid has: " + (known.empty() ? "none" : known) + ".");
    }
    fields.push_back(field);
  }
  if (names.empty())
  {
    for (const auto& field : model.Fields())
    {
      fields.push_back(&field);
    }
  }
  return fields;
}
} // namespace pixelexact
