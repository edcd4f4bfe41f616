// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/VtkTriangles.h"

#include "Core/Base/Error.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTriangleFilter.h"

#include <glm/gtc/type_ptr.hpp>

#include <utility>
#include <vector>

namespace pixelexact
{
std::shared_ptr<const Triangles> ToTriangles(vtkPolyData* surface)
{
  vtkNew<vtkTriangleFilter> filter;
  filter->PassVertsOff();
  filter->PassLinesOff();
  filter->SetInputData(surface);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  if (output->GetNumberOfPolys() == 0)
  {
    throw Error("there are no triangles in the surface; give it polygons");
  }
  std::vector<Triangles::Triangle> triangles;
  triangles.reserve(static_cast<std::size_t>(output->GetNumberOfPolys()));
  const auto cell = vtkSmartPointer<vtkCellArrayIterator>::Take(output->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(count, ids);
    auto& triangle = triangles.emplace_back();
    for (std::size_t k = 0; k < triangle.size(); ++k)
    {
      output->GetPoint(ids[k], glm::value_ptr(triangle[k]));
    }
  }
  return std::make_shared<Triangles>(std::move(triangles));
}
} // namespace pixelexact
