// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Frame.h"

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

/// Bit for bit, but for the seconds.
inline void ExpectSame(const Frame& frame, const Frame& wanted)
{
  const SampleBuffers& a = frame.centres;
  const SampleBuffers& b = wanted.centres;
  EXPECT_TRUE(SameBytes(a.value, b.value));
  EXPECT_TRUE(SameBytes(a.position, b.position));
  EXPECT_TRUE(SameBytes(a.normal, b.normal));
  EXPECT_TRUE(SameBytes(a.xi, b.xi));
  EXPECT_TRUE(SameBytes(a.element, b.element));
  EXPECT_TRUE(SameBytes(a.depth, b.depth));
  EXPECT_TRUE(SameBytes(a.verdict, b.verdict));
  EXPECT_TRUE(SameBytes(a.owners, b.owners));
  EXPECT_TRUE(SameBytes(a.coverage, b.coverage));
  EXPECT_TRUE(SameBytes(a.valueLower, b.valueLower));
  EXPECT_TRUE(SameBytes(a.valueUpper, b.valueUpper));
  EXPECT_EQ(frame.counters.rays, wanted.counters.rays);
  EXPECT_EQ(frame.counters.surfaceHits, wanted.counters.surfaceHits);
  EXPECT_EQ(frame.counters.exact, wanted.counters.exact);
  EXPECT_EQ(frame.counters.nothing, wanted.counters.nothing);
  EXPECT_EQ(frame.counters.unknown, wanted.counters.unknown);
}
} // namespace pixelexact::testing
