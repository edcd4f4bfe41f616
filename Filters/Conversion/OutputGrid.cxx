// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/OutputGrid.h"

#include "HighOrderArrays.h"
#include "PackedArrays.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

namespace pixelexact
{
void CopyElements(vtkUnstructuredGrid* input, const SourceMesh& mesh, vtkUnstructuredGrid* output)
{
  if (mesh.Elements() == input->GetNumberOfCells())
  {
    output->ShallowCopy(input);
  }
  else
  {
    output->Initialize();
    output->SetPoints(input->GetPoints());
    output->GetPointData()->ShallowCopy(input->GetPointData());
    output->AllocateEstimate(mesh.Elements(), 8);
    output->GetCellData()->CopyAllOn();
    output->GetCellData()->CopyAllocate(input->GetCellData(), mesh.Elements());
    for (int e = 0; e < mesh.Elements(); ++e)
    {
      const auto points = mesh.Points(e);
      const vtkIdType cell = output->InsertNextCell(
        input->GetCellType(mesh.Cell(e)), static_cast<vtkIdType>(points.size()), points.data());
      output->GetCellData()->CopyData(input->GetCellData(), mesh.Cell(e), cell);
    }
  }
  // An own list of arrays: adding ours must not add them to the input.
  vtkNew<vtkFieldData> fieldData;
  fieldData->ShallowCopy(input->GetFieldData());
  output->SetFieldData(fieldData);
  RemoveHighOrderArrays(output);
}

bool HasSolverCoefficients(vtkUnstructuredGrid* grid)
{
  if (!HasHighOrderArrays(grid))
  {
    return false;
  }
  if (IsPacked(grid))
  {
    return PacksSolverCoefficients(grid);
  }
  bool found = false;
  vtkFieldData* data = grid->GetFieldData();
  auto look = [&](const std::string& prefix)
  {
    vtkDataArray* origin = data->GetArray((prefix + "Origin").c_str());
    found = found ||
      (origin && origin->GetNumberOfValues() > 0 &&
        IsSolvers(static_cast<Origin>(static_cast<int>(origin->GetComponent(0, 0)))));
  };
  look(kMeshPrefix);
  for (const auto& name : StoredFieldNames(grid))
  {
    look(kFieldPrefix + name + ".");
  }
  return found;
}
} // namespace pixelexact
