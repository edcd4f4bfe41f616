// SPDX-License-Identifier: BSD-3-Clause
#ifndef GridConversion_h
#define GridConversion_h

#include "Cells/CellBasis.h"

#include "vtkType.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

class vtkDataArray;
class vtkUnstructuredGrid;

namespace pixelexact
{
class KeptMesh;
class SourceMesh;
struct MeshArrays;

struct ConversionOptions
{
  std::vector<std::string> fields;      ///< names of arrays to convert; none: all (SelectFields)
  bool diagnose = true;                 ///< look for signs of a faulty file
  NodeConvention nodes;                 ///< of the grid's Lagrange cells
  bool surfaces = false;                ///< two-dimensional cells, also where there are solids
  std::function<void(double)> progress; ///< may be empty; called from the calling thread
};

struct ConversionReport
{
  vtkIdType skippedCells = 0;
  std::map<std::string, int> nonFinite; ///< per field: elements with NaN or infinite coefficients
  std::vector<std::string> diagnostics; ///< lines for the user
};

/// Makes `output` a grid of the input's three-dimensional cells or, where it has none or they are
/// chosen, its two-dimensional ones (bases-and-kernels.md), with their coefficients and those of
/// its fields, made from points and nodal values; the mesh is taken from `kept` where that has it,
/// and kept there for the next time step. Parallel. Throws Error naming the cell or array; the
/// output is then undefined.
ConversionReport ConvertGrid(vtkUnstructuredGrid* input, const ConversionOptions& options,
  KeptMesh& kept, vtkUnstructuredGrid* output);

// Steps of ConvertGrid.

/// The maps of a mesh's elements, from the points. Parallel.
MeshArrays ConvertMaps(const SourceMesh& mesh);

/// Adds the coefficients of a field at the grid's points, in the spaces of the cells; element e of
/// `mesh` is cell e of `grid`. Returns the number of elements with coefficients that are not
/// finite.
int ConvertPointField(const SourceMesh& mesh, vtkDataArray* values, vtkUnstructuredGrid* grid);
} // namespace pixelexact
#endif
