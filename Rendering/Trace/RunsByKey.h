// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pixelexact
{
/// Consecutive hits of a tile with a common key, such as an element or a piece.
struct KeyRun
{
  std::int32_t key;
  std::size_t begin;
  std::size_t end;
};

/// Calls visit(key, runs) for each key. Evaluation by element then fills whole packs, even if a
/// tile's hits alternate between elements. `keyOf(i)`: for i below `count`. `runs`: scratch memory.
template <class KeyOf, class Visit>
void ForEachKey(
  std::size_t count, const KeyOf& keyOf, std::vector<KeyRun>& runs, const Visit& visit)
{
  runs.clear();
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::int32_t key = keyOf(i);
    if (runs.empty() || runs.back().key != key)
    {
      runs.push_back({ key, i, i });
    }
    runs.back().end = i + 1;
  }
  std::ranges::sort(runs,
    [](const KeyRun& a, const KeyRun& b)
    { return a.key != b.key ? a.key < b.key : a.begin < b.begin; });
  for (std::size_t first = 0, last = 0; first < runs.size(); first = last)
  {
    while (last < runs.size() && runs[last].key == runs[first].key)
    {
      ++last;
    }
    visit(runs[first].key, std::span(runs).subspan(first, last - first));
  }
}
} // namespace pixelexact
