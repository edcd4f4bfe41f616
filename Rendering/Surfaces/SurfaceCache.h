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

/// What a user cuts with: one of the two, or nothing.
struct CutSource
{
  vtkImplicitFunction* function = nullptr;
  vtkHighOrderSurface* surface = nullptr;

  [[nodiscard]] vtkObject* Object() const;
};

/// The cut-surfaces of one mapper, shared by all of its views: each is made once for a state of
/// what it is made of, of the model and of the search, and is the same object until one of these
/// changes.
class SurfaceCache
{
public:
  /// `samples`: see SearchedSurface. Throws Error where there is nothing to cut with, and as
  /// ToSurface and vtkHighOrderSurface::MakeSurface, after which there is none.
  std::shared_ptr<const Surface> Of(
    const CutSource& source, const std::shared_ptr<HighOrderModel>& model, int samples);

  /// Forgets what is of other sources.
  void KeepOnly(std::span<const CutSource> sources);
  /// Forgets what is of other models; null: of any.
  void DropOthers(const std::shared_ptr<HighOrderModel>& model);

  /// How many were made.
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

  std::weak_ptr<const HighOrderModel> Model; ///< of all entries that are of one
  std::vector<Entry> Entries;
  std::int64_t Count = 0;
};
} // namespace pixelexact
