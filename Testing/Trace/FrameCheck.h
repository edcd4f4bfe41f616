// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/BufferTable.h"
#include "Trace/Modules/ColorMapping.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

// Frames compared, and colours that tests paint them with.
namespace pixelexact::testing
{
inline constexpr Rgba kBlack{ 0, 0, 0, 255 };
inline constexpr Rgba kRed{ 255, 0, 0, 255 };
inline constexpr Rgba kGreen{ 0, 255, 0, 255 };

/// Everything white, so that black lines show the part of a pixel that they cover.
inline ColorMapping MakeWhite(std::size_t layers = 1)
{
  return ColorMapping(std::vector<LayerColors>(
    layers, { SolidColor({ 255, 255, 255, 255 }), { 255, 255, 255, 255 } }));
}

/// The part of a pixel that black lines cover on white.
inline double CoverAt(const Frame& frame, int x, int y)
{
  return 1.0 - frame.Image()[4 * static_cast<std::size_t>(y * frame.width + x)] / 255.0;
}

inline Rgba ColorAt(const std::vector<std::uint8_t>& colors, std::size_t i)
{
  return { colors.at(4 * i), colors.at(4 * i + 1), colors.at(4 * i + 2), colors.at(4 * i + 3) };
}

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
