// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"
#include "Trace/Surfaces/Surface.h"

#include <array>
#include <cstddef>
#include <memory>
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

/// A surface that an option's numbers describe.
struct NumberedSurface
{
  const char* option;
  /// Throws Error for numbers of which there is none.
  std::shared_ptr<const Surface> (*make)(const GivenNumbers& numbers);
};
/// The surfaces in the order of the help.
extern const std::array<NumberedSurface, 7> kNumberedSurfaces;

/// Throws UsageError, which begins with the option, for numbers that describe no surface.
std::shared_ptr<const Surface> MakeNumbered(
  const NumberedSurface& kind, const GivenNumbers& numbers);
} // namespace pixelexact
