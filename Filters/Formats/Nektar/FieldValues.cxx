// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/FieldValues.h"

#include <algorithm>

namespace pixelexact::nektar
{
void FieldValues::Append(std::span<const double> values)
{
  while (!values.empty())
  {
    const std::size_t used = Count % kChunk;
    if (used == 0)
    {
      Chunks.push_back({ std::unique_ptr<double[]>(new double[kChunk]),
        std::make_unique<std::atomic<std::size_t>>(0) });
    }
    const auto part = values.first(std::min(values.size(), kChunk - used));
    std::ranges::copy(part, &Chunks.back().values[used]);
    Count += part.size();
    values = values.subspan(part.size());
  }
}

void FieldValues::Expect(std::size_t begin, std::size_t count)
{
  for (std::size_t c = begin / kChunk; count > 0 && c <= (begin + count - 1) / kChunk; ++c)
  {
    ++*Chunks[c].expected;
  }
}

void FieldValues::Take(std::size_t begin, std::span<double> out)
{
  while (!out.empty())
  {
    Chunk& chunk = Chunks[begin / kChunk];
    const std::size_t at = begin % kChunk;
    const std::size_t count = std::min(out.size(), kChunk - at);
    std::copy_n(&chunk.values[at], count, out.begin());
    if (--*chunk.expected == 0)
    {
      chunk.values.reset();
    }
    out = out.subspan(count);
    begin += count;
  }
}
} // namespace pixelexact::nektar
