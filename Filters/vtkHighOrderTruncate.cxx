// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderTruncate.h"

#include "Conversion/ModelSource.h"
#include "Grids/FieldsNamed.h"
#include "Grids/FilterWork.h"
#include "Grids/GridTruncation.h"

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
  pixelexact::PrintFields(os, indent, this->Fields);
}

void vtkHighOrderTruncate::AddField(const std::string& name)
{
  this->Fields.push_back(name);
  this->Modified();
}

void vtkHighOrderTruncate::ClearFields()
{
  this->Fields.clear();
  this->Modified();
}

int vtkHighOrderTruncate::FillInputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

void vtkHighOrderTruncate::Truncate(vtkUnstructuredGrid* input, vtkUnstructuredGrid* output)
{
  using namespace pixelexact;
  const auto model = this->Source->Get(input, this);
  std::vector<Truncation> truncations;
  for (const Field* field : FieldsNamed(*model, this->Fields))
  {
    truncations.emplace_back(*field, this->Order);
  }
  auto* grid = vtkUnstructuredGrid::SafeDownCast(this->Source->GridOf(input));
  output->ShallowCopy(WithTruncated(grid, truncations));
  for (std::size_t k = 0; this->Bounds && k < truncations.size(); ++k)
  {
    vtkNew<vtkDoubleArray> change;
    change->SetName((truncations[k].Kept().name + "_LargestChange").c_str());
    change->InsertNextValue(LargestChange(model->GetMesh(), truncations[k], -1,
      [&](double part)
      {
        this->UpdateProgress(
          (static_cast<double>(k) + part) / static_cast<double>(truncations.size()));
      }));
    output->GetFieldData()->AddArray(change);
  }
}

int vtkHighOrderTruncate::RequestData(vtkInformation* /*request*/,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* output = vtkUnstructuredGrid::GetData(outputVector);
  return pixelexact::FillOutput(this, output,
    [&]
    {
      this->Truncate(vtkUnstructuredGrid::GetData(inputVector[0]), output);
      return true;
    });
}
