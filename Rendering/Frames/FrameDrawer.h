// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Frames/ViewFrames.h"
#include "Surfaces/SurfaceCache.h"
#include "Views/GridModel.h"

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

class vtkActor;
class vtkDataObject;
class vtkMapper;
class vtkRenderer;
class vtkWindow;

namespace pixelexact
{
/// The part of a frame to draw: pixels that hide all behind them, translucent ones, or both.
enum class FramePart
{
  Opaque,
  Translucent,
  All
};

/// Draws frames into renderers, for one mapper. Keeps the model of its grid, its cut-surfaces and a
/// frame for each view.
class FrameDrawer
{
public:
  /// The current model of a vtkUnstructuredGrid, or of a composite data set of these. Throws Error.
  const std::shared_ptr<HighOrderModel>& ModelOf(vtkDataObject* grid);

  /// The cut-surfaces of that model's views.
  SurfaceCache& Surfaces() { return surfaces_; }

  /// Draws a part of a view of the model, through the renderer's camera and at the actor's place.
  /// Completes the view: viewport, camera and lights from the renderer, matrix from the actor,
  /// clipping planes and depth offset from the mapper. Applies the actor's opacity. The first frame
  /// for a camera is complete, without a time limit. Throws Error, after which there is no frame.
  void Draw(View view, RenderWork work, FramePart part, vtkRenderer* renderer, vtkActor* actor,
    vtkMapper* mapper, const Progress& progress);

  /// Draws the colours of the renderer's current selection pass (SelectionImage.h) for the pixels
  /// that Draw shows. The frame is always complete. Throws Error as Draw.
  void Select(View view, RenderWork work, vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper,
    const Progress& progress);

  /// The ranges of the model's fields.
  [[nodiscard]] const std::shared_ptr<FieldRanges>& Ranges() const { return ranges_; }

  /// Discards the frame of a view that shows nothing.
  void DropFrame(vtkRenderer* renderer, vtkActor* actor);

  /// Returns the complaints that are new (ViewFrames::Complain).
  std::vector<std::string> Complain(
    vtkRenderer* renderer, vtkActor* actor, std::vector<std::string> complaints)
  {
    return Views.Complain(Views.Of(renderer, actor), std::move(complaints));
  }

  void ReleaseGraphicsResources(vtkWindow* window) { Views.ReleaseGraphicsResources(window); }

  /// The renderer of the last drawn view; null before the first one.
  [[nodiscard]] Renderer* LastRenderer() { return Views.Last(); }
  /// The model of the last drawn view; null before the first one.
  [[nodiscard]] const HighOrderModel* LastModel() const { return Views.LastModel(); }
  /// The model of the last call of ModelOf.
  [[nodiscard]] const std::shared_ptr<HighOrderModel>& LatestModel() const { return Model.Last(); }
  [[nodiscard]] std::int64_t ModelBuilds() const { return Model.Builds(); }
  [[nodiscard]] const RenderCounters& Counters() const { return Views.Counters(); }

private:
  ViewFrame& Begin(
    View& view, RenderWork& work, vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper);

  GridModel Model;
  bool HasGhosts = false; ///< the model has elements of other processes
  SurfaceCache surfaces_;
  std::shared_ptr<FieldRanges> ranges_ = std::make_shared<FieldRanges>(); ///< of the model
  ViewFrames Views;
};
} // namespace pixelexact
