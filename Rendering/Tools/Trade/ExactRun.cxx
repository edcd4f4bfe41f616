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
/// The changes of a frame by one of the exact side's settings.
struct ExactVariant
{
  const char* name;
  Precision precision = Precision::Double;
  int stride = 1;
  int samples = 1;
  std::optional<ContourMethod> contours = {}; ///< none: the default
  bool ofContours = false;
};

ContourMethod Frugal()
{
  ContourMethod method;
  method.edgeLevels = 2;
  method.crossings = 3;
  method.parts = 4;
  return method;
}

const std::vector<ExactVariant>& ExactVariants()
{
  static const std::vector<ExactVariant> all{ { "exact" }, { "exact-float", Precision::Float },
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
  ExactRun(const TradeScene& scene, const ExactVariant& exact, std::optional<int> order)
    : scene_(scene)
    , setting_(exact)
    , Order(order)
  {
  }

  TradeTime Measure() override
  {
    const FreshModel fresh(*scene_.shot);
    View view = ViewOf(fresh);
    Layer& layer = view.scene.layers.front();
    // Later frames of the same data keep the elements' bounds.
    Paints = std::make_unique<Painter>(view, scene_.resolved, std::make_shared<ContourBounds>());
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
    layer.surface = scene_.surface(fresh.model);
    frame_ = MakeFrame(view);
    time.first = first.Seconds();
    const Timer next;
    frame_ = MakeFrame(view);
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
    const Layer& layer = scene_.shot->scene.layers.front();
    return LargestChange(
      scene_.shot->input.model->GetMesh(), Truncation(*layer.field, *Order), layer.component);
  }

  Picture Show() override
  {
    const ContourCertifier* contours = Paints->Contours();
    return PictureOf(
      frame_, contours != nullptr ? contours->Verdicts() : std::vector<std::uint8_t>());
  }

private:
  /// The compared view of the fresh model with the given settings, with only colours and the
  /// verdicts of contours.
  [[nodiscard]] View ViewOf(const FreshModel& fresh) const
  {
    View view = scene_.view;
    Layer& layer = view.scene.layers.front();
    layer.field = fresh.model->FindField(layer.field->name);
    layer.precision = setting_.precision;
    Appearance& appearance = view.appearance;
    appearance.layers.front().material.reset();
    appearance.edges.reset();
    appearance.outlines.reset();
    appearance.samples = setting_.samples;
    appearance.contours = {};
    appearance.contours.method = setting_.contours.value_or(ContourMethod());
    if (setting_.stride > 1)
    {
      appearance.layers.front().contours = {};
    }
    view.stride = setting_.stride;
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

  const TradeScene& scene_;
  const ExactVariant& setting_;
  std::optional<int> Order;
  std::unique_ptr<Painter> Paints;
  Frame frame_;
};
} // namespace

std::vector<TradeSetting> ExactSettings(bool contours, const std::vector<int>& orders)
{
  std::vector<TradeSetting> settings;
  for (std::size_t k = 0; k < ExactVariants().size(); ++k)
  {
    if (contours || !ExactVariants()[k].ofContours)
    {
      settings.push_back({ ExactVariants()[k].name, TradeFamily::Exact, static_cast<int>(k), 0.0 });
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
  const ExactVariant& exact = ExactVariants()[static_cast<std::size_t>(setting.number)];
  return !exact.ofContours && exact.samples == 1;
}

std::unique_ptr<TradeRun> MakeExactRun(const TradeScene& scene, const TradeSetting& setting)
{
  return std::make_unique<ExactRun>(
    scene, ExactVariants()[static_cast<std::size_t>(setting.number)], setting.order);
}
} // namespace pixelexact
