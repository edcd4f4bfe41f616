// SPDX-License-Identifier: BSD-3-Clause
#ifndef SourceMesh_h
#define SourceMesh_h

#include "Cells/CellBasis.h"
#include "Cells/RationalCells.h"

#include "Formats/Slab.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <vector>

class vtkCellArray;
class vtkDataArray;
class vtkDoubleArray;
class vtkUnstructuredGrid;

namespace pixelexact
{
/// Name of an int64 CellData array of a grid that is part of another: the cells' numbers in the
/// whole.
inline constexpr const char* kSourceCells = "PixelExactSourceCell";

/// The three-dimensional cells of a grid or, where it has none or surfaces are chosen, the
/// two-dimensional ones, in the grid's order, with basis and points. Keeps the grid's points and
/// connectivity, not the grid. Safe to read from several threads.
class SourceMesh
{
public:
  /// Throws Unsupported or InvalidData, naming the cell, for: cells without a basis; weights that
  /// are not positive or differ too much; points that do not exist; coordinates that are NaN or
  /// infinite. Throws InvalidData for a grid without cells of two or three dimensions, and for one
  /// without cells of two dimensions where `surfaces` chooses these.
  explicit SourceMesh(
    vtkUnstructuredGrid* grid, const NodeConvention& nodes = {}, bool surfaces = false);

  [[nodiscard]] int Elements() const { return static_cast<int>(Cells.size()); }
  /// Number of the element's cell in the grid.
  [[nodiscard]] vtkIdType Cell(int element) const { return Cells[element]; }
  /// The number shown to users. In a part of a grid (kSourceCells) it is the cell's number in the
  /// whole.
  [[nodiscard]] std::int64_t Number(int element) const
  {
    return Numbers.empty() ? Cells[element] : Numbers[element];
  }
  [[nodiscard]] const CellBasis& Basis(int element) const { return *BasisOf[element]; }
  [[nodiscard]] std::span<const vtkIdType> Points(int element) const
  {
    const vtkIdType cell = Cells[element];
    return PointIds.subspan(static_cast<std::size_t>(Offsets[cell]),
      static_cast<std::size_t>(Offsets[cell + 1] - Offsets[cell]));
  }
  /// The slab of a plane mesh.
  [[nodiscard]] const std::optional<Slab>& GetSlab() const { return Plane; }
  /// The number of cells that are skipped: those of lower dimension, empty and hidden ones.
  [[nodiscard]] vtkIdType SkippedCells() const { return Skipped; }
  /// The number of two-dimensional cells among them, where the elements are solids.
  [[nodiscard]] vtkIdType SkippedSurfaces() const { return Surfaces; }
  /// "cell 12 (vtkLagrangeWedge)"
  [[nodiscard]] std::string Describe(int element) const;

  /// Unit roundoff of the type of the grid's coordinates.
  [[nodiscard]] double CoordinateRoundoff() const { return Roundoff; }
  /// x, y, z per point of the grid.
  [[nodiscard]] std::span<const double> Coordinates() const { return Xyz; }

  /// Bound of the difference between the element's polynomial and rational map
  /// (bases-and-kernels.md), in world units; 0 for all other cells.
  [[nodiscard]] double Loss(int element) const { return Rationals.Loss(element); }
  /// The same bound for one component of values, in their units.
  [[nodiscard]] double Loss(
    int element, std::span<const double> values, int components, int component) const
  {
    return Rationals.Loss(element, values, components, component);
  }
  /// How many elements are rational.
  [[nodiscard]] int RationalElements() const { return Rationals.Count(); }

  /// Writes component `component` of `values`, which has `components` per point, at the element's
  /// points to `out`; for rational elements at the nodes of their basis.
  void Gather(int element, std::span<const double> values, int components, int component,
    std::vector<double>& out) const;
  /// Writes the first `wanted` components, one after the other.
  void GatherAll(int element, std::span<const double> values, int components, int wanted,
    std::vector<double>& out) const;

private:
  void ViewConnectivity(vtkUnstructuredGrid* grid);
  void AddCell(vtkUnstructuredGrid* grid, vtkIdType cell, int type);
  void CheckCoordinates() const;
  void FindSlab();

  NodeConvention Nodes;
  std::deque<CellBasis> Bases;
  RationalCells Rationals;
  std::map<CellKind, const CellBasis*> BasisOfKind;
  std::vector<vtkIdType> Cells;
  std::vector<std::int64_t> Numbers; ///< by element; empty: those of the cells
  std::vector<const CellBasis*> BasisOf;
  vtkSmartPointer<vtkCellArray> Connectivity;
  std::span<const vtkIdType> PointIds;
  std::span<const vtkIdType> Offsets; ///< per cell of the grid, and one more
  vtkIdType Skipped = 0;
  vtkIdType Surfaces = 0; ///< of the skipped cells
  double Roundoff = 0.0;
  std::optional<Slab> Plane;
  vtkSmartPointer<vtkDoubleArray> Points3;
  std::span<const double> Xyz;
};

/// The array itself where it holds contiguous doubles, else a copy that does.
vtkSmartPointer<vtkDoubleArray> AsDoubles(vtkDataArray* array);
} // namespace pixelexact
#endif
