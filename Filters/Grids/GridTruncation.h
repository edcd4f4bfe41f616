// SPDX-License-Identifier: BSD-3-Clause
#ifndef GridTruncation_h
#define GridTruncation_h

#include "Core/Element/Truncation.h"
#include "PixelExactFiltersModule.h"

#include "vtkSmartPointer.h"

#include <span>

class vtkUnstructuredGrid;

namespace pixelexact
{
/// A shallow copy of a grid that carries coefficients, with what truncations keep in the place of
/// the fields of their names. Point and cell arrays of these names, which are the whole fields',
/// are left out.
[[nodiscard]] PIXELEXACTFILTERS_EXPORT vtkSmartPointer<vtkUnstructuredGrid> WithTruncated(
  vtkUnstructuredGrid* grid, std::span<const Truncation> truncations);
} // namespace pixelexact
#endif
