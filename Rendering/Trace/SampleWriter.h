// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/Verdict.h"
#include "Trace/TileSamples.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace pixelexact
{
/// Takes a tile's results to the frame's buffers, one buffer after the other. Most samples are
/// inside and lie beside each other in the frame: rows of them are written together.
class SampleWriter
{
public:
  /// Sorts the samples by their verdicts; `place` are their places in the frame's buffers. Both
  /// must live until the next call. `complete`: these are all samples of a tile's lattice.
  void Sort(
    std::span<const Verdict> verdicts, std::span<const std::size_t> place, bool complete = false);

  [[nodiscard]] std::int64_t Exact() const { return ExactCount; }
  [[nodiscard]] std::int64_t Unknown() const { return static_cast<std::int64_t>(Unknowns.size()); }

  /// buffer[place[i]] = valueOf(i) for the samples inside; an empty buffer is not wanted.
  template <class T, class ValueOf>
  void WriteInside(std::vector<T>& buffer, const ValueOf& valueOf) const
  {
    if (buffer.empty())
    {
      return;
    }
    for (const std::size_t begin : Rows)
    {
      std::array<T, TileSamples::kRow> row;
      for (std::size_t k = 0; k < row.size(); ++k)
      {
        row[k] = valueOf(begin + k);
      }
      std::ranges::copy(row, &buffer[Place[begin]]);
    }
    WriteThese(Singles, buffer, valueOf);
  }

  /// The same for the samples inside and the undecided ones.
  template <class T, class ValueOf>
  void WriteHeld(std::vector<T>& buffer, const ValueOf& valueOf) const
  {
    WriteInside(buffer, valueOf);
    WriteThese(Unknowns, buffer, valueOf);
  }

private:
  template <class T, class ValueOf>
  void WriteThese(
    const std::vector<std::size_t>& samples, std::vector<T>& buffer, const ValueOf& valueOf) const
  {
    if (!buffer.empty())
    {
      for (const std::size_t i : samples)
      {
        buffer[Place[i]] = valueOf(i);
      }
    }
  }

  std::span<const std::size_t> Place;
  std::vector<std::size_t> Rows;    ///< first samples of rows that are inside
  std::vector<std::size_t> Singles; ///< all others that are
  std::vector<std::size_t> Unknowns;
  std::int64_t ExactCount = 0;
};
} // namespace pixelexact
