// SPDX-License-Identifier: BSD-3-Clause
#ifndef PackedCheck_h
#define PackedCheck_h

#include "Core/Basis/Space.h"

#include <cstdint>
#include <span>

// The tuples of one packed cell (PackedArrays.h), and the hash that detects whether they were
// changed.
namespace pixelexact
{
inline constexpr int kPackedSpace = 8;
inline constexpr int kPackedOrigin =
  5; ///< among the numbers of a space; the mapping and the field's place follow
inline constexpr int kPackedMarks = 3;
inline constexpr int kPackedPlace = 5;

struct PackedCell
{
  const std::uint8_t* space = nullptr;  ///< kPackedSpace
  const std::int64_t* marks = nullptr;  ///< kPackedMarks, of which the last is the check
  std::span<const double> place;        ///< empty of a field
  std::span<const double> coefficients; ///< those that the cell has
};

/// Decodes a cell's space; the result may be invalid.
Space SpaceIn(const std::uint8_t* numbers);

/// XXH3 (64 bits) of everything but the check itself.
std::int64_t CheckOf(const PackedCell& cell);
} // namespace pixelexact
#endif
