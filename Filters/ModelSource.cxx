// SPDX-License-Identifier: BSD-3-Clause
#include "ModelSource.h"

#include "Core/Base/Error.h"
#include "GridConversion.h"
#include "HighOrderArrays.h"
#include "KeptMesh.h"

#include "vtkAlgorithm.h"
#include "vtkUnstructuredGrid.h"

namespace pixelexact
{
ModelSource::ModelSource()
  : Kept(std::make_unique<KeptMesh>())
{
}

ModelSource::~ModelSource() = default;

std::shared_ptr<HighOrderModel> ModelSource::Get(vtkUnstructuredGrid* grid, vtkAlgorithm* owner)
{
  if (!grid)
  {
    throw InvalidData("there is no high-order grid; connect a vtkUnstructuredGrid.");
  }
  if (HasHighOrderArrays(grid))
  {
    this->Converted = nullptr;
    this->Kept->Forget();
    this->Model = HighOrderModel::From(grid);
    return this->Model;
  }
  if (!this->Converted || this->Source != grid || this->SourceTime != grid->GetMTime())
  {
    this->Converted = nullptr;
    const auto converted = vtkSmartPointer<vtkUnstructuredGrid>::New();
    const auto report = ConvertGrid(grid, {}, *this->Kept, converted);
    for (const auto& line : report.diagnostics)
    {
      vtkWarningWithObjectMacro(owner, << line);
    }
    this->Model = HighOrderModel::From(converted);
    this->Converted = converted;
    this->Source = grid;
    this->SourceTime = grid->GetMTime();
  }
  return this->Model;
}
} // namespace pixelexact
