// SPDX-License-Identifier: BSD-3-Clause
#include "Trade/LinearIntegral.h"

#include "Base/VtkMessages.h"

#include "Core/Base/Error.h"

#include <vtkCellData.h>
#include <vtkCutter.h>
#include <vtkDataArray.h>
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
} // namespace pixelexact
