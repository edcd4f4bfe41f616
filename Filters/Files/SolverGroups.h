// SPDX-License-Identifier: BSD-3-Clause
#ifndef SolverGroups_h
#define SolverGroups_h

#include "Core/Faces/AttributedFace.h"
#include "Formats/SolverModel.h"

class vtkUnstructuredGrid;

namespace pixelexact
{
/// The file's faces with attributes; `view` is of the same mesh.
std::vector<AttributedFace> AttributedFacesOf(const SolverMesh& mesh, const Mesh& view);

/// Adds the file's attributes and groups, for VTK's filters and for people (see SolverGrid.h).
/// `view` is of the same mesh; `grid` has its cells.
void AddGroups(const SolverMesh& mesh, const Mesh& view, vtkUnstructuredGrid* grid);
/// The names of groups alone.
void AddGroupNames(const std::vector<Group>& groups, vtkUnstructuredGrid* grid);
} // namespace pixelexact
#endif
