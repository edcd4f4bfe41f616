// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/GridCopies.h"

#include "HighOrderArrays.h"

#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace pixelexact
{
vtkSmartPointer<vtkUnstructuredGrid> ExtractedCells(
  vtkUnstructuredGrid* grid, std::span<const vtkIdType> cells)
{
  auto extracted = vtkSmartPointer<vtkUnstructuredGrid>::New();
  const auto count = static_cast<vtkIdType>(cells.size());
  extracted->AllocateEstimate(count, 8);
  extracted->GetFieldData()->ShallowCopy(grid->GetFieldData());
  vtkNew<vtkPoints> points;
  points->SetDataType(grid->GetPoints()->GetDataType());
  vtkPointData* pointData = extracted->GetPointData();
  pointData->CopyAllOn();
  pointData->CopyAllocate(grid->GetPointData());
  vtkCellData* cellData = extracted->GetCellData();
  cellData->CopyAllOn();
  cellData->CopyAllocate(grid->GetCellData(), count);
  std::vector<vtkIdType> newPoint(static_cast<std::size_t>(grid->GetNumberOfPoints()), -1);
  vtkNew<vtkIdList> ids;
  for (const vtkIdType cell : cells)
  {
    grid->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      const vtkIdType old = ids->GetId(i);
      vtkIdType& point = newPoint[static_cast<std::size_t>(old)];
      if (point < 0)
      {
        double x[3];
        grid->GetPoint(old, x);
        point = points->InsertNextPoint(x);
        pointData->CopyData(grid->GetPointData(), old, point);
      }
      ids->SetId(i, point);
    }
    const vtkIdType made = extracted->InsertNextCell(grid->GetCellType(cell), ids);
    cellData->CopyData(grid->GetCellData(), cell, made);
  }
  extracted->SetPoints(points);
  extracted->Squeeze();
  return extracted;
}

vtkSmartPointer<vtkUnstructuredGrid> AppendedGrids(
  std::span<const vtkSmartPointer<vtkUnstructuredGrid>> grids)
{
  vtkNew<vtkAppendFilter> append;
  append->MergePointsOff();
  int precision = vtkAlgorithm::SINGLE_PRECISION;
  for (const auto& grid : grids)
  {
    append->AddInputData(grid);
    if (grid->GetPoints() != nullptr && grid->GetPoints()->GetDataType() != VTK_FLOAT)
    {
      precision = vtkAlgorithm::DOUBLE_PRECISION;
    }
  }
  // VTK's default is the precision of the first grid.
  append->SetOutputPointsPrecision(precision);
  append->Update();
  return append->GetOutput();
}

void FillCellKinds(std::span<const vtkSmartPointer<vtkUnstructuredGrid>> grids)
{
  constexpr std::array kKinds{ vtkDataSetAttributes::RATIONALWEIGHTS,
    vtkDataSetAttributes::HIGHERORDERDEGREES };
  for (const int kind : kKinds)
  {
    const bool isOfPoints = kind == vtkDataSetAttributes::RATIONALWEIGHTS;
    const auto dataOf = [isOfPoints](vtkUnstructuredGrid* grid) -> vtkDataSetAttributes*
    {
      return isOfPoints ? static_cast<vtkDataSetAttributes*>(grid->GetPointData())
                        : grid->GetCellData();
    };
    const auto arrayOf = [&](vtkUnstructuredGrid* grid)
    { return vtkDataArray::SafeDownCast(dataOf(grid)->GetAbstractAttribute(kind)); };
    const auto like = std::ranges::max_element(grids, {},
      [&](const vtkSmartPointer<vtkUnstructuredGrid>& grid)
      { return arrayOf(grid) != nullptr ? arrayOf(grid)->GetDataTypeSize() : 0; });
    const vtkSmartPointer<vtkDataArray> model = arrayOf(*like);
    for (const vtkSmartPointer<vtkUnstructuredGrid>& grid : grids)
    {
      const vtkSmartPointer<vtkDataArray> own = arrayOf(grid);
      if (model == nullptr ||
        (own != nullptr && own->GetDataType() == model->GetDataType() &&
          std::string_view(own->GetName()) == model->GetName()))
      {
        continue;
      }
      const auto array = vtk::TakeSmartPointer(model->NewInstance());
      if (own != nullptr)
      {
        array->DeepCopy(own);
        dataOf(grid)->RemoveArray(own->GetName());
      }
      else
      {
        array->SetNumberOfComponents(model->GetNumberOfComponents());
        array->SetNumberOfTuples(isOfPoints ? grid->GetNumberOfPoints() : grid->GetNumberOfCells());
        array->Fill(isOfPoints ? 1.0 : 0.0);
      }
      array->SetName(model->GetName());
      dataOf(grid)->SetAttribute(array, kind);
    }
  }
}

vtkSmartPointer<vtkUnstructuredGrid> WithTruncated(
  vtkUnstructuredGrid* grid, std::span<const Truncation> truncations)
{
  auto output = vtkSmartPointer<vtkUnstructuredGrid>::Take(grid->NewInstance());
  output->ShallowCopy(grid);
  for (const Truncation& truncation : truncations)
  {
    const Field kept = truncation.Kept();
    std::vector<Space> spaces;
    spaces.reserve(static_cast<std::size_t>(kept.values.Elements()));
    for (int e = 0; e < kept.values.Elements(); ++e)
    {
      spaces.push_back(kept.values.SpaceOf(e));
    }
    FieldExpansion field;
    field.values.Allocate(spaces, kept.values.components);
    field.mapping = kept.mapping;
    // Both lie element by element, component by component.
    std::ranges::copy(kept.values.coefficients, field.values.coefficients.begin());
    StoreField(output, kept.name, std::move(field), Origin::Coefficients);
    output->GetPointData()->RemoveArray(kept.name.c_str());
    output->GetCellData()->RemoveArray(kept.name.c_str());
  }
  return output;
}
} // namespace pixelexact
