// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/PointBudget.h"

#include <array>
#include <utility>

namespace pixelexact
{
void FindWithin(ElementTree& tree, std::span<SoughtPoint> points,
  std::span<PointBudget* const> budgets, Wanted wanted, std::span<Preimages> answers)
{
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    points[k].mostWork = budgets[k]->Share();
  }
  FindPreimages(tree, points, wanted, answers);
  std::array<SoughtPoint, kGroupPoints> again;
  std::array<std::size_t, kGroupPoints> which{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    const bool decided =
      answers[k].complete || (wanted == Wanted::First && answers[k].verdict == Verdict::Inside);
    if (decided)
    {
      continue;
    }
    if (const std::int64_t more = budgets[k]->TakeMore(); more > 0)
    {
      points[k].mostWork = more;
      again[count] = points[k];
      which[count++] = k;
    }
  }
  std::array<Preimages, kGroupPoints> found;
  FindPreimages(tree, std::span(again).first(count), wanted, std::span(found).first(count));
  for (std::size_t k = 0; k < count; ++k)
  {
    answers[which[k]] = std::move(found[k]);
  }
}
} // namespace pixelexact
