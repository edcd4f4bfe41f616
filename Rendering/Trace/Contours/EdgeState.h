// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace pixelexact
{
/// Of an edge, or of a pixel by its edges.
enum class EdgeState : std::uint8_t
{
  Out,
  Undecided,
  In
};
} // namespace pixelexact
