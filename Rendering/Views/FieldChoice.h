// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Mesh.h"

#include <string>

class vtkMapper;

namespace pixelexact
{
class HighOrderModel;

/// A choice of a model's field: by name, else by index, else the first field.
struct FieldChoice
{
  std::string name;
  int index = -1;

  bool operator==(const FieldChoice&) const = default;

  /// The chosen field. Throws Error, listing the fields, if the model lacks it.
  [[nodiscard]] const Field& In(const HighOrderModel& model) const;
};

/// Throws Error if the field lacks the component; kMagnitude exists for any field.
void RequireComponent(const Field& field, int component);

/// The field chosen for colours by a mapper's settings: SelectColorArray, else
/// SetInputArrayToProcess(0).
[[nodiscard]] FieldChoice FieldOf(vtkMapper* mapper);
} // namespace pixelexact
