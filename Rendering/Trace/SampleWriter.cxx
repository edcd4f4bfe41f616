// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/SampleWriter.h"

#include <cstring>

namespace pixelexact
{
namespace
{
/// Whether samples lie side by side. Of all samples of a tile the ends tell; where some are
/// missing, those of two blocks may be as far apart as those of a row.
bool AreRow(std::span<const std::size_t, TileSamples::kRow> place, bool complete)
{
  bool areRow = place.back() == place.front() + place.size() - 1;
  for (std::size_t k = 1; !complete && k < place.size(); ++k)
  {
    areRow &= place[k] == place[0] + k;
  }
  return areRow;
}
} // namespace

void SampleWriter::Sort(
  std::span<const Verdict> verdicts, std::span<const std::size_t> place, bool complete)
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
      AreRow(place.subspan(i).first<kRow>(), complete))
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
