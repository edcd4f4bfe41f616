// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPixelExactComparison.h"

#include "Parts/ParallelRun.h"
#include "Parts/WholeMesh.h"
#include "WholeInputs.h"

#include "vtkDataObject.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <exception>
#include <vector>

vtkStandardNewMacro(vtkPixelExactComparison);

using namespace pixelexact;

vtkPixelExactComparison::vtkPixelExactComparison()
  : Mesh(std::make_unique<WholeMesh>(WholeMesh::Maker::First))
{
}

vtkPixelExactComparison::~vtkPixelExactComparison() = default;

void vtkPixelExactComparison::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
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
  if (ProcessesThatShare(outputVector) == nullptr)
  {
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  try
  {
    vtkDataObject* mesh = this->Mesh->Of(inputVector[0], outputVector, this);
    std::vector<vtkSmartPointer<vtkPolyData>> surfaces;
    std::vector<vtkDataObject*> given;
    for (int s = 0; s < inputVector[1]->GetNumberOfInformationObjects(); ++s)
    {
      surfaces.push_back(WholeSurface(vtkPolyData::GetData(inputVector[1], s), outputVector));
      given.push_back(surfaces.back());
    }
    if (mesh == nullptr)
    {
      output->Initialize();
      return AnswerOfAll(1, outputVector);
    }
    WholeInputs wholes({ { mesh }, given });
    return AnswerOfAll(
      this->Superclass::RequestData(request, wholes.Vectors(), outputVector), outputVector);
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return AnswerOfAll(0, outputVector);
  }
}
