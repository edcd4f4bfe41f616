// SPDX-License-Identifier: BSD-3-Clause
#include "Serve/ServedMessages.h"

#include "Drawing/ImageFile.h"
#include "Picture/DrawnShot.h"
#include "Picture/RenderOptions.h"
#include "Scene/Model.h"
#include "Scene/Shot.h"

#include "Views/VtkColorMap.h"

#include "vtkHighOrderCalculator.h"

#include <fmt/format.h>
#include <vtkLookupTable.h>
#include <vtkUnstructuredGrid.h>

#include <cstdint>
#include <utility>

namespace pixelexact
{
namespace
{
constexpr std::size_t kLargePng = 200'000; ///< bytes
constexpr int kCoarseQuality = 85;
constexpr int kBarColors = 64;

nlohmann::ordered_json ToJson(const Vec3& v)
{
  return nlohmann::ordered_json::array({ v.x, v.y, v.z });
}

std::string VerdictName(std::uint8_t verdict)
{
  switch (static_cast<PixelVerdict>(verdict))
  {
    case PixelVerdict::Exact:
      return "exact";
    case PixelVerdict::Unknown:
      return "unknown";
    default:
      return "nothing";
  }
}

/// Whether --phase has an effect.
bool HasComplexField(const LoadedModel& input)
{
  const auto copy = vtkSmartPointer<vtkUnstructuredGrid>::Take(input.source->NewInstance());
  copy->ShallowCopy(input.source);
  return vtkHighOrderCalculator::DefinePhase(copy, 0.0) > 0;
}

/// The colours of the first layer's map from low to high; null where it has one colour.
nlohmann::ordered_json BarOf(const RenderOptions& options, const Shot& shot, const DrawnShot& drawn)
{
  const ValueRange& range = drawn.GetAppearance().Ranges().front();
  if (!range || drawn.Debug().IsInPlace())
  {
    return nullptr;
  }
  const auto table = options.shot.colors.TableOver({ 0.0, 1.0 }, shot.settings.front().colormap);
  nlohmann::ordered_json colors = nlohmann::ordered_json::array();
  for (int k = 0; k < kBarColors; ++k)
  {
    const auto at = static_cast<vtkIdType>(
      (k + 0.5) / kBarColors * static_cast<double>(table->GetNumberOfTableValues()));
    const unsigned char* rgba = table->GetPointer(at);
    colors.push_back(fmt::format("#{:02x}{:02x}{:02x}", rgba[0], rgba[1], rgba[2]));
  }
  return { { "range", *range }, { "colors", colors }, { "log", options.shot.colors.Logarithm() } };
}
} // namespace

std::string TextMessage(const nlohmann::ordered_json& message)
{
  return message.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::string BinaryMessage(const nlohmann::ordered_json& header, const std::string& content)
{
  const std::string text = TextMessage(header);
  std::string bytes;
  bytes.reserve(4 + text.size() + content.size());
  for (const int shift : { 24, 16, 8, 0 })
  {
    bytes += static_cast<char>(text.size() >> shift & 0xffU);
  }
  bytes += text;
  bytes += content;
  return bytes;
}

std::string PictureMessage(const Image& image, bool isExact, nlohmann::ordered_json header)
{
  PictureFacts facts;
  facts.pngEffort = 1;
  facts.jpegQuality = kCoarseQuality;
  const std::size_t uncompressed = image.pixels.size();
  const bool isJpeg = !isExact && image.channels == 3 && uncompressed > kLargePng;
  header["mime"] = isJpeg ? "image/jpeg" : "image/png";
  return BinaryMessage(header,
    EncodeImage(image, isJpeg ? PictureFormat::Jpeg : PictureFormat::Png, facts, "the page"));
}

std::string HoverMessage(
  const std::array<int, 2>& pixel, const SampleBuffers& sample, const Shot& shot)
{
  nlohmann::ordered_json message{ { "kind", "hover" }, { "pixel", pixel },
    { "verdict", VerdictName(sample.verdict.front()) } };
  if (sample.verdict.front() != kNothingPixel)
  {
    message["position"] = ToJson(sample.position.front());
  }
  if (sample.verdict.front() == kExactPixel)
  {
    const std::int64_t element = sample.element.front();
    message["element"] = shot.input.model->SourceCells()[static_cast<std::size_t>(element)];
    message["xi"] = ToJson(sample.xi.front());
    if (!sample.value.empty())
    {
      message["value"] = sample.value.front();
    }
  }
  return TextMessage(message);
}

void AddExact(nlohmann::ordered_json& header, const RenderOptions& options, const Shot& shot,
  const DrawnShot& drawn)
{
  const FrameCounters& pixels = drawn.GetFrame().counters;
  header["pixels"] = { { "exact", pixels.exact }, { "nothing", pixels.nothing },
    { "unknown", pixels.unknown } };
  nlohmann::ordered_json fields = nlohmann::ordered_json::array();
  const HighOrderModel& model = *shot.input.model;
  for (const Field& field : model.Fields())
  {
    fields.push_back({ { "name", field.name }, { "components", field.values.components } });
  }
  // Complex fields at a phase, and fields of saved grids that are expressions.
  for (const auto& [name, text] : model.Definitions())
  {
    fields.push_back(
      { { "name", name }, { "components", model.GetField(name).values.components } });
  }
  header["fields"] = std::move(fields);
  header["maps"] = ColorMapNames();
  const Field* shown = shot.scene.layers.front().field;
  header["field"] = shown != nullptr ? nlohmann::ordered_json(shown->name) : nullptr;
  header["times"] = shot.input.times;
  header["step"] = shot.input.step;
  header["complex"] = HasComplexField(shot.input);
  const Box3 box = BoxOf(*shot.input.model);
  header["box"] = { ToJson(box.lower), ToJson(box.upper) };
  header["bar"] = BarOf(options, shot, drawn);
  if (const auto& values = drawn.WhatIsFound().values)
  {
    header["values"] = *values;
  }
}
} // namespace pixelexact
