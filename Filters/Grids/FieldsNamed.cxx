// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/FieldsNamed.h"

#include "Core/Base/Error.h"

#include <algorithm>
#include <iterator>

namespace pixelexact
{
const Field& FieldNamed(const HighOrderModel& model, const std::string& name)
{
  if (const Field* field = model.FindField(name))
  {
    return *field;
  }
  std::string known;
  for (const auto& other : model.Fields())
  {
    known += (known.empty() ? "" : ", ") + other.name;
  }
  throw InvalidData("there is no high-order field '" + name +
    "'; the grid has: " + (known.empty() ? "none" : known) + ".");
}

std::vector<const Field*> FieldsNamed(
  const HighOrderModel& model, const std::vector<std::string>& names)
{
  std::vector<const Field*> fields;
  std::ranges::transform(names, std::back_inserter(fields),
    [&model](const std::string& name) { return &FieldNamed(model, name); });
  if (names.empty())
  {
    for (const auto& field : model.Fields())
    {
      fields.push_back(&field);
    }
  }
  return fields;
}

void PrintFields(ostream& os, vtkIndent indent, const std::vector<std::string>& names)
{
  os << indent << "Fields:";
  for (const auto& name : names)
  {
    os << " " << name;
  }
  os << (names.empty() ? " all\n" : "\n");
}
} // namespace pixelexact
