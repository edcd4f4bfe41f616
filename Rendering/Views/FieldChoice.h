// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Mesh.h"

#include <string>

class vtkMapper;

namespace pixelexact
{
class HighOrderModel;

/// Which field of a model: the named one, else the one of that number, else the first.
struct FieldChoice
{
  std::string name;
  int index = -1;

  bool operator==(const FieldChoice&) const = default;

  /// Throws Error, listing what there is, when the model has no such field.
  [[nodiscard]] const Field& In(const HighOrderModel& model) const;
};

/// Throws Error when the field has no such component; kMagnitude is one of any field.
void RequireComponent(const Field& field, int component);

/// As VTK's users tell mappers what to colour by: SelectColorArray, else SetInputArrayToProcess(0).
[[nodiscard]] FieldChoice FieldOf(vtkMapper* mapper);
} // namespace pixelexact
