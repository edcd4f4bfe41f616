// SPDX-License-Identifier: BSD-3-Clause
#include "ArrayViews.h"
#include "CellSums.h"
#include "ConversionLoss.h"
#include "Core/Base/Error.h"
#include "Fingerprint.h"
#include "PackedCheck.h"
#include "PackedNames.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace pixelexact
{
using namespace packing;

namespace
{
/// The arrays of one expansion, checked, and their unpacked form.
class Unpacking
{
public:
  Unpacking(vtkUnstructuredGrid* grid, const std::string& prefix, const std::string& what)
    : What(what)
    , Grid(grid)
    , Cells(grid->GetNumberOfCells())
  {
    vtkCellData* data = grid->GetCellData();
    Spaces = ViewArrayOf<std::uint8_t>(data, prefix + "Space", kPackedSpace, Cells, Keeper);
    Marks = ViewArrayOf<std::int64_t>(data, prefix + "Marks", kPackedMarks, Cells, Keeper);
    Packed = ViewArrayOf<double>(data, prefix + "Coefficients", -1, Cells, Keeper);
    Width = Cells > 0 ? Packed.size() / static_cast<std::size_t>(Cells) : 0;
  }

  /// `place` is empty for a field; a mesh needs it.
  OwnedExpansion Expand(std::span<const double> place, int components)
  {
    std::vector<Space> spaces;
    for (std::size_t e = 0; e < static_cast<std::size_t>(Cells); ++e)
    {
      PackedCell cell;
      cell.space = &Spaces[e * kPackedSpace];
      cell.marks = &Marks[e * kPackedMarks];
      cell.place = place.empty() ? place : place.subspan(e * kPackedPlace, kPackedPlace);
      const Space space = SpaceIn(cell.space);
      const std::size_t values =
        space.IsValid() ? static_cast<std::size_t>(space.Modes() * components) : Width + 1;
      if (values <= Width)
      {
        cell.coefficients = Packed.subspan(e * Width, values);
      }
      if (values > Width || cell.marks[2] != CheckOf(cell))
      {
        throw StaleData("cell " + std::to_string(e) + " has packed coefficients of " + What +
          " that were changed on the way: averaged, rounded, transformed, filled in or blanked; "
          "pack after that filter (vtkHighOrderPack), or keep the cells from it" +
          RemedyOf(Grid));
      }
      spaces.push_back(space);
    }
    OwnedExpansion expansion;
    expansion.Allocate(spaces, components);
    for (std::size_t e = 0; e < spaces.size(); ++e)
    {
      const std::span<double> own = expansion.Coefficients(e);
      std::ranges::copy(Packed.subspan(e * Width, own.size()), own.begin());
    }
    return expansion;
  }

  /// Returns the value that all cells share. Throws InvalidData where cells differ.
  std::int64_t Common(const char* name, bool ofSpace, std::size_t at) const
  {
    const auto value = [&](std::size_t e) {
      return ofSpace ? std::int64_t{ Spaces[e * kPackedSpace + at] } : Marks[e * kPackedMarks + at];
    };
    for (std::size_t e = 1; e < static_cast<std::size_t>(Cells); ++e)
    {
      if (value(e) != value(0))
      {
        throw InvalidData(What + " is of two kinds: cells 0 and " + std::to_string(e) +
          " differ in its " + name + "; rename it in one of the data sets that were put together.");
      }
    }
    return Cells > 0 ? value(0) : 0;
  }

  std::vector<std::int64_t> Column(std::size_t at) const
  {
    std::vector<std::int64_t> column;
    for (std::size_t e = 0; e < static_cast<std::size_t>(Cells); ++e)
    {
      column.push_back(Marks[e * kPackedMarks + at]);
    }
    return column;
  }
  [[nodiscard]] bool IsAnySolvers() const
  {
    for (std::size_t e = 0; e < static_cast<std::size_t>(Cells); ++e)
    {
      if (IsSolvers(static_cast<Origin>(Spaces[e * kPackedSpace + kPackedOrigin])))
      {
        return true;
      }
    }
    return false;
  }

private:
  std::string What;
  vtkUnstructuredGrid* Grid;
  vtkIdType Cells;
  ArrayKeeper Keeper;
  std::span<const std::uint8_t> Spaces;
  std::span<const std::int64_t> Marks;
  std::span<const double> Packed;
  std::size_t Width = 0;
};

/// Returns the stored fingerprints, except for cells whose points or values are the same up to
/// rounding: those get their present fingerprints. `roundings(cell)` gives the largest error of
/// each value and the largest magnitude.
std::vector<std::int64_t> Restamped(vtkUnstructuredGrid* grid, const std::string& prefix,
  vtkDataArray* values, std::vector<std::int64_t> then, const std::vector<std::int64_t>& now,
  const std::function<std::pair<double, double>(std::size_t)>& roundings)
{
  vtkDataArray* sums = grid->GetCellData()->GetArray((prefix + "Sums").c_str());
  const auto count = static_cast<std::size_t>(SumsFor(values->GetNumberOfComponents()));
  if (sums == nullptr || sums->GetNumberOfComponents() != static_cast<int>(count) ||
    sums->GetNumberOfTuples() != grid->GetNumberOfCells())
  {
    return then;
  }
  std::vector<double> before(count);
  std::vector<double> after(count);
  for (std::size_t cell = 0; cell < then.size(); ++cell)
  {
    if (then[cell] != now[cell])
    {
      sums->GetTuple(static_cast<vtkIdType>(cell), before.data());
      SumOver(grid, static_cast<vtkIdType>(cell), values, after);
      const auto [tolerance, largest] = roundings(cell);
      then[cell] = AreSameSums(before, after, tolerance, largest) ? now[cell] : then[cell];
    }
  }
  return then;
}

double LargestOf(vtkDataArray* values)
{
  double largest = 0.0;
  for (int c = 0; c < values->GetNumberOfComponents(); ++c)
  {
    double range[2] = { 0.0, 0.0 };
    values->GetRange(range, c);
    largest = std::max({ largest, std::fabs(range[0]), std::fabs(range[1]) });
  }
  return largest;
}

constexpr double kRounding = std::numeric_limits<double>::epsilon();

std::vector<AttributedFace> UnpackBoundary(vtkUnstructuredGrid* grid)
{
  std::vector<AttributedFace> boundary;
  vtkDataArray* array = grid->GetCellData()->GetArray(kBoundary.c_str());
  if (array == nullptr)
  {
    return boundary;
  }
  ArrayKeeper keeper;
  const auto numbers =
    ViewArrayOf<std::int32_t>(grid->GetCellData(), kBoundary, -1, grid->GetNumberOfCells(), keeper);
  const int width = array->GetNumberOfComponents();
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    for (int i = 0; i + 1 < width; i += 2)
    {
      const auto* entry = &numbers[static_cast<std::size_t>(cell * width + i)];
      if (entry[0] >= 0)
      {
        // The model refuses entries that are no faces.
        boundary.push_back({ { static_cast<std::int32_t>(cell), entry[0] }, entry[1] });
      }
    }
  }
  return boundary;
}

void UnpackMesh(vtkUnstructuredGrid* grid, vtkUnstructuredGrid* output)
{
  Unpacking packed(grid, kMesh, "the mesh");
  ArrayKeeper keeper;
  const auto place = ViewArrayOf<double>(
    grid->GetCellData(), kMesh + "Place", kPackedPlace, grid->GetNumberOfCells(), keeper);
  MeshArrays mesh;
  mesh.map = packed.Expand(place, 3);
  for (std::size_t i = 0; i < place.size(); i += kPackedPlace)
  {
    mesh.centre.insert(mesh.centre.end(), &place[i], &place[i] + 3);
    mesh.size.push_back(place[i + 3]);
    mesh.uncertainty.push_back(place[i + 4]);
  }
  mesh.sourceCell = packed.Column(0);
  mesh.boundary = UnpackBoundary(grid);
  vtkDataArray* points = grid->GetPoints()->GetData();
  const double largest = LargestOf(points);
  const auto prints = Restamped(grid, kMesh, points, packed.Column(1), CellFingerprints(grid),
    [&](std::size_t cell)
    { return std::pair(4.0 * mesh.uncertainty[cell] + 16.0 * kRounding * largest, largest); });
  StoreMesh(output, std::move(mesh),
    packed.IsAnySolvers() ? Origin::Coefficients : Origin::PointData, prints);
}

void UnpackField(vtkUnstructuredGrid* grid, const std::string& name, vtkUnstructuredGrid* output)
{
  Unpacking packed(grid, FieldName(name), "field '" + name + "'");
  const std::int64_t components = packed.Common("number of components", false, 0);
  const std::int64_t origin =
    packed.Common("origin (nodal values, a solver's)", true, kPackedOrigin);
  const std::int64_t mapping = packed.Common("mapping", true, kPackedOrigin + 1);
  if (components < 0 || components > 1 << 16)
  {
    throw InvalidData("field '" + name + "' is said to have " + std::to_string(components) +
      " components; pack it again (vtkHighOrderPack).");
  }
  FieldExpansion field{ packed.Expand({}, std::max(1, static_cast<int>(components))),
    static_cast<Mapping>(mapping) };
  auto prints = packed.Column(1);
  vtkDataArray* nodal = FieldSource(grid, name, static_cast<Origin>(origin));
  if (nodal != nullptr && IsAtPoints(static_cast<Origin>(origin)))
  {
    const double largest = LargestOf(nodal);
    prints = Restamped(grid, FieldName(name), nodal, std::move(prints),
      ValueFingerprints(grid, nodal, static_cast<Origin>(origin)),
      [&](std::size_t) { return std::pair(256.0 * kRounding * largest, largest); });
  }
  StoreField(output, name, std::move(field), static_cast<Origin>(origin), prints);
}
} // namespace

bool PacksSolverCoefficients(vtkUnstructuredGrid* grid)
{
  if (!IsPacked(grid))
  {
    return false;
  }
  const auto names = PackedFieldNames(grid);
  return Unpacking(grid, kMesh, "the mesh").IsAnySolvers() ||
    std::ranges::any_of(names,
      [grid](const std::string& name)
      { return Unpacking(grid, FieldName(name), "field '" + name + "'").IsAnySolvers(); });
}

vtkSmartPointer<vtkUnstructuredGrid> Unpack(vtkUnstructuredGrid* grid)
{
  auto output = BareCopy(grid, false);
  if (grid->GetNumberOfCells() == 0)
  {
    return output;
  }
  // StoreMesh removes all of PixelExact's arrays first.
  const auto fixed = FixedArrays(grid->GetFieldData());
  UnpackMesh(grid, output);
  for (const auto& array : fixed)
  {
    output->GetFieldData()->AddArray(array);
  }
  for (const std::string& name : PackedFieldNames(grid))
  {
    UnpackField(grid, name, output);
  }
  return output;
}
} // namespace pixelexact
