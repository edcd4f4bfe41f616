// SPDX-License-Identifier: BSD-3-Clause
#include "Serve/ServedInput.h"

#include "Base/Report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <utility>

namespace pixelexact
{
namespace
{
/// The part of a request that changes mesh or fields, as text; empty: none.
std::string ChangeOf(const InputRequest& request)
{
  std::string change;
  if (request.warp)
  {
    change = fmt::format("warp {}={} by {}", request.warp->field, request.warp->scale,
      fmt::join(request.warpDirection, ","));
  }
  if (request.phase)
  {
    change += fmt::format(" phase {}", *request.phase);
  }
  if (request.truncateOrder)
  {
    change += fmt::format(" truncate {}", *request.truncateOrder);
  }
  return change;
}

/// The same request without what changes the mesh or the fields.
InputRequest Unchanged(const InputRequest& request, int step)
{
  InputRequest plain = request;
  plain.warp.reset();
  plain.warpDirection.clear();
  plain.phase.reset();
  plain.truncateOrder.reset();
  plain.time.reset();
  plain.step = step;
  return plain;
}
} // namespace

ServedInput::ServedInput(const InputRequest& request)
{
  InputRequest plain = Unchanged(request, 0);
  plain.step = request.step;
  plain.time = request.time;
  Stopwatch watch;
  Kept first;
  first.model = LoadModel(plain, {}, watch);
  WarnOfDiagnostics(first.model);
  first.step = first.model.step;
  times_ = first.model.times;
  FirstStep_ = first.step;
  Keep(std::move(first));
}

int ServedInput::StepOf(const InputRequest& request) const
{
  const bool isGiven = request.step || request.time;
  return isGiven ? ChooseStep(request, times_) : FirstStep_;
}

ServedInput::Kept& ServedInput::Keep(Kept kept)
{
  Models.push_front(std::move(kept));
  while (Models.size() > kKept)
  {
    Models.pop_back();
  }
  return Models.front();
}

ServedInput::Kept& ServedInput::Find(const InputRequest& request, int step)
{
  const std::string change = ChangeOf(request);
  const auto find = [&](const std::string& wanted)
  {
    return std::ranges::find_if(
      Models, [&](const Kept& kept) { return kept.step == step && kept.change == wanted; });
  };
  if (const auto known = find(change); known != Models.end())
  {
    Models.splice(Models.begin(), Models, known);
    return Models.front();
  }
  auto plain = find({});
  if (plain == Models.end())
  {
    Stopwatch watch;
    Kept read;
    read.step = step;
    vtkUnstructuredGrid* before =
      Models.front().change.empty() ? Models.front().model.grid.Get() : nullptr;
    read.model = LoadModel(Unchanged(request, step), {}, watch, before);
    Keep(std::move(read));
    plain = Models.begin();
  }
  Models.splice(Models.begin(), Models, plain);
  if (change.empty())
  {
    return Models.front();
  }
  if (request.warp)
  {
    Count(Models.front(), { request.warp->field });
  }
  return Keep({ step, change, Changed(Models.front().model, request), {} });
}

void ServedInput::Count(Kept& kept, const std::vector<std::string>& expressions)
{
  kept.expressions.insert(expressions.begin(), expressions.end());
  if (kept.expressions.size() > kMaxExpressions)
  {
    // A copy of the grid has a model of its own, which shares mesh and locator.
    const auto copy = vtkSmartPointer<vtkUnstructuredGrid>::Take(kept.model.grid->NewInstance());
    copy->ShallowCopy(kept.model.grid);
    if (kept.model.source == kept.model.grid)
    {
      kept.model.source = copy;
    }
    kept.model.grid = copy;
    kept.model.model = HighOrderModel::From(copy);
    kept.expressions = { expressions.begin(), expressions.end() };
  }
}

LoadedModel ServedInput::Get(
  const InputRequest& request, const std::vector<std::string>& expressions)
{
  Kept& kept = Find(request, StepOf(request));
  Count(kept, expressions);
  return kept.model;
}
} // namespace pixelexact
