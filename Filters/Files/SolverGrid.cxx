// SPDX-License-Identifier: BSD-3-Clause
#include "Files/SolverGrid.h"

#include "Cells/LinearCell.h"
#include "Conversion/ConvertedGrid.h"
#include "ConversionLoss.h"
#include "Core/Base/Error.h"
#include "Core/Faces/AttributedFace.h"
#include "Core/Location/Sample.h"
#include "HighOrderArrays.h"
#include "HighOrderModel.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
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

/// Adds the file's attributes and groups, for VTK's filters and for people (see SolverGrid.h).
/// `view` is of the same mesh; `grid` has its cells.
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

/// In element sizes: vertices of one number that are closer than this become one point. It only
/// concerns the linear cells, not the elements.
constexpr double kSamePoint = 1e-9;

template <class Function>
void ForElements(std::size_t elements, Function&& function)
{
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, elements, 64),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t e = range.begin(); e < range.end(); ++e)
      {
        function(static_cast<int>(e));
      }
    });
}

/// Gives elements' corners that have one vertex number and one place a common point.
class PointNumbering
{
public:
  explicit PointNumbering(std::size_t corners)
    : Points(vtkSmartPointer<vtkPoints>::New())
  {
    Points->SetDataTypeToDouble();
    First.reserve(corners / 4);
  }

  vtkIdType Find(std::int64_t vertex, const Vec3& x, double size)
  {
    // Vertices of a periodic mesh have several places: a list of points for each.
    const auto [at, isNew] = First.try_emplace(vertex, -1);
    for (vtkIdType p = at->second; p >= 0; p = Next[p])
    {
      const double* y = static_cast<vtkDoubleArray*>(Points->GetData())->GetPointer(3 * p);
      const Vec3 apart(y[0] - x[0], y[1] - x[1], y[2] - x[2]);
      if (std::max({ std::fabs(apart.x), std::fabs(apart.y), std::fabs(apart.z) }) <=
        kSamePoint * size)
      {
        return p;
      }
    }
    const vtkIdType added = Points->InsertNextPoint(x.x, x.y, x.z);
    Next.push_back(at->second);
    at->second = added;
    return added;
  }

  vtkSmartPointer<vtkPoints> Points;

private:
  std::unordered_map<std::int64_t, vtkIdType> First;
  std::vector<vtkIdType> Next;
};

void MakeCells(const SolverMesh& mesh, const Mesh& view, vtkUnstructuredGrid* grid)
{
  const std::size_t elements = mesh.number.size();
  constexpr std::size_t kTogether = 8192;
  std::vector<std::array<Vec3, 8>> places(std::min(elements, kTogether));
  std::array<vtkIdType, 8> ids{};
  PointNumbering points(elements * 8);
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> types;
  cells->AllocateEstimate(static_cast<vtkIdType>(elements), 8);
  types->SetNumberOfValues(static_cast<vtkIdType>(elements));
  for (std::size_t e = 0; e < elements; ++e)
  {
    if (e % kTogether == 0)
    {
      ForElements(std::min(kTogether, elements - e),
        [&](int k)
        {
          const int own = static_cast<int>(e) + k;
          const auto& corners = LinearCellOf(view.ShapeOf(own)).corners;
          MapForward(view, own, corners,
            std::span(places[static_cast<std::size_t>(k)]).first(corners.size()));
        });
    }
    const LinearCell& cell = LinearCellOf(view.ShapeOf(static_cast<int>(e)));
    types->SetValue(static_cast<vtkIdType>(e), static_cast<unsigned char>(cell.type));
    const std::span own = std::span(places[e % kTogether]).first(cell.corners.size());
    for (std::size_t k = 0; k < own.size(); ++k)
    {
      ids[k] = points.Find(mesh.corners[e][k], own[k], mesh.size[e]);
    }
    const std::span corners = std::span(ids).first(own.size());
    if (VolumeOf(cell.type, own) < 0.0)
    {
      Mirror(corners);
    }
    cells->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
  }
  points.Points->Squeeze(); // it has grown by doubling
  grid->SetPoints(points.Points);
  grid->SetCells(types, cells);
}

vtkSmartPointer<vtkDoubleArray> NewArray(const std::string& name, int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array;
}

/// Values at the cells' vertices. Elements that share a vertex agree; the last one's value is kept.
void AddVertexValues(const Mesh& mesh, const Field& field, vtkUnstructuredGrid* grid)
{
  const int components = field.values.components;
  const auto array = NewArray(field.name, components, grid->GetNumberOfPoints());
  std::vector<Vec3> corners; // in xi, in the cell's order
  std::vector<double> values;
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    const LinearCell& cell = LinearCellOf(mesh.ShapeOf(e));
    corners = cell.corners;
    if (IsMirrored(mesh, e))
    {
      Mirror(std::span(corners));
    }
    values.resize(corners.size() * components);
    EvaluateAt(mesh, field, e, corners, values, {});
    grid->GetCells()->GetCellAtId(e, count, points);
    for (vtkIdType k = 0; k < count; ++k)
    {
      array->SetTypedTuple(points[k], &values[k * components]);
    }
  }
  grid->GetPointData()->AddArray(array);
}

void AddCentreValues(const Mesh& mesh, const Field& field, vtkUnstructuredGrid* grid)
{
  const int components = field.values.components;
  const auto array = NewArray(field.name, components, mesh.Elements());
  ForElements(mesh.Elements(),
    [&](int e)
    {
      const Vec3 centre = TensorToReference(mesh.ShapeOf(e), Vec3(0.0));
      const std::span value(array->GetPointer(static_cast<vtkIdType>(e) * components), components);
      EvaluateAt(mesh, field, e, std::span(&centre, 1), value, {});
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

void StoreSolverMesh(SolverMesh&& mesh, vtkUnstructuredGrid* grid)
{
  grid->Initialize();
  const Mesh view{ mesh.map.View(), mesh.centre, mesh.size, mesh.uncertainty };
  Validate(view);
  MakeCells(mesh, view, grid);
  MeshArrays arrays;
  arrays.boundary = AttributedFacesOf(mesh, view);
  AddGroups(mesh, view, grid);
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

void StoreSolverField(SolverField&& field, vtkUnstructuredGrid* grid)
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
  const auto addValues = field.continuous ? &AddVertexValues : &AddCentreValues;
  addValues(model->GetMesh(), view, grid);
  StoreField(grid, field.name, { std::move(field.values), field.mapping },
    field.continuous ? Origin::SolverPoints : Origin::SolverCells);
  MarkLinearized(grid, field.name);
  vtkNew<vtkStringArray> basis;
  basis->SetName((kFieldPrefix + field.name + ".Basis").c_str());
  basis->InsertNextValue(field.basis);
  grid->GetFieldData()->AddArray(basis);
}
} // namespace pixelexact
