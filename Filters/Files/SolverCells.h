// SPDX-License-Identifier: BSD-3-Clause
#ifndef SolverCells_h
#define SolverCells_h

#include "Cells/CellNodes.h"
#include "Formats/SolverModel.h"

#include <cstdint>
#include <vector>

class vtkUnstructuredGrid;

// VTK's cells of a solver's grid: their nodes, the nodes' positions, and the fields' values there.
namespace pixelexact
{
struct Expansion;
struct Field;
struct Mesh;

/// The cell of each element.
struct CellLayout
{
  std::vector<CellDegrees> degrees; ///< per element
  /// Whether neighbouring elements share points. Otherwise each has its own, so that values may
  /// jump.
  bool sharesPoints = true;

  /// Points of all cells, counted per cell.
  [[nodiscard]] std::int64_t NodeCount(const Mesh& mesh) const;
};

/// Linear cells between the elements' vertices.
[[nodiscard]] CellLayout CornerLayout(const Mesh& mesh);

/// Lagrange cells that represent the map and the fields: per direction the largest degree of these,
/// at most kMaxCellDegree. Pyramids become linear cells, because VTK has no Lagrange pyramids.
/// Elements share points if all fields of degree 1 or more are continuous.
[[nodiscard]] CellLayout NodeLayout(const Mesh& mesh, const std::vector<SolverField>& fields);

/// Makes the points and cells of `grid`. `mesh` views `solver`. Nodes of one place on a common
/// vertex, edge or face are one point where the layout shares points.
void MakeCells(const SolverMesh& solver, const Mesh& mesh, const CellLayout& layout,
  const ElementCells& cells, vtkUnstructuredGrid* grid);

/// Whether a field has degree 0 in all elements, so that a value per cell is all of it.
[[nodiscard]] bool IsConstantPerElement(const Expansion& values);

/// Adds the field's values at the points of the cells as point data. Where elements share points
/// they agree up to rounding; the last one's value is kept.
void AddNodeValues(
  const Mesh& mesh, const Field& field, const ElementCells& cells, vtkUnstructuredGrid* grid);
} // namespace pixelexact
#endif
