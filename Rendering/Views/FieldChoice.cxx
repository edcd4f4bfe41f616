// SPDX-License-Identifier: BSD-3-Clause
#include "Views/FieldChoice.h"

#include "HighOrderModel.h"

#include "Core/Base/Error.h"
#include "Trace/Scene.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMapper.h"

#include <algorithm>
#include <span>

namespace pixelexact
{
const Field& FieldChoice::In(const HighOrderModel& model) const
{
  const std::span<const Field> fields = model.Fields();
  if (fields.empty())
  {
    throw Error("the grid carries no high-order field; without colours by a field "
                "(ScalarVisibilityOff) its cut can be drawn");
  }
  if (!name.empty())
  {
    return model.GetField(name);
  }
  if (index >= static_cast<int>(fields.size()))
  {
    throw Error("no high-order field number " + std::to_string(index) + ": there are " +
      std::to_string(fields.size()));
  }
  return fields[static_cast<std::size_t>(std::max(index, 0))];
}

void RequireComponent(const Field& field, int component)
{
  const int components = field.values.components;
  if (component != kMagnitude && (component < 0 || component >= components))
  {
    throw Error("component " + std::to_string(component) + " is asked for, but the field '" +
      field.name + "' has " + std::to_string(components) +
      (components == 1 ? " component" : " components"));
  }
}

FieldChoice FieldOf(vtkMapper* mapper)
{
  const char* name = mapper->GetArrayName();
  if (mapper->GetArrayAccessMode() == VTK_GET_ARRAY_BY_NAME && name != nullptr && name[0] != '\0')
  {
    return { .name = name };
  }
  if (mapper->GetArrayAccessMode() == VTK_GET_ARRAY_BY_ID && mapper->GetArrayId() >= 0)
  {
    return { .name = {}, .index = mapper->GetArrayId() };
  }
  // Avoids GetInputArrayInformation(0), which would add a missing entry.
  vtkInformationVector* arrays =
    mapper->GetInformation()->Get(vtkAlgorithm::INPUT_ARRAYS_TO_PROCESS());
  vtkInformation* array = arrays != nullptr ? arrays->GetInformationObject(0) : nullptr;
  if (array != nullptr && array->Has(vtkDataObject::FIELD_NAME()))
  {
    return { .name = array->Get(vtkDataObject::FIELD_NAME()) };
  }
  return {};
}
} // namespace pixelexact
