// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/SlabArray.h"

#include "HighOrderArrays.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <string>

namespace pixelexact
{
namespace
{
const std::string kName = std::string(kMeshPrefix) + "Slab";
} // namespace

void StoreSlab(const Slab& slab, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(kName.c_str());
  array->SetNumberOfComponents(2);
  array->InsertNextTuple2(slab.middle, slab.thickness);
  grid->GetFieldData()->AddArray(array);
}

std::optional<Slab> SlabOf(vtkUnstructuredGrid* grid)
{
  vtkDataArray* array = grid->GetFieldData()->GetArray(kName.c_str());
  if (array == nullptr || array->GetNumberOfValues() != 2)
  {
    return std::nullopt;
  }
  const Slab slab{ array->GetComponent(0, 0), array->GetComponent(0, 1) };
  return std::isfinite(slab.middle) && std::isnormal(slab.thickness) && slab.thickness > 0.0
    ? std::optional(slab)
    : std::nullopt;
}
} // namespace pixelexact
