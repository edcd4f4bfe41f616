// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/SampleWriter.h"

#include <cstring>

namespace pixelexact
{
namespace
{
/// The ends alone do not tell: where rays are missing, those of two blocks may be as far apart as
/// those of a row.
bool IsRow(std::span<const std::size_t, TileSamples::kRow> place)
{
  bool isRow = true;
  for (std::size_t k = 1; k < place.size(); ++k)
  {
    isRow &= place[k] == place[0] + k;
  }
  return isRow;
}
} // namespace

void SampleWriter::Sort(std::span<const Verdict> verdicts, std::span<const std::size_t> place)
{
  constexpr std::size_t kRow = TileSamples::kRow;
  static constexpr auto kAllInside = []
  {
    std::array<Verdict, kRow> all{};
    all.fill(Verdict::Inside);
    return all;
  }();
  Place = place;
  Rows.clear();
  Singles.clear();
  Unknowns.clear();
  for (std::size_t i = 0; i < verdicts.size();)
  {
    if (i + kRow <= verdicts.size() &&
      std::memcmp(&verdicts[i], kAllInside.data(), sizeof kAllInside) == 0 &&
      IsRow(place.subspan(i).first<kRow>()))
    {
      Rows.push_back(i);
      i += kRow;
      continue;
    }
    if (verdicts[i] == Verdict::Inside)
    {
      Singles.push_back(i);
    }
    else if (verdicts[i] == Verdict::Unknown)
    {
      Unknowns.push_back(i);
    }
    ++i;
  }
  ExactCount = static_cast<std::int64_t>(Rows.size() * kRow + Singles.size());
}
} // namespace pixelexact
