// SPDX-License-Identifier: BSD-3-Clause
#include "Base/PeakMemory.h"
#include "Bench/FrameTime.h"
#include "Scene/Shot.h"
#include "Trade/TradeRun.h"

#include "Core/Element/Truncation.h"
#include "HighOrderModel.h"
#include "Trace/Contours/LayerBounds.h"
#include "Trace/Modules/Antialiasing.h"
#include "Trace/StridedFrame.h"
#include "Trace/Tracer.h"

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
    , Colors(scene.map)
  {
    if (knob.samples > 1)
    {
      Smooth.emplace(knob.samples);
    }
  }

  TradeTime Measure() override
  {
    const FreshModel fresh(*TheScene.shot);
    Scene scene = TheScene.shot->scene;
    Layer& layer = scene.layers.front();
    layer.field = fresh.model->FindField(layer.field->name);
    layer.precision = TheKnob.precision;
    if (!TheScene.isoValues.empty() && TheKnob.stride == 1)
    {
      // Later frames of the same data know the elements' bounds.
      Contours.emplace(std::vector<std::vector<double>>{ TheScene.isoValues },
        TheKnob.contours.value_or(ContourMethod()), std::make_shared<ContourBounds>());
    }
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
    scene.locator = &fresh.model->GetLocator();
    layer.surface = TheScene.surface(fresh.model);
    TheFrame = MakeFrame(scene);
    time.first = first.Seconds();
    const Timer next;
    TheFrame = MakeFrame(scene);
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
    return PictureOf(TheFrame, Contours ? Contours->Verdicts() : std::vector<std::uint8_t>());
  }

private:
  Frame MakeFrame(const Scene& scene)
  {
    const Camera camera = TheScene.shot->MakeCamera();
    Pipeline pipeline{ { &Colors }, {} };
    if (Smooth)
    {
      pipeline.modules.push_back(&*Smooth);
    }
    if (Contours)
    {
      pipeline.modules.push_back(&*Contours);
    }
    if (TheKnob.stride == 1)
    {
      return Trace(scene, camera, pipeline, { .centres = Buffer::Value | Buffer::Verdict });
    }
    Frame frame = TraceStrided(scene, camera, Buffer::Value | Buffer::Verdict, TheKnob.stride);
    Repaint(pipeline, frame);
    return frame;
  }

  const TradeScene& TheScene;
  const Knob& TheKnob;
  std::optional<int> Order;
  ColorMapping Colors;
  std::optional<Antialiasing> Smooth;
  std::optional<ContourCertifier> Contours;
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
