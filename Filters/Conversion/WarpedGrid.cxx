// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/WarpedGrid.h"

#include "Cells/LinearCell.h"
#include "Conversion/ConvertedGrid.h"
#include "ConversionLoss.h"
#include "Core/Base/Error.h"
#include "Core/Location/Sample.h"
#include "HighOrderArrays.h"
#include "HighOrderModel.h"
#include "PackedArrays.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
/// The values of a field at the grid's points; null where there is no array of them.
vtkDataArray* ValuesAtPointsOf(vtkUnstructuredGrid* grid, const Field& field)
{
  return IsAtPoints(OriginOf(grid, kFieldPrefix + field.name + "."))
    ? grid->GetPointData()->GetArray(field.name.c_str())
    : nullptr;
}

/// The displacement at the vertices of an element.
std::vector<Vec3> AtVertices(
  const Mesh& mesh, int element, std::span<const Vec3> xi, const std::vector<WarpTerm>& terms)
{
  std::vector<Vec3> moved(xi.size(), Vec3(0.0));
  for (const WarpTerm& term : terms)
  {
    const auto width = static_cast<std::size_t>(term.field->values.components);
    std::vector<double> values(width * xi.size());
    EvaluateAt(mesh, *term.field, element, xi, values, {});
    for (std::size_t k = 0; k < xi.size(); ++k)
    {
      moved[k] += values[width * k + static_cast<std::size_t>(term.component)] * term.direction;
    }
  }
  return moved;
}

/// Puts the displacement of the points of linear cells into `moved`. Each is that of the element's
/// vertex next to it.
void MoveCorners(vtkUnstructuredGrid* grid, const Mesh& mesh, const std::vector<WarpTerm>& terms,
  std::vector<Vec3>& moved)
{
  vtkNew<vtkIdList> points;
  std::vector<Vec3> places;
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    if (!IsLinearCell(grid->GetCellType(e)))
    {
      throw InvalidData("the grid has no array at the points that holds the displacement '" +
        terms.front().field->name + "', by which cell " + std::to_string(e) +
        " could move; read the grid again with it.");
    }
    const std::vector<Vec3>& corners = LinearCellOf(mesh.ShapeOf(e)).corners;
    places.resize(corners.size());
    MapForward(mesh, e, corners, places);
    const std::vector<Vec3> displaced = AtVertices(mesh, e, corners, terms);
    grid->GetCellPoints(e, points);
    for (vtkIdType k = 0; k < points->GetNumberOfIds(); ++k)
    {
      Vec3 at;
      grid->GetPoint(points->GetId(k), &at.x);
      std::size_t nearest = 0;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t v = 0; v < places.size(); ++v)
      {
        const Vec3 apart = places[v] - at;
        if (const double distance = std::hypot(apart.x, apart.y, apart.z); distance < least)
        {
          least = distance;
          nearest = v;
        }
      }
      moved[static_cast<std::size_t>(points->GetId(k))] = displaced[nearest];
    }
  }
}

/// The displacement of each point of the grid.
std::vector<Vec3> DisplacementsOfPoints(
  vtkUnstructuredGrid* grid, const Mesh& mesh, const std::vector<WarpTerm>& terms)
{
  std::vector<Vec3> moved(static_cast<std::size_t>(grid->GetNumberOfPoints()), Vec3(0.0));
  const bool haveValues = std::ranges::all_of(
    terms, [grid](const WarpTerm& term) { return ValuesAtPointsOf(grid, *term.field) != nullptr; });
  if (!haveValues)
  {
    MoveCorners(grid, mesh, terms, moved);
    return moved;
  }
  for (const WarpTerm& term : terms)
  {
    vtkDataArray* const values = ValuesAtPointsOf(grid, *term.field);
    for (std::size_t p = 0; p < moved.size(); ++p)
    {
      moved[p] += values->GetComponent(static_cast<vtkIdType>(p), term.component) * term.direction;
    }
  }
  return moved;
}

vtkNew<vtkPoints> MovedPoints(
  vtkUnstructuredGrid* grid, const std::vector<Vec3>& moved, double scale)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(grid->GetNumberOfPoints());
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    Vec3 at;
    grid->GetPoint(p, &at.x);
    at += scale * moved[static_cast<std::size_t>(p)];
    points->SetPoint(p, &at.x);
  }
  return points;
}

/// Shares the arrays of the fields that do not depend on the map.
void ShareFields(vtkUnstructuredGrid* from, const HighOrderModel& model, vtkUnstructuredGrid* to,
  std::vector<std::string>& leftOut)
{
  for (const Field& field : model.Fields())
  {
    if (field.mapping != Mapping::Identity)
    {
      leftOut.push_back(field.name);
      to->GetPointData()->RemoveArray(field.name.c_str());
      to->GetCellData()->RemoveArray(field.name.c_str());
      continue;
    }
    ShareField(from, field.name, to);
  }
}
} // namespace

WarpedGrid WarpGrid(vtkUnstructuredGrid* grid, const WarpRequest& request)
{
  if (!std::isfinite(request.scale))
  {
    throw InvalidData("the scale of the displacement is NaN or infinite; give a finite number.");
  }
  const auto whole = WithAllElements(IsPacked(grid) ? Unpack(grid).Get() : grid);
  const auto model = HighOrderModel::From(whole);
  const Mesh& mesh = model->GetMesh();
  const Displacement displacement = DisplacementOf(*model, whole, request);
  OwnedMesh warped = WarpedMesh(mesh, displacement.terms, request.scale, displacement.jump);
  const auto slab = SlabOf(whole);
  if (slab)
  {
    LiftAgain(*slab, model->SourceCells(), warped.map);
  }
  WarpedGrid result;
  result.grid = vtkSmartPointer<vtkUnstructuredGrid>::Take(grid->NewInstance());
  result.grid->ShallowCopy(whole);
  result.grid->SetPoints(
    MovedPoints(whole, DisplacementsOfPoints(whole, mesh, displacement.terms), request.scale));
  MeshArrays arrays;
  arrays.map = std::move(warped.map);
  arrays.centre = std::move(warped.centre);
  arrays.size = std::move(warped.size);
  arrays.uncertainty = std::move(warped.uncertainty);
  arrays.sourceCell.assign(model->SourceCells().begin(), model->SourceCells().end());
  arrays.boundary.assign(model->BoundaryFaces().begin(), model->BoundaryFaces().end());
  StoreMesh(result.grid, std::move(arrays), OriginOf(whole, kMeshPrefix));
  if (slab)
  {
    StoreSlab(*slab, result.grid);
  }
  ShareFields(whole, *model, result.grid, result.leftOut);
  return result;
}
} // namespace pixelexact
