// SPDX-License-Identifier: BSD-3-Clause
#ifndef ArrayViews_h
#define ArrayViews_h

#include "Core/Element/Mesh.h"
#include "HighOrderArrays.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

class vtkFieldData;

// Typed views of the arrays that HighOrderArrays.h names. Every function throws InvalidData, naming
// the array, where it is missing, of another type or of another size.
namespace pixelexact
{
/// Keeps what the views point to alive.
using ArrayKeeper = std::vector<vtkSmartPointer<vtkDataArray>>;

/// The values of FieldData array `name` of `components` components and, unless it is negative, of
/// `tuples` tuples. T: double, std::uint8_t, std::int32_t or std::int64_t.
template <class T>
std::span<const T> ViewArray(vtkUnstructuredGrid* grid, const std::string& name, int components,
  vtkIdType tuples, ArrayKeeper& keeper);

/// The same for the arrays of `data`, which may be CellData. A negative number of components
/// accepts any number.
template <class T>
std::span<const T> ViewArrayOf(vtkFieldData* data, const std::string& name, int components,
  vtkIdType tuples, ArrayKeeper& keeper);

/// The same for CellData, with one tuple per cell.
std::span<const std::int64_t> ViewElementIds(vtkUnstructuredGrid* grid, ArrayKeeper& keeper);

/// The arrays of one expansion; spaces are copied, the rest is viewed.
struct ExpansionView
{
  std::vector<Space> spaces;
  std::span<const std::int32_t> spaceOf;
  std::span<const std::int64_t> offset;
  std::span<const double> coefficients;
  Origin origin = Origin::Coefficients;
};

/// The expansion under `prefix`, of `elements` elements (negative: as many as there are).
ExpansionView ViewExpansion(
  vtkUnstructuredGrid* grid, const std::string& prefix, vtkIdType elements, ArrayKeeper& keeper);

/// The mapping of the field under `prefix`; Identity where none is stored.
Mapping ReadMapping(vtkUnstructuredGrid* grid, const std::string& prefix);
} // namespace pixelexact
#endif
