// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/WarpFacts.h"

#include "Input/Input.h"
#include "Scene/Model.h"

#include "Conversion/Displacement.h"
#include "Core/Base/Counted.h"

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <vtkUnstructuredGrid.h>

#include <chrono>
#include <cmath>

namespace pixelexact
{
namespace
{
constexpr std::size_t kMaxElementsListed = 10;

std::string PlaceText(const Vec3& xi)
{
  return fmt::format("({}, {}, {})", Short(xi.x, 9), Short(xi.y, 9), Short(xi.z, 9));
}
} // namespace

WarpFacts FindWarpFacts(
  const LoadedModel& input, const InputRequest& request, const std::string& field, bool negative)
{
  const auto begin = std::chrono::steady_clock::now();
  const HighOrderModel& model = *input.model;
  Displacement displacement = DisplacementOf(model, input.grid, request.WarpBy(field, 1.0));
  if (negative)
  {
    for (WarpTerm& term : displacement.terms)
    {
      term.direction = -term.direction;
    }
  }
  model.RequireSolids("--warp-limit");
  ProgressLine line("finding the limit");
  WarpFacts facts;
  facts.field = field;
  facts.sign = negative ? -1.0 : 1.0;
  facts.limit = FindWarpLimit(
    model.GetMesh(), displacement.terms, WarpEffort{}, [&line](double part) { line(part); });
  const auto cellOf = [&model](int element)
  { return model.SourceCells()[static_cast<std::size_t>(element)]; };
  facts.cell = facts.limit.element >= 0 ? cellOf(facts.limit.element) : -1;
  for (const int element : facts.limit.leftOut)
  {
    if (facts.leftOut.size() < kMaxElementsListed)
    {
      facts.leftOut.push_back(cellOf(element));
    }
  }
  facts.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return facts;
}

void AddTo(Table& table, const WarpFacts& facts)
{
  const WarpLimit& limit = facts.limit;
  const char* const sign = facts.sign < 0.0 ? "-" : "";
  table.Row("warp limit", "{}: det J of {} proven positive for scales between 0 and {}{}",
    facts.field, limit.leftOut.empty() ? "all elements is" : "all other elements is", sign,
    Rounded(limit.positive, false, 12));
  if (std::isfinite(limit.inverted))
  {
    table.Row("", "element {} proven inverted at scale {}{}, at xi = {}", facts.cell, sign,
      Rounded(limit.inverted, true, 12), PlaceText(limit.xi));
  }
  else
  {
    table.Row("", "no scale was found that inverts an element");
  }
  if (!limit.leftOut.empty())
  {
    table.Row("", "left out: {}, not proven valid without a displacement ({}{})",
      Counted(limit.leftOut.size(), "element"), fmt::join(facts.leftOut, ", "),
      facts.leftOut.size() < limit.leftOut.size() ? ", ..." : "");
  }
  table.Row("", "{} boxes bounded in {} s{}", limit.boxes, Short(facts.seconds),
    limit.met ? "" : "; the work budget is exhausted");
}

void AddTo(nlohmann::ordered_json& summary, const WarpFacts& facts)
{
  const WarpLimit& limit = facts.limit;
  // Numbers that are not known become null.
  summary["warp_limit"] = { { "field", facts.field },
    { "positive_below", facts.sign * limit.positive },
    { "inverted_at", facts.sign * limit.inverted }, { "never_inverts", std::isinf(limit.positive) },
    { "element", facts.cell }, { "xi", { limit.xi.x, limit.xi.y, limit.xi.z } },
    { "left_out", limit.leftOut.size() }, { "left_out_elements", facts.leftOut },
    { "boxes", limit.boxes }, { "tolerance_met", limit.met }, { "seconds", facts.seconds } };
}
} // namespace pixelexact
