// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeshPart_h
#define MeshPart_h

#include "CellElements.h"
#include "Core/Faces/AttributedFace.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <utility>

class vtkAbstractArray;

namespace pixelexact
{
class FaceTable;
class Locator;

/// The mesh in a grid's arrays, with its locator. Grids that hold the same arrays of the mesh, not
/// modified since, share one: a shallow copy, another time step. It keeps the arrays alive.
class MeshPart
{
public:
  /// The part of `grid` in its present state. Returns an existing part that a caller holds if its
  /// arrays are the same. The grid's cells are compared with their fingerprints in any case. Throws
  /// as HighOrderModel::From.
  static std::shared_ptr<const MeshPart> Of(vtkUnstructuredGrid* grid);

  /// The elements of all parts, one after the other, as copies. Returns an existing object that a
  /// caller holds if the parts are the same.
  static std::shared_ptr<const MeshPart> Join(std::vector<std::shared_ptr<const MeshPart>> parts);

  ~MeshPart();
  MeshPart(const MeshPart&) = delete;
  MeshPart& operator=(const MeshPart&) = delete;

  [[nodiscard]] const Mesh& GetMesh() const { return mesh_; }
  /// Maps the grid's cells to the StoredElements() stored elements. Not for joined parts.
  [[nodiscard]] const CellElements& Cells() const { return *cells_; }
  [[nodiscard]] vtkIdType StoredElements() const { return Stored; }
  [[nodiscard]] std::span<const std::int64_t> SourceCells() const { return Sources; }
  [[nodiscard]] std::span<const AttributedFace> BoundaryFaces() const { return Boundary; }

  /// Built, in parallel, by the first call.
  [[nodiscard]] const Locator& GetLocator() const;
  [[nodiscard]] bool HasLocator() const { return LocatorMade; }
  /// Made, in parallel, by the first call.
  [[nodiscard]] const FaceTable& GetFaces() const;
  [[nodiscard]] bool HasFaces() const { return FacesMade; }

private:
  /// Arrays, kept alive so that no other can have their address, and their states.
  using Key = std::vector<std::pair<vtkSmartPointer<vtkAbstractArray>, vtkMTimeType>>;

  MeshPart(vtkUnstructuredGrid* grid, Key key);
  explicit MeshPart(std::vector<std::shared_ptr<const MeshPart>> parts);
  static Key KeyOf(vtkUnstructuredGrid* grid);
  void CompareCells(vtkUnstructuredGrid* grid) const;

  Key Arrays;                                         ///< of a grid
  std::vector<std::shared_ptr<const MeshPart>> Parts; ///< of what is joined
  ViewStorage Storage;
  Mesh mesh_;
  std::unique_ptr<CellElements> cells_;
  vtkIdType Stored = 0;
  std::span<const std::int64_t> Sources;
  std::vector<AttributedFace> Boundary;
  std::span<const std::int64_t> Fingerprints; ///< per stored element
  mutable std::once_flag LocatorOnce;
  mutable std::unique_ptr<Locator> locator_;
  mutable std::atomic<bool> LocatorMade{ false };
  mutable std::once_flag FacesOnce;
  mutable std::unique_ptr<FaceTable> faces_;
  mutable std::atomic<bool> FacesMade{ false };
};
} // namespace pixelexact
#endif
