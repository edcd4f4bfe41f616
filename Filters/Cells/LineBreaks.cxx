// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/LineBreaks.h"

#include "Core/Location/Sample.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pixelexact
{
namespace
{
constexpr double kSpacing = 1e-15; ///< of t, beyond which halving brings nothing

/// An end of a stretch.
struct StretchEnd
{
  double t = 0.0;
  std::int32_t element = -1;
};
struct Stretch
{
  StretchEnd from;
  StretchEnd to;
};

std::vector<StretchEnd> Locate(const HighOrderModel& model, const Vec3& start, const Vec3& end,
  const std::vector<double>& places)
{
  std::vector<Vec3> points(places.size());
  std::ranges::transform(
    places, points.begin(), [&](double t) { return start + t * (end - start); });
  std::vector<std::int32_t> elements(places.size());
  std::vector<Verdict> verdicts(places.size());
  SampleTarget target;
  target.element = elements;
  target.verdict = verdicts;
  Sample(model.GetLocator(), nullptr, points, target);
  std::vector<StretchEnd> located(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    located[i] = { places[i], verdicts[i] == Verdict::Inside ? elements[i] : -1 };
  }
  return located;
}
} // namespace

std::vector<double> LineBreaks(const HighOrderModel& model, const Vec3& start, const Vec3& end,
  const std::vector<double>& places)
{
  std::vector<Stretch> open;
  const auto add = [&open](const StretchEnd& from, const StretchEnd& to)
  {
    if (from.element != to.element)
    {
      open.push_back({ from, to });
    }
  };
  const std::vector<StretchEnd> first = Locate(model, start, end, places);
  for (std::size_t i = 1; i < first.size(); ++i)
  {
    add(first[i - 1], first[i]);
  }
  std::vector<double> breaks;
  while (!open.empty())
  {
    std::vector<Stretch> halved;
    std::vector<double> middles;
    for (const Stretch& stretch : open)
    {
      const double middle = 0.5 * (stretch.from.t + stretch.to.t);
      if (!(stretch.to.t - stretch.from.t > kSpacing) || !(middle > stretch.from.t) ||
        !(middle < stretch.to.t))
      {
        breaks.push_back(stretch.from.t);
        breaks.push_back(stretch.to.t);
        continue;
      }
      halved.push_back(stretch);
      middles.push_back(middle);
    }
    open.clear();
    const std::vector<StretchEnd> located = Locate(model, start, end, middles);
    for (std::size_t i = 0; i < halved.size(); ++i)
    {
      add(halved[i].from, located[i]);
      add(located[i], halved[i].to);
    }
  }
  std::ranges::sort(breaks);
  return breaks;
}
} // namespace pixelexact
