// SPDX-License-Identifier: BSD-3-Clause
#include "Files/SolverGroups.h"

#include "Cells/LinearCell.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
constexpr int kFaces = 6;
constexpr int kInside = -1;
} // namespace

std::vector<AttributedFace> AttributedFacesOf(const SolverMesh& mesh, const Mesh& view)
{
  std::vector<AttributedFace> faces;
  for (const BoundaryFace& face : mesh.boundary)
  {
    const auto& faceOf = LinearCellOf(view.ShapeOf(face.element)).faceOf;
    faces.push_back(
      { { face.element, faceOf[static_cast<std::size_t>(face.face)] }, face.attribute });
  }
  return faces;
}

void AddGroups(const SolverMesh& mesh, const Mesh& view, vtkUnstructuredGrid* grid)
{
  const auto elements = static_cast<vtkIdType>(mesh.number.size());
  if (!mesh.attribute.empty())
  {
    vtkNew<vtkIntArray> attribute;
    attribute->SetName("Attribute");
    attribute->SetNumberOfValues(elements);
    std::ranges::copy(mesh.attribute, attribute->GetPointer(0));
    grid->GetCellData()->AddArray(attribute);
  }
  if (!mesh.boundary.empty())
  {
    vtkNew<vtkIntArray> boundary;
    boundary->SetName("BoundaryAttribute");
    boundary->SetNumberOfComponents(kFaces);
    boundary->SetNumberOfTuples(elements);
    std::fill_n(boundary->GetPointer(0), kFaces * elements, kInside);
    for (const auto& face : mesh.boundary)
    {
      const int own = IsMirrored(view, face.element)
        ? MirroredFace(grid->GetCellType(face.element), face.face)
        : face.face;
      if (boundary->GetTypedComponent(face.element, own) == kInside)
      {
        boundary->SetTypedComponent(face.element, own, face.attribute);
      }
    }
    grid->GetCellData()->AddArray(boundary);
  }
  AddGroupNames(mesh.groups, grid);
}

void AddGroupNames(const std::vector<Group>& groups, vtkUnstructuredGrid* grid)
{
  if (groups.empty())
  {
    return;
  }
  vtkNew<vtkIntArray> ids;
  vtkNew<vtkUnsignedCharArray> isBoundary;
  vtkNew<vtkStringArray> names;
  ids->SetName("PixelExact.Groups.Id");
  isBoundary->SetName("PixelExact.Groups.Boundary");
  names->SetName("PixelExact.Groups.Name");
  for (const auto& group : groups)
  {
    ids->InsertNextValue(group.id);
    isBoundary->InsertNextValue(group.boundary ? 1 : 0);
    names->InsertNextValue(group.name);
  }
  grid->GetFieldData()->AddArray(ids);
  grid->GetFieldData()->AddArray(isBoundary);
  grid->GetFieldData()->AddArray(names);
}
} // namespace pixelexact
