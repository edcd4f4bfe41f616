// SPDX-License-Identifier: BSD-3-Clause
#include "Base/PeakMemory.h"
#include "Bench/FrameTime.h"
#include "Scene/Shot.h"
#include "Trade/TradeRun.h"

#include "Core/Element/Truncation.h"
#include "HighOrderModel.h"
#include "Trace/Appearance/Painter.h"
#include "Trace/Contours/LayerBounds.h"
#include "Trace/View.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace pixelexact
{
namespace
{
/// What one of the exact side's settings does to a frame.
struct Knob
{
  const char* name;
  Precision precision = Precision::Double;
  int stride = 1;
  int samples = 1;
  std::optional<ContourMethod> contours = {}; ///< none: as usual
  bool ofContours = false;
};

ContourMethod Frugal()
{
  ContourMethod method;
  method.halvings = 2;
  method.crossings = 3;
  method.parts = 4;
  return method;
}

const std::vector<Knob>& Knobs()
{
  static const std::vector<Knob> all{ { "exact" }, { "exact-float", Precision::Float },
    { "exact-stride-2", Precision::Double, 2 }, { "exact-stride-4", Precision::Double, 4 },
    { "exact-stride-8", Precision::Double, 8 }, { "exact-samples-4", Precision::Double, 1, 4 },
    { "exact-contours-frugal", Precision::Double, 1, 1, Frugal(), true },
    { "exact-contours-interval", Precision::Double, 1, 1, ContourMethod{ .subdivisions = 5 },
      true } };
  return all;
}

class ExactRun final : public TradeRun
{
public:
  ExactRun(const TradeScene& scene, const Knob& knob, std::optional<int> order)
    : TheScene(scene)
    , TheKnob(knob)
    , Order(order)
  {
  }

  TradeTime Measure() override
  {
    const FreshModel fresh(*TheScene.shot);
    View view = ViewOf(fresh);
    Layer& layer = view.scene.layers.front();
    // Later frames of the same data know the elements' bounds.
    Paints = std::make_unique<Painter>(view, TheScene.resolved, std::make_shared<ContourBounds>());
    TradeTime time;
    const PeakMemory memory;
    const Timer first;
    std::optional<Truncation> truncation;
    Field kept;
    if (Order)
    {
      kept = truncation.emplace(*layer.field, *Order).Kept();
      layer.field = &kept;
    }
    view.scene.locator = &fresh.model->GetLocator();
    layer.surface = TheScene.surface(fresh.model);
    TheFrame = MakeFrame(view);
    time.first = first.Seconds();
    const Timer next;
    TheFrame = MakeFrame(view);
    time.next = next.Seconds();
    time.bytes = memory.Bytes().value_or(-1.0);
    return time;
  }

  [[nodiscard]] std::optional<double> ProvenChange() const override
  {
    if (!Order)
    {
      return std::nullopt;
    }
    const Layer& layer = TheScene.shot->scene.layers.front();
    return LargestChange(
      TheScene.shot->input.model->GetMesh(), Truncation(*layer.field, *Order), layer.component);
  }

  Picture Show() override
  {
    const ContourCertifier* contours = Paints->Contours();
    return PictureOf(
      TheFrame, contours != nullptr ? contours->Verdicts() : std::vector<std::uint8_t>());
  }

private:
  /// The compared view of the fresh model with the knob's settings, and nothing but colours and the
  /// verdicts of contours.
  [[nodiscard]] View ViewOf(const FreshModel& fresh) const
  {
    View view = TheScene.view;
    Layer& layer = view.scene.layers.front();
    layer.field = fresh.model->FindField(layer.field->name);
    layer.precision = TheKnob.precision;
    Appearance& appearance = view.appearance;
    appearance.layers.front().material.reset();
    appearance.edges.reset();
    appearance.outlines.reset();
    appearance.samples = TheKnob.samples;
    appearance.contours = {};
    appearance.contours.method = TheKnob.contours.value_or(ContourMethod());
    if (TheKnob.stride > 1)
    {
      appearance.layers.front().contours = {};
    }
    view.stride = TheKnob.stride;
    return view;
  }

  [[nodiscard]] Frame MakeFrame(const View& view)
  {
    const Camera camera = view.camera.Make();
    const Pipeline pipeline = Paints->MakePipeline({ .edges = false, .contours = false });
    constexpr Buffer kWanted = Buffer::Value | Buffer::Verdict;
    if (view.stride == 1)
    {
      return Trace(view.scene, camera, pipeline, { .centres = kWanted });
    }
    Frame frame = TraceStrided(view.scene, camera, kWanted, view.stride);
    Repaint(pipeline, frame);
    return frame;
  }

  const TradeScene& TheScene;
  const Knob& TheKnob;
  std::optional<int> Order;
  std::unique_ptr<Painter> Paints;
  Frame TheFrame;
};
} // namespace

std::vector<TradeSetting> ExactSettings(bool contours, const std::vector<int>& orders)
{
  std::vector<TradeSetting> settings;
  for (std::size_t k = 0; k < Knobs().size(); ++k)
  {
    if (contours || !Knobs()[k].ofContours)
    {
      settings.push_back({ Knobs()[k].name, TradeFamily::Exact, static_cast<int>(k), 0.0 });
    }
  }
  for (const int order : orders)
  {
    settings.push_back(
      { fmt::format("exact-truncate-{}", order), TradeFamily::Exact, 0, 0.0, order });
  }
  return settings;
}

bool HasOwnValues(const TradeSetting& setting)
{
  if (setting.family != TradeFamily::Exact)
  {
    return true;
  }
  const Knob& knob = Knobs()[static_cast<std::size_t>(setting.number)];
  return !knob.ofContours && knob.samples == 1;
}

std::unique_ptr<TradeRun> MakeExactRun(const TradeScene& scene, const TradeSetting& setting)
{
  return std::make_unique<ExactRun>(
    scene, Knobs()[static_cast<std::size_t>(setting.number)], setting.order);
}
} // namespace pixelexact
