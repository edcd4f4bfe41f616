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
/// CellData, int64, of a grid that is a part of another: the numbers that its cells have there.
inline constexpr const char* kSourceCells = "PixelExactSourceCell";

/// The three-dimensional cells of a grid or, where it has none, the two-dimensional ones, in the
/// grid's order, with basis and points. Keeps the grid's points and connectivity, not the grid;
/// safe to read from several threads.
class SourceMesh
{
public:
  /// Throws Unsupported or InvalidData, naming the cell, for cells without a basis, weights
  /// that are not positive or differ too much, points that are not there,
  /// coordinates that are NaN or infinite, plane cells in no plane z = const; InvalidData for a
  /// grid without any such cell.
  explicit SourceMesh(vtkUnstructuredGrid* grid, const NodeConvention& nodes = {});

  [[nodiscard]] int Elements() const { return static_cast<int>(Cells.size()); }
  /// Number of the element's cell in the grid.
  [[nodiscard]] vtkIdType Cell(int element) const { return Cells[element]; }
  /// What users are shown as its number: that in the grid of which this is a part (kSourceCells).
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
  /// Of plane cells: the slab that they become.
  [[nodiscard]] const std::optional<Slab>& GetSlab() const { return Plane; }
  /// Cells of lower dimension, empty and hidden ones.
  [[nodiscard]] vtkIdType SkippedCells() const { return Skipped; }
  /// "cell 12 (vtkLagrangeWedge)"
  [[nodiscard]] std::string Describe(int element) const;

  /// Half the distance of 1 to the next number of the type of the grid's coordinates.
  [[nodiscard]] double CoordinateRoundoff() const { return Roundoff; }
  /// x, y, z per point of the grid.
  [[nodiscard]] std::span<const double> Coordinates() const { return Xyz; }

  /// What the element's map loses because polynomials stand for rational functions
  /// (bases-and-kernels.md), in world units; 0 for all other cells.
  [[nodiscard]] double Loss(int element) const { return Rationals.Loss(element); }
  /// The same of a component of values, in their units.
  [[nodiscard]] double Loss(
    int element, std::span<const double> values, int components, int component) const
  {
    return Rationals.Loss(element, values, components, component);
  }
  /// How many elements are rational.
  [[nodiscard]] int RationalElements() const { return Rationals.Count(); }

  /// Component `component` of `values`, `components` per point, at the element's points; for
  /// rational elements at the nodes of their basis.
  void Gather(int element, std::span<const double> values, int components, int component,
    std::vector<double>& out) const;
  /// The first `wanted` components, one after the other.
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
  double Roundoff = 0.0;
  std::optional<Slab> Plane;
  vtkSmartPointer<vtkDoubleArray> Points3;
  std::span<const double> Xyz;
};

/// The array itself where it holds contiguous doubles, else a copy that does.
vtkSmartPointer<vtkDoubleArray> AsDoubles(vtkDataArray* array);
} // namespace pixelexact
#endif
