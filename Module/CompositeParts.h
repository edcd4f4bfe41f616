// SPDX-License-Identifier: BSD-3-Clause
#ifndef CompositeParts_h
#define CompositeParts_h

#include "PixelExactDataModelModule.h"

#include "vtkType.h"

#include <string>
#include <utility>
#include <vector>

class vtkCompositeDataSet;
class vtkDataObject;
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

/// An object with its modification time; for composite data also the leaves with theirs. VTK's time
/// stamps are unique in the process, so a new object at an old address has another state.
using DataState = std::vector<std::pair<const vtkDataObject*, vtkMTimeType>>;
PIXELEXACTDATAMODEL_EXPORT DataState StateOf(vtkDataObject* data);
} // namespace pixelexact
#endif
