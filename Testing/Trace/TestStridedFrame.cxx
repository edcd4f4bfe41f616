// SPDX-License-Identifier: BSD-3-Clause
// Strided frames against the pixels of whole ones.
#include "Block.h"

#include "Core/Base/Error.h"
#include "Trace/Tracer.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace pixelexact::testing
{
TEST(StridedFrame, BlocksShowTheirMiddlePixelBitForBit)
{
  Block block;
  block.MakeCurved();
  const Scene& scene = block.WithPlane(Vec3(0.1, 0.0, 0.0), Vec3(0.1, 0.2, 1.0));
  constexpr int kWidth = 61;
  constexpr int kHeight = 47;
  const Camera camera = ViewAlongZ(kWidth, kHeight);
  const Frame all = Trace(scene, camera, {}, { .centres = kAll });
  for (const int stride : { 1, 2, 3, 4, 7, 64 })
  {
    const Frame strided = TraceStrided(scene, camera, kAll, stride);
    const int across = (kWidth + stride - 1) / stride;
    const int up = (kHeight + stride - 1) / stride;
    EXPECT_EQ(strided.counters.rays, static_cast<std::int64_t>(across) * up);
    std::int64_t exact = 0;
    for (int y = 0; y < kHeight; ++y)
    {
      for (int x = 0; x < kWidth; ++x)
      {
        const auto here = static_cast<std::size_t>(y * kWidth + x);
        exact += strided.centres.verdict[here] == static_cast<std::uint8_t>(PixelVerdict::Exact);
        const int middleX = x - x % stride + stride / 2;
        const int middleY = y - y % stride + stride / 2;
        if (middleX >= kWidth || middleY >= kHeight)
        {
          continue;
        }
        const auto middle = static_cast<std::size_t>(middleY * kWidth + middleX);
        ASSERT_EQ(strided.centres.verdict[here], all.centres.verdict[middle]);
        ASSERT_EQ(strided.centres.element[here], all.centres.element[middle]);
        if (all.centres.verdict[middle] == static_cast<std::uint8_t>(PixelVerdict::Exact))
        {
          ASSERT_EQ(strided.centres.value[here], all.centres.value[middle]);
          ASSERT_EQ(strided.centres.position[here], all.centres.position[middle]);
        }
      }
    }
    EXPECT_EQ(strided.counters.exact, exact);
    EXPECT_EQ(strided.counters.exact + strided.counters.nothing + strided.counters.unknown,
      kWidth * kHeight);
  }
}

TEST(StridedFrame, RefusesWhatTraceDoes)
{
  const Block block;
  EXPECT_THROW((void)TraceStrided(block.scene_, ViewAlongZ(8, 8), Buffer::Value, 2), Error);
}
} // namespace pixelexact::testing
