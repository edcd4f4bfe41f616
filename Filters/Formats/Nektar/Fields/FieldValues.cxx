// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Fields/FieldValues.h"

#include <sys/mman.h>

#include <algorithm>
#include <new>

namespace pixelexact::nektar
{
namespace
{
double* MapPages(std::size_t bytes)
{
  void* pages = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (pages == MAP_FAILED)
  {
    throw std::bad_alloc();
  }
  return static_cast<double*>(pages);
}
} // namespace

void FieldValues::Unmap::operator()(double* pages) const
{
  munmap(pages, kChunk * sizeof(double));
}

void FieldValues::Append(std::span<const double> values)
{
  while (!values.empty())
  {
    const std::size_t used = Count % kChunk;
    if (used == 0)
    {
      Chunks.push_back({ std::unique_ptr<double[], Unmap>(MapPages(kChunk * sizeof(double))),
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
