// SPDX-License-Identifier: BSD-3-Clause
#ifndef FieldSelection_h
#define FieldSelection_h

#include "vtkObject.h"

#include <string>
#include <vector>

namespace pixelexact
{
/// The names of fields that were given to a filter, in their order. Without names the filter takes
/// all fields.
class FieldSelection
{
public:
  /// Each change marks `owner` as modified.
  explicit FieldSelection(vtkObject* owner)
    : Owner(owner)
  {
  }

  void Add(const std::string& name)
  {
    this->Names.push_back(name);
    this->Owner->Modified();
  }

  void Clear()
  {
    this->Names.clear();
    this->Owner->Modified();
  }

  [[nodiscard]] const std::vector<std::string>& All() const { return this->Names; }

private:
  vtkObject* Owner;
  std::vector<std::string> Names;
};
} // namespace pixelexact
#endif
