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
/// What of a frame is drawn: what hides all behind it, what is seen through, or both.
enum class FramePart
{
  Opaque,
  Translucent,
  All
};

/// Frames into renderers, for one mapper. Keeps the model of its grid, its cut-surfaces and a frame
/// for each view.
class FrameDrawer
{
public:
  /// The model of a vtkUnstructuredGrid, or of composite data of such, as it is now. Throws Error.
  const std::shared_ptr<HighOrderModel>& ModelOf(vtkDataObject* grid);

  /// The cut-surfaces, for views of that model.
  SurfaceCache& Surfaces() { return surfaces_; }

  /// Draws a part of a view of the model, seen through the renderer's camera and placed by the
  /// actor. This completes the view: viewport, camera and lights from the renderer, matrix from the
  /// actor, clipping planes and depth offset from the mapper. The actor's opacity is applied. A
  /// camera that the actor is seen through for the first time gets a complete frame, whatever the
  /// time limit. Throws Error, after which there is no frame.
  void Draw(View view, RenderWork work, FramePart part, vtkRenderer* renderer, vtkActor* actor,
    vtkMapper* mapper, const Progress& progress);

  /// Draws what the present pass of the renderer's selector wants of the pixels that Draw shows
  /// (SelectionImage.h), complete in any case. Throws as Draw.
  void Select(View view, RenderWork work, vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper,
    const Progress& progress);

  /// The ranges of the model's fields.
  [[nodiscard]] const std::shared_ptr<FieldRanges>& Ranges() const { return ranges_; }

  /// There is nothing to be seen in this view.
  void DropFrame(vtkRenderer* renderer, vtkActor* actor);

  /// What is new of this (ViewFrames::Complain).
  std::vector<std::string> Complain(
    vtkRenderer* renderer, vtkActor* actor, std::vector<std::string> complaints)
  {
    return Views.Complain(Views.Of(renderer, actor), std::move(complaints));
  }

  void ReleaseGraphicsResources(vtkWindow* window) { Views.ReleaseGraphicsResources(window); }

  /// Of the view that was drawn last; null before the first one.
  [[nodiscard]] Renderer* LastRenderer() { return Views.Last(); }
  /// The model that it shows; null before the first one.
  [[nodiscard]] const HighOrderModel* LastModel() const { return Views.LastModel(); }
  /// The model of the last call of ModelOf.
  [[nodiscard]] const std::shared_ptr<HighOrderModel>& LatestModel() const { return Model.Last(); }
  [[nodiscard]] std::int64_t ModelBuilds() const { return Model.Builds(); }
  [[nodiscard]] const RenderCounters& Counters() const { return Views.Counters(); }

private:
  ViewFrame& Begin(
    View& view, RenderWork& work, vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper);

  GridModel Model;
  bool HasGhosts = false; ///< the model
  SurfaceCache surfaces_;
  std::shared_ptr<FieldRanges> ranges_ = std::make_shared<FieldRanges>(); ///< of the model
  ViewFrames Views;
};
} // namespace pixelexact
