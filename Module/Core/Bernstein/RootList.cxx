// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bernstein/RootList.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
ParameterIntervals IntervalsOf(const ParameterBox& box)
{
  ParameterIntervals intervals;
  for (std::size_t d = 0; d < 3; ++d)
  {
    intervals[d] = { box.lower[d], box.upper[d] };
  }
  return intervals;
}

bool Contains(const ParameterIntervals& outer, const ParameterIntervals& inner, std::size_t n)
{
  for (std::size_t d = 0; d < n; ++d)
  {
    if (!outer[d].Contains(inner[d]))
    {
      return false;
    }
  }
  return true;
}

bool AreApart(const ParameterIntervals& a, const ParameterIntervals& b, std::size_t n)
{
  for (std::size_t d = 0; d < n; ++d)
  {
    if (Intersect(a[d], b[d]).IsEmpty())
    {
      return true;
    }
  }
  return false;
}

bool MeetsCube(const ParameterIntervals& box, std::size_t n)
{
  return std::all_of(box.begin(), box.begin() + static_cast<std::ptrdiff_t>(n),
    [](const Interval& side) {
      return !Intersect(side, { 0.0, 1.0 }).IsEmpty();
    });
}
} // namespace

bool RootList::Add(const IsolatedRoot& root)
{
  const auto n = static_cast<std::size_t>(System.Variables());
  for (const IsolatedRoot& listed : Roots)
  {
    if (Contains(listed.alone, root.enclosure, n) || Contains(root.alone, listed.enclosure, n))
    {
      return true;
    }
    if (!AreApart(listed.enclosure, root.enclosure, n))
    {
      return false;
    }
  }
  if (MeetsCube(root.enclosure, n))
  {
    Roots.push_back(root);
  }
  return true;
}

bool RootList::IsSettled(const ParameterBox& box) const
{
  const auto n = static_cast<std::size_t>(System.Variables());
  return std::ranges::any_of(
    Roots, [&](const IsolatedRoot& root) { return Contains(root.alone, IntervalsOf(box), n); });
}
} // namespace pixelexact
