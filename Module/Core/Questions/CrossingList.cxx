// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Questions/CrossingList.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
using Box = std::array<Interval, 3>;

bool Contains(const Box& outer, const Box& inner)
{
  return outer[0].Contains(inner[0]) && outer[1].Contains(inner[1]) && outer[2].Contains(inner[2]);
}

bool AreApart(const Box& a, const Box& b)
{
  return Intersect(a[0], b[0]).IsEmpty() || Intersect(a[1], b[1]).IsEmpty() ||
    Intersect(a[2], b[2]).IsEmpty();
}

Vec3 Ends(const Box& box, double Interval::*end)
{
  return { box[0].*end, box[1].*end, box[2].*end };
}
} // namespace

void CrossingList::Add(const Crossing& crossing, const Box& alone)
{
  for (const Entry& entry : Found)
  {
    if (Contains(entry.alone, crossing.eta) || Contains(alone, entry.crossing.eta))
    {
      return;
    }
  }
  // Those that are listed already have been told from each other.
  const auto open = std::ranges::find_if(
    Found, [&](const Entry& entry) { return !AreApart(entry.crossing.eta, crossing.eta); });
  if (open == Found.end())
  {
    Found.push_back({ crossing, alone });
    return;
  }
  for (const Crossing& one : { open->crossing, crossing })
  {
    AddUndecided(one.t, { Ends(one.eta, &Interval::lower), Ends(one.eta, &Interval::upper) });
  }
  Found.erase(open);
}

void CrossingList::AddUndecided(const Interval& t, const EtaBox& box)
{
  Undecided.push_back({ t, box });
}

Crossings CrossingList::Take()
{
  Crossings result;
  for (const Entry& entry : Found)
  {
    result.found.push_back(entry.crossing);
  }
  std::ranges::sort(result.found, {}, [](const Crossing& one) { return one.middle; });
  result.undecided = std::move(Undecided);
  return result;
}
} // namespace pixelexact
