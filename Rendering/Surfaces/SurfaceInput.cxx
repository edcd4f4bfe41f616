// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/SurfaceInput.h"

#include "Core/Base/Error.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"

#include <algorithm>

namespace pixelexact
{
vtkStandardNewMacro(SurfaceInput);

SurfaceInput::SurfaceInput()
{
  this->SetNumberOfInputPorts(1);
  this->SetNumberOfOutputPorts(0);
}

int SurfaceInput::FillInputPortInformation(int /*port*/, vtkInformation* info)
{
  for (const std::string& type : Types)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), type.c_str());
  }
  // The user of the input reports missing data.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

vtkDataObject* SurfaceInput::Data()
{
  return this->GetNumberOfInputConnections(0) > 0 ? this->GetInputDataObject(0, 0) : nullptr;
}

void* SurfaceInput::Refuse(vtkObject* surface)
{
  vtkDataObject* const data = this->Data();
  std::string text = surface->GetClassName() +
    (data != nullptr ? std::string(": its input is a ") + data->GetClassName()
                     : ": it has no input");
  text += "; SetInputConnection or SetInputData gives it a ";
  for (std::size_t k = 0; k < Types.size(); ++k)
  {
    text += (k > 0 ? " or a " : "") + Types[k];
  }
  throw Error(text);
}

vtkMTimeType SurfaceInput::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  vtkDataObject* const data = this->Data();
  return data != nullptr ? std::max(time, data->GetMTime()) : time;
}
} // namespace pixelexact
