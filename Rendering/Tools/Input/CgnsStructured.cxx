// SPDX-License-Identifier: BSD-3-Clause
#include "Input/CgnsStructured.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
using Place = std::array<std::int64_t, 3>;

/// All faces of the flat box from `low` to `high`.
void AddFlat(const CgnsStructured& zone, const Place& low, const Place& high, std::size_t across,
  CgnsBoundary& boundary)
{
  const std::size_t a = across == 0 ? 1 : 0;
  const std::size_t b = across == 2 ? 1 : 2;
  const auto pointAt = [&](std::int64_t i, std::int64_t j)
  {
    Place at = low;
    at[a] = i;
    at[b] = j;
    return at[0] + zone.extent[0] * (at[1] + zone.extent[1] * at[2]);
  };
  const bool isPlane = zone.directions == 2;
  for (std::int64_t j = low[b]; j < std::max(high[b], low[b] + (isPlane ? 1 : 0)); ++j)
  {
    for (std::int64_t i = low[a]; i < high[a]; ++i)
    {
      boundary.faces.push_back(isPlane
          ? CgnsBoundary::Face{ pointAt(i, j), pointAt(i + 1, j), -1, -1 }
          : CgnsBoundary::Face{
              pointAt(i, j), pointAt(i + 1, j), pointAt(i + 1, j + 1), pointAt(i, j + 1) });
    }
  }
}
} // namespace

bool CgnsStructured::AddPoints(std::span<const std::int64_t> numbers, CgnsBoundary& boundary) const
{
  const auto n = static_cast<std::size_t>(directions);
  for (std::size_t at = 0; at + n <= numbers.size(); at += n)
  {
    std::int64_t point = 0;
    for (std::size_t d = n; d-- > 0;)
    {
      const std::int64_t place = numbers[at + d] - 1;
      if (place < 0 || place >= extent[d])
      {
        return false;
      }
      point = point * extent[d] + place;
    }
    boundary.points.push_back(point);
  }
  return true;
}

bool CgnsStructured::AddFaces(
  std::span<const std::int64_t> numbers, int across, CgnsBoundary& boundary) const
{
  const auto n = static_cast<std::size_t>(directions);
  if (n < 2 || across >= directions)
  {
    return false;
  }
  Place low{ 0, 0, 0 };
  Place high{ 0, 0, 0 };
  int flat = -1;
  for (std::size_t d = 0; d < n; ++d)
  {
    const bool isAcross = across == static_cast<int>(d);
    low[d] = std::min(numbers[d], numbers[n + d]) - 1;
    high[d] = std::max(numbers[d], numbers[n + d]) - 1 + (across >= 0 && !isAcross ? 1 : 0);
    if (low[d] < 0 || high[d] >= extent[d])
    {
      return false;
    }
    flat = low[d] == high[d] && (flat < 0 || isAcross) ? static_cast<int>(d) : flat;
  }
  if (flat < 0 || (across >= 0 && flat != across))
  {
    return false;
  }
  AddFlat(*this, low, high, static_cast<std::size_t>(flat), boundary);
  return true;
}
} // namespace pixelexact
