// SPDX-License-Identifier: BSD-3-Clause
#ifndef HighOrderArrays_h
#define HighOrderArrays_h

#include "PixelExactDataModelModule.h"

#include "Core/Element/OwnedExpansion.h"
#include "Core/Faces/AttributedFace.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSet;
class vtkUnstructuredGrid;

// Stores a mesh and its fields in the arrays of a vtkUnstructuredGrid.
//
// FieldData, E elements (arrays marked * have a fixed size of their own):
//   PixelExact.Mesh.Spaces*       uint8 x 5   distinct spaces: shape, form, three orders
//   PixelExact.Mesh.Space         int32       per element: which of them
//   PixelExact.Mesh.Offset        int64       per element: its first coefficient
//   PixelExact.Mesh.Coefficients* double      component by component, as in Expansion
//   PixelExact.Mesh.Centre        double x 3
//   PixelExact.Mesh.Size          double
//   PixelExact.Mesh.Uncertainty   double
//   PixelExact.Mesh.SourceCell    int64       per element: number of its cell in the source
//   PixelExact.Mesh.Fingerprint   int64       per element: hash of the cell it was made with
//   PixelExact.Mesh.Origin*       uint8       see Origin
// for meshes of triangles and quadrilaterals (Formats/Slab.h):
//   PixelExact.Mesh.Slab*         double      in a plane: middle and thickness; in space: thickness
// where the source gives faces attributes, an entry for each face and attribute:
//   PixelExact.Mesh.Boundary.Element*   int64
//   PixelExact.Mesh.Boundary.Face*      int32   as in FacesOf(shape)
//   PixelExact.Mesh.Boundary.Attribute* int32
// and the same for each field under PixelExact.Field.<name>: Spaces, Space, Offset, Coefficients,
// Origin, Components* (int32); Fingerprint only where an array of that name holds values of the
// field (it is not Origin::Coefficients); Mapping* (uint8, see Mapping in Core/Element/Mesh.h) only
// where it is not Identity. CellData:
// PixelExactElementId, int64: the element of each cell.
//
// FieldData, a string: PixelExact.Definition.<name> is an expression of fields that counts as a
// field of that name (Core/Expression/Expression.h).
//
// FieldData survives what VTK does to a data set, even when cells are dropped or points are moved;
// HighOrderModel compares the fingerprints and refuses coefficients that no longer fit.
namespace pixelexact
{
inline constexpr const char* kMeshPrefix = "PixelExact.Mesh.";
inline constexpr const char* kSlab = "PixelExact.Mesh.Slab";
inline constexpr const char* kBoundaryPrefix = "PixelExact.Mesh.Boundary.";
inline constexpr const char* kFieldPrefix = "PixelExact.Field.";
inline constexpr const char* kDefinitionPrefix = "PixelExact.Definition.";
inline constexpr const char* kElementIds = "PixelExactElementId";

/// The source of coefficients.
enum class Origin : std::uint8_t
{
  Coefficients = 0, ///< a solver's own file; no array of the grid shows the field
  PointData = 1,    ///< nodal values at the cells' points
  CellData = 2,     ///< one value per cell
  SolverPoints = 3, ///< a solver's own file; point data show the field at the cells' points
  SolverCells = 4   ///< a solver's own file; cell data show the field at the elements' centres
};

constexpr bool IsSolvers(Origin origin)
{
  return origin != Origin::PointData && origin != Origin::CellData;
}

/// Whether point data of the field's name hold values of the field.
constexpr bool IsAtPoints(Origin origin)
{
  return origin == Origin::PointData || origin == Origin::SolverPoints;
}

// Arguments of StoreMesh and StoreField. The grid takes over the coefficients.

struct FieldExpansion
{
  OwnedExpansion values;
  Mapping mapping = Mapping::Identity;
};

struct MeshArrays
{
  OwnedExpansion map;
  std::vector<double> centre; ///< 3 per element
  std::vector<double> size;
  std::vector<double> uncertainty;
  std::vector<std::int64_t> sourceCell;
  std::vector<AttributedFace> boundary; ///< in any order
};

/// Whether the grid carries the arrays of a mesh, in FieldData or packed (PackedArrays.h). Does not
/// check whether they fit the cells.
PIXELEXACTDATAMODEL_EXPORT bool HasHighOrderArrays(vtkUnstructuredGrid* grid);

/// Whether the stored mesh is a surface in space.
PIXELEXACTDATAMODEL_EXPORT bool IsShell(vtkUnstructuredGrid* grid);

/// Removes all arrays that PixelExact added to FieldData and CellData, also packed ones.
PIXELEXACTDATAMODEL_EXPORT void RemoveHighOrderArrays(vtkUnstructuredGrid* grid);

/// Adds a mesh whose element e is the grid's cell e, and fingerprints the cells as they are now.
/// Throws InvalidData where the number of elements is not the number of cells.
PIXELEXACTDATAMODEL_EXPORT void StoreMesh(
  vtkUnstructuredGrid* grid, MeshArrays mesh, Origin origin);

/// The same with the stored fingerprints of the cells that the mesh was computed from.
PIXELEXACTDATAMODEL_EXPORT void StoreMesh(vtkUnstructuredGrid* grid, MeshArrays mesh, Origin origin,
  std::span<const std::int64_t> fingerprints);

/// Whether the stored mesh was computed from the grid's present cells, where element e is cell e.
/// Compares the fingerprints.
PIXELEXACTDATAMODEL_EXPORT bool StoredMeshFits(vtkUnstructuredGrid* grid);

/// Adds or replaces a field on the mesh stored before. The array that `origin` names must be there:
/// its values are fingerprinted. Throws InvalidData where it is not.
PIXELEXACTDATAMODEL_EXPORT void StoreField(
  vtkUnstructuredGrid* grid, const std::string& name, FieldExpansion field, Origin origin);

/// The same with the stored fingerprints of the field's values.
PIXELEXACTDATAMODEL_EXPORT void StoreField(vtkUnstructuredGrid* grid, const std::string& name,
  FieldExpansion field, Origin origin, std::span<const std::int64_t> fingerprints);

/// Whether the grid has another array with a field's name in point data (`ofPoints`) or else cell
/// data: an array that a filter or the file named so and that does not hold the field's values.
PIXELEXACTDATAMODEL_EXPORT bool HasNamesake(
  vtkUnstructuredGrid* grid, const std::string& field, bool ofPoints);

/// Names of the fields whose coefficients are in FieldData, in their order there, or packed.
PIXELEXACTDATAMODEL_EXPORT std::vector<std::string> StoredFieldNames(vtkUnstructuredGrid* grid);
} // namespace pixelexact
#endif
