// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/ConvertedGrid.h"

#include "HighOrderArrays.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace pixelexact
{
KeptMesh::KeptMesh() = default;
KeptMesh::~KeptMesh() = default;

void KeptMesh::Forget()
{
  *this = {};
}

void KeptMesh::Keep(const SourceMesh& mesh, vtkUnstructuredGrid* grid)
{
  Forget();
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    Kinds.push_back(mesh.Basis(e).kind);
  }
  Roundoff = mesh.CoordinateRoundoff();
  Arrays = vtkSmartPointer<vtkFieldData>::New();
  for (int i = 0; i < grid->GetFieldData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = grid->GetFieldData()->GetAbstractArray(i);
    if (array->GetName() && std::string(array->GetName()).starts_with(kMeshPrefix))
    {
      Arrays->AddArray(array);
    }
  }
  Ids = grid->GetCellData()->GetArray(kElementIds);
  Time = std::max(Arrays->GetMTime(), Ids->GetMTime());
}

bool KeptMesh::AddTo(const SourceMesh& mesh, vtkUnstructuredGrid* grid) const
{
  if (!Arrays || std::max(Arrays->GetMTime(), Ids->GetMTime()) != Time ||
    Roundoff != mesh.CoordinateRoundoff() ||
    Kinds.size() != static_cast<std::size_t>(mesh.Elements()))
  {
    return false;
  }
  vtkDataArray* cells = Arrays->GetArray((std::string(kMeshPrefix) + "SourceCell").c_str());
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    if (Kinds[e] != mesh.Basis(e).kind ||
      cells->GetComponent(e, 0) != static_cast<double>(mesh.Number(e)))
    {
      return false;
    }
  }
  for (int i = 0; i < Arrays->GetNumberOfArrays(); ++i)
  {
    grid->GetFieldData()->AddArray(Arrays->GetAbstractArray(i));
  }
  grid->GetCellData()->AddArray(Ids);
  if (StoredMeshFits(grid))
  {
    return true;
  }
  RemoveHighOrderArrays(grid);
  return false;
}
} // namespace pixelexact
