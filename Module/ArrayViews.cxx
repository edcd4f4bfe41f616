// SPDX-License-Identifier: BSD-3-Clause
#include "ArrayViews.h"

#include "Core/Base/Error.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkUnstructuredGrid.h"

#include <type_traits>

namespace pixelexact
{
namespace
{
[[noreturn]] void Fail(const std::string& name, const std::string& problem)
{
  throw InvalidData("array '" + name + "' " + problem + "; read the source file again.");
}

/// Readers give back an array of int64 as long, long long or vtkIdType, whichever has its size.
template <class T>
bool HasType(vtkDataArray* array)
{
  const int type = array->GetDataType();
  const bool floating = type == VTK_FLOAT || type == VTK_DOUBLE;
  const bool isUnsigned = type == VTK_UNSIGNED_CHAR || type == VTK_UNSIGNED_SHORT ||
    type == VTK_UNSIGNED_INT || type == VTK_UNSIGNED_LONG || type == VTK_UNSIGNED_LONG_LONG;
  return array->GetDataTypeSize() == static_cast<int>(sizeof(T)) &&
    floating == std::is_floating_point_v<T> && isUnsigned == std::is_unsigned_v<T>;
}

template <class T>
std::span<const T> View(vtkDataArray* array, const std::string& name, int components,
  vtkIdType tuples, ArrayKeeper& keeper)
{
  if (!array)
  {
    Fail(name, "is missing or not numeric");
  }
  if (!HasType<T>(array))
  {
    Fail(name,
      std::string("is of type ") + array->GetDataTypeAsString() + ", not " +
        (std::is_floating_point_v<T> ? "double"
            : std::is_unsigned_v<T>  ? "unsigned char"
            : sizeof(T) == 4         ? "a 32-bit integer"
                                     : "a 64-bit integer"));
  }
  if ((components >= 0 && array->GetNumberOfComponents() != components) ||
    (tuples >= 0 && array->GetNumberOfTuples() != tuples))
  {
    Fail(name,
      "has " + std::to_string(array->GetNumberOfTuples()) + " x " +
        std::to_string(array->GetNumberOfComponents()) + " values where " +
        (tuples >= 0 ? std::to_string(tuples) : std::string("any number")) + " x " +
        (components >= 0 ? std::to_string(components) : std::string("any number")) + " are needed");
  }
  if (!array->HasStandardMemoryLayout())
  {
    // Structures of arrays and computed arrays cannot be viewed.
    keeper.push_back(
      vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(array->GetDataType())));
    keeper.back()->DeepCopy(array);
  }
  else
  {
    keeper.emplace_back(array);
  }
  return { static_cast<const T*>(keeper.back()->GetVoidPointer(0)),
    static_cast<std::size_t>(array->GetNumberOfValues()) };
}
} // namespace

template <class T>
std::span<const T> ViewArrayOf(vtkFieldData* data, const std::string& name, int components,
  vtkIdType tuples, ArrayKeeper& keeper)
{
  return View<T>(data->GetArray(name.c_str()), name, components, tuples, keeper);
}

template std::span<const double> ViewArrayOf(
  vtkFieldData*, const std::string&, int, vtkIdType, ArrayKeeper&);
template std::span<const std::uint8_t> ViewArrayOf(
  vtkFieldData*, const std::string&, int, vtkIdType, ArrayKeeper&);
template std::span<const std::int32_t> ViewArrayOf(
  vtkFieldData*, const std::string&, int, vtkIdType, ArrayKeeper&);
template std::span<const std::int64_t> ViewArrayOf(
  vtkFieldData*, const std::string&, int, vtkIdType, ArrayKeeper&);

template <class T>
std::span<const T> ViewArray(vtkUnstructuredGrid* grid, const std::string& name, int components,
  vtkIdType tuples, ArrayKeeper& keeper)
{
  return ViewArrayOf<T>(grid->GetFieldData(), name, components, tuples, keeper);
}

template std::span<const double> ViewArray(
  vtkUnstructuredGrid*, const std::string&, int, vtkIdType, ArrayKeeper&);
template std::span<const std::uint8_t> ViewArray(
  vtkUnstructuredGrid*, const std::string&, int, vtkIdType, ArrayKeeper&);
template std::span<const std::int32_t> ViewArray(
  vtkUnstructuredGrid*, const std::string&, int, vtkIdType, ArrayKeeper&);
template std::span<const std::int64_t> ViewArray(
  vtkUnstructuredGrid*, const std::string&, int, vtkIdType, ArrayKeeper&);

std::span<const std::int64_t> ViewElementIds(vtkUnstructuredGrid* grid, ArrayKeeper& keeper)
{
  return View<std::int64_t>(
    grid->GetCellData()->GetArray(kElementIds), kElementIds, 1, grid->GetNumberOfCells(), keeper);
}

ExpansionView ViewExpansion(
  vtkUnstructuredGrid* grid, const std::string& prefix, vtkIdType elements, ArrayKeeper& keeper)
{
  ExpansionView view;
  const auto spaces = ViewArray<std::uint8_t>(grid, prefix + "Spaces", 5, -1, keeper);
  for (std::size_t i = 0; i < spaces.size(); i += 5)
  {
    // Validate(Expansion) judges the numbers.
    view.spaces.push_back({ static_cast<Shape>(spaces[i]), static_cast<Form>(spaces[i + 1]),
      { spaces[i + 2], spaces[i + 3], spaces[i + 4] } });
  }
  view.spaceOf = ViewArray<std::int32_t>(grid, prefix + "Space", 1, elements, keeper);
  view.offset = ViewArray<std::int64_t>(
    grid, prefix + "Offset", 1, static_cast<vtkIdType>(view.spaceOf.size()), keeper);
  view.coefficients = ViewArray<double>(grid, prefix + "Coefficients", 1, -1, keeper);
  const auto origin = ViewArray<std::uint8_t>(grid, prefix + "Origin", 1, 1, keeper)[0];
  if (origin > static_cast<std::uint8_t>(Origin::SolverCells))
  {
    Fail(prefix + "Origin", "holds the unknown value " + std::to_string(origin));
  }
  view.origin = static_cast<Origin>(origin);
  return view;
}

Mapping ReadMapping(vtkUnstructuredGrid* grid, const std::string& prefix)
{
  const std::string name = prefix + "Mapping";
  if (!grid->GetFieldData()->HasArray(name.c_str()))
  {
    return Mapping::Identity;
  }
  ArrayKeeper keeper;
  // Validate(Field) judges the number.
  return static_cast<Mapping>(ViewArray<std::uint8_t>(grid, name, 1, 1, keeper)[0]);
}
} // namespace pixelexact
