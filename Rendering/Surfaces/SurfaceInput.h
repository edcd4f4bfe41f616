// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkAlgorithm.h"

#include <string>
#include <vector>

class vtkDataObject;

namespace pixelexact
{
/// The end of a pipeline that provides a surface's data. Input connections are those of a
/// vtkAlgorithm.
class SurfaceInput : public vtkAlgorithm
{
public:
  static SurfaceInput* New();
  vtkTypeMacro(SurfaceInput, vtkAlgorithm);

  /// Sets the accepted data types; must be called once, before all other functions.
  void Accept(std::vector<std::string> types) { Types = std::move(types); }

  void SetData(vtkDataObject* data) { this->SetInputDataInternal(0, data); }
  /// The input data, of an accepted type or not; null: there are none.
  vtkDataObject* Data();
  /// The input data as T. Throws Error, which begins with the surface's name and ends with the
  /// accepted types, if there are none or they have another type.
  template <class T>
  T* DataOf(vtkObject* surface)
  {
    T* const data = T::SafeDownCast(this->Data());
    return data != nullptr ? data : static_cast<T*>(this->Refuse(surface));
  }

  /// Changes with the connection and with the data.
  vtkMTimeType GetMTime() override;

  SurfaceInput(const SurfaceInput&) = delete;
  void operator=(const SurfaceInput&) = delete;

protected:
  SurfaceInput();
  ~SurfaceInput() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  [[noreturn]] void* Refuse(vtkObject* surface);

  std::vector<std::string> Types;
};
} // namespace pixelexact
