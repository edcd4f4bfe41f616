// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Frame.h"

#include <mutex>

namespace pixelexact
{
/// The sheets of a set of samples while tiles write to them: what is nearest, and what is seen
/// through it, made when the first ray comes so far.
class Sheets
{
public:
  /// Of all of a ray's samples; what is behind is not kept.
  static constexpr int kMost = 64;

  /// `nearest` is allocated, as are all sheets, for the buffers `wanted`.
  Sheets(SampleBuffers& nearest, Buffer wanted)
    : Nearest(nearest)
    , Wanted(wanted)
  {
  }

  [[nodiscard]] Buffer Buffers() const { return Wanted; }

  /// From 0, the nearest, to kMost - 1. May be called from several threads at once.
  SampleBuffers& At(int k)
  {
    if (k == 0)
    {
      return Nearest;
    }
    const std::scoped_lock lock(Growing);
    auto& behind = Nearest.behind;
    // Sheets do not move while others write to them.
    behind.reserve(kMost - 1);
    while (behind.size() < static_cast<std::size_t>(k))
    {
      behind.emplace_back().Allocate(Wanted, Nearest.width, Nearest.height);
    }
    return behind[static_cast<std::size_t>(k) - 1];
  }

private:
  SampleBuffers& Nearest;
  Buffer Wanted;
  std::mutex Growing;
};
} // namespace pixelexact
