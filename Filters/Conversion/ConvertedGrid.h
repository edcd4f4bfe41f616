// SPDX-License-Identifier: BSD-3-Clause
#ifndef ConvertedGrid_h
#define ConvertedGrid_h

#include "Conversion/SourceMesh.h"
#include "Formats/Slab.h"
#include "HighOrderArrays.h"
#include "PixelExactFiltersModule.h"

#include <optional>
#include <string>
#include <vector>

class vtkDataArray;
class vtkFieldData;
class vtkUnstructuredGrid;

namespace pixelexact
{
/// Makes `output` a grid of the elements' cells alone, with all points and all data of the input
/// but without coefficients of any earlier conversion. Arrays are shared where no cell is left out.
void CopyElements(vtkUnstructuredGrid* input, const SourceMesh& mesh, vtkUnstructuredGrid* output);

/// Whether the grid carries coefficients from a solver's own file, which a conversion from nodal
/// values could only lose.
bool HasSolverCoefficients(vtkUnstructuredGrid* grid);

/// Whether the mesh itself is a solver's. Of packed grids, as HasSolverCoefficients.
bool HasSolverMesh(vtkUnstructuredGrid* grid);

/// The grid itself where element e is cell e and there are no others, else a copy of which that is
/// so. The coefficients must fit and not be packed. Throws as HighOrderModel::From.
vtkSmartPointer<vtkUnstructuredGrid> WithAllElements(vtkUnstructuredGrid* grid);

/// The origin of the expansion under a prefix, which must be there.
Origin OriginOf(vtkUnstructuredGrid* grid, const std::string& prefix);

/// Adds the arrays of a field's coefficients to another grid with the same elements.
void ShareField(vtkUnstructuredGrid* from, const std::string& name, vtkUnstructuredGrid* to);

/// The mesh arrays of the last conversion, for the next time step: readers make new points and
/// cells of the same values. With the arrays, models share the locator (HighOrderModel::From).
class KeptMesh
{
public:
  KeptMesh();
  ~KeptMesh();

  /// Adds the arrays to `grid`, whose cell e is element e of `mesh`, where a conversion would give
  /// the same: the same cells of the same points, by the fingerprints. Returns whether it did.
  bool AddTo(const SourceMesh& mesh, vtkUnstructuredGrid* grid) const;

  /// Keeps the arrays of a grid that was just converted.
  void Keep(const SourceMesh& mesh, vtkUnstructuredGrid* grid);
  void Forget();

  /// Lines about the mesh; none: not looked for. Keep and Forget drop them.
  std::optional<std::vector<std::string>> diagnostics;

private:
  std::vector<CellKind> Kinds; ///< per element
  double Roundoff = 0.0;
  vtkSmartPointer<vtkFieldData> Arrays;
  vtkSmartPointer<vtkDataArray> Ids;
  vtkMTimeType Time = 0; ///< modification time of the arrays, to detect changes
};

// Position of the slab of a plane mesh: FieldData PixelExact.Mesh.Slab (kSlab), double x 2, middle
// and thickness along z; of a surface in space one double, the thickness in units of the elements.
// Absent for meshes of solids.

/// Stores the slab. Must be called after StoreMesh, which removes old arrays.
void StoreSlab(const Slab& slab, vtkUnstructuredGrid* grid);

/// None also where the array holds what no slab has.
PIXELEXACTFILTERS_EXPORT std::optional<Slab> SlabOf(vtkUnstructuredGrid* grid);
} // namespace pixelexact
#endif
