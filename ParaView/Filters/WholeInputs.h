// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace pixelexact
{
/// What RequestData gets of inputs, with other data in their places.
class WholeInputs
{
public:
  /// Of each port the data of its connections.
  explicit WholeInputs(const std::vector<std::vector<vtkDataObject*>>& ports)
  {
    for (const auto& connections : ports)
    {
      auto port = vtkSmartPointer<vtkInformationVector>::New();
      for (vtkDataObject* data : connections)
      {
        vtkNew<vtkInformation> connection;
        connection->Set(vtkDataObject::DATA_OBJECT(), data);
        port->Append(connection);
      }
      Ports.push_back(port);
      Pointers.push_back(port);
    }
  }
  vtkInformationVector** Vectors() { return Pointers.data(); }

private:
  std::vector<vtkSmartPointer<vtkInformationVector>> Ports;
  std::vector<vtkInformationVector*> Pointers;
};
} // namespace pixelexact
