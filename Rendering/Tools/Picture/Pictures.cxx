// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/Pictures.h"

#include "Base/Report.h"
#include "Picture/AnimationFrames.h"
#include "Picture/DrawnShot.h"
#include "Picture/RenderOptions.h"

#include "Conversion/ConvertedGrid.h"
#include "Core/Base/Error.h"
#include "Trace/Projection.h"
#include "Trace/Surfaces/Plane.h"

#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>

namespace pixelexact
{
namespace
{
/// Number of places along a sweep that determine a view of the whole sweep.
constexpr int kPlaces = 12;

using Range = std::array<double, 2>;

std::vector<bool> LayersAlike(const Shot& shot, std::size_t layer)
{
  const std::vector<Layer>& layers = shot.scene.layers;
  std::vector<bool> alike;
  alike.reserve(layers.size());
  for (const Layer& other : layers)
  {
    alike.push_back(
      other.field == layers[layer].field && other.component == layers[layer].component);
  }
  return alike;
}

/// Visible points at places along the sweep, relative to a camera at rest.
std::vector<Vec3> SeenOfAll(const AnimationOptions& animation, const Shot& shot,
  const std::function<std::vector<Vec3>(const Shot&)>& outlined)
{
  std::vector<Vec3> points = SeenPoints(shot.scene, shot.view, shot.size);
  if (outlined)
  {
    std::ranges::copy(outlined(shot), std::back_inserter(points));
  }
  const int frames = animation.Frames().value_or(1);
  const Box3 box = BoxOf(*shot.input.model);
  const int places = animation.Sweeps() ? std::min(frames, kPlaces) : 0;
  for (int k = 0; k < places; ++k)
  {
    const int frame = static_cast<int>(std::int64_t{ k } * (frames - 1) / std::max(1, places - 1));
    Scene scene = shot.scene;
    scene.layers.front().surface = std::make_shared<Plane>(animation.PlaneAt(frame).Make(box));
    std::ranges::copy(SeenPoints(scene, shot.view, shot.size), std::back_inserter(points));
  }
  if (!animation.Turns())
  {
    return points;
  }
  const Vec3 pivot = 0.5 * (box.lower + box.upper);
  std::vector<Vec3> turned;
  for (int k = 0; k < std::min(frames, 8 * kPlaces); ++k)
  {
    const int frame = static_cast<int>(std::int64_t{ k } * frames / std::min(frames, 8 * kPlaces));
    const CameraView view = animation.ViewAt(frame, shot.view, pivot);
    const Projection from(view, shot.size.width, shot.size.height);
    for (const Vec3& point : points)
    {
      turned.push_back(from.AsSeenFrom(shot.view, point));
    }
  }
  return turned;
}
} // namespace

Pictures::Pictures(const RenderOptions& options, Stopwatch& watch)
  : Options(options)
  , Watch(watch)
  , Asked(options.OfPicture())
{
  const AnimationOptions& animation = Options.animation;
  Asked.alsoSeen = [&animation, outlined = Asked.alsoSeen](const Shot& shot)
  { return SeenOfAll(animation, shot, outlined); };
  Asked.meshChanges =
    Asked.input.allSteps || animation.Deforms() || (animation.Phases() && Asked.input.warp);
  if (animation.Deforms())
  {
    // The view is that of the mesh where it is deformed most.
    Asked.input.warp->scale = animation.LargestScale();
  }
  else
  {
    animation.Apply(0, Asked.input);
  }
  Now.emplace(Prepare(Asked, Watch));
  ++Reads;
  if (Asked.meshChanges && !Asked.surfaces.AreGiven() && !Asked.HasVolumeAlone() &&
    !SlabOf(Now->input.grid))
  {
    // All pictures have the plane of the first one, which the command names.
    Asked.surfaces.AddFirst(
      PlaneChoice::Read(PlaneChoice::ThroughTheMiddle().Numbers(BoxOf(*Now->input.model))));
  }
  First = Now->view;
  Pivot = Pivoted();
  const auto steps = static_cast<int>(Now->input.times.size());
  const bool all = Options.shot.input.allSteps;
  Count = animation.Frames().value_or(steps);
  if (all && (steps == 0 || Count != steps))
  {
    throw Error(steps == 0
        ? "--time-step all: '" + Options.shot.input.files[0] + "' has no time steps"
        : fmt::format("--time-step all: there are {} time steps, and {} pictures of --sweep or "
                      "--turn; give as many",
            steps, Count));
  }
}

int Pictures::StepOf(int frame) const
{
  return Options.shot.input.allSteps ? frame : Now->input.step;
}

Vec3 Pictures::Pivoted() const
{
  const Box3 box = BoxOf(*Now->input.model);
  return Options.shot.camera.IsPlaced() ? First.focalPoint : 0.5 * (box.lower + box.upper);
}

const Shot& Pictures::At(int frame)
{
  const bool isOtherStep = StepOf(frame) != Now->input.step;
  const auto scaleOf = [](const InputRequest& input)
  { return input.warp ? input.warp->scale : 0.0; };
  const double scale = scaleOf(Asked.input);
  const auto phase = Asked.input.phase;
  Options.animation.Apply(frame, Asked.input);
  if (isOtherStep || scaleOf(Asked.input) != scale || Asked.input.phase != phase)
  {
    const Shot before = std::move(*Now);
    Now.emplace(PrepareStep(Asked, StepOf(frame), before, Watch));
    Reads += isOtherStep ? 1 : 0;
  }
  Shot& shot = *Now;
  // The one before is held while another is made: they differ in their addresses.
  Locators += shot.scene.locator != Latest ? 1 : 0;
  Latest = shot.scene.locator;
  shot.valuesOfAll = Values;
  if (Options.animation.Sweeps())
  {
    shot.scene.layers.front().surface =
      std::make_shared<Plane>(Options.animation.PlaneAt(frame).Make(BoxOf(*shot.input.model)));
  }
  shot.view = Options.animation.ViewAt(frame, First, Pivot);
  return shot;
}

void Pictures::FindValues()
{
  const FrameProgress progress("values of picture", Count);
  const double lowest =
    Options.shot.colors.Logarithm() ? 0.0 : -std::numeric_limits<double>::infinity();
  std::vector<std::optional<Range>> found(Now->scene.layers.size());
  for (int frame = 0; frame < Count; ++frame)
  {
    progress.Tell(frame, frame);
    const Shot& shot = At(frame);
    const Frame traced = TraceShot(Options, shot, {});
    Watch.Stage("values of all");
    for (std::size_t k = 0; k < found.size(); ++k)
    {
      if (const auto here = ValuesSeen(traced, lowest, LayersAlike(shot, k)))
      {
        found[k] = found[k]
          ? Range{ std::min((*found[k])[0], (*here)[0]), std::max((*found[k])[1], (*here)[1]) }
          : *here;
      }
    }
  }
  Values = found;
}
} // namespace pixelexact
