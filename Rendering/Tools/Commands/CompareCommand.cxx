// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Command.h"
#include "Base/FileOrPipe.h"
#include "Base/Output.h"
#include "Base/Report.h"
#include "Commands/DifferenceCommand.h"
#include "Input/PatchFile.h"
#include "Picture/RenderReport.h"
#include "Scene/ContourOptions.h"
#include "Scene/Shot.h"
#include "Scene/ShotAppearance.h"
#include "Trade/DifferenceOptions.h"
#include "Trade/Recommendation.h"
#include "Trade/TradeOptions.h"
#include "Trade/TradeReport.h"
#include "Trade/TradeRows.h"
#include "Trade/TradeScript.h"
#include "Trade/TradeTable.h"
#include "Trade/TradeWords.h"

#include "Core/Base/Error.h"
#include "HighOrderModel.h"
#include "Surfaces/FunctionOfSurface.h"
#include "Trace/Compare/TracedPicture.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <tbb/global_control.h>
#include <vtkImplicitFunction.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string_view>
#include <utility>

namespace pixelexact
{
namespace
{
struct CompareOptions
{
  ShotOptions shot;
  ContourOptions contours;
  TradeOptions trade;
  DifferenceOptions difference;
  QualityOptions quality;
};

/// Refuses options of shots and contours that have no effect on pictures of values.
void CheckOptions(const CompareOptions& options)
{
  constexpr std::array<std::string_view, 19> kUnused{ "--precision", "--samples", "--lights",
    "--edges", "--edge-color", "--edges-by-kind", "--outlines", "--outline-color", "--layer",
    "--log", "--color", "--contour-width", "--contour-color", "--contour-labels", "--contours-only",
    "--certifier", "--interior", "--subdivisions", "--contour-effort" };
  for (const std::string& name : OptionsGiven(*options.shot.command))
  {
    if (std::ranges::find(kUnused, name) != kUnused.end() || name.find("undecided") != name.npos)
    {
      throw UsageError(name + " has no effect on a comparison; leave it out");
    }
  }
  constexpr std::pair<const char*, const char*> kNotSampled[] = { { "--boundary", "boundaries" },
    { "--isosurface", "iso-surfaces" }, { "--surface", "triangles" }, { "--patch", "patches" } };
  for (const auto& [option, what] : kNotSampled)
  {
    if (IsGiven(*options.shot.command, option) &&
      (IsGiven(*options.shot.command, "--resolutions") ||
        IsGiven(*options.shot.command, "--grids")))
    {
      throw UsageError(
        std::string("--resolutions and --grids have no effect on ") + what + "; leave them out");
    }
  }
  if (options.shot.surfaces.Count() > 1)
  {
    throw UsageError("compare takes one surface; leave the others out");
  }
}

/// Makes the scene and its colours. The frame that gives their range is not kept.
TradeScene MakeScene(const CompareOptions& options, const Shot& shot)
{
  if (shot.scene.layers.front().field == nullptr)
  {
    throw Error("the input has no field to compare; name the file of a field");
  }
  TradeScene scene;
  scene.shot = &shot;
  scene.surface = options.shot.surfaces.Make().front();
  scene.function = FunctionOf(*shot.scene.layers.front().surface);
  const std::vector<IsoText>& isos = options.shot.surfaces.IsoSurfaces();
  if (!isos.empty())
  {
    const IsoChoice iso = Resolve(isos.front(), *shot.input.model);
    scene.isoField = iso.field;
    scene.isoComponent = iso.component;
    scene.isoComponents = shot.input.model->FindField(iso.field)->values.components;
    scene.isoValue = iso.value;
  }
  else if (!scene.function && !IsOfFaces(scene) && !IsOfPieces(scene))
  {
    throw Error("compare takes --plane, --sphere, --cylinder, --cone, --quadric, --torus, --box, "
                "--isosurface, --boundary, --surface or --patch");
  }
  for (const std::string& file : options.shot.surfaces.PatchFiles())
  {
    scene.patches = ReadPatches(file);
  }
  const Frame frame = Trace(ViewOf(options.shot.colors, &options.contours, shot), Buffer::Value);
  const ShotAppearance appearance(options.shot.colors, &options.contours, shot, frame);
  scene.view = appearance.GetView();
  scene.resolved = appearance.Resolved();
  scene.map = appearance.Maps().front();
  scene.range = *appearance.Ranges().front();
  if (const ContourCertifier* contours = appearance.GetPainter().Contours())
  {
    scene.isoValues = contours->Values().front();
  }
  return scene;
}

std::vector<TradeSetting> SettingsOf(const CompareOptions& options, const TradeScene& scene)
{
  const Field& field = *scene.shot->scene.layers.front().field;
  std::vector<TradeSetting> settings =
    ExactSettings(!scene.isoValues.empty(), options.trade.Orders(OrderRange(field.values)[1]));
  const auto add = [&settings](TradeFamily family, const std::vector<int>& numbers, auto spacing)
  {
    for (const int number : numbers)
    {
      settings.push_back(
        { fmt::format("{}-{}", Name(family), number), family, number, spacing(number) });
    }
  };
  const bool isPlane = scene.shot->scene.layers.front().surface->IsPlane();
  if (scene.function)
  {
    add(TradeFamily::Cut, options.trade.Resolutions(isPlane), [](int n) { return 1.0 / n; });
    add(TradeFamily::Resample, options.trade.Grids(), [](int n) { return 1.0 / (n - 1); });
  }
  const auto ofLevel = [](int level) { return 1.0 / (1 << level); };
  const auto addCells = [&](TradeFamily family)
  {
    if (!IsOfFaces(scene) && !IsOfPieces(scene) && HasHighOrderCells(scene, family))
    {
      settings.push_back({ Name(family), family, 0, 0.0 });
    }
  };
  add(TradeFamily::Subdivide, options.trade.Levels(), ofLevel);
  addCells(TradeFamily::Cells);
  if (HasDerivatives(scene) && !GradientObstacle(scene).empty())
  {
    settings.push_back({ Name(TradeFamily::Gradient), TradeFamily::Gradient, 0, 0.0 });
  }
  else if (HasDerivatives(scene))
  {
    add(TradeFamily::Gradient, options.trade.Levels(), ofLevel);
    addCells(TradeFamily::GradientCells);
  }
  return settings;
}

TradeFacts FactsOf(const CompareOptions& options, const TradeScene& scene, const Picture& truth,
  const std::string& command)
{
  const Shot& shot = *scene.shot;
  const Layer& layer = shot.scene.layers.front();
  TradeFacts facts;
  facts.range = scene.range;
  facts.share = options.trade.Share();
  facts.bins = options.trade.Bins();
  facts.ofNext = options.trade.OfNext();
  facts.command = command;
  const auto pixels = [&truth](PixelVerdict verdict)
  { return std::ranges::count(truth.verdict, static_cast<std::uint8_t>(verdict)); };
  facts.lines = { { "input", Listed(options.shot.input.files) },
    { "elements", fmt::to_string(shot.input.model->GetMesh().Elements()) },
    { "field", layer.field->name + FieldKind(*layer.field) + ", " + ComponentName(layer) },
    { "size", fmt::format("{} x {}", shot.size.width, shot.size.height) },
    { "pixels",
      fmt::format("{} exact, {} nothing, {} unknown", pixels(PixelVerdict::Exact),
        pixels(PixelVerdict::Nothing), pixels(PixelVerdict::Unknown)) },
    { "range", Short(scene.range[0]) + " to " + Short(scene.range[1]) },
    { "contours", fmt::to_string(scene.isoValues.size()) },
    { "repeats", fmt::to_string(options.trade.Repeat()) },
    { "threads",
      fmt::to_string(
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism)) } };
  if (HasDerivatives(scene) && GradientObstacle(scene).empty())
  {
    facts.lines.emplace_back("gradient-...", kGradientMethod);
  }
  return facts;
}

/// Writes the script of a recommended linear setting. Returns its name, empty where there is none.
std::string WriteScript(const std::string& folder, const TradeScene& scene,
  const Recommendation& recommended, const std::vector<std::string>& files)
{
  const std::string text =
    recommended.row != nullptr ? ScriptOf(scene, recommended.row->setting, files) : std::string();
  if (text.empty())
  {
    return {};
  }
  std::string name = (std::filesystem::path(folder) / "recommended.py").string();
  OutputFile file(name);
  file.Stream() << text;
  file.Close();
  return name;
}

void Compare(const CompareOptions& options, const CommonOptions& common)
{
  CheckOptions(options);
  options.difference.Check(*options.shot.command, options.shot.size);
  if (options.difference.IsAsked())
  {
    CompareSolutions(options.shot, options.difference, options.trade.Output(), common);
    return;
  }
  if (options.shot.input.allSteps)
  {
    throw UsageError(
      "--time-step all: linear pictures are compared at one step, of which info names "
      "the times; give its number, or another solution with --with");
  }
  if (options.quality.Stride() > 1 || options.shot.input.truncateOrder)
  {
    throw UsageError(std::string(options.quality.Stride() > 1 ? "--stride" : "--truncate-order") +
      " is among what is compared; leave it out, or name orders with --truncate-orders");
  }
  options.contours.Check(options.shot.MakeLayers());
  Stopwatch stopwatch;
  const Shot shot = Prepare(options.shot, stopwatch);
  const TradeScene scene = MakeScene(options, shot);
  const std::string folder =
    MakeOutputFolder(options.trade.Output(), options.shot.input.files.front(), "-trade");
  const Picture truth =
    TracePicture(shot.scene, shot.MakeCamera(), {}, scene.isoValues, ContourMethod());
  const ErrorMeasure measure{ options.trade.Share(), scene.range, options.trade.Bins() };
  const std::vector<TradeRow> rows = [&]
  {
    ProgressLine line("comparing");
    return MeasureTrade(scene, SettingsOf(options, scene), truth, measure, options.trade.Repeat(),
      [&line](double part) { line(part); });
  }();
  stopwatch.Stage("compare");

  const RepeatedCommand command{ common.words, shot.chosen };
  TradeFacts facts = FactsOf(options, scene, truth, command.Text());
  std::optional<Recommendation> recommended;
  if (const auto& target = options.trade.Target())
  {
    recommended = Recommend(rows, *target, scene.range);
    facts.script = WriteScript(folder, scene, *recommended, options.shot.input.files);
    facts.recommendation =
      Describe(*recommended, *target, facts, SceneWords(common.words, shot.chosen));
  }
  WriteTradeReport(folder, scene, truth, rows, facts, options.shot.colors.BackgroundColor());
  OutputFile csv((std::filesystem::path(folder) / "trade.csv").string());
  csv.Stream() << ToCsv(rows, scene.range);
  csv.Close();
  stopwatch.Stage("write");
  Note("written to '" + folder + "'");

  if (!common.json)
  {
    PrintRows(rows, facts);
    return;
  }
  nlohmann::ordered_json summary{ { "folder", folder }, { "range", scene.range } };
  for (const TradeRow& row : rows)
  {
    summary["settings"].push_back(ToJson(row, scene.range));
  }
  for (const TradeOrder& order : OrdersOf(rows, facts.range))
  {
    summary["orders"][Name(order.family)] = { { "overall", order.overall },
      { "last", order.last } };
  }
  if (recommended)
  {
    summary["recommended"] = { { "setting",
                                 recommended->row != nullptr
                                   ? nlohmann::ordered_json(recommended->row->setting.name)
                                   : nullptr },
      { "margin", recommended->margin }, { "text", facts.recommendation } };
  }
  summary["command"] = command.Words();
  summary["seconds"] = ToJson(stopwatch);
  Print(summary);
}
} // namespace

void AddCompareCommand(CLI::App& program, const CommonOptions& common, Action& action)
{
  const auto options = std::make_shared<CompareOptions>();
  CLI::App& command = AddCommand(program, "compare",
    "Measure what linear pictures of a cut cost and miss, beside exact ones; writes a report; or, "
    "--with other solutions, how far these are from INPUT, pixel by pixel",
    [options, &common, &action] { action = [options, &common] { Compare(*options, common); }; });
  options->shot.input.mayBeAll = true;
  options->shot.AddTo(command);
  options->contours.AddTo(command);
  options->trade.AddTo(command);
  options->difference.AddTo(command);
  options->quality.AddTo(command, options->shot);
  // A picture of a difference needs its colour bar.
  options->difference.AskForFigure();
}
} // namespace pixelexact
