// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Surface.h"

#include "vtkWeakPointer.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

class vtkHighOrderSurface;
class vtkImplicitFunction;
class vtkObject;

namespace pixelexact
{
class HighOrderModel;

/// The source of a cut-surface: a function, a surface object, or none.
struct CutSource
{
  vtkImplicitFunction* function = nullptr;
  vtkHighOrderSurface* surface = nullptr;

  [[nodiscard]] vtkObject* Object() const;
};

/// The cut-surfaces of one mapper, shared by all of its views. A surface is constructed once for
/// each state of its source, the model and the search, and remains the same object until one of
/// these changes.
class SurfaceCache
{
public:
  /// `samples`: see SearchedSurface. Throws Error without a source, and as ToSurface and
  /// vtkHighOrderSurface::MakeSurface do; then no surface is kept.
  std::shared_ptr<const Surface> Of(
    const CutSource& source, const std::shared_ptr<HighOrderModel>& model, int samples);

  /// Discards the surfaces of all other sources.
  void KeepOnly(std::span<const CutSource> sources);
  /// Discards the surfaces of all other models; null: of any model.
  void DropOthers(const std::shared_ptr<HighOrderModel>& model);

  /// Count of constructed surfaces.
  [[nodiscard]] std::int64_t Builds() const { return Count; }

private:
  struct Entry
  {
    vtkWeakPointer<vtkObject> source;
    std::uint64_t state = 0; ///< modification time, which is unique; the source's address is not
    int samples = 0;
    bool ofModel = true;
    std::shared_ptr<const Surface> surface;
  };

  std::weak_ptr<const HighOrderModel> Model; ///< of all entries that depend on a model
  std::vector<Entry> Entries;
  std::int64_t Count = 0;
};
} // namespace pixelexact
