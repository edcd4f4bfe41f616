// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPixelExactComparison.h"

#include "InputCut.h"
#include "Parts/ParallelRun.h"
#include "ResultOfParts.h"

#include "vtkDataObject.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkPixelExactComparison);

using namespace pixelexact;

vtkPixelExactComparison::vtkPixelExactComparison()
  : Cut(std::make_unique<InputCut>())
  , Mesh(std::make_unique<WholeMesh>(WholeMesh::Maker::First))
{
}

vtkPixelExactComparison::~vtkPixelExactComparison() = default;

void vtkPixelExactComparison::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UseInputCut: " << this->Cut->ofInput << "\n";
}

vtkMTimeType vtkPixelExactComparison::GetMTime()
{
  return this->Cut->Latest(this->Superclass::GetMTime());
}

void vtkPixelExactComparison::SetCutFunction(vtkImplicitFunction* function)
{
  this->Cut->chosen = function;
  this->Modified();
}

void vtkPixelExactComparison::SetUseInputCut(bool use)
{
  if (this->Cut->ofInput != use)
  {
    this->Cut->ofInput = use;
    this->Modified();
  }
}

int vtkPixelExactComparison::RequestUpdateExtent(vtkInformation* /*request*/,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  AskForParts(inputVector[0], outputVector);
  AskForParts(inputVector[1], outputVector);
  return 1;
}

int vtkPixelExactComparison::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return ResultOfParts(
    this, outputVector,
    [&]
    {
      InputPorts wholes(2);
      wholes[0].emplace_back(this->Mesh->Of(inputVector[0], outputVector, this));
      for (int s = 0; s < inputVector[1]->GetNumberOfInformationObjects(); ++s)
      {
        wholes[1].emplace_back(WholeSurface(vtkPolyData::GetData(inputVector[1], s), outputVector));
      }
      return wholes;
    },
    [&](vtkInformationVector** wholes)
    {
      this->Superclass::SetCutFunction(this->Cut->In(vtkDataObject::GetData(wholes[0])));
      return this->Superclass::RequestData(request, wholes, outputVector);
    });
}
