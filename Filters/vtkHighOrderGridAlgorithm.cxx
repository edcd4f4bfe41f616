// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderGridAlgorithm.h"

#include "MessageWords.h"
#include "vtkHighOrderGrid.h"

#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"

vtkHighOrderGridAlgorithm::vtkHighOrderGridAlgorithm() = default;
vtkHighOrderGridAlgorithm::~vtkHighOrderGridAlgorithm() = default;

void vtkHighOrderGridAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Diagnostics: " << this->Diagnostics.size() << "\n";
  for (const auto& line : this->Diagnostics)
  {
    os << indent.GetNextIndent() << line << "\n";
  }
}

int vtkHighOrderGridAlgorithm::GetNumberOfDiagnostics()
{
  return static_cast<int>(this->Diagnostics.size());
}

std::string vtkHighOrderGridAlgorithm::GetDiagnostic(int index)
{
  return index >= 0 && index < this->GetNumberOfDiagnostics() ? this->Diagnostics[index]
                                                              : std::string();
}

vtkHighOrderGrid* vtkHighOrderGridAlgorithm::GetHighOrderOutput()
{
  return vtkHighOrderGrid::SafeDownCast(this->GetOutputDataObject(0));
}

// RequestDataObject is not virtual in vtkUnstructuredGridAlgorithm.
vtkTypeBool vtkHighOrderGridAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    if (!vtkHighOrderGrid::GetData(outputVector))
    {
      vtkNew<vtkHighOrderGrid> output;
      outputVector->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), output);
    }
    return 1;
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

void vtkHighOrderGridAlgorithm::Report(const std::string& line)
{
  this->Diagnostics.push_back(line);
  vtkWarningMacro(<< pixelexact::Worded(line));
}
