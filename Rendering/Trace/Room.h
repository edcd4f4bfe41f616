// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

namespace pixelexact
{
/// The first `size` entries; the vector grows to hold them.
template <class T>
std::span<T> Room(std::vector<T>& of, std::size_t size)
{
  if (of.size() < size)
  {
    of.resize(size);
  }
  return std::span(of).first(size);
}
} // namespace pixelexact
