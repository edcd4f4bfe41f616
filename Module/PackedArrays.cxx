// SPDX-License-Identifier: BSD-3-Clause
#include "PackedArrays.h"

#include "ArrayViews.h"
#include "CellSums.h"
#include "Core/Base/Error.h"
#include "Fingerprint.h"
#include "HighOrderModel.h"
#include "PackedCheck.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

namespace pixelexact
{
namespace
{
const std::string kMesh = std::string(kPackedPrefix) + "Mesh.";
const std::string kField = std::string(kPackedPrefix) + "Field.";
const std::string kBoundary = kMesh + "Boundary";

std::string FieldName(const std::string& field)
{
  return kField + field + ".";
}

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

/// Of attributed faces, the most that one element has.
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

/// What all of an expansion's cells have alike.
struct PackedKind
{
  Origin origin = Origin::Coefficients;
  Mapping mapping = Mapping::Identity;
  std::size_t place = 0; ///< of a field, among the grid's
};

/// All but the marks.
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
  if (nodal != nullptr && origin == Origin::PointData)
  {
    PackSums(grid, prefix, nodal);
  }
}

/// Arrays of ours that are not of elements: names of bases, a plane mesh's slab.
std::vector<vtkSmartPointer<vtkAbstractArray>> FixedArrays(vtkFieldData* data)
{
  static const std::set<std::string> kOfElements{ "Spaces", "Space", "Offset", "Coefficients",
    "Centre", "Size", "Uncertainty", "SourceCell", "Fingerprint", "Origin", "Components", "Mapping",
    "Element", "Face", "Attribute" };
  std::vector<vtkSmartPointer<vtkAbstractArray>> fixed;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : "";
    if ((name.starts_with(kMeshPrefix) || name.starts_with(kFieldPrefix)) &&
      !kOfElements.contains(name.substr(name.rfind('.') + 1)))
    {
      fixed.emplace_back(array);
    }
  }
  return fixed;
}

/// A copy whose lists of arrays are its own, with our arrays that `keep` names alone.
vtkSmartPointer<vtkUnstructuredGrid> BareCopy(vtkUnstructuredGrid* grid, bool keepIds)
{
  auto copy = vtkSmartPointer<vtkUnstructuredGrid>::Take(grid->NewInstance());
  copy->ShallowCopy(grid);
  vtkNew<vtkFieldData> fieldData;
  fieldData->ShallowCopy(grid->GetFieldData());
  copy->SetFieldData(fieldData);
  const auto fixed = FixedArrays(grid->GetFieldData());
  const vtkSmartPointer<vtkAbstractArray> ids = grid->GetCellData()->GetAbstractArray(kElementIds);
  RemoveHighOrderArrays(copy);
  for (const auto& array : fixed)
  {
    copy->GetFieldData()->AddArray(array);
  }
  if (keepIds && ids)
  {
    copy->GetCellData()->AddArray(ids);
  }
  return copy;
}
} // namespace

bool IsPacked(vtkUnstructuredGrid* grid)
{
  return grid->GetCellData()->HasArray((kMesh + "Space").c_str()) != 0 ||
    grid->GetCellData()->HasArray((kMesh + "Marks").c_str()) != 0;
}

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
  const auto packed = BareCopy(grid, true);
  PackMesh(packed, grid, *model, widths);
  const auto fields = model->Fields();
  for (std::size_t i = 0; i < fields.size(); ++i)
  {
    PackField(packed, grid, fields[i], i, widths);
  }
  return packed;
}

namespace
{
/// The arrays of one expansion, checked, and their unpacked form.
class Unpacking
{
public:
  Unpacking(vtkUnstructuredGrid* grid, const std::string& prefix, const std::string& what)
    : What(what)
    , Cells(grid->GetNumberOfCells())
  {
    vtkCellData* data = grid->GetCellData();
    Spaces = ViewArrayOf<std::uint8_t>(data, prefix + "Space", kPackedSpace, Cells, Keeper);
    Marks = ViewArrayOf<std::int64_t>(data, prefix + "Marks", kPackedMarks, Cells, Keeper);
    Packed = ViewArrayOf<double>(data, prefix + "Coefficients", -1, Cells, Keeper);
    Width = Cells > 0 ? Packed.size() / static_cast<std::size_t>(Cells) : 0;
  }

  /// Of a mesh `place` is given, of a field it is empty.
  ExpansionArrays Arrays(std::span<const double> place, int components)
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
          "pack "
          "behind that filter (vtkHighOrderPack), or run vtkUnstructuredGridToHighOrderGrid "
          "again.");
      }
      spaces.push_back(space);
    }
    ExpansionArrays arrays;
    arrays.Allocate(spaces, components);
    for (std::size_t e = 0; e < spaces.size(); ++e)
    {
      std::ranges::copy(
        Packed.subspan(e * Width, static_cast<std::size_t>(spaces[e].Modes() * components)),
        arrays.Coefficients(e));
    }
    return arrays;
  }

  /// What all cells have alike; InvalidData where they do not.
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
      if (Spaces[e * kPackedSpace + kPackedOrigin] ==
        static_cast<std::uint8_t>(Origin::Coefficients))
      {
        return true;
      }
    }
    return false;
  }

private:
  std::string What;
  vtkIdType Cells;
  ArrayKeeper Keeper;
  std::span<const std::uint8_t> Spaces;
  std::span<const std::int64_t> Marks;
  std::span<const double> Packed;
  std::size_t Width = 0;
};

/// The fingerprints as they were, but for cells whose points or values are still the same up to
/// rounding: those have the fingerprints that they have now. `roundings(cell)`: how far off each
/// may be, and how large it is.
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
        // What is no face the model refuses.
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
  mesh.map = packed.Arrays(place, 3);
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
  StoreMesh(output, mesh, packed.IsAnySolvers() ? Origin::Coefficients : Origin::PointData, prints);
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
  ExpansionArrays values = packed.Arrays({}, std::max(1, static_cast<int>(components)));
  values.mapping = static_cast<Mapping>(mapping);
  auto prints = packed.Column(1);
  vtkDataArray* nodal = FieldSource(grid, name, static_cast<Origin>(origin));
  if (nodal != nullptr && static_cast<Origin>(origin) == Origin::PointData)
  {
    const double largest = LargestOf(nodal);
    prints = Restamped(grid, FieldName(name), nodal, std::move(prints),
      ValueFingerprints(grid, nodal, Origin::PointData),
      [&](std::size_t) { return std::pair(256.0 * kRounding * largest, largest); });
  }
  StoreField(output, name, values, static_cast<Origin>(origin), prints);
}
} // namespace

std::vector<std::string> PackedFieldNames(vtkUnstructuredGrid* grid)
{
  const std::string suffix = ".Marks";
  // By their places, since filters and files put arrays in an order of their own.
  std::multimap<double, std::string> byPlace;
  vtkCellData* data = grid->GetCellData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    const char* arrayName = data->GetArrayName(i);
    const std::string name = arrayName ? arrayName : "";
    if (name.starts_with(kField) && name.ends_with(suffix) &&
      name.size() > kField.size() + suffix.size())
    {
      const std::string field =
        name.substr(kField.size(), name.size() - kField.size() - suffix.size());
      vtkDataArray* space = data->GetArray((FieldName(field) + "Space").c_str());
      const bool isThere = space != nullptr && space->GetNumberOfTuples() > 0 &&
        space->GetNumberOfComponents() == kPackedSpace;
      byPlace.emplace(isThere ? space->GetComponent(0, kPackedSpace - 1) : 0.0, field);
    }
  }
  std::vector<std::string> names;
  for (const auto& [place, field] : byPlace)
  {
    names.push_back(field);
  }
  return names;
}

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
  const auto output = BareCopy(grid, false);
  if (grid->GetNumberOfCells() == 0)
  {
    return output;
  }
  // StoreMesh begins with nothing of ours.
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
