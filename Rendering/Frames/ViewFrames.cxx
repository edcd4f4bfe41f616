// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/ViewFrames.h"

#include "Frames/ContourLabels.h"
#include "Frames/GhostPixels.h"
#include "HighOrderModel.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace pixelexact
{
namespace
{
/// 0 for cameras with one eye.
int EyeOf(vtkCamera* camera)
{
  return !camera->GetStereo() ? 0 : camera->GetLeftEye() ? 1 : 2;
}
} // namespace

ViewFrame::ViewFrame(RenderCounters& counters)
  : frames(counters, &DrawLabelsOf)
{
}

void ViewFrame::DropFrame()
{
  frames.DropFrame();
  model.reset();
}

bool ViewFrame::MayBeCoarse(vtkCamera* camera)
{
  if (camera == Latest)
  {
    Usual = camera;
  }
  Latest = camera;
  return camera == Usual;
}

namespace
{
/// Removes the depths of transparent pixels, which hide nothing.
void HideClear(const std::vector<std::uint8_t>& rgba, std::vector<float>& depths)
{
  for (std::size_t i = 0; i < depths.size(); ++i)
  {
    depths[i] = rgba[4 * i + 3] == 0 ? kNoDepth : depths[i];
  }
}
} // namespace

void ViewFrame::MakeDrawn(const DepthRows& rows)
{
  const bool moved = DrawnTrace != frames.TraceVersion() || Rows != rows;
  if (!moved && drawnVersion == frames.Version())
  {
    return;
  }
  const Frame& frame = *frames.LastFrame();
  const std::vector<Layer>& layers = frames.LastView().scene.layers;
  const bool anyTranslucent = HasTranslucent(frames.LastView().scene);
  const bool linesAlone = frames.LastView().appearance.contours.only.has_value();
  depthsVersion += moved || anyTranslucent || linesAlone || LinesAlone ? 1 : 0;
  Rows = rows;
  DrawnTrace = frames.TraceVersion();
  drawnVersion = frames.Version();
  opaque.rgba.clear();
  if (!anyTranslucent)
  {
    seenThrough.clear();
    if (moved || linesAlone || LinesAlone)
    {
      LinesAlone = linesAlone;
      WindowDepth(frame.centres, rows, opaque.depths);
      if (linesAlone)
      {
        HideClear(frame.Image(), opaque.depths);
      }
      if (hasGhosts)
      {
        HideGhosts(frame.centres, *model, opaque.depths);
      }
    }
    return;
  }
  // Each ray ends at its first opaque layer, so at most one of its samples is opaque.
  const std::size_t pixels = frame.centres.Size();
  opaque.rgba.assign(4 * pixels, 0);
  opaque.depths.assign(pixels, kNoDepth);
  seenThrough.resize(1 + frame.centres.behind.size());
  for (std::size_t k = 0; k < seenThrough.size(); ++k)
  {
    const SampleBuffers& sheet = k == 0 ? frame.centres : frame.centres.behind[k - 1];
    Drawn& drawn = seenThrough[k];
    drawn.rgba = sheet.color;
    WindowDepth(sheet, rows, drawn.depths);
    if (hasGhosts)
    {
      HideGhosts(sheet, *model, drawn.depths);
    }
    for (std::size_t i = 0; i < pixels; ++i)
    {
      const std::uint8_t layer = layers.size() > 1 ? sheet.layer[i] : std::uint8_t{ 0 };
      if (layer != kNoLayer && !layers[layer].translucent && drawn.depths[i] <= 1.0F)
      {
        std::copy_n(&drawn.rgba[4 * i], 4, &opaque.rgba[4 * i]);
        opaque.depths[i] = drawn.depths[i];
        drawn.depths[i] = kNoDepth;
      }
    }
  }
}

ViewFrame& ViewFrames::Of(vtkRenderer* renderer, vtkActor* actor)
{
  std::erase_if(Views, [](const View& view) { return !view.renderer || !view.actor; });
  const int eye = EyeOf(renderer->GetActiveCamera());
  const auto found = std::ranges::find_if(Views,
    [&](const View& view)
    { return view.renderer == renderer && view.actor == actor && view.eye == eye; });
  if (found != Views.end())
  {
    Views.splice(Views.begin(), Views, found);
  }
  else
  {
    if (Views.size() == kMax)
    {
      Views.pop_back();
    }
    Views.push_front({ renderer, actor, eye, std::make_unique<ViewFrame>(counters_) });
  }
  return *Views.front().frame;
}

std::vector<std::string> ViewFrames::Complain(ViewFrame& view, std::vector<std::string> complaints)
{
  std::vector<std::string> fresh;
  std::ranges::copy_if(complaints, std::back_inserter(fresh),
    [&](const std::string& text)
    {
      return std::ranges::none_of(Views,
        [&](const View& each) {
          return std::ranges::find(each.frame->complaints, text) != each.frame->complaints.end();
        });
    });
  view.complaints = std::move(complaints);
  return fresh;
}

void ViewFrames::DropOthers(const HighOrderModel* model)
{
  for (View& view : Views)
  {
    if (view.frame->model.get() != model)
    {
      view.frame->DropFrame();
    }
  }
}

void ViewFrames::ReleaseGraphicsResources(vtkWindow* window)
{
  for (View& view : Views)
  {
    view.frame->compositor.ReleaseGraphicsResources(window);
    view.frame->selection.ReleaseGraphicsResources(window);
  }
}
} // namespace pixelexact
