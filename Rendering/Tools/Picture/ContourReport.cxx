// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/ContourReport.h"

#include "Base/Report.h"
#include "Scene/ShotAppearance.h"

#include "Core/Base/Counted.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace pixelexact
{
FoundContours FindContours(
  const ShotAppearance& appearance, const Frame& frame, std::optional<int> labels)
{
  const ContourCertifier& certifier = *appearance.GetPainter().Contours();
  FoundContours found{ certifier.Values(), 0, certifier.Counters(), labels,
    appearance.GetView().appearance.contours.method.interior, appearance.Resolved().ofOneValue };
  for (std::size_t k = 0; k < found.values.size(); ++k)
  {
    const ValueRange seen = ValuesSeen(frame, k);
    found.outside += static_cast<std::size_t>(std::ranges::count_if(found.values[k],
      [&seen](double value) { return !seen || value < (*seen)[0] || value > (*seen)[1]; }));
  }
  return found;
}

std::size_t CountOf(const FoundContours& contours)
{
  std::size_t count = 0;
  for (const std::vector<double>& values : contours.values)
  {
    count += values.size();
  }
  return count;
}

nlohmann::ordered_json ToJson(const FoundContours& contours)
{
  // An array per layer, where there are several.
  const nlohmann::ordered_json values = contours.values.size() > 1
    ? nlohmann::ordered_json(contours.values)
    : nlohmann::ordered_json(contours.values.front());
  const ContourCounters& pixels = contours.pixels;
  nlohmann::ordered_json summary{ { "values", values }, { "outside", contours.outside },
    { "pixels",
      { { "in", pixels.in }, { "out", pixels.out }, { "undecided", pixels.undecided },
        { "jumps", pixels.jumps } } } };
  if (contours.interior)
  {
    summary["pixels"]["loops"] = pixels.loops;
  }
  if (pixels.spent > 0)
  {
    summary["spent_tiles"] = pixels.spent;
  }
  if (contours.labels)
  {
    summary["labels"] = *contours.labels;
  }
  return summary;
}

void AddContours(Table& table, const FoundContours& contours)
{
  const std::string outside = contours.outside > 0
    ? fmt::format(", {} of them not among those that are seen", contours.outside)
    : std::string();
  table.Row("contours", Counted(CountOf(contours), "value") + outside);
  const ContourCounters& pixels = contours.pixels;
  const std::string loops =
    contours.interior ? fmt::format(", {} by loops inside", pixels.loops) : std::string();
  table.Row("", "{} in, {} out, {} undecided, {} at jumps{}", Counted(pixels.in, "pixel"),
    pixels.out, pixels.undecided, pixels.jumps, loops);
  if (pixels.spent > 0)
  {
    table.Row("", "the work budget was exhausted in {}; --contour-effort raises it",
      Counted(pixels.spent, "tile"));
  }
  if (contours.labels)
  {
    table.Row("", Counted(*contours.labels, "label"));
  }
}
} // namespace pixelexact
