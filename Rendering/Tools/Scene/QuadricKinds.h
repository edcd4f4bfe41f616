// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"
#include "Trace/Surfaces/Quadric.h"

#include <array>
#include <cstddef>
#include <vector>

namespace pixelexact
{
/// The numbers of an option.
using GivenNumbers = std::vector<double>;

/// Three of them.
inline Vec3 VectorAt(const GivenNumbers& numbers, std::size_t first)
{
  return { numbers[first], numbers[first + 1], numbers[first + 2] };
}

/// A quadric that an option's numbers describe.
struct QuadricKind
{
  const char* name;
  /// Throws Error for numbers of which there is none.
  Quadric (*make)(const GivenNumbers& numbers);
};
/// In the order of the help.
extern const std::array<QuadricKind, 4> kQuadricKinds;
} // namespace pixelexact
