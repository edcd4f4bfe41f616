// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/DifferenceCommand.h"

#include "Base/Command.h"
#include "Base/FileOrPipe.h"
#include "Base/Output.h"
#include "Base/Report.h"
#include "Drawing/Plot.h"
#include "Picture/PictureFile.h"
#include "Scene/Shot.h"
#include "Trade/Convergence.h"
#include "Trade/DifferenceOptions.h"
#include "Trade/DifferencePicture.h"
#include "Trade/DifferenceReport.h"

#include "Core/Base/Error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <filesystem>
#include <utility>
#include <vector>

namespace pixelexact
{
namespace
{

/// The options of the picture inside the figure.
ShotOptions OfPicture(const ShotOptions& shot, const DifferenceOptions& difference)
{
  ShotOptions asked = shot;
  asked.layout = [&difference, size = shot.size](const Shot& of)
  {
    FigureLayout layout = difference.Figure().LayOut(size, of, false);
    difference.Figure().NoteEffects(layout, of);
    return layout;
  };
  return asked;
}

void RequireField(const Shot& shot)
{
  if (shot.scene.layers.front().field == nullptr)
  {
    throw Error("the input has no field to compare; name the file of a field");
  }
}

/// The texts that describe a picture in its file.
PictureTexts TextsOf(const Shot& shot, const InputRequest& first, const InputRequest& second,
  const DifferenceNumbers& numbers, const RepeatedCommand& command)
{
  PictureTexts texts{ { "Source", DescribeFiles(first.files) },
    { "With", DescribeFiles(second.files) }, { "Command", command.Text() },
    { "Pixels", PixelsText(numbers) } };
  for (const std::string& given : QualityFacts{ 1, shot.truncated }.Texts())
  {
    texts.emplace_back("Given up", given);
  }
  return texts;
}

void CompareTwo(const ShotOptions& shot, const DifferenceOptions& difference,
  const std::string& output, const CommonOptions& common)
{
  const InputRequest request = difference.Requests(shot.input).front();
  const std::string picture =
    output.empty() ? PictureNamedAfter(shot.input.files.front(), "-difference") : output;
  (void)FormatOf("--output", picture);
  std::vector<std::string> read = shot.input.files;
  read.insert(read.end(), request.files.begin(), request.files.end());
  CheckOutput("--output", picture, read);
  CheckOutput("--buffers", difference.BufferFile(), read);
  const std::array<std::string, 2> outputs{ picture, difference.BufferFile() };
  CheckStandardOutput({ outputs.begin(), outputs.end() }, common.json);
  Stopwatch stopwatch;
  const ShotOptions asked = OfPicture(shot, difference);
  const Shot prepared = Prepare(asked, stopwatch);
  RequireField(prepared);
  const OtherSolution other = LoadOther(request, difference.FieldName(), prepared, stopwatch);
  FieldDifference found = TraceDifferenceOf(asked.colors, prepared, other);
  stopwatch.Stage("compare");

  RepeatedCommand command{ common.words, prepared.chosen };
  if (output.empty())
  {
    command.chosen.insert(command.chosen.end(), { "--output", picture });
  }
  DifferenceFacts facts{ { other.name, SizeOf(other.input, *other.field), NumbersOf(found) },
    other.field->name + FieldKind(*other.field), {} };
  const DifferenceNumbers& numbers = facts.row.numbers;
  const DifferencePicture drawn(asked, prepared, other.field->name, found);
  facts.range = drawn.Range();
  WriteBytes(picture,
    drawn.Encode(difference, TextsOf(prepared, shot.input, request, numbers, command), picture));
  if (!difference.BufferFile().empty())
  {
    WriteDifference(difference.BufferFile(), found, prepared.input.model->SourceCells(),
      other.input.model->SourceCells());
  }
  stopwatch.Stage("write");
  if (output.empty())
  {
    Note("written to '" + picture + "'");
  }
  WarnOf(numbers, other.name);
  if (!common.json)
  {
    const bool onStderr = std::ranges::any_of(outputs, IsStandardStream);
    PrintDifference(prepared, facts, command, stopwatch, onStderr);
    return;
  }
  nlohmann::ordered_json summary{ { "output", picture }, { "solution", other.name },
    { "pixels", ToJson(numbers) }, { "range", facts.range },
    { "figure", ToJson(*prepared.layout) } };
  QualityFacts{ 1, prepared.truncated }.AddTo(summary);
  summary["command"] = command.Words();
  summary["seconds"] = ToJson(stopwatch);
  Print(summary);
}

void CompareSeries(const ShotOptions& shot, const DifferenceOptions& difference,
  const std::string& output, const CommonOptions& common)
{
  const std::vector<InputRequest> requests = difference.Requests(shot.input);
  Stopwatch stopwatch;
  const ShotOptions asked = OfPicture(shot, difference);
  const Shot prepared = Prepare(asked, stopwatch);
  RequireField(prepared);
  const std::filesystem::path folder =
    MakeOutputFolder(output, shot.input.files.front(), "-series");
  const RepeatedCommand command{ common.words, prepared.chosen };
  std::vector<SeriesRow> rows;
  for (const InputRequest& request : requests)
  {
    const OtherSolution other = LoadOther(request, difference.FieldName(), prepared, stopwatch);
    FieldDifference found = TraceDifferenceOf(asked.colors, prepared, other);
    const DifferenceNumbers numbers = NumbersOf(found);
    WarnOf(numbers, other.name);
    const DifferencePicture drawn(asked, prepared, other.field->name, found);
    const std::string picture =
      (folder / fmt::format("difference-{}.png", rows.size() + 1)).string();
    WriteBytes(picture,
      drawn.Encode(difference, TextsOf(prepared, shot.input, request, numbers, command), picture));
    rows.push_back({ other.name, SizeOf(other.input, *other.field), numbers });
    stopwatch.Stage("compare");
  }
  const Convergence convergence(std::move(rows));
  WriteBytes((folder / "convergence.csv").string(), convergence.ToCsv());
  const std::string plot = (folder / "convergence.png").string();
  const std::string reference = SolutionName(shot.input, prepared.input);
  WriteBytes(plot,
    EncodeImage(
      { kPlotWidth, kPlotHeight, 3, convergence.Draw(reference, kPlotWidth, kPlotHeight) },
      PictureFormat::Png, {}, plot));
  stopwatch.Stage("write");
  Note("written to '" + folder.string() + "'");
  if (!common.json)
  {
    PrintSeries(prepared, convergence, command, stopwatch);
    return;
  }
  nlohmann::ordered_json summary{ { "folder", folder.string() }, { "reference", reference } };
  for (const SeriesRow& row : convergence.Rows())
  {
    summary["solutions"].push_back({ { "solution", row.name }, { "elements", row.size.elements },
      { "orders", row.size.orders }, { "modes", row.size.modes },
      { "relative_length", row.size.length }, { "pixels", ToJson(row.numbers) } });
  }
  summary["convergence"] = convergence.ToJson();
  QualityFacts{ 1, prepared.truncated }.AddTo(summary);
  summary["command"] = command.Words();
  summary["seconds"] = ToJson(stopwatch);
  Print(summary);
}
/// The difference at a time step of INPUT.
struct StepDifference
{
  int step = 0;
  double time = 0.0;
  DifferenceNumbers numbers;
};

std::string ToCsv(const std::vector<StepDifference>& steps)
{
  std::string text = "step,time,largest,l2,mean,relative_l2,largest_bound,both,only_first,"
                     "only_second,unknown,not_finite,unbounded\n";
  for (const auto& [step, time, numbers] : steps)
  {
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", step, time, numbers.largest,
      numbers.rootMeanSquare, numbers.mean,
      numbers.firstRootMeanSquare > 0.0
        ? fmt::to_string(numbers.rootMeanSquare / numbers.firstRootMeanSquare)
        : "",
      numbers.largestBound, numbers.both, numbers.onlyFirst, numbers.onlySecond, numbers.unknown,
      numbers.notFinite, numbers.unbounded);
  }
  return text;
}

Plot PlotOf(const std::vector<StepDifference>& steps)
{
  constexpr std::array kNumbers{ std::pair{ "largest", &DifferenceNumbers::largest },
    std::pair{ "L2", &DifferenceNumbers::rootMeanSquare },
    std::pair{ "mean", &DifferenceNumbers::mean } };
  Plot plot;
  plot.title = "Differences over the pixels";
  plot.across = "time";
  plot.up = "difference";
  for (const auto& [name, number] : kNumbers)
  {
    Plot::Series series{ name, SeriesColor(plot.series.size()), {} };
    series.points.reserve(steps.size());
    for (const StepDifference& one : steps)
    {
      series.points.push_back({ one.time, one.numbers.*number, {} });
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

/// Compares INPUT with one other solution at each of INPUT's time steps. The other one's step has
/// the same number, unless one is given.
void CompareSteps(const ShotOptions& shot, const DifferenceOptions& difference,
  const std::string& output, const CommonOptions& common)
{
  const std::size_t count = ReadTimes(shot.input).size();
  if (count == 0)
  {
    throw Error("--time-step all: '" + shot.input.files[0] + "' has no time steps; leave it out");
  }
  const std::filesystem::path folder =
    MakeOutputFolder(output, shot.input.files.front(), "-series");
  Stopwatch stopwatch;
  RepeatedCommand command{ common.words, {} };
  std::vector<StepDifference> steps;
  Table table;
  for (std::size_t k = 0; k < count; ++k)
  {
    ShotOptions asked = OfPicture(shot, difference);
    asked.input.allSteps = false;
    asked.input.step = static_cast<int>(k);
    const Shot prepared = Prepare(asked, stopwatch);
    RequireField(prepared);
    command.chosen = prepared.chosen;
    InputRequest request = difference.Requests(asked.input).front();
    request.step = request.step || request.time ? request.step : asked.input.step;
    const OtherSolution other = LoadOther(request, difference.FieldName(), prepared, stopwatch);
    FieldDifference found = TraceDifferenceOf(asked.colors, prepared, other);
    steps.push_back({ prepared.input.step, TimeOf(prepared.input), NumbersOf(found) });
    const DifferenceNumbers& numbers = steps.back().numbers;
    WarnOf(numbers, other.name);
    const DifferencePicture drawn(asked, prepared, other.field->name, found);
    const std::string picture = (folder / fmt::format("difference-{}.png", k)).string();
    WriteBytes(picture,
      drawn.Encode(difference, TextsOf(prepared, asked.input, request, numbers, command), picture));
    table.Row(fmt::format("step {}", steps.back().step),
      "time {}: largest {}, mean {}, L2 {}, each off by {} at most", Short(steps.back().time),
      Short(numbers.largest), Short(numbers.mean), Short(numbers.rootMeanSquare),
      Short(numbers.largestBound, 3));
    stopwatch.Stage("compare");
  }
  WriteBytes((folder / "over_time.csv").string(), ToCsv(steps));
  const std::string plot = (folder / "over_time.png").string();
  WriteBytes(plot,
    EncodeImage({ kPlotWidth, kPlotHeight, 3, PlotOf(steps).Draw(kPlotWidth, kPlotHeight) },
      PictureFormat::Png, {}, plot));
  stopwatch.Stage("write");
  Note("written to '" + folder.string() + "'");
  if (!common.json)
  {
    AddStages(table, stopwatch);
    if (!command.chosen.empty())
    {
      table.Row("repeat", command.Text());
    }
    table.Print();
    return;
  }
  nlohmann::ordered_json summary{ { "folder", folder.string() } };
  for (const auto& [step, time, numbers] : steps)
  {
    summary["steps"].push_back(
      { { "step", step }, { "time", time }, { "pixels", ToJson(numbers) } });
  }
  summary["command"] = command.Words();
  summary["seconds"] = ToJson(stopwatch);
  Print(summary);
}
} // namespace

void CompareSolutions(ShotOptions shot, const DifferenceOptions& difference,
  const std::string& output, const CommonOptions& common)
{
  if (IsGiven(*shot.command, "--stride"))
  {
    throw UsageError("--stride: differences are of each pixel; leave it out");
  }
  if (!IsGiven(*shot.command, "--size"))
  {
    shot.size.height = 0; // which the layout determines
  }
  shot.size = AtDpi(shot.size, kDefaultDpi);
  shot.CheckRangeOfOne();
  if (shot.colors.Range().of == RangeRule::Of::Field)
  {
    throw UsageError("--range field: a difference is no field of a mesh; choose symmetric, cut, "
                     "percentages or a,b");
  }
  const bool isSeries = difference.Requests(shot.input).size() > 1;
  if (shot.input.allSteps && (isSeries || !difference.BufferFile().empty()))
  {
    throw UsageError(isSeries
        ? "--time-step all: give --with once, or the number of one step"
        : "--buffers: there are several differences; give the number of one --time-step");
  }
  (shot.input.allSteps ? CompareSteps
      : isSeries       ? CompareSeries
                       : CompareTwo)(shot, difference, output, common);
}
} // namespace pixelexact
