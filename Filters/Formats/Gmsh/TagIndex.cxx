// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Gmsh/TagIndex.h"

#include <algorithm>

namespace pixelexact::gmsh
{
const std::uint64_t* TagIndex::Finish()
{
  using Pair = std::pair<std::uint64_t, std::int32_t>;
  if (!std::ranges::is_sorted(Pairs, {}, &Pair::first))
  {
    std::ranges::sort(Pairs, {}, &Pair::first);
  }
  const auto twice = std::ranges::adjacent_find(Pairs, {}, &Pair::first);
  if (twice != Pairs.end())
  {
    Twice = twice->first;
    return &Twice;
  }
  if (Pairs.empty())
  {
    return nullptr;
  }
  First = Pairs.front().first;
  const std::uint64_t span = Pairs.back().first - First;
  if (span / 4 <= Pairs.size())
  {
    Dense.assign(static_cast<std::size_t>(span) + 1, -1);
    for (const auto& [tag, place] : Pairs)
    {
      Dense[static_cast<std::size_t>(tag - First)] = place;
    }
    std::vector<Pair>().swap(Pairs); // with its memory
  }
  return nullptr;
}

std::int32_t TagIndex::Find(std::uint64_t tag) const
{
  if (!Dense.empty())
  {
    return tag >= First && tag - First < Dense.size() ? Dense[static_cast<std::size_t>(tag - First)]
                                                      : -1;
  }
  const auto found =
    std::ranges::lower_bound(Pairs, tag, {}, [](const auto& pair) { return pair.first; });
  return found != Pairs.end() && found->first == tag ? found->second : -1;
}
} // namespace pixelexact::gmsh
