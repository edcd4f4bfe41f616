// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bernstein/RootList.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
/// normal . t - offset.
Interval Beyond(const HalfSpace& half, const ParameterIntervals& t)
{
  Interval beyond = -Interval(half.offset);
  for (std::size_t d = 0; d < 3; ++d)
  {
    beyond += Interval(half.normal[d]) * t[d];
  }
  return beyond;
}

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
} // namespace

bool RootList::Add(IsolatedRoot root)
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
  if (Place(root))
  {
    Roots.push_back(root);
  }
  return true;
}

/// Sets inDomain; false where the enclosure lies outside of the domain.
bool RootList::Place(IsolatedRoot& root) const
{
  root.inDomain = true;
  for (std::size_t d = 0; d < static_cast<std::size_t>(System.Variables()); ++d)
  {
    if (Intersect(root.enclosure[d], { 0.0, 1.0 }).IsEmpty())
    {
      return false;
    }
    root.inDomain = root.inDomain && Interval(0.0, 1.0).Contains(root.enclosure[d]);
  }
  for (const HalfSpace& half : System.Domain())
  {
    const Interval beyond = Beyond(half, root.enclosure);
    if (beyond.lower > 0.0)
    {
      return false;
    }
    root.inDomain = root.inDomain && beyond.upper <= 0.0;
  }
  return true;
}

bool RootList::IsOutsideDomain(const ParameterBox& box) const
{
  return std::ranges::any_of(System.Domain(),
    [&](const HalfSpace& half) { return Beyond(half, IntervalsOf(box)).lower > 0.0; });
}

bool RootList::IsSettled(const ParameterBox& box) const
{
  const auto n = static_cast<std::size_t>(System.Variables());
  return std::ranges::any_of(
    Roots, [&](const IsolatedRoot& root) { return Contains(root.alone, IntervalsOf(box), n); });
}
} // namespace pixelexact
