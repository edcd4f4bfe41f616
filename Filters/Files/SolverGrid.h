// SPDX-License-Identifier: BSD-3-Clause
#ifndef SolverGrid_h
#define SolverGrid_h

#include "Files/SolverCells.h"
#include "Formats/SolverModel.h"

#include <functional>

class vtkUnstructuredGrid;

// Converts a solver's model to a grid. In addition to the coefficients, the grid has VTK's cells of
// a CellLayout, for VTK's own filters and windows:
//
//   CellData   Attribute           int32      the file's number for the element's group
//              BoundaryAttribute   int32 x 6  per face of the cell as VTK numbers them, the first
//                                             of its attributes, -1 where it has none; models read
//                                             PixelExact.Mesh.Boundary.* (HighOrderArrays.h)
//              PixelExactLinearizedOrder  uint8, see ConversionLoss.h
//              HigherOrderDegrees  double x 3 where degrees of a cell differ
//   FieldData  PixelExact.Groups.Id, .Boundary, .Name   the file's groups
//              PixelExact.Field.<name>.Basis            the source basis, for people
//              <parameter>                              a number of the run, for expressions
//   PointData  <field>, at the cells' points, where the field is continuous by construction or
//              elements have points of their own
//   CellData   <field>, at the element's centre (eta = 0), otherwise

namespace pixelexact
{
/// Chooses the cells of a mesh.
using LayoutRule = std::function<CellLayout(const Mesh& mesh)>;

/// Makes `grid` a grid of the mesh, without fields, and returns the layout that `rule` chose.
/// Coefficients are moved, not copied.
CellLayout StoreSolverMesh(SolverMesh&& mesh, const LayoutRule& rule, vtkUnstructuredGrid* grid);

/// Adds a run's numbers to the FieldData, where no array has the name.
void StoreParameters(const std::map<std::string, double>& parameters, vtkUnstructuredGrid* grid);

/// Adds a field to a grid of this layout. Throws InvalidData where the grid has one of that name.
void StoreSolverField(SolverField&& field, const CellLayout& layout, vtkUnstructuredGrid* grid);

/// Adds the names of groups alone, without attributes.
void AddGroupNames(const std::vector<Group>& groups, vtkUnstructuredGrid* grid);
} // namespace pixelexact
#endif
