// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/FollowedGrid.h"

#include "Cells/CellNodes.h"
#include "Conversion/ConvertedGrid.h"
#include "Conversion/GridConversion.h"
#include "Conversion/SourceArrays.h"
#include "Conversion/SourceMesh.h"
#include "ConversionLoss.h"
#include "Core/Base/Error.h"
#include "Core/Element/ElementUnits.h"
#include "Core/Element/Warp.h"
#include "Core/Location/Sample.h"
#include "HighOrderArrays.h"
#include "HighOrderModel.h"
#include "PackedArrays.h"
#include "StaleArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <span>

namespace pixelexact
{
namespace
{
/// Distance of a moved point from its image under an affine motion that rounding explains, in
/// roundings of the largest coordinates.
constexpr double kMotionRoundings = 32.0;
/// Difference of a field from its array at the cells' points that rounding explains, relative to
/// the largest value.
constexpr double kSameValue = 1e-9;
/// Entries of a motion's matrix, relative to the largest, that count as 0 across a plane.
constexpr double kParallel = 1e-9;

std::vector<vtkDataArray*> NewPointArrays(vtkUnstructuredGrid* grid)
{
  std::vector<vtkDataArray*> arrays = SelectFields(grid, {}).points;
  const std::vector<std::string> known = StoredFieldNames(grid);
  std::erase_if(arrays,
    [grid, &known](vtkDataArray* array)
    {
      const std::string name = array->GetName();
      return std::ranges::find(known, name) != known.end() ||
        grid->GetFieldData()->HasArray((kDefinitionPrefix + name).c_str()) != 0;
    });
  return arrays;
}

/// Makes the grid that FollowGrid returns.
class Follower
{
public:
  /// `whole`: a grid all of whose elements are there, with coefficients that count as fitting;
  /// `stale`: those that do not.
  Follower(vtkUnstructuredGrid* whole, const StaleParts& stale)
    : Grid(whole)
    , Stale(stale)
    , Model(HighOrderModel::From(whole))
    , Map(Model->GetMesh())
    , Cells(Map, Degrees())
  {
    RequireCells();
  }

  FollowedGrid Make()
  {
    Followed.grid = vtkSmartPointer<vtkUnstructuredGrid>::Take(Grid->NewInstance());
    Followed.grid->ShallowCopy(Grid);
    if (Stale.cells)
    {
      StoreMovedMesh();
      KeepFields();
    }
    StoreNodalFields();
    return std::move(Followed);
  }

private:
  /// The degrees of the grid's cells; 1 of linear ones.
  std::vector<CellDegrees> Degrees()
  {
    Source.emplace(Grid);
    std::vector<CellDegrees> degrees(static_cast<std::size_t>(Map.Elements()), { 1, 1, 1 });
    for (int e = 0; Source->Elements() == Map.Elements() && e < Map.Elements(); ++e)
    {
      if (!IsLinearCell(Grid->GetCellType(e)))
      {
        degrees[static_cast<std::size_t>(e)] = CellDegreesOf(Source->Basis(e).GetSpace());
      }
    }
    return degrees;
  }

  [[noreturn]] void Refuse(const std::string& problem) const
  {
    throw StaleData(problem + RemedyOf(Grid));
  }

  /// Throws StaleData where cells are not those that a reader makes of the elements.
  void RequireCells() const
  {
    for (int e = 0; e < Map.Elements(); ++e)
    {
      const CellNodes& nodes = Cells.Of(e).nodes;
      if (Source->Elements() != Map.Elements() || Grid->GetCellType(e) != nodes.type ||
        Source->Points(e).size() != nodes.nodes.size())
      {
        Refuse("cell " + std::to_string(e) +
          " is not the one that its coefficients were made from: it was cut (Clip)");
      }
    }
  }

  [[nodiscard]] Vec3 PointOf(vtkIdType point) const
  {
    const auto at = Source->Coordinates().subspan(3 * static_cast<std::size_t>(point), 3);
    return { at[0], at[1], at[2] };
  }

  /// The motion that takes all cells' points from where the map has them to where they are, and
  /// per element how far it may be off. None where there is no affine one.
  std::optional<AffineMotion> FindMotion(std::vector<double>& errors) const
  {
    std::vector<Vec3> corners;
    std::vector<Vec3> movedCorners;
    double largest = 0.0;
    double largestMoved = 0.0;
    std::vector<std::vector<Vec3>> places(static_cast<std::size_t>(Map.Elements()));
    tbb::parallel_for(0, Map.Elements(),
      [&](int e)
      {
        auto& own = places[static_cast<std::size_t>(e)];
        own.resize(Cells.Of(e).xi.size());
        MapForward(Map, e, Cells.Of(e).xi, own);
      });
    for (int e = 0; e < Map.Elements(); ++e)
    {
      const auto& own = places[static_cast<std::size_t>(e)];
      for (std::size_t k = 0; k < static_cast<std::size_t>(Cells.Of(e).nodes.corners); ++k)
      {
        corners.push_back(own[k]);
        movedCorners.push_back(PointOf(Source->Points(e)[k]));
        for (int c = 0; c < 3; ++c)
        {
          largest = std::max(largest, std::fabs(corners.back()[c]));
          largestMoved = std::max(largestMoved, std::fabs(movedCorners.back()[c]));
        }
      }
    }
    const std::optional<AffineMotion> motion = FitMotion(corners, movedCorners);
    if (!motion)
    {
      return std::nullopt;
    }
    const double stretch = motion->Stretch();
    const double rounding =
      Source->CoordinateRoundoff() * std::max(largestMoved, stretch * largest);
    errors.resize(static_cast<std::size_t>(Map.Elements()));
    for (int e = 0; e < Map.Elements(); ++e)
    {
      const auto index = static_cast<std::size_t>(e);
      double farthest = 0.0;
      for (std::size_t k = 0; k < places[index].size(); ++k)
      {
        const std::array<long double, 3> image = motion->Apply(places[index][k]);
        const Vec3 now = PointOf(Source->Points(e)[k]);
        for (std::size_t c = 0; c < 3; ++c)
        {
          farthest =
            std::max(farthest, std::fabs(static_cast<double>(image[c] - now[static_cast<int>(c)])));
        }
      }
      if (!(farthest <= kMotionRoundings * rounding + stretch * Map.uncertainty[index]))
      {
        return std::nullopt;
      }
      // A curved element may reach beyond its nodes.
      errors[index] = 2.0 * (farthest + kCoordinateRoundings * rounding);
    }
    return motion;
  }

  /// The slab of a 2-D mesh after a motion, which must keep it parallel to its plane.
  [[nodiscard]] Slab MovedSlab(const Slab& slab, const std::optional<AffineMotion>& motion) const
  {
    if (slab.inSpace)
    {
      if (!motion)
      {
        Refuse(
          "the mesh is a surface in space whose points were moved, and not by an affine motion");
      }
      return slab;
    }
    const double stretch = motion ? motion->Stretch() : 0.0;
    const auto isSmall = [&](std::size_t i, std::size_t j)
    { return std::fabs(motion->matrix[i][j]) <= kParallel * stretch; };
    if (motion && isSmall(2, 0) && isSmall(2, 1) && isSmall(0, 2) && isSmall(1, 2))
    {
      const Vec3 middle(motion->from[0], motion->from[1], slab.middle);
      return { static_cast<double>(motion->Apply(middle)[2]),
        slab.thickness * static_cast<double>(std::fabs(motion->matrix[2][2])) };
    }
    const double reach = 0.5 * slab.thickness * (1.0 + kParallel);
    for (vtkIdType p = 0; p < Grid->GetNumberOfPoints(); ++p)
    {
      if (motion || !(std::fabs(PointOf(p).z - slab.middle) <= reach))
      {
        Refuse("the mesh is 2-D and was moved out of its plane");
      }
    }
    return slab;
  }

  void StoreMovedMesh()
  {
    std::vector<double> errors;
    const std::optional<AffineMotion> motion = FindMotion(errors);
    std::optional<Slab> slab = SlabOf(Grid);
    if (slab)
    {
      slab = MovedSlab(*slab, motion);
    }
    MeshArrays arrays;
    if (motion)
    {
      OwnedMesh moved = MovedMesh(Map, *motion, errors);
      if (slab)
      {
        LiftAgain(*slab, Model->SourceCells(), moved.map);
      }
      arrays.map = std::move(moved.map);
      arrays.centre = std::move(moved.centre);
      arrays.size = std::move(moved.size);
      arrays.uncertainty = std::move(moved.uncertainty);
      IsAffine = true;
    }
    else if (CellsHoldMap(Grid))
    {
      arrays = ConvertMaps(SourceMesh(InElements()));
      const bool isSingle = Grid->GetPoints()->GetDataType() == VTK_FLOAT;
      Followed.notes.emplace_back(
        std::string("the points were moved by a filter; the map is the polynomial through them") +
        (isSingle ? ", in the single precision in which the filter wrote them." : "."));
    }
    else
    {
      Refuse("the points were moved, and not by an affine motion");
    }
    arrays.sourceCell.assign(Model->SourceCells().begin(), Model->SourceCells().end());
    arrays.boundary.assign(Model->BoundaryFaces().begin(), Model->BoundaryFaces().end());
    StoreMesh(Followed.grid, std::move(arrays), OriginOf(Grid, kMeshPrefix));
    if (slab)
    {
      StoreSlab(*slab, Followed.grid);
    }
  }

  /// The grid with the points of each cell in the order that VTK's cell in the element has, whether
  /// or not the grid's is mirrored.
  vtkSmartPointer<vtkUnstructuredGrid> InElements()
  {
    if (Ordered)
    {
      return Ordered;
    }
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkUnsignedCharArray> types;
    types->SetNumberOfValues(Map.Elements());
    std::map<const CellNodes*, std::vector<std::size_t>> orders;
    std::vector<vtkIdType> ids;
    for (int e = 0; e < Map.Elements(); ++e)
    {
      const std::span<const vtkIdType> points = Source->Points(e);
      ids.assign(points.begin(), points.end());
      if (const CellOfKind& kind = Cells.Of(e); kind.isMirrored)
      {
        std::vector<std::size_t>& order = orders[&kind.nodes];
        if (order.empty())
        {
          order = UnmirroredOrder(kind.nodes);
        }
        std::ranges::transform(order, ids.begin(), [points](std::size_t k) { return points[k]; });
      }
      types->SetValue(e, static_cast<unsigned char>(Grid->GetCellType(e)));
      cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    }
    Ordered = vtkSmartPointer<vtkUnstructuredGrid>::New();
    Ordered->ShallowCopy(Grid);
    Ordered->SetCells(types, cells);
    return Ordered;
  }

  /// Whether a field has the values of its array at the cells' points; none where no array of the
  /// points shows it.
  [[nodiscard]] std::optional<bool> IsShownRight(const Field& field) const
  {
    vtkDataArray* array = IsAtPoints(OriginOf(Grid, kFieldPrefix + field.name + "."))
      ? Grid->GetPointData()->GetArray(field.name.c_str())
      : nullptr;
    if (array == nullptr || array->GetNumberOfComponents() != field.values.components)
    {
      return std::nullopt;
    }
    const auto width = static_cast<std::size_t>(field.values.components);
    std::vector<double> values;
    double farthest = 0.0;
    double largest = 0.0;
    for (int e = 0; e < Map.Elements(); ++e)
    {
      const std::vector<Vec3>& xi = Cells.Of(e).xi;
      values.resize(width * xi.size());
      EvaluateAt(Map, field, e, xi, values, {});
      for (std::size_t k = 0; k < values.size(); ++k)
      {
        const double shown =
          array->GetComponent(Source->Points(e)[k / width], static_cast<int>(k % width));
        if (std::isfinite(shown) && std::isfinite(values[k]))
        {
          farthest = std::max(farthest, std::fabs(shown - values[k]));
          largest = std::max(largest, std::fabs(shown));
        }
      }
    }
    return farthest <= kSameValue * largest;
  }

  /// Shares the coefficients of the fields that have not changed with the moved mesh.
  void KeepFields()
  {
    bool isConfirmed = false;
    for (const Field& field : Model->Fields())
    {
      if (field.mapping != Mapping::Identity)
      {
        Followed.notes.push_back("field '" + field.name +
          "' is left out: it is an H(curl), H(div) or density field, whose values depend on the "
          "map.");
        Followed.grid->GetPointData()->RemoveArray(field.name.c_str());
        Followed.grid->GetCellData()->RemoveArray(field.name.c_str());
        continue;
      }
      if (IsChanged(field.name))
      {
        continue;
      }
      const std::optional<bool> isRight = IsShownRight(field);
      if (isRight.has_value() && !*isRight)
      {
        Refuse("the cells' points have another order than the elements");
      }
      isConfirmed = isConfirmed || isRight.has_value();
      ShareField(Grid, field.name, Followed.grid);
    }
    // A piece that a cut leaves of an element may look like its affine image.
    bool areCurved = false;
    for (int e = 0; e < Map.Elements(); ++e)
    {
      areCurved = areCurved || !IsLinearCell(Grid->GetCellType(e));
    }
    if (!isConfirmed && !(IsAffine && areCurved))
    {
      Refuse("the points were moved, and no array of point data shows that the cells are whole");
    }
  }

  [[nodiscard]] bool IsChanged(const std::string& field) const
  {
    return std::ranges::find(Stale.fields, field) != Stale.fields.end();
  }

  /// Stores the fields of changed and of new arrays.
  void StoreNodalFields()
  {
    std::vector<vtkDataArray*> arrays;
    for (const std::string& name : Stale.fields)
    {
      vtkDataArray* array = Grid->GetPointData()->GetArray(name.c_str());
      if (array == nullptr || !CellsHoldMap(Grid) ||
        !IsAtPoints(OriginOf(Grid, kFieldPrefix + name + ".")))
      {
        Refuse("the array '" + name + "' has other values than its coefficients: it was changed");
      }
      arrays.push_back(array);
      Followed.notes.push_back("field '" + name +
        "' was changed by a filter; it is the polynomial through its values at the cells' points.");
    }
    if (CellsHoldMap(Grid))
    {
      const std::vector<vtkDataArray*> added = NewPointArrays(Grid);
      arrays.insert(arrays.end(), added.begin(), added.end());
    }
    if (arrays.empty())
    {
      return;
    }
    const SourceMesh mesh(InElements());
    for (vtkDataArray* array : arrays)
    {
      Followed.grid->GetFieldData()->RemoveArray(
        (std::string(kFieldPrefix) + array->GetName() + ".Basis").c_str());
      ConvertPointField(mesh, array, Followed.grid);
    }
  }

  vtkUnstructuredGrid* Grid;
  const StaleParts& Stale;
  std::shared_ptr<HighOrderModel> Model;
  const Mesh& Map;
  std::optional<SourceMesh> Source;
  ElementCells Cells;
  vtkSmartPointer<vtkUnstructuredGrid> Ordered;
  FollowedGrid Followed;
  bool IsAffine = false;
};
} // namespace

bool HasNewPointArrays(vtkUnstructuredGrid* grid)
{
  return !IsPacked(grid) && !NewPointArrays(grid).empty() && CellsHoldMap(grid);
}

vtkSmartPointer<vtkUnstructuredGrid> WithNewFields(vtkUnstructuredGrid* grid)
{
  const auto whole = WithAllElements(grid);
  auto copy = vtkSmartPointer<vtkUnstructuredGrid>::Take(grid->NewInstance());
  copy->ShallowCopy(whole);
  const SourceMesh mesh(whole);
  for (vtkDataArray* array : NewPointArrays(whole))
  {
    ConvertPointField(mesh, array, copy);
  }
  return copy;
}

FollowedGrid FollowGrid(vtkUnstructuredGrid* grid)
{
  const auto given = IsPacked(grid) ? Unpack(grid) : vtkSmartPointer<vtkUnstructuredGrid>(grid);
  const StaleParts stale = FindStaleParts(given);
  if (!stale.Any() && !HasNewPointArrays(given))
  {
    return { given, {} };
  }
  const auto fitting = stale.Any() ? WithPresentFingerprints(given, stale) : given;
  const auto whole = WithAllElements(fitting);
  return Follower(whole, stale).Make();
}
} // namespace pixelexact
