// SPDX-License-Identifier: BSD-3-Clause
#ifndef JoinedArrays_h
#define JoinedArrays_h

#include "CellElements.h"

#include <span>
#include <vector>

// Arrays of several parts, one after the other, as those of one.
namespace pixelexact
{
/// The elements of all parts, in their order, as copies in `storage`. Parts have the same number of
/// components.
Expansion Join(const std::vector<const Expansion*>& parts, ViewStorage& storage);

template <class T>
std::span<const T> Join(
  const std::vector<std::span<const T>>& parts, std::deque<std::vector<T>>& copies)
{
  auto& joined = copies.emplace_back();
  for (const auto& part : parts)
  {
    joined.insert(joined.end(), part.begin(), part.end());
  }
  return joined;
}
} // namespace pixelexact
#endif
