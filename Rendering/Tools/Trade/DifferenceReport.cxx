// SPDX-License-Identifier: BSD-3-Clause
#include "Trade/DifferenceReport.h"

#include "Base/Report.h"
#include "Scene/Shot.h"

#include "Core/Base/Counted.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace pixelexact
{
namespace
{
std::string PointText(const Vec3& x)
{
  return fmt::format("({}, {}, {})", Short(x.x), Short(x.y), Short(x.z));
}

/// Whether a pixel has a finite difference.
bool HasAny(const DifferenceNumbers& numbers)
{
  return numbers.largestPixel >= 0;
}

double RelativeL2(const DifferenceNumbers& numbers)
{
  return numbers.rootMeanSquare / numbers.firstRootMeanSquare;
}

void AddFirst(Table& table, const Shot& shot)
{
  const Layer& layer = shot.scene.layers.front();
  table.Row("first", "{}{}, {}; {}", layer.field->name, FieldKind(*layer.field),
    ComponentName(layer),
    Counted(static_cast<std::size_t>(shot.input.model->GetMesh().Elements()), "element"));
  AddTime(table, shot.input);
  QualityFacts{ 1, shot.truncated }.AddTo(table);
}
} // namespace

std::string PixelsText(const DifferenceNumbers& numbers)
{
  return fmt::format("{} both, {} only first, {} only second, {} unknown, {} nothing", numbers.both,
    numbers.onlyFirst, numbers.onlySecond, numbers.unknown, numbers.nothing);
}

void WarnOf(const DifferenceNumbers& numbers, const std::string& name)
{
  if (numbers.both == 0)
  {
    Warn("--with '" + name + "': no pixel has a value in both solutions" +
      (numbers.onlyFirst + numbers.onlySecond > 0 ? "; their meshes do not meet there" : ""));
  }
  if (numbers.unknown > 0)
  {
    Warn(Counted(numbers.unknown, "pixel") + " could not be decided; shown as unknown");
  }
  if (numbers.notFinite > 0)
  {
    Warn("NaN or infinite at " + Counted(numbers.notFinite, "pixel") +
      ", which are left out of the numbers; NaN is shown in the colour that --nan-color chooses");
  }
}

nlohmann::ordered_json ToJson(const DifferenceNumbers& numbers)
{
  nlohmann::ordered_json json{ { "both", numbers.both }, { "only_first", numbers.onlyFirst },
    { "only_second", numbers.onlySecond }, { "unknown", numbers.unknown },
    { "nothing", numbers.nothing }, { "not_finite", numbers.notFinite } };
  if (!HasAny(numbers))
  {
    return json;
  }
  const Vec3& at = numbers.largestAt;
  json.update({ { "largest", numbers.largest }, { "largest_at", { at.x, at.y, at.z } },
    { "mean", numbers.mean }, { "l2", numbers.rootMeanSquare },
    { "relative_l2", RelativeL2(numbers) } });
  if (numbers.bounded)
  {
    json.update({ { "largest_bound", numbers.largestBound }, { "unbounded", numbers.unbounded },
      { "largest_true", { numbers.largestTrue.lower, numbers.largestTrue.upper } },
      { "proven_apart", numbers.provenApart } });
  }
  return json;
}

void PrintDifference(const Shot& shot, const DifferenceFacts& facts, const RepeatedCommand& command,
  const Stopwatch& stopwatch, bool onStderr)
{
  const DifferenceNumbers& numbers = facts.row.numbers;
  Table table;
  AddFirst(table, shot);
  table.Row("second", "{}; {}; {}", facts.otherField,
    Counted(static_cast<std::size_t>(facts.row.size.elements), "element"), facts.row.name);
  table.Row("size", "{} x {}", shot.size.width, shot.size.height);
  table.Row("pixels", PixelsText(numbers));
  if (HasAny(numbers))
  {
    table.Row("largest", "{} at {}", Short(numbers.largest), PointText(numbers.largestAt));
    table.Row("mean", Short(numbers.mean));
    table.Row("L2", "{} (root of the mean square), {} of the first one's",
      Short(numbers.rootMeanSquare), Short(RelativeL2(numbers)));
    table.Row("bound", "each is off by {} at most; the largest is within {} and {}",
      Short(numbers.largestBound, 3), Short(numbers.largestTrue.lower, 9),
      Short(numbers.largestTrue.upper, 9));
    table.Row("", "{} proven to differ{}", Counted(numbers.provenApart, "pixel"),
      numbers.unbounded > 0 ? ", " + Counted(numbers.unbounded, "pixel") + " without a bound"
                            : std::string());
    table.Row("colours", "{} to {}", Short(facts.range[0]), Short(facts.range[1]));
  }
  AddStages(table, stopwatch);
  if (!command.chosen.empty())
  {
    table.Row("repeat", command.Text());
  }
  table.Print(onStderr);
}

void PrintSeries(const Shot& shot, const Convergence& convergence, const RepeatedCommand& command,
  const Stopwatch& stopwatch)
{
  Table table;
  AddFirst(table, shot);
  table.Row("solution", "{:>9} {:>7} {:>9} {:>9} {:>10} {:>10} {:>10} {:>8} {:>9} {:>10}",
    "elements", "order", "modes", "length", "largest", "mean", "L2", "order", "bound", "only one");
  for (std::size_t k = 0; k < convergence.Rows().size(); ++k)
  {
    const auto& [name, size, numbers] = convergence.Rows()[k];
    const auto order = convergence.StepOrder(k);
    table.Row(name, "{:>9} {:>7} {:>9} {:>9} {:>10} {:>10} {:>10} {:>8} {:>9} {:>10}",
      size.elements, OrderText(size.orders), size.modes, Short(size.length, 3),
      Short(numbers.largest, 4), Short(numbers.mean, 4), Short(numbers.rootMeanSquare, 4),
      order ? fmt::format("{:.2f}", *order) : "", Short(numbers.largestBound, 2),
      numbers.onlyFirst + numbers.onlySecond);
  }
  const char* over = convergence.Axis() == SeriesAxis::Length
    ? "over the elements' length"
    : "over modes to the power of -1 by the dimension";
  if (const auto order = convergence.OrderOf(&DifferenceNumbers::rootMeanSquare))
  {
    table.Row("order of L2", "{:.2f}; {:.2f} at the end; {}", order->overall, order->last, over);
  }
  if (const auto order = convergence.OrderOf(&DifferenceNumbers::largest))
  {
    table.Row("of the largest", "{:.2f}; {:.2f} at the end", order->overall, order->last);
  }
  AddStages(table, stopwatch);
  if (!command.chosen.empty())
  {
    table.Row("repeat", command.Text());
  }
  table.Print();
}
} // namespace pixelexact
