// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderTruncate.h"

#include "Conversion/ModelSource.h"
#include "Grids/FilterInput.h"
#include "Grids/FilterWork.h"
#include "Grids/GridCopies.h"
#include "Parts/ParallelRun.h"
#include "Parts/PartExchange.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkHighOrderTruncate);

vtkHighOrderTruncate::vtkHighOrderTruncate()
  : Source(std::make_unique<pixelexact::ModelSource>())
{
}

vtkHighOrderTruncate::~vtkHighOrderTruncate() = default;

void vtkHighOrderTruncate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Order: " << this->Order << "\n";
  os << indent << "Bounds: " << this->Bounds << "\n";
  pixelexact::PrintFields(os, indent, this->Fields.All());
}

int vtkHighOrderTruncate::FillInputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

std::map<std::string, double> vtkHighOrderTruncate::Truncate(
  vtkUnstructuredGrid* input, vtkUnstructuredGrid* output)
{
  using namespace pixelexact;
  const auto model = this->Source->Get(input, this);
  std::vector<Truncation> truncations;
  for (const Field* field : FieldsNamed(*model, this->Fields.All()))
  {
    if (field->function == nullptr || !this->Fields.All().empty())
    {
      truncations.emplace_back(*field, this->Order);
    }
  }
  auto* grid = vtkUnstructuredGrid::SafeDownCast(this->Source->GridOf(input));
  output->ShallowCopy(WithTruncated(grid, truncations));
  std::map<std::string, double> changes;
  for (std::size_t k = 0; this->Bounds && k < truncations.size(); ++k)
  {
    changes[truncations[k].Kept().name + "_LargestChange"] =
      LargestChange(model->GetMesh(), truncations[k], -1,
        [&](double part)
        {
          this->UpdateProgress(
            (static_cast<double>(k) + part) / static_cast<double>(truncations.size()));
        });
  }
  return changes;
}

int vtkHighOrderTruncate::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->InBlocks = pixelexact::ComesInBlocks(this->InBlocks, inputVector[0], outputVector);
  return this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
}

int vtkHighOrderTruncate::RequestData(vtkInformation* /*request*/,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* output = vtkUnstructuredGrid::GetData(outputVector);
  std::map<std::string, double> changes;
  int filled = pixelexact::FillOutput(this, output,
    [&]
    {
      const bool any = !pixelexact::HasNoShare(inputVector[0]);
      if (any)
      {
        changes = this->Truncate(vtkUnstructuredGrid::GetData(inputVector[0]), output);
      }
      return any;
    });
  if (this->InBlocks)
  {
    return filled;
  }
  if (auto* processes = pixelexact::ProcessesThatShare(outputVector))
  {
    filled = pixelexact::AnswerOfAll(filled, outputVector);
    if (filled == 0)
    {
      return 0;
    }
    changes = pixelexact::LargestOfAll(changes, processes);
  }
  for (const auto& [name, change] : changes)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name.c_str());
    array->InsertNextValue(change);
    output->GetFieldData()->AddArray(array);
  }
  return filled;
}
