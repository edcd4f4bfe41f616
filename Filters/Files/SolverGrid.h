// SPDX-License-Identifier: BSD-3-Clause
#ifndef SolverGrid_h
#define SolverGrid_h

#include "Formats/SolverModel.h"

class vtkUnstructuredGrid;

// From what a solver's files hold to a grid that carries it. Beside the coefficients the grid has
// VTK's linear cells between the elements' vertices, for what VTK draws and selects by itself:
//
//   CellData   Attribute           int32      the file's number for the element's group
//              BoundaryAttribute   int32 x 6  per face of the cell as VTK numbers them, the first
//                                             of its attributes, -1 where it has none; models read
//                                             PixelExact.Mesh.Boundary.* (HighOrderArrays.h)
//              PixelExactLinearizedOrder  uint8, see ConversionLoss.h
//   FieldData  PixelExact.Groups.Id, .Boundary, .Name   the file's groups
//              PixelExact.Field.<name>.Basis            the source basis, for people
//              <parameter>                              a number of the run, for expressions
//   PointData  <field>, at the vertices, where the field is continuous by construction
//   CellData   <field>, at the element's centre (eta = 0), otherwise

namespace pixelexact
{
/// Makes `grid` a grid of the mesh, without fields. Coefficients are handed on, not copied.
void StoreSolverMesh(SolverMesh&& mesh, vtkUnstructuredGrid* grid);

/// Adds a run's numbers to the FieldData, where no array has the name.
void StoreParameters(const std::map<std::string, double>& parameters, vtkUnstructuredGrid* grid);

/// Adds a field. Throws InvalidData where the grid has one of that name.
void StoreSolverField(SolverField&& field, vtkUnstructuredGrid* grid);

/// Adds the names of groups alone, without attributes.
void AddGroupNames(const std::vector<Group>& groups, vtkUnstructuredGrid* grid);
} // namespace pixelexact
#endif
