// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

namespace pixelexact
{
/// A set of up to 64 points or chunks, a bit each.
using Bits = std::uint64_t;

constexpr Bits BitOf(std::size_t i)
{
  return Bits{ 1 } << i;
}

/// visit(i) for each bit, lowest first.
template <class Visit>
void ForEachBit(Bits bits, Visit&& visit)
{
  for (; bits != 0; bits &= bits - 1)
  {
    visit(static_cast<std::size_t>(std::countr_zero(bits)));
  }
}
} // namespace pixelexact
