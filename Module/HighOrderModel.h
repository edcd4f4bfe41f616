// SPDX-License-Identifier: BSD-3-Clause
#ifndef HighOrderModel_h
#define HighOrderModel_h

#include "PixelExactDataModelModule.h"

#include "Core/Element/Mesh.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>

class vtkUnstructuredGrid;

namespace pixelexact
{
class Locator;

/// The mesh and the fields that a vtkUnstructuredGrid carries in its arrays (HighOrderArrays.h),
/// checked, as views that the numerics work on. Element numbers of the model are the grid's cell
/// numbers. It keeps the arrays alive, not the grid, and may be shared between threads.
class PIXELEXACTDATAMODEL_EXPORT HighOrderModel
{
public:
  /// The model of `grid` as it is now; the same one again while somebody holds it and the grid is
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

  ~HighOrderModel();
  HighOrderModel(const HighOrderModel&) = delete;
  HighOrderModel& operator=(const HighOrderModel&) = delete;

  [[nodiscard]] const Mesh& GetMesh() const;
  [[nodiscard]] std::span<const Field> Fields() const;
  /// Null where there is no field of that name.
  [[nodiscard]] const Field* FindField(const std::string& name) const;

  /// Built, in parallel, by the first call of all models that share it.
  [[nodiscard]] const Locator& GetLocator() const;
  [[nodiscard]] bool HasLocator() const;

  /// Per element the number of its cell in the source file: what users are shown as `element`.
  [[nodiscard]] std::span<const std::int64_t> SourceCells() const;

  /// Whether this is the model of `grid` as it is now: same object, unmodified.
  [[nodiscard]] bool IsCurrent(vtkUnstructuredGrid* grid) const;

private:
  struct Internals;
  explicit HighOrderModel(vtkUnstructuredGrid* grid);

  std::unique_ptr<Internals> Data;
};
} // namespace pixelexact
#endif
