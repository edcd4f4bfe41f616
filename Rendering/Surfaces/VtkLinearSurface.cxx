// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/VtkLinearSurface.h"

#include "Core/Base/Error.h"
#include "Trace/Scene.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTriangleFilter.h"

#include <glm/gtc/type_ptr.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace pixelexact
{
double ValueAt(vtkDataArray* values, vtkIdType point, int component)
{
  if (component != kMagnitude || values->GetNumberOfComponents() == 1)
  {
    return values->GetComponent(point, component == kMagnitude ? 0 : component);
  }
  double square = 0.0;
  for (int c = 0; c < values->GetNumberOfComponents(); ++c)
  {
    const double part = values->GetComponent(point, c);
    square += part * part;
  }
  return std::sqrt(square);
}

std::unique_ptr<const LinearSurface> ToLinearSurface(
  vtkPolyData* surface, const std::string& array, int component)
{
  if (surface->GetNumberOfCells() == 0)
  {
    return std::make_unique<const LinearSurface>(
      std::vector<Triangles::Triangle>(), std::vector<std::array<double, 3>>());
  }
  vtkDataArray* values = surface->GetPointData()->GetArray(array.c_str());
  if (values == nullptr || component >= values->GetNumberOfComponents())
  {
    throw Error("the linear surface has no point array '" + array +
      (values == nullptr ? "'; give it one of that name."
                         : "' with a component " + std::to_string(component) + "."));
  }
  vtkNew<vtkTriangleFilter> filter;
  filter->PassVertsOff();
  filter->PassLinesOff();
  filter->SetInputData(surface);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  values = output->GetPointData()->GetArray(array.c_str());
  std::vector<Triangles::Triangle> triangles;
  std::vector<std::array<double, 3>> corners;
  const auto cell = vtkSmartPointer<vtkCellArrayIterator>::Take(output->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(count, ids);
    Triangles::Triangle triangle;
    std::array<double, 3> at{};
    bool isFinite = true;
    for (std::size_t k = 0; k < 3; ++k)
    {
      output->GetPoint(ids[k], glm::value_ptr(triangle[k]));
      at[k] = ValueAt(values, ids[k], component);
      isFinite = isFinite && std::isfinite(at[k]) &&
        std::isfinite(triangle[k].x + triangle[k].y + triangle[k].z);
    }
    if (isFinite)
    {
      triangles.push_back(triangle);
      corners.push_back(at);
    }
  }
  return std::make_unique<const LinearSurface>(std::move(triangles), std::move(corners));
}
} // namespace pixelexact
