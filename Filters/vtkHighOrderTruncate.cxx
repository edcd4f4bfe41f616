// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderTruncate.h"

#include "Grids/FilterInput.h"
#include "Grids/GridCopies.h"
#include "HighOrderModel.h"
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
  : MeshFilter(pixelexact::MeshScope::PartByBlock)
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

void vtkHighOrderTruncate::ResetReport()
{
  this->Changes.clear();
}

bool vtkHighOrderTruncate::Make(vtkDataObject* mesh, vtkDataObject* output)
{
  using namespace pixelexact;
  const auto model = this->ModelOf(mesh);
  std::vector<Truncation> truncations;
  for (const Field* field : FieldsNamed(*model, this->Fields.All()))
  {
    if (field->function == nullptr || !this->Fields.All().empty())
    {
      truncations.emplace_back(*field, this->Order);
    }
  }
  auto* grid = vtkUnstructuredGrid::SafeDownCast(this->Input.GridOf(mesh));
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
  this->Changes = std::move(changes);
  return true;
}

int vtkHighOrderTruncate::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->InBlocks = pixelexact::ComesInBlocks(this->InBlocks, inputVector[0], outputVector);
  return this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
}

int vtkHighOrderTruncate::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  int filled = this->Superclass::RequestData(request, inputVector, outputVector);
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
    this->Changes = pixelexact::LargestOfAll(this->Changes, processes);
  }
  auto* output = vtkUnstructuredGrid::GetData(outputVector);
  for (const auto& [name, change] : this->Changes)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name.c_str());
    array->InsertNextValue(change);
    output->GetFieldData()->AddArray(array);
  }
  return filled;
}
