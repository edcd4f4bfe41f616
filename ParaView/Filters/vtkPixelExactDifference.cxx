// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPixelExactDifference.h"

#include "Parts/ParallelRun.h"
#include "Parts/WholeMesh.h"
#include "WholeInputs.h"

#include "vtkDataObject.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

#include <exception>

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
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  try
  {
    vtkDataObject* first = this->First->Of(inputVector[0], outputVector, this);
    vtkDataObject* second = this->Second->Of(inputVector[1], outputVector, this);
    if (first == nullptr || second == nullptr)
    {
      output->Initialize();
      return AnswerOfAll(1, outputVector);
    }
    WholeInputs wholes({ { first }, { second } });
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
