// SPDX-License-Identifier: BSD-3-Clause
#include "PackedArrays.h"

#include "ArrayViews.h"
#include "CellSums.h"
#include "Fingerprint.h"
#include "HighOrderModel.h"
#include "PackedCheck.h"
#include "PackedNames.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkPoints.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>

namespace pixelexact
{
using namespace packing;

namespace
{
template <class Array>
vtkSmartPointer<Array> AddArray(
  vtkUnstructuredGrid* grid, const std::string& name, int components, double fill)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(grid->GetNumberOfCells());
  array->Fill(fill);
  grid->GetCellData()->AddArray(array);
  return array;
}

int WidthOf(const Expansion& expansion)
{
  int width = 1;
  for (const Space& space : expansion.spaces)
  {
    width = std::max(width, space.Modes() * expansion.components);
  }
  return width;
}

/// The largest number of attributed faces of one element.
int MostFaces(std::span<const AttributedFace> faces)
{
  int most = 0;
  int count = 0;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    count = i > 0 && faces[i].face.element == faces[i - 1].face.element ? count + 1 : 1;
    most = std::max(most, count);
  }
  return most;
}

PackedWidths WidthsFor(const HighOrderModel& model)
{
  PackedWidths widths{ { kMesh + "Coefficients", WidthOf(model.GetMesh().map) } };
  if (const int faces = MostFaces(model.BoundaryFaces()); faces > 0)
  {
    widths[kBoundary] = 2 * faces;
  }
  for (const Field& field : model.Fields())
  {
    widths[FieldName(field.name) + "Coefficients"] = WidthOf(field.values);
  }
  return widths;
}

struct PackedExpansion
{
  vtkSmartPointer<vtkUnsignedCharArray> space;
  vtkSmartPointer<vtkDoubleArray> coefficients;
  vtkSmartPointer<vtkTypeInt64Array> marks;
};

/// Properties that all cells of an expansion share.
struct PackedKind
{
  Origin origin = Origin::Coefficients;
  Mapping mapping = Mapping::Identity;
  std::size_t place = 0; ///< of a field, among the grid's
};

/// Packs everything but the marks.
PackedExpansion PackExpansion(vtkUnstructuredGrid* grid, const std::string& prefix,
  const Expansion& expansion, const PackedKind& kind, int width)
{
  PackedExpansion packed;
  packed.space = AddArray<vtkUnsignedCharArray>(grid, prefix + "Space", kPackedSpace, 0.0);
  packed.coefficients = AddArray<vtkDoubleArray>(grid, prefix + "Coefficients", width, 0.0);
  packed.marks = AddArray<vtkTypeInt64Array>(grid, prefix + "Marks", kPackedMarks, 0.0);
  for (int e = 0; e < expansion.Elements(); ++e)
  {
    const Space& space = expansion.SpaceOf(e);
    const std::array<unsigned char, kPackedSpace> numbers{ static_cast<unsigned char>(space.shape),
      static_cast<unsigned char>(space.form), space.order[0], space.order[1], space.order[2],
      static_cast<unsigned char>(kind.origin), static_cast<unsigned char>(kind.mapping),
      static_cast<unsigned char>(std::min<std::size_t>(kind.place, 255)) };
    std::ranges::copy(numbers, packed.space->GetPointer(std::int64_t{ e } * kPackedSpace));
    std::copy_n(expansion.Coefficients(e), space.Modes() * expansion.components,
      packed.coefficients->GetPointer(std::int64_t{ e } * width));
  }
  return packed;
}

void Mark(const PackedExpansion& packed, std::span<const std::int64_t> first,
  std::span<const std::int64_t> fingerprint, int components, std::span<const double> place)
{
  const auto cells = static_cast<std::size_t>(packed.marks->GetNumberOfTuples());
  for (std::size_t e = 0; e < cells; ++e)
  {
    std::array<std::int64_t, kPackedMarks> marks{ first.empty() ? components : first[e],
      fingerprint.empty() ? 0 : fingerprint[e], 0 };
    PackedCell cell;
    cell.space = packed.space->GetPointer(static_cast<vtkIdType>(e) * kPackedSpace);
    cell.marks = marks.data();
    cell.place = place.empty() ? place : place.subspan(e * kPackedPlace, kPackedPlace);
    const int width = packed.coefficients->GetNumberOfComponents();
    cell.coefficients = { packed.coefficients->GetPointer(static_cast<vtkIdType>(e) * width),
      static_cast<std::size_t>(SpaceIn(cell.space).Modes() * components) };
    marks[2] = CheckOf(cell);
    for (int i = 0; i < kPackedMarks; ++i)
    {
      packed.marks->SetTypedComponent(
        static_cast<vtkIdType>(e), i, marks[static_cast<std::size_t>(i)]);
    }
  }
}

Origin OriginOf(vtkUnstructuredGrid* grid, const std::string& prefix)
{
  ArrayKeeper keeper;
  return static_cast<Origin>(ViewArray<std::uint8_t>(grid, prefix + "Origin", 1, 1, keeper)[0]);
}

void PackSums(vtkUnstructuredGrid* grid, const std::string& prefix, vtkDataArray* values)
{
  const int count = SumsFor(values->GetNumberOfComponents());
  const auto sums = AddArray<vtkDoubleArray>(grid, prefix + "Sums", count, 0.0);
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    SumOver(
      grid, cell, values, { sums->GetPointer(cell * count), static_cast<std::size_t>(count) });
  }
}

void PackMesh(vtkUnstructuredGrid* grid, vtkUnstructuredGrid* source, const HighOrderModel& model,
  const PackedWidths& widths)
{
  const Mesh& mesh = model.GetMesh();
  const auto packed = PackExpansion(
    grid, kMesh, mesh.map, { OriginOf(source, kMeshPrefix) }, widths.at(kMesh + "Coefficients"));
  const auto place = AddArray<vtkDoubleArray>(grid, kMesh + "Place", kPackedPlace, 0.0);
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    double* at = place->GetPointer(std::int64_t{ e } * kPackedPlace);
    std::copy_n(&mesh.centre[3 * static_cast<std::size_t>(e)], 3, at);
    at[3] = mesh.size[static_cast<std::size_t>(e)];
    at[4] = mesh.uncertainty[static_cast<std::size_t>(e)];
  }
  Mark(packed, model.SourceCells(), CellFingerprints(grid), 3,
    { place->GetPointer(0), static_cast<std::size_t>(place->GetNumberOfValues()) });
  PackSums(grid, kMesh, grid->GetPoints()->GetData());
  const auto width = widths.find(kBoundary);
  if (width == widths.end())
  {
    return;
  }
  const auto boundary = AddArray<vtkIntArray>(grid, kBoundary, width->second, -1.0);
  int next = 0;
  const auto faces = model.BoundaryFaces();
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    next = i > 0 && faces[i].face.element == faces[i - 1].face.element ? next + 2 : 0;
    boundary->SetTypedComponent(faces[i].face.element, next, faces[i].face.face);
    boundary->SetTypedComponent(faces[i].face.element, next + 1, faces[i].attribute);
  }
}

void PackField(vtkUnstructuredGrid* grid, vtkUnstructuredGrid* source, const Field& field,
  std::size_t place, const PackedWidths& widths)
{
  const Origin origin = OriginOf(source, kFieldPrefix + field.name + ".");
  const std::string prefix = FieldName(field.name);
  const auto packed = PackExpansion(grid, prefix, field.values, { origin, field.mapping, place },
    widths.at(prefix + "Coefficients"));
  vtkDataArray* nodal = FieldSource(source, field.name, origin);
  const auto prints =
    nodal ? ValueFingerprints(source, nodal, origin) : std::vector<std::int64_t>();
  Mark(packed, {}, prints, field.values.components, {});
  if (nodal != nullptr && IsAtPoints(origin))
  {
    PackSums(grid, prefix, nodal);
  }
}
} // namespace

PackedWidths WidthsFor(vtkUnstructuredGrid* grid)
{
  return WidthsFor(*HighOrderModel::From(grid));
}

PackedWidths WidthsForModes(vtkUnstructuredGrid* grid, int modes)
{
  PackedWidths widths{ { kMesh + "Coefficients", 3 * modes } };
  const auto model = HighOrderModel::From(grid);
  for (const Field& field : model->Fields())
  {
    widths[FieldName(field.name) + "Coefficients"] = field.values.components * modes;
  }
  return widths;
}

void Widen(PackedWidths& widths, const PackedWidths& others)
{
  for (const auto& [name, width] : others)
  {
    int& own = widths[name];
    own = std::max(own, width);
  }
}

vtkSmartPointer<vtkUnstructuredGrid> Pack(vtkUnstructuredGrid* grid, const PackedWidths& atLeast)
{
  if (IsPacked(grid))
  {
    return Pack(Unpack(grid), atLeast);
  }
  const auto model = HighOrderModel::From(grid);
  PackedWidths widths = WidthsFor(*model);
  Widen(widths, atLeast);
  auto packed = BareCopy(grid, true);
  PackMesh(packed, grid, *model, widths);
  const auto fields = model->Fields();
  for (std::size_t i = 0; i < fields.size(); ++i)
  {
    PackField(packed, grid, fields[i], i, widths);
  }
  return packed;
}
} // namespace pixelexact
