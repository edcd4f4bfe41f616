// SPDX-License-Identifier: BSD-3-Clause
#ifndef VtkHdfGrid_h
#define VtkHdfGrid_h

#include "PixelExactFiltersModule.h"

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <string>
#include <vector>

// Grids of VTK's HDF format (Formats/VtkHdf). All functions throw InvalidData or Unsupported,
// without the file's name.
namespace pixelexact
{
/// The times of the file's steps, in its order; empty: it has no steps.
std::vector<double> VtkHdfTimes(const std::string& file);

/// Reads the parts of all blocks at a step, counted from 0; at least one. Numbers keep their type:
/// arrays of single precision stay single, integers keep sign and size. Reals of more than double
/// precision are rounded to double, which is noted, as is what is left out.
std::vector<vtkSmartPointer<vtkUnstructuredGrid>> ReadVtkHdfParts(
  const std::string& file, std::size_t step, std::vector<std::string>& notes);

/// Whether the first step has a cell that is not linear; false also for files that cannot be read.
PIXELEXACTFILTERS_EXPORT bool HasCurvedVtkHdfCells(const std::string& file);
} // namespace pixelexact
#endif
