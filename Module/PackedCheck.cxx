// SPDX-License-Identifier: BSD-3-Clause
#include "PackedCheck.h"

#include <xxhash.h>

#include <bit>

namespace pixelexact
{
Space SpaceIn(const std::uint8_t* numbers)
{
  return { static_cast<Shape>(numbers[0]), static_cast<Form>(numbers[1]),
    { numbers[2], numbers[3], numbers[4] } };
}

std::int64_t CheckOf(const PackedCell& cell)
{
  XXH64_hash_t hash = XXH3_64bits(cell.space, kPackedSpace);
  hash = XXH3_64bits_withSeed(cell.marks, (kPackedMarks - 1) * sizeof(*cell.marks), hash);
  hash = XXH3_64bits_withSeed(cell.place.data(), cell.place.size_bytes(), hash);
  hash = XXH3_64bits_withSeed(cell.coefficients.data(), cell.coefficients.size_bytes(), hash);
  return std::bit_cast<std::int64_t>(hash);
}
} // namespace pixelexact
