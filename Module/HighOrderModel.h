// SPDX-License-Identifier: BSD-3-Clause
#ifndef HighOrderModel_h
#define HighOrderModel_h

#include "PixelExactDataModelModule.h"

#include "Core/Element/Mesh.h"
#include "Core/Faces/AttributedFace.h"

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

class vtkCompositeDataSet;
class vtkDataObject;
class vtkUnstructuredGrid;

namespace pixelexact
{
class FaceTable;
class Locator;

/// CellData, uint8, where a grid is a part of a mesh: bit `face`, numbered as in FacesOf(shape), is
/// set where the whole mesh has an element behind that face.
inline constexpr const char* kInnerFaces = "PixelExactInnerFaces";

/// CellData: cell numbers that hardware selection reports in place of the source's. A caller that
/// created the grid from other data stores the numbers of those data.
inline constexpr const char* kSelectedCells = "PixelExactSelectedCells";

/// The mesh and the fields that a vtkUnstructuredGrid carries in its arrays (HighOrderArrays.h),
/// checked, as views that the numerics work on. Element numbers of the model are the grid's cell
/// numbers, those of composite data count on from leaf to leaf. It keeps the arrays alive, not the
/// grid, and may be shared between threads.
class PIXELEXACTDATAMODEL_EXPORT HighOrderModel
{
public:
  /// Returns the model of `grid` in its present state. Packed coefficients (PackedArrays.h) are
  /// copied. While a caller holds the model and the grid is unchanged, the same model is returned.
  /// Another grid or state whose mesh arrays (PixelExact.Mesh.*, PixelExactElementId) are the same
  /// unmodified objects has its own model but shares mesh and locator while a caller holds a model
  /// with them: hold the old model until the next time step's is created.
  ///
  /// Cells may have been dropped, whole, since the coefficients were computed (Threshold,
  /// ExtractCells); the coefficients are not copied. Any other change of the cells, their points or
  /// the nodal values of a field throws StaleData. InvalidData: arrays that are missing, of wrong
  /// type or size, or contradict each other.
  static std::shared_ptr<HighOrderModel> From(vtkUnstructuredGrid* grid);

  /// The same for a grid or for composite data whose leaves with cells are such grids. Their
  /// elements follow each other, as copies, with the fields that all leaves share (components,
  /// mapping). Mesh and locator are shared as above, leaf by leaf. Throws InvalidData, naming the
  /// leaf, also where a leaf is no grid, or where leaves have fields but none in common.
  static std::shared_ptr<HighOrderModel> From(vtkDataObject* data);

  ~HighOrderModel();
  HighOrderModel(const HighOrderModel&) = delete;
  HighOrderModel& operator=(const HighOrderModel&) = delete;

  [[nodiscard]] const Mesh& GetMesh() const;
  /// The fields that are polynomials. Fields defined by expressions are not included.
  [[nodiscard]] std::span<const Field> Fields() const;
  /// Returns the field of that name, else the definition of that name (kDefinitionPrefix), else the
  /// expression `text` (MakeExpression), with the grid's time and FieldData of a single number as
  /// parameters. The field is created once and kept as long as the model. Throws InvalidData,
  /// naming the available fields, and Unsupported.
  [[nodiscard]] const Field& GetField(const std::string& text) const;
  /// The texts of expressions that count as fields (kDefinitionPrefix), by their names.
  [[nodiscard]] const std::map<std::string, std::string>& Definitions() const;
  /// Numbers that expressions may name: arrays of FieldData that hold one.
  [[nodiscard]] const std::map<std::string, double>& Parameters() const;
  /// The same as GetField, but returns null where there is no such field.
  [[nodiscard]] const Field* FindField(const std::string& text) const;

  /// Built, in parallel, by the first call of all models that share it.
  [[nodiscard]] const Locator& GetLocator() const;
  [[nodiscard]] bool HasLocator() const;
  /// The neighbours behind each element's faces. Computed, in parallel, by the first call of all
  /// models that share the mesh. Builds the locator as well.
  [[nodiscard]] const FaceTable& Faces() const;
  [[nodiscard]] bool HasFaces() const;

  /// The faces to which the source gives attributes, in ascending order; empty for `.vtu` files
  /// that were not saved from a solver's mesh. Faces() classifies which faces lie on the mesh's
  /// boundary.
  [[nodiscard]] std::span<const AttributedFace> BoundaryFaces() const;

  /// Whether the mesh is a surface in space: its elements are there as their faces
  /// ShellFace(shape) alone, which the boundary consists of. The solids beneath them are for the
  /// kernels.
  [[nodiscard]] bool IsShell() const;
  /// Throws Unsupported where the mesh is a surface in space: `what` needs solids.
  void RequireSolids(const std::string& what) const;

  /// A leaf of composite data.
  struct Block
  {
    std::int64_t flatIndex = 0; ///< in the composite data
    std::int64_t begin = 0;     ///< its first element; they end at the next block's
  };
  /// The leaves in the order of elements; empty where the model belongs to one grid.
  [[nodiscard]] std::span<const Block> Blocks() const;
  /// Returns the block that contains the element. `blocks` must not be empty.
  [[nodiscard]] static const Block& BlockOf(std::int64_t element, std::span<const Block> blocks);

  /// Returns for each element the number of its cell in the source file, or in its block's file.
  /// Users see it as `element`.
  [[nodiscard]] std::span<const std::int64_t> SourceCells() const;

  /// Returns for each element the number that hardware selection reports: CellData kSelectedCells,
  /// else its source cell.
  [[nodiscard]] std::span<const std::int64_t> SelectedCells() const;

  /// Whether another process or block holds the original of this element (VTK's ghost cells, marked
  /// as duplicates). Its field is valid; faces on the boundary belong to the original.
  [[nodiscard]] bool IsGhost(int element) const;

  /// Whether bit `face` of CellData kInnerFaces marks a neighbour that the whole mesh has and the
  /// grid does not.
  [[nodiscard]] bool IsInner(int element, int face) const;

  /// Whether this is the model of the present state of `data`: same object, unmodified, and so are
  /// its leaves.
  [[nodiscard]] bool IsCurrent(vtkDataObject* data) const;

private:
  struct Internals;
  explicit HighOrderModel(vtkUnstructuredGrid* given);
  explicit HighOrderModel(vtkCompositeDataSet* data);
  static std::shared_ptr<HighOrderModel> Known(vtkDataObject* data);
  /// Returns the registered model, else a new one.
  template <class Source>
  static std::shared_ptr<HighOrderModel> Shared(vtkDataObject* key, Source* source);

  /// The list of names for error messages.
  [[nodiscard]] std::string NamesOfFields() const;

  std::unique_ptr<Internals> Data;
};
} // namespace pixelexact
#endif
