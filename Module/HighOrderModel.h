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

/// CellData, uint8, where a grid is a part of a mesh: a bit for each face, as in FacesOf(shape),
/// that has something behind it in the whole.
inline constexpr const char* kInnerFaces = "PixelExactInnerFaces";

/// CellData, where hardware selection is to tell other numbers than the source's cells: those of
/// the data that somebody else made the grid of.
inline constexpr const char* kSelectedCells = "PixelExactSelectedCells";

/// The mesh and the fields that a vtkUnstructuredGrid carries in its arrays (HighOrderArrays.h),
/// checked, as views that the numerics work on. Element numbers of the model are the grid's cell
/// numbers, those of composite data count on from leaf to leaf. It keeps the arrays alive, not the
/// grid, and may be shared between threads.
class PIXELEXACTDATAMODEL_EXPORT HighOrderModel
{
public:
  /// The model of `grid` as it is now, of packed coefficients too (PackedArrays.h), which are then
  /// copied; the same one again while somebody holds it and the grid is
  /// unchanged. Another grid or state whose mesh arrays (PixelExact.Mesh.*, PixelExactElementId)
  /// are the same objects, unmodified, has a model of its own but shares mesh and locator, while
  /// somebody holds a model with them: hold the old one while asking for that of the next time
  /// step.
  ///
  /// Cells may have been dropped, whole, since the coefficients were made (Threshold,
  /// ExtractCells); the coefficients are not copied. Anything else that was done to the cells,
  /// their points or the nodal values of a field throws StaleData. InvalidData: arrays that are
  /// missing, of wrong type or size, or contradict each other.
  static std::shared_ptr<HighOrderModel> From(vtkUnstructuredGrid* grid);

  /// The same of a grid or of composite data whose leaves with cells are such grids: their elements
  /// one after the other, as copies, with the fields that all leaves have alike (components,
  /// mapping). Mesh and locator are shared as above, leaf by leaf. InvalidData, naming the leaf:
  /// also where it is no grid, or where leaves have fields and none in common.
  static std::shared_ptr<HighOrderModel> From(vtkDataObject* data);

  ~HighOrderModel();
  HighOrderModel(const HighOrderModel&) = delete;
  HighOrderModel& operator=(const HighOrderModel&) = delete;

  [[nodiscard]] const Mesh& GetMesh() const;
  /// Those that are polynomials; what expressions make of them is not among them.
  [[nodiscard]] std::span<const Field> Fields() const;
  /// The field of that name, else what the name is defined as (kDefinitionPrefix), else the
  /// expression that the text is (MakeExpression); with the grid's time, and FieldData of a single
  /// number as parameters. Made once, and kept as long as the model. Throws InvalidData, naming
  /// what there is, and Unsupported.
  [[nodiscard]] const Field& GetField(const std::string& text) const;
  /// The texts of expressions that count as fields (kDefinitionPrefix), by their names.
  [[nodiscard]] const std::map<std::string, std::string>& Definitions() const;
  /// Numbers that expressions may name: arrays of FieldData that hold one.
  [[nodiscard]] const std::map<std::string, double>& Parameters() const;
  /// As GetField, but null where there is none.
  [[nodiscard]] const Field* FindField(const std::string& text) const;

  /// Built, in parallel, by the first call of all models that share it.
  [[nodiscard]] const Locator& GetLocator() const;
  [[nodiscard]] bool HasLocator() const;
  /// What lies behind each element's faces; made, in parallel, by the first call of all models that
  /// share the mesh. Builds the locator too.
  [[nodiscard]] const FaceTable& Faces() const;
  [[nodiscard]] bool HasFaces() const;

  /// The faces to which the source gives attributes, in ascending order; none of `.vtu` files that
  /// are not saved from a solver's. Which of a mesh's faces are its boundary, Faces() tells.
  [[nodiscard]] std::span<const AttributedFace> BoundaryFaces() const;

  /// A leaf of composite data.
  struct Block
  {
    std::int64_t flatIndex = 0; ///< in the composite data
    std::int64_t begin = 0;     ///< its first element; they end at the next block's
  };
  /// In the order of elements; none where the model is of one grid.
  [[nodiscard]] std::span<const Block> Blocks() const;
  /// That of an element; there must be some.
  [[nodiscard]] static const Block& BlockOf(std::int64_t element, std::span<const Block> blocks);

  /// Per element the number of its cell in the source file, of its block: what users are shown as
  /// `element`.
  [[nodiscard]] std::span<const std::int64_t> SourceCells() const;

  /// Per element what hardware selection tells: CellData kSelectedCells, else its source cell.
  [[nodiscard]] std::span<const std::int64_t> SelectedCells() const;

  /// Whether an element is a copy of one that another process or block holds (VTK's ghost cells,
  /// marked as duplicates). Its field is as good as any; faces of boundaries are the other's.
  [[nodiscard]] bool IsGhost(int element) const;

  /// Whether the grid says that something is behind a face, in a part of the mesh that it does not
  /// hold: bit `face` of CellData kInnerFaces.
  [[nodiscard]] bool IsInner(int element, int face) const;

  /// Whether this is the model of `data` as it is now: same object, unmodified, leaves too.
  [[nodiscard]] bool IsCurrent(vtkDataObject* data) const;

private:
  struct Internals;
  explicit HighOrderModel(vtkUnstructuredGrid* given);
  explicit HighOrderModel(vtkCompositeDataSet* data);
  static std::shared_ptr<HighOrderModel> Known(vtkDataObject* data);
  /// The one that is known, else a new one.
  template <class Source>
  static std::shared_ptr<HighOrderModel> Shared(vtkDataObject* key, Source* source);

  /// For messages.
  [[nodiscard]] std::string NamesOfFields() const;

  std::unique_ptr<Internals> Data;
};
} // namespace pixelexact
#endif
