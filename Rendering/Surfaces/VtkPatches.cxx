// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/VtkPatches.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Trace/Surfaces/BezierPatches.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkHigherOrderQuadrilateral.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <glm/gtc/type_ptr.hpp>

#include <array>
#include <cmath>
#include <string>

namespace pixelexact
{
namespace
{
constexpr int kCubic = 3;
constexpr vtkIdType kPointsOfCubic = (kCubic + 1) * (kCubic + 1);

Vec3 PointOf(vtkPointSet* data, vtkIdType id, const std::string& owner)
{
  Vec3 point;
  data->GetPoint(id, glm::value_ptr(point));
  if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z))
  {
    throw Error(owner + ": point " + std::to_string(id) + " is not finite; correct it");
  }
  return point;
}

bool IsVertex(int type)
{
  return type == VTK_VERTEX || type == VTK_POLY_VERTEX || type == VTK_EMPTY_CELL;
}

bool HasCells(vtkPointSet* data)
{
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    if (!IsVertex(data->GetCellType(cell)))
    {
      return true;
    }
  }
  return false;
}

std::string NameOf(vtkIdType cell)
{
  return "Bezier patches: cell " + std::to_string(cell);
}

/// Degrees in u and v: the given ones, or two equal ones from the number of points.
std::array<int, 2> DegreesOf(vtkPointSet* data, vtkIdType cell, vtkIdType points)
{
  vtkDataArray* given = data->GetCellData()->GetHigherOrderDegrees();
  std::array<double, 2> degrees{};
  if (given != nullptr && given->GetNumberOfComponents() >= 2)
  {
    degrees = { given->GetComponent(cell, 0), given->GetComponent(cell, 1) };
  }
  else
  {
    const double side = std::round(std::sqrt(static_cast<double>(points)));
    degrees = { side - 1.0, side - 1.0 };
  }
  const auto whole = [&](double degree) {
    return degree >= 1.0 && degree <= static_cast<double>(points) && degree == std::floor(degree);
  };
  if (!whole(degrees[0]) || !whole(degrees[1]) ||
    (degrees[0] + 1.0) * (degrees[1] + 1.0) != static_cast<double>(points))
  {
    throw Error(NameOf(cell) + " has " + Counted(points, "point") +
      ", not those of a patch of its degrees; correct it, or its cell array HigherOrderDegrees");
  }
  return { static_cast<int>(degrees[0]), static_cast<int>(degrees[1]) };
}

/// A rational patch with equal weights is a polynomial patch.
void RequireEqualWeights(vtkPointSet* data, vtkIdType cell, vtkIdList* ids)
{
  vtkDataArray* weights = data->GetPointData()->GetRationalWeights();
  for (vtkIdType k = 0; weights != nullptr && k < ids->GetNumberOfIds(); ++k)
  {
    const double first = weights->GetComponent(ids->GetId(0), 0);
    if (!std::isfinite(first) || first == 0.0 || weights->GetComponent(ids->GetId(k), 0) != first)
    {
      throw Unsupported(NameOf(cell) +
        " has rational weights that differ, or are no weights; rational patches are not "
        "polynomials: refit it without weights");
    }
  }
}

BezierPatch FromCell(vtkPointSet* data, vtkIdType cell, vtkIdList* ids)
{
  if (data->GetCellType(cell) != VTK_BEZIER_QUADRILATERAL)
  {
    throw Unsupported(NameOf(cell) + " is a " + data->GetCell(cell)->GetClassName() +
      "; patches are vtkBezierQuadrilateral, and polygons are taken by "
      "vtkHighOrderTriangleSurface");
  }
  data->GetCellPoints(cell, ids);
  const auto [nu, nv] = DegreesOf(data, cell, ids->GetNumberOfIds());
  RequireEqualWeights(data, cell, ids);
  BezierPatch patch{ { nu, nv }, {} };
  patch.points.reserve(static_cast<std::size_t>(ids->GetNumberOfIds()));
  for (int i = 0; i <= nu; ++i)
  {
    for (int j = 0; j <= nv; ++j)
    {
      const int at = vtkHigherOrderQuadrilateral::PointIndexFromIJK(i, j, patch.degree);
      patch.points.push_back(PointOf(data, ids->GetId(at), NameOf(cell)));
    }
  }
  return patch;
}

std::vector<BezierPatch> FromPoints(vtkPointSet* data)
{
  const vtkIdType count = data->GetNumberOfPoints();
  if (count == 0 || count % kPointsOfCubic != 0)
  {
    throw Error("Bezier patches: " + Counted(count, "point") +
      " without cells; a bicubic patch has 16, rows of u, and others are cells of type "
      "vtkBezierQuadrilateral");
  }
  std::vector<BezierPatch> patches(static_cast<std::size_t>(count / kPointsOfCubic));
  for (vtkIdType id = 0; id < count; ++id)
  {
    BezierPatch& patch = patches[static_cast<std::size_t>(id / kPointsOfCubic)];
    patch.degree[0] = patch.degree[1] = kCubic;
    patch.points.push_back(
      PointOf(data, id, "Bezier patches: patch " + std::to_string(id / kPointsOfCubic)));
  }
  return patches;
}
} // namespace

std::vector<BezierPatch> ToPatches(vtkPointSet* data)
{
  if (!HasCells(data))
  {
    return FromPoints(data);
  }
  std::vector<BezierPatch> patches;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    patches.push_back(FromCell(data, cell, ids));
  }
  return patches;
}

std::shared_ptr<const Surface> SurfaceOf(const std::vector<BezierPatch>& patches)
{
  return std::make_shared<const BezierPatches>(patches);
}
} // namespace pixelexact
