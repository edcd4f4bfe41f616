// SPDX-License-Identifier: BSD-3-Clause
#include "JoinedArrays.h"

namespace pixelexact
{
Expansion Join(const std::vector<const Expansion*>& parts, ViewStorage& storage)
{
  auto& spaces = storage.spaces.emplace_back();
  auto& spaceOf = storage.ints.emplace_back();
  auto& offset = storage.longs.emplace_back();
  auto& coefficients = storage.doubles.emplace_back();
  for (const Expansion* part : parts)
  {
    const auto firstSpace = static_cast<std::int32_t>(spaces.size());
    const auto firstCoefficient = static_cast<std::int64_t>(coefficients.size());
    spaces.insert(spaces.end(), part->spaces.begin(), part->spaces.end());
    coefficients.insert(coefficients.end(), part->coefficients.begin(), part->coefficients.end());
    for (int e = 0; e < part->Elements(); ++e)
    {
      spaceOf.push_back(firstSpace + part->spaceOf[e]);
      offset.push_back(firstCoefficient + part->offset[e]);
    }
  }
  return { spaces, spaceOf, offset, coefficients, parts.front()->components };
}
} // namespace pixelexact
