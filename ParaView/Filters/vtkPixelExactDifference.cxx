// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPixelExactDifference.h"

#include "InputCut.h"
#include "Parts/ParallelRun.h"
#include "ResultOfParts.h"

#include "vtkDataObject.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPixelExactDifference);

using namespace pixelexact;

vtkPixelExactDifference::vtkPixelExactDifference()
  : Cut(std::make_unique<InputCut>())
  , First(std::make_unique<WholeMesh>(WholeMesh::Maker::First))
  , Second(std::make_unique<WholeMesh>(WholeMesh::Maker::First))
{
}

vtkPixelExactDifference::~vtkPixelExactDifference() = default;

void vtkPixelExactDifference::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UseInputCut: " << this->Cut->ofInput << "\n";
}

vtkMTimeType vtkPixelExactDifference::GetMTime()
{
  return this->Cut->Latest(this->Superclass::GetMTime());
}

void vtkPixelExactDifference::SetCutFunction(vtkImplicitFunction* function)
{
  this->Cut->chosen = function;
  this->Modified();
}

void vtkPixelExactDifference::SetUseInputCut(bool use)
{
  if (this->Cut->ofInput != use)
  {
    this->Cut->ofInput = use;
    this->Modified();
  }
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
  return ResultOfParts(
    this, outputVector,
    [&]
    {
      return InputPorts{ { this->First->Of(inputVector[0], outputVector, this) },
        { this->Second->Of(inputVector[1], outputVector, this) } };
    },
    [&](vtkInformationVector** wholes)
    {
      this->Superclass::SetCutFunction(this->Cut->In(vtkDataObject::GetData(wholes[0])));
      return this->Superclass::RequestData(request, wholes, outputVector);
    });
}
