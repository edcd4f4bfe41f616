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

/// The frame of one view, and its drawable pixels.
struct ViewFrame
{
  explicit ViewFrame(RenderCounters& counters);

  /// Discards model and frame.
  void DropFrame();

  /// The pixels of one or more sheets, ready to be drawn.
  struct Drawn
  {
    std::vector<std::uint8_t> rgba;
    std::vector<float> depths;
  };
  /// Makes the drawable pixels of the renderer's last frame, unless they are current.
  void MakeDrawn(const DepthRows& rows);

  Renderer frames;
  std::shared_ptr<HighOrderModel> model; ///< of the last frame
  bool hasGhosts = false; ///< the model has elements of other processes, which are not drawn
  FrameCompositor compositor;
  FrameCompositor selection;      ///< keeps the textures of selectors' passes
  std::int64_t selected = 0;      ///< count of drawn passes
  Drawn opaque;                   ///< rgba empty: the frame's own image
  std::deque<Drawn> seenThrough;  ///< nearest first
  std::int64_t drawnVersion = -1; ///< version of the frame that these were made from
  std::int64_t depthsVersion = 0;
  /// A frame through this camera may be coarse. It may not if the camera is set for one picture
  /// only, as vtkWindowToImageFilter does when it saves a window's picture.
  bool MayBeCoarse(vtkCamera* camera);
  std::vector<std::string> complaints; ///< for the last picture

private:
  vtkWeakPointer<vtkCamera> Usual;
  vtkWeakPointer<vtkCamera> Latest; ///< used once; null after its deletion
  DepthRows Rows;
  std::int64_t DrawnTrace = -1;
  bool LinesAlone = false; ///< only contours have depths
};

/// The frames of a mapper, one for each renderer, actor and eye that it is drawn for, so that none
/// replaces another. They are removed with their renderer or actor. Above kMax, the least recently
/// drawn one is removed.
class ViewFrames
{
public:
  static constexpr std::size_t kMax = 16;

  /// The frame of the renderer's current eye and the actor.
  ViewFrame& Of(vtkRenderer* renderer, vtkActor* actor);

  /// The renderer of the last drawn view; null before the first one.
  [[nodiscard]] Renderer* Last() { return Views.empty() ? nullptr : &Views.front().frame->frames; }
  [[nodiscard]] const HighOrderModel* LastModel() const
  {
    return Views.empty() ? nullptr : Views.front().frame->model.get();
  }
  [[nodiscard]] const RenderCounters& Counters() const { return counters_; }

  /// Records the complaints about the view's current picture. Returns those that neither its
  /// previous picture nor another view has, so that each is reported once, not in every frame.
  std::vector<std::string> Complain(ViewFrame& view, std::vector<std::string> complaints);

  /// Removes the frames of all other models.
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
  std::list<View> Views; ///< most recently drawn first
};
} // namespace pixelexact
