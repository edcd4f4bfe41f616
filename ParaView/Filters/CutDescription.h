// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactParaViewFiltersModule.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkDataObject;
class vtkImplicitFunction;
class vtkUnstructuredGrid;

// Cut and clip functions that a grid carries from a filter to the representation, in a FieldData
// array of doubles. A tuple holds one function: its kind, whether it is inverted, its parameters,
// and the rows of its transform's matrix. Functions are in the grid's coordinates.
namespace pixelexact
{
/// The array of the functions by which PixelExact Slice cuts.
inline constexpr const char* kSlices = "PixelExactSlices";
/// The array of PixelExact Clip, which keeps the points where no function is positive.
inline constexpr const char* kClips = "PixelExactClips";

struct DescribedCut
{
  vtkSmartPointer<vtkImplicitFunction> function;
  bool inverted = false; ///< of a clip: the points are kept where it is not negative
};

/// Adds functions to an array. The array of an input that shares its FieldData is not changed.
/// Planes, spheres, cylinders, boxes, quadrics and tori are supported, ParaView's included. Throws
/// pixelexact::InvalidData for others and for transforms that are no matrices.
PIXELEXACTPARAVIEWFILTERS_EXPORT void AddCuts(
  vtkUnstructuredGrid* grid, const char* array, const std::vector<DescribedCut>& cuts);

/// Removes an array.
PIXELEXACTPARAVIEWFILTERS_EXPORT void RemoveCuts(vtkUnstructuredGrid* grid, const char* array);

/// The functions in an array of a grid or, of composite data, of the first leaf that has it. Empty
/// where there are none, and where the array is of another kind.
[[nodiscard]] PIXELEXACTPARAVIEWFILTERS_EXPORT std::vector<DescribedCut> CutsOf(
  vtkDataObject* data, const char* array);
} // namespace pixelexact
