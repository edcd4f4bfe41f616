// SPDX-License-Identifier: BSD-3-Clause
#include "Files/SolverGrid.h"

#include "Cells/LinearCell.h"
#include "Conversion/ConvertedGrid.h"
#include "ConversionLoss.h"
#include "Core/Base/Error.h"
#include "Core/Faces/AttributedFace.h"
#include "Core/Location/Sample.h"
#include "Core/Shape/ShapeFace.h"
#include "HighOrderArrays.h"
#include "HighOrderModel.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

namespace pixelexact
{
namespace
{
constexpr int kFaces = 6;
constexpr int kInside = -1;

/// The file's faces with attributes; `view` is of the same mesh.
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

/// Faces with attributes of a surface in space: each element is a face, with its own attribute.
void MakeShellBoundary(const Mesh& view, SolverMesh& mesh)
{
  mesh.boundary.clear();
  for (std::size_t e = 0; e < mesh.attribute.size(); ++e)
  {
    const Shape shape = view.ShapeOf(static_cast<int>(e));
    const auto& faceOf = LinearCellOf(shape).faceOf;
    mesh.boundary.push_back({ static_cast<std::int32_t>(e),
      static_cast<std::int8_t>(std::ranges::find(faceOf, ShellFace(shape)) - faceOf.begin()),
      mesh.attribute[e] });
  }
  std::erase_if(mesh.groups, [](const Group& group) { return group.boundary; });
  for (Group& group : mesh.groups)
  {
    group.boundary = true;
  }
}

/// Adds the file's attributes and groups, for VTK's filters and for people (see SolverGrid.h).
/// `grid` has these cells.
void AddGroups(
  const SolverMesh& mesh, const Mesh& view, const ElementCells& cells, vtkUnstructuredGrid* grid)
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
      const int own = cells.Of(face.element).isMirrored
        ? MirroredFace(LinearCellOf(view.ShapeOf(face.element)).type, face.face)
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

/// Adds the field's values at the elements' centres (eta = 0) as cell data.
void AddCentreValues(const Mesh& mesh, const Field& field, vtkUnstructuredGrid* grid)
{
  const int components = field.values.components;
  vtkNew<vtkDoubleArray> array;
  array->SetName(field.name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(mesh.Elements());
  tbb::parallel_for(tbb::blocked_range<int>(0, mesh.Elements(), 64),
    [&](const tbb::blocked_range<int>& range)
    {
      for (int e = range.begin(); e < range.end(); ++e)
      {
        const Vec3 centre = TensorToReference(mesh.ShapeOf(e), Vec3(0.0));
        const std::span value(
          array->GetPointer(static_cast<vtkIdType>(e) * components), components);
        EvaluateAt(mesh, field, e, std::span(&centre, 1), value, {});
      }
    });
  grid->GetCellData()->AddArray(array);
}
} // namespace

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

CellLayout StoreSolverMesh(SolverMesh&& mesh, const LayoutRule& rule, vtkUnstructuredGrid* grid)
{
  grid->Initialize();
  const Mesh view{ mesh.map.View(), mesh.centre, mesh.size, mesh.uncertainty };
  Validate(view);
  if (mesh.slab && mesh.slab->inSpace)
  {
    MakeShellBoundary(view, mesh);
  }
  CellLayout layout = rule(view);
  const ElementCells cells(view, layout.degrees);
  MakeCells(mesh, view, layout, cells, grid);
  MeshArrays arrays;
  arrays.boundary = AttributedFacesOf(mesh, view);
  AddGroups(mesh, view, cells, grid);
  arrays.map = std::move(mesh.map);
  arrays.centre = std::move(mesh.centre);
  arrays.size = std::move(mesh.size);
  arrays.uncertainty = std::move(mesh.uncertainty);
  arrays.sourceCell = std::move(mesh.number);
  StoreMesh(grid, std::move(arrays), Origin::Coefficients);
  MarkLinearized(grid, "");
  if (mesh.slab)
  {
    StoreSlab(*mesh.slab, grid);
  }
  return layout;
}

void StoreParameters(const std::map<std::string, double>& parameters, vtkUnstructuredGrid* grid)
{
  for (const auto& [name, value] : parameters)
  {
    if (grid->GetFieldData()->HasArray(name.c_str()) != 0)
    {
      continue;
    }
    vtkNew<vtkDoubleArray> array;
    array->SetName(name.c_str());
    array->InsertNextValue(value);
    grid->GetFieldData()->AddArray(array);
  }
}

void StoreSolverField(SolverField&& field, const CellLayout& layout, vtkUnstructuredGrid* grid)
{
  const auto names = StoredFieldNames(grid);
  if (std::ranges::find(names, field.name) != names.end())
  {
    throw InvalidData("there are two fields of the name '" + field.name +
      "'; fields are named after their files: rename one of them.");
  }
  const auto model = HighOrderModel::From(grid);
  const Field view{ field.name, field.values.View(), field.mapping };
  Validate(view, model->GetMesh());
  const bool atPoints =
    field.continuous || (!layout.sharesPoints && !IsConstantPerElement(view.values));
  if (atPoints)
  {
    AddNodeValues(model->GetMesh(), view, ElementCells(model->GetMesh(), layout.degrees), grid);
  }
  else
  {
    AddCentreValues(model->GetMesh(), view, grid);
  }
  StoreField(grid, field.name, { std::move(field.values), field.mapping },
    atPoints ? Origin::SolverPoints : Origin::SolverCells);
  MarkLinearized(grid, field.name);
  vtkNew<vtkStringArray> basis;
  basis->SetName((kFieldPrefix + field.name + ".Basis").c_str());
  basis->InsertNextValue(field.basis);
  grid->GetFieldData()->AddArray(basis);
}
} // namespace pixelexact
