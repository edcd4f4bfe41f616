// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/BufferTable.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

namespace pixelexact::testing
{
template <class T>
bool SameBytes(const std::vector<T>& a, const std::vector<T>& b)
{
  return a.size() == b.size() &&
    (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// Bit for bit.
inline void ExpectSame(const SampleBuffers& a, const SampleBuffers& b)
{
  ForEachBuffer(
    [&](const auto& row) { EXPECT_TRUE(SameBytes(a.*row.member, b.*row.member)) << row.name; });
}

/// Bit for bit, but for the seconds.
inline void ExpectSame(const Frame& frame, const Frame& wanted)
{
  ExpectSame(frame.centres, wanted.centres);
  ASSERT_EQ(frame.centres.behind.size(), wanted.centres.behind.size());
  for (std::size_t k = 0; k < wanted.centres.behind.size(); ++k)
  {
    ExpectSame(frame.centres.behind[k], wanted.centres.behind[k]);
  }
  EXPECT_EQ(frame.Image(), wanted.Image());
  EXPECT_EQ(frame.counters.rays, wanted.counters.rays);
  EXPECT_EQ(frame.counters.surfaceHits, wanted.counters.surfaceHits);
  EXPECT_EQ(frame.counters.exact, wanted.counters.exact);
  EXPECT_EQ(frame.counters.nothing, wanted.counters.nothing);
  EXPECT_EQ(frame.counters.unknown, wanted.counters.unknown);
}
} // namespace pixelexact::testing
