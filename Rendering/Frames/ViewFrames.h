// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Frames/FrameCompositor.h"
#include "Trace/Renderer.h"

#include "vtkWeakPointer.h"

#include <cstdint>
#include <deque>
#include <list>
#include <memory>
#include <string>
#include <vector>

class vtkActor;
class vtkCamera;
class vtkRenderer;
class vtkWindow;

namespace pixelexact
{
class HighOrderModel;

/// The frame of one view, and what of it is drawn.
struct ViewFrame
{
  explicit ViewFrame(RenderCounters& counters);

  /// Forgets model and frame.
  void DropFrame();

  /// The pixels of one or more sheets, ready to be drawn.
  struct Drawn
  {
    std::vector<std::uint8_t> rgba;
    std::vector<float> depths;
  };
  /// Makes what is drawn of the source's last frame, if that is not what is there.
  void MakeDrawn(const DepthRows& rows);

  Renderer frames;
  std::shared_ptr<HighOrderModel> model; ///< of the last frame
  bool hasGhosts = false;                ///< its model, which are not drawn
  FrameCompositor compositor;
  FrameCompositor selection;      ///< keeps the textures of selectors' passes
  std::int64_t selected = 0;      ///< passes drawn
  Drawn opaque;                   ///< rgba empty: the frame's own
  std::deque<Drawn> seenThrough;  ///< nearest first
  std::int64_t drawnVersion = -1; ///< of the source, that these were made of
  std::int64_t depthsVersion = 0;
  /// Whether a frame through this camera may be coarse: it was not lent for this one alone, as
  /// whoever saves a window's picture (vtkWindowToImageFilter) lends cameras to its renderers.
  bool MayBeCoarse(vtkCamera* camera);
  std::vector<std::string> complaints; ///< of the last picture

private:
  vtkWeakPointer<vtkCamera> Usual;
  vtkWeakPointer<vtkCamera> Latest; ///< seen through once; null once it is gone
  DepthRows Rows;
  std::int64_t DrawnTrace = -1;
  bool LinesAlone = false; ///< the depths are those of contours alone
};

/// The frames of a mapper: one for each renderer, actor and eye that it is drawn for, so that none
/// of them is traced anew because of the others. They go with their renderer and actor, and beyond
/// kMax the one that was not drawn for longest.
class ViewFrames
{
public:
  static constexpr std::size_t kMax = 16;

  /// The view that the renderer's camera, which draws one eye at a time, has of the actor now.
  ViewFrame& Of(vtkRenderer* renderer, vtkActor* actor);

  /// Of the view that was drawn last; null before the first one.
  [[nodiscard]] Renderer* Last() { return Views.empty() ? nullptr : &Views.front().frame->frames; }
  [[nodiscard]] const HighOrderModel* LastModel() const
  {
    return Views.empty() ? nullptr : Views.front().frame->model.get();
  }
  [[nodiscard]] const RenderCounters& Counters() const { return counters_; }

  /// Takes what there is to say of the view's picture now. Gives back what was not to be said of
  /// the picture before, nor of another view's: nobody wants to read a thing in every frame.
  std::vector<std::string> Complain(ViewFrame& view, std::vector<std::string> complaints);

  /// Those of another model than this.
  void DropOthers(const HighOrderModel* model);
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct View
  {
    vtkWeakPointer<vtkRenderer> renderer;
    vtkWeakPointer<vtkActor> actor;
    int eye = 0;
    std::unique_ptr<ViewFrame> frame;
  };

  RenderCounters counters_;
  std::list<View> Views; ///< drawn last, first
};
} // namespace pixelexact
