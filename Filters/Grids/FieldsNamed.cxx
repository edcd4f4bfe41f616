// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/FieldsNamed.h"

#include "Core/Base/Error.h"

#include <algorithm>
#include <iterator>

namespace pixelexact
{
std::vector<const Field*> FieldsNamed(
  const HighOrderModel& model, const std::vector<std::string>& names)
{
  std::vector<const Field*> fields;
  std::ranges::transform(names, std::back_inserter(fields),
    [&model](const std::string& name) { return &model.GetField(name); });
  if (names.empty())
  {
    for (const auto& field : model.Fields())
    {
      fields.push_back(&field);
    }
    for (const auto& [name, text] : model.Definitions())
    {
      fields.push_back(&model.GetField(name));
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
