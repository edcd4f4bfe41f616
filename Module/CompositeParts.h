// SPDX-License-Identifier: BSD-3-Clause
#ifndef CompositeParts_h
#define CompositeParts_h

#include "PixelExactDataModelModule.h"

#include <string>
#include <vector>

class vtkCompositeDataSet;
class vtkUnstructuredGrid;

namespace pixelexact
{
/// A leaf of composite data.
struct CompositePart
{
  vtkUnstructuredGrid* grid = nullptr;
  unsigned int flatIndex = 0;
  std::string name; ///< for messages: its number, and its name where it has one
};

/// The leaves with cells, in VTK's order. Throws InvalidData where a leaf with cells is no
/// vtkUnstructuredGrid, naming it.
PIXELEXACTDATAMODEL_EXPORT std::vector<CompositePart> PartsOf(vtkCompositeDataSet* data);
} // namespace pixelexact
#endif
