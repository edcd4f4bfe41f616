// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/SourceMesh.h"
#include "Conversion/SourceCells.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Core/Basis/ModeBound.h"
#include "Core/Element/ElementUnits.h"
#include "Core/Math/Rounding.h"
#include "Formats/FileText.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
/// Distance of a plane's points from it that rounding explains, in roundings of their coordinates.
constexpr double kPlaneRoundings = 4.0;

bool IsHidden(vtkDataArray* ghosts, vtkIdType cell)
{
  return ghosts &&
    (static_cast<int>(ghosts->GetComponent(cell, 0)) & vtkDataSetAttributes::HIDDENCELL) != 0;
}
} // namespace

vtkSmartPointer<vtkDoubleArray> AsDoubles(vtkDataArray* array)
{
  if (auto* doubles = vtkDoubleArray::FastDownCast(array))
  {
    return doubles;
  }
  auto copy = vtkSmartPointer<vtkDoubleArray>::New();
  copy->DeepCopy(array);
  return copy;
}

SourceMesh::SourceMesh(vtkUnstructuredGrid* grid, const NodeConvention& nodes, bool surfaces)
  : Nodes(nodes)
{
  vtkDataArray* ghosts = grid->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName());
  const std::map<int, int> dimensions = DimensionsOf(grid);
  const bool isPlane = surfaces || HighestDimension(dimensions) == 2;
  const int wanted = isPlane ? 2 : 3;
  ViewConnectivity(grid);
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const int type = grid->GetCellType(cell);
    const int dimension = dimensions.at(type);
    const bool isHidden = IsHidden(ghosts, cell);
    if ((dimension >= 0 && dimension < wanted) || (surfaces && dimension != wanted) || isHidden)
    {
      ++Skipped;
      Surfaces += dimension == 2 && !isHidden ? 1 : 0;
      continue;
    }
    AddCell(grid, cell, type);
  }
  if (Cells.empty() && surfaces)
  {
    throw InvalidData("the grid has no triangles and no quadrilaterals; switch SurfaceElements off "
                      "(leave out --surface-elements).");
  }
  if (Cells.empty())
  {
    const bool curves = HighestDimension(dimensions) == 1;
    throw InvalidData("the grid has no two- or three-dimensional cell (" + std::to_string(Skipped) +
      " of other dimensions); " +
      (curves
          ? "curves are not drawn: make tubes of them (vtkTubeFilter; in ParaView: Extract "
            "Surface, Tube, Triangulate, Append Datasets), or write the surfaces or solids that "
            "they stand for."
          : "check that the file holds a mesh."));
  }
  if (Cells.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
  {
    throw Unsupported("the grid has more than 2^31 - 1 cells; split it.");
  }
  if (vtkDataArray* numbers = grid->GetCellData()->GetArray(kSourceCells);
      numbers != nullptr && numbers->GetNumberOfValues() == grid->GetNumberOfCells())
  {
    for (const vtkIdType cell : Cells)
    {
      Numbers.push_back(static_cast<std::int64_t>(numbers->GetComponent(cell, 0)));
    }
  }
  Roundoff = grid->GetPoints()->GetDataType() == VTK_FLOAT ? kFloatRoundoff : kUnitRoundoff;
  for (CellBasis& basis : Bases)
  {
    if (basis.kind.weights == 0)
    {
      basis.noise = NoiseBound(basis.change);
    }
  }
  Points3 = AsDoubles(grid->GetPoints()->GetData());
  Xyz = { Points3->GetPointer(0), static_cast<std::size_t>(Points3->GetNumberOfValues()) };
  CheckCoordinates();
  if (isPlane)
  {
    FindSlab();
  }
  Rationals.Convert(
    Xyz, Plane && !Plane->inSpace ? 2 : 3, [this](int e) { return Describe(e); },
    [this](int e, const ChangeOfBasis& change)
    {
      const auto index = static_cast<std::size_t>(e);
      BasisOf[index] = &Bases.emplace_back(CellBasis{ BasisOf[index]->kind, change, {} });
    });
}

void SourceMesh::FindSlab()
{
  Vec3 low(INFINITY);
  Vec3 high(-INFINITY);
  for (int e = 0; e < Elements(); ++e)
  {
    for (const auto p : Points(e))
    {
      const Vec3 x(Xyz[3 * p], Xyz[3 * p + 1], Xyz[3 * p + 2]);
      low = glm::min(low, x);
      high = glm::max(high, x);
    }
  }
  Plane = MakeSlab(low, high, kPlaneRoundings * Roundoff);
}

/// Views the grid's own lists where they are of vtkIdType, else copies them.
void SourceMesh::ViewConnectivity(vtkUnstructuredGrid* grid)
{
  Connectivity = grid->GetCells();
  if (!Connectivity)
  {
    return;
  }
  if (!Connectivity->IsStorage64Bit())
  {
    Connectivity = vtkSmartPointer<vtkCellArray>::New();
    Connectivity->DeepCopy(grid->GetCells());
    Connectivity->ConvertTo64BitStorage();
  }
  static_assert(sizeof(vtkIdType) == sizeof(vtkTypeInt64), "VTK with VTK_USE_64BIT_IDS is needed");
  const auto view = [](auto* array)
  {
    return std::span<const vtkIdType>(
      array->GetPointer(0), static_cast<std::size_t>(array->GetNumberOfValues()));
  };
  PointIds = view(PointIds64(*Connectivity));
  Offsets = view(Offsets64(*Connectivity));
}

void SourceMesh::AddCell(vtkUnstructuredGrid* grid, vtkIdType cell, int type)
{
  const auto first = static_cast<std::size_t>(Offsets[cell]);
  const auto points = PointIds.subspan(first, static_cast<std::size_t>(Offsets[cell + 1]) - first);
  const CellKind kind = KindOf(grid, cell, type, points, Nodes);
  auto& basis = BasisOfKind[kind];
  if (!basis)
  {
    basis = NameErrors(
      "cell " + std::to_string(cell), [&] { return &Bases.emplace_back(MakeCellBasis(kind)); });
  }
  if (kind.weights != 0)
  {
    Rationals.Add(Elements(), *basis, points, grid->GetPointData()->GetRationalWeights());
  }
  Cells.push_back(cell);
  BasisOf.push_back(basis);
}

void SourceMesh::CheckCoordinates() const
{
  int bad = 0;
  int first = -1;
  for (int e = 0; e < Elements(); ++e)
  {
    const bool finite = std::ranges::all_of(Points(e),
      [&](vtkIdType p)
      {
        return std::isfinite(Xyz[3 * p]) && std::isfinite(Xyz[3 * p + 1]) &&
          std::isfinite(Xyz[3 * p + 2]);
      });
    if (!finite)
    {
      first = bad++ == 0 ? e : first;
    }
  }
  if (bad > 0)
  {
    throw InvalidData(Describe(first) + " has a point whose coordinates are NaN or infinite" +
      (bad > 1 ? ", and so have " + Counted(bad - 1, "more cell") : "") +
      "; repair the points or take these cells out.");
  }
}

std::string SourceMesh::Describe(int element) const
{
  return NameCell(Cells[element], BasisOf[element]->kind.type);
}

void SourceMesh::GatherAll(int element, std::span<const double> values, int components, int wanted,
  std::vector<double>& out) const
{
  if (Rationals.Has(element))
  {
    out.clear();
    std::vector<double> one;
    for (int c = 0; c < wanted; ++c)
    {
      Gather(element, values, components, c, one);
      out.insert(out.end(), one.begin(), one.end());
    }
    return;
  }
  const auto points = Points(element);
  out.resize(points.size() * static_cast<std::size_t>(wanted));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double* tuple = &values[static_cast<std::size_t>(points[i]) * components];
    for (int c = 0; c < wanted; ++c)
    {
      out[static_cast<std::size_t>(c) * points.size() + i] = tuple[c];
    }
  }
}

void SourceMesh::Gather(int element, std::span<const double> values, int components, int component,
  std::vector<double>& out) const
{
  if (Rationals.Has(element))
  {
    Rationals.Gather(element, values, components, component, out);
    return;
  }
  const auto points = Points(element);
  out.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    out[i] = values[static_cast<std::size_t>(points[i]) * components + component];
  }
}
} // namespace pixelexact
