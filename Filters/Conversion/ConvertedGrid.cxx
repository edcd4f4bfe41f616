// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/ConvertedGrid.h"

#include "HighOrderArrays.h"
#include "PackedArrays.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Whether element e is cell e, and there are no others.
bool HoldsAllElements(vtkUnstructuredGrid* grid)
{
  vtkDataArray* spaces =
    grid->GetFieldData()->GetArray((std::string(kMeshPrefix) + "Space").c_str());
  vtkDataArray* ids = grid->GetCellData()->GetArray(kElementIds);
  if (spaces == nullptr || spaces->GetNumberOfTuples() != grid->GetNumberOfCells())
  {
    return false;
  }
  for (vtkIdType cell = 0; ids != nullptr && cell < ids->GetNumberOfTuples(); ++cell)
  {
    if (ids->GetComponent(cell, 0) != static_cast<double>(cell))
    {
      return false;
    }
  }
  return true;
}

/// Whether the expansion under a prefix is a solver's; false where damaged arrays do not say it.
bool IsFromSolver(vtkUnstructuredGrid* grid, const std::string& prefix)
{
  vtkDataArray* origin = grid->GetFieldData()->GetArray((prefix + "Origin").c_str());
  return origin != nullptr && origin->GetNumberOfValues() > 0 && IsSolvers(OriginOf(grid, prefix));
}
} // namespace

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
  const std::vector<std::string> names = StoredFieldNames(grid);
  return IsFromSolver(grid, kMeshPrefix) ||
    std::ranges::any_of(names,
      [grid](const std::string& name) { return IsFromSolver(grid, kFieldPrefix + name + "."); });
}

bool HasSolverMesh(vtkUnstructuredGrid* grid)
{
  return HasHighOrderArrays(grid) &&
    (IsPacked(grid) ? PacksSolverCoefficients(grid) : IsFromSolver(grid, kMeshPrefix));
}

vtkSmartPointer<vtkUnstructuredGrid> WithAllElements(vtkUnstructuredGrid* grid)
{
  return HoldsAllElements(grid) ? vtkSmartPointer<vtkUnstructuredGrid>(grid) : Unpack(Pack(grid));
}

Origin OriginOf(vtkUnstructuredGrid* grid, const std::string& prefix)
{
  vtkDataArray* origin = grid->GetFieldData()->GetArray((prefix + "Origin").c_str());
  return static_cast<Origin>(static_cast<int>(origin->GetComponent(0, 0)));
}

void ShareField(vtkUnstructuredGrid* from, const std::string& name, vtkUnstructuredGrid* to)
{
  // A name may be the beginning of another, with a dot after it.
  for (const char* part : { "Spaces", "Space", "Offset", "Coefficients", "Origin", "Components",
         "Mapping", "Fingerprint", "Basis" })
  {
    vtkAbstractArray* array =
      from->GetFieldData()->GetAbstractArray((kFieldPrefix + name + "." + part).c_str());
    if (array != nullptr)
    {
      to->GetFieldData()->AddArray(array);
    }
  }
}

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

void StoreSlab(const Slab& slab, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(kSlab);
  if (slab.inSpace)
  {
    array->InsertNextValue(slab.thickness);
  }
  else
  {
    array->SetNumberOfComponents(2);
    array->InsertNextTuple2(slab.middle, slab.thickness);
  }
  grid->GetFieldData()->AddArray(array);
}

std::optional<Slab> SlabOf(vtkUnstructuredGrid* grid)
{
  vtkDataArray* array = grid->GetFieldData()->GetArray(kSlab);
  const vtkIdType values = array != nullptr ? array->GetNumberOfValues() : 0;
  if (values != 1 && values != 2)
  {
    return std::nullopt;
  }
  const Slab slab = values == 1
    ? Slab{ .middle = 0.0, .thickness = array->GetComponent(0, 0), .inSpace = true }
    : Slab{ .middle = array->GetComponent(0, 0), .thickness = array->GetComponent(0, 1) };
  return std::isfinite(slab.middle) && std::isnormal(slab.thickness) && slab.thickness > 0.0
    ? std::optional(slab)
    : std::nullopt;
}
} // namespace pixelexact
