// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/CellArrays.h"

#include "CompositeParts.h"
#include "ConversionLoss.h"
#include "HighOrderArrays.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

namespace pixelexact
{
namespace
{
std::vector<vtkUnstructuredGrid*> GridsOf(vtkDataObject* data)
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    return { grid };
  }
  std::vector<vtkUnstructuredGrid*> grids;
  for (const CompositePart& part : PartsOf(vtkCompositeDataSet::SafeDownCast(data)))
  {
    grids.push_back(part.grid);
  }
  return grids;
}

/// By name, one array of each grid; none where one of them lacks it or has another kind.
std::vector<vtkAbstractArray*> AlikeOf(
  const std::vector<vtkUnstructuredGrid*>& grids, const char* name)
{
  std::vector<vtkAbstractArray*> arrays;
  for (vtkUnstructuredGrid* grid : grids)
  {
    vtkAbstractArray* array = grid->GetCellData()->GetAbstractArray(name);
    if (array == nullptr ||
      array->GetDataType() != grids[0]->GetCellData()->GetAbstractArray(name)->GetDataType() ||
      array->GetNumberOfComponents() !=
        grids[0]->GetCellData()->GetAbstractArray(name)->GetNumberOfComponents())
    {
      return {};
    }
    arrays.push_back(array);
  }
  return arrays;
}
} // namespace

void SpreadCellArrays(vtkDataObject* grid, const HighOrderModel& model,
  std::span<const int> elementOf, vtkUnstructuredGrid* output)
{
  const std::vector<vtkUnstructuredGrid*> grids = GridsOf(grid);
  if (grids.empty())
  {
    return;
  }
  std::vector<std::int64_t> begins;
  for (const HighOrderModel::Block& block : model.Blocks())
  {
    begins.push_back(block.begin);
  }
  begins.resize(std::max<std::size_t>(begins.size(), 1));
  vtkCellData* first = grids[0]->GetCellData();
  for (int a = 0; a < first->GetNumberOfArrays(); ++a)
  {
    const char* name = first->GetArrayName(a);
    if (name == nullptr || std::strcmp(name, kElementIds) == 0 ||
      std::strcmp(name, kLinearizedOrder) == 0 || output->GetCellData()->HasArray(name) != 0)
    {
      continue;
    }
    const std::vector<vtkAbstractArray*> from = AlikeOf(grids, name);
    if (from.empty())
    {
      continue;
    }
    const auto to = vtkSmartPointer<vtkAbstractArray>::Take(from[0]->NewInstance());
    to->SetName(name);
    to->SetNumberOfComponents(from[0]->GetNumberOfComponents());
    to->CopyComponentNames(from[0]);
    to->SetNumberOfTuples(static_cast<vtkIdType>(elementOf.size()));
    for (std::size_t i = 0; i < elementOf.size(); ++i)
    {
      const auto block = static_cast<std::size_t>(
        std::upper_bound(begins.begin(), begins.end(), elementOf[i]) - begins.begin() - 1);
      to->SetTuple(static_cast<vtkIdType>(i), elementOf[i] - static_cast<vtkIdType>(begins[block]),
        from[block]);
    }
    output->GetCellData()->AddArray(to);
  }
  if (grids.size() == 1)
  {
    output->GetFieldData()->ShallowCopy(grids[0]->GetFieldData());
    RemoveHighOrderArrays(output);
  }
}

double BytesOfCellArrays(vtkDataObject* grid)
{
  double bytes = 0.0;
  for (vtkUnstructuredGrid* one : GridsOf(grid))
  {
    double sum = 0.0;
    for (int a = 0; a < one->GetCellData()->GetNumberOfArrays(); ++a)
    {
      const vtkAbstractArray* array = one->GetCellData()->GetAbstractArray(a);
      sum += static_cast<double>(array->GetDataTypeSize()) * array->GetNumberOfComponents();
    }
    bytes = std::max(bytes, sum);
  }
  return bytes;
}
} // namespace pixelexact
