// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPixelExactDifference.h"

#include "Parts/ParallelRun.h"
#include "ResultOfParts.h"

#include "vtkDataObject.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPixelExactDifference);

using namespace pixelexact;

vtkPixelExactDifference::vtkPixelExactDifference()
  : First(std::make_unique<WholeMesh>(WholeMesh::Maker::First))
  , Second(std::make_unique<WholeMesh>(WholeMesh::Maker::First))
{
}

vtkPixelExactDifference::~vtkPixelExactDifference() = default;

void vtkPixelExactDifference::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

void vtkPixelExactDifference::SetSecondFieldName(std::string name)
{
  this->Superclass::SetSecondFieldName(name == "Same Name" ? "" : name);
}

int vtkPixelExactDifference::RequestUpdateExtent(vtkInformation* /*request*/,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  AskForParts(inputVector[0], outputVector);
  AskForParts(inputVector[1], outputVector);
  return 1;
}

int vtkPixelExactDifference::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (ProcessesThatShare(outputVector) == nullptr)
  {
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }
  return ResultOfParts(
    this, outputVector,
    [&]
    {
      return InputPorts{ { this->First->Of(inputVector[0], outputVector, this) },
        { this->Second->Of(inputVector[1], outputVector, this) } };
    },
    [&](vtkInformationVector** wholes)
    { return this->Superclass::RequestData(request, wholes, outputVector); });
}
