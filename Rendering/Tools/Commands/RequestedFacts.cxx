// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/RequestedFacts.h"

#include "Base/Command.h"
#include "Base/Output.h"
#include "Scene/Model.h"

#include <nlohmann/json.hpp>

namespace pixelexact
{
namespace
{
template <class Report>
void AddRequested(Report& report, const LoadedModel& input, const RequestedFacts& facts)
{
  if (facts.certified)
  {
    AddTo(report, *facts.certified);
  }
  if (facts.extremes)
  {
    AddTo(report, input, *facts.extremes);
  }
  if (facts.jumps)
  {
    AddTo(report, *facts.jumps);
  }
  if (facts.norms)
  {
    AddTo(report, input, *facts.norms);
  }
  if (facts.series)
  {
    AddTo(report, *facts.series);
  }
  if (facts.warp)
  {
    AddTo(report, *facts.warp);
  }
}
} // namespace

void FactRequests::AddTo(CLI::App& command)
{
  const auto names = [&command](const char* option, std::vector<std::string>& list)
  { Bind(command, option, [&list](const std::string& name) { list.push_back(name); }); };
  Bind(command, "--certify", certify_);
  names("--field", Certified);
  names("--extremes", Extremes);
  names("--jumps", Jumps);
  names("--norms", Norms);
  Bind(command, "--norms-table", NormTable);
  With.AddTo(command);
  PlotOfSeries.AddTo(command);
  Bind(command, "--warp-limit",
    [this](const std::string& text) { ReadWarp("--warp-limit", text, WarpLimit.emplace()); });
}

void FactRequests::Check(const InputRequest& input, bool json) const
{
  if (!input.warpDirection.empty() && !input.warp && !WarpLimit)
  {
    throw UsageError("--warp-direction has no effect without --warp or --warp-limit; leave it out");
  }
  if (PlotOfSeries.IsAsked() && With.IsEmpty())
  {
    throw UsageError("--plot: info draws the norms of a series; give --norms and --with, or use "
                     "probe or integrate for values");
  }
  std::vector<std::string> read = With.Files();
  read.insert(read.end(), input.files.begin(), input.files.end());
  PlotOfSeries.Check(read);
  CheckOutput("--norms-table", NormTable, read);
  CheckStandardOutput({ NormTable, PlotOfSeries.Name() }, json);
}

RequestedFacts FactRequests::Find(const LoadedModel& input, const InputRequest& request) const
{
  RequestedFacts facts;
  if (certify_)
  {
    facts.certified = Certify(input, Certified);
  }
  if (!Extremes.empty())
  {
    facts.extremes = FindExtremeFacts(input, Extremes);
  }
  if (!Jumps.empty())
  {
    facts.jumps = FindJumpFacts(input, Jumps);
  }
  if (!Norms.empty())
  {
    facts.norms = FindNormFacts(input, Norms);
  }
  if (!NormTable.empty())
  {
    WriteNorms(NormTable, input, *facts.norms);
  }
  if (!With.IsEmpty())
  {
    facts.series = FindNormSeries(input, *facts.norms, request, With, Norms);
  }
  if (PlotOfSeries.IsAsked())
  {
    PlotOfSeries.Write(PlotOfNorms(*facts.series));
  }
  if (WarpLimit)
  {
    facts.warp = FindWarpFacts(input, request, WarpLimit->field, WarpLimit->scale < 0.0);
  }
  return facts;
}

void AddTo(Table& table, const LoadedModel& input, const RequestedFacts& facts)
{
  AddRequested(table, input, facts);
}

void AddTo(nlohmann::ordered_json& summary, const LoadedModel& input, const RequestedFacts& facts)
{
  AddRequested(summary, input, facts);
}
} // namespace pixelexact
