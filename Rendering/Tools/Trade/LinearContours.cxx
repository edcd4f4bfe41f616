// SPDX-License-Identifier: BSD-3-Clause
#include "Trade/LinearContours.h"

#include "Base/VtkMessages.h"
#include "Core/Base/Error.h"
#include "Surfaces/VtkLinearSurface.h"

#include <vtkCellData.h>
#include <vtkCutter.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkHighOrderSubdivide.h>
#include <vtkImplicitFunction.h>
#include <vtkIntegrateAttributes.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

namespace pixelexact
{
LinearIntegral IntegrateLinearly(
  vtkUnstructuredGrid* grid, vtkImplicitFunction* function, const std::string& field, int level)
{
  const VtkMessages messages;
  vtkNew<vtkHighOrderSubdivide> subdivide;
  subdivide->SetInputData(grid);
  subdivide->SetLevel(level);
  if (!field.empty())
  {
    subdivide->AddField(field);
  }
  vtkNew<vtkCutter> cutter;
  cutter->SetInputConnection(subdivide->GetOutputPort());
  cutter->SetCutFunction(function);
  cutter->GenerateTrianglesOn();
  vtkNew<vtkIntegrateAttributes> integrate;
  integrate->SetInputConnection(cutter->GetOutputPort());
  integrate->Update();
  if (const std::string error = messages.FirstError(); !error.empty())
  {
    throw Error(error);
  }
  LinearIntegral result;
  result.triangles = cutter->GetOutput()->GetNumberOfCells();
  auto* output = vtkUnstructuredGrid::SafeDownCast(integrate->GetOutputDataObject(0));
  if (vtkDataArray* area = output->GetCellData()->GetArray("Area"))
  {
    result.area = area->GetTuple1(0);
  }
  if (vtkDataArray* values = output->GetPointData()->GetArray(field.c_str());
      values != nullptr && values->GetNumberOfTuples() > 0)
  {
    for (int c = 0; c < values->GetNumberOfComponents(); ++c)
    {
      result.integrals.push_back(values->GetComponent(0, c));
    }
  }
  return result;
}

vtkSmartPointer<vtkContourFilter> MakeLinearContours(
  vtkPolyData* surface, const Layer& layer, std::span<const double> isoValues)
{
  vtkDataArray* const values = surface->GetPointData()->GetArray(layer.field->name.c_str());
  if (values == nullptr)
  {
    return nullptr;
  }
  vtkNew<vtkPolyData> input;
  input->CopyStructure(surface);
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetNumberOfValues(values->GetNumberOfTuples());
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    scalars->SetValue(i, ValueAt(values, i, layer.component));
  }
  input->GetPointData()->SetScalars(scalars);
  vtkNew<vtkContourFilter> contours;
  contours->SetInputData(input);
  for (std::size_t k = 0; k < isoValues.size(); ++k)
  {
    contours->SetValue(static_cast<int>(k), isoValues[k]);
  }
  return contours;
}
} // namespace pixelexact
