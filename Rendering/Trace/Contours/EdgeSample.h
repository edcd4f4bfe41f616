// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Frame.h"
#include "Trace/TraceTile.h"

#include <cmath>
#include <cstdint>

namespace pixelexact
{
/// What is seen at a point of a pixel's edge.
struct EdgeSample
{
  ImagePosition at{};
  PixelVerdict verdict = PixelVerdict::Nothing;
  std::uint8_t layer = kNoLayer;
  int element = -1;
  double value = 0.0;
  Vec3 xi{ 0.0 };
  Vec3 position{ 0.0 };
};

/// The buffers that a sample is made of.
inline constexpr Buffer kEdgeSampleBuffers =
  Buffer::Value | Buffer::Verdict | Buffer::Layer | Buffer::Element | Buffer::Xi | Buffer::Position;
inline EdgeSample SampleFrom(const SampleBuffers& samples, std::size_t i, const ImagePosition& at)
{
  return { at, static_cast<PixelVerdict>(samples.verdict[i]), samples.layer[i],
    static_cast<int>(samples.element[i]), samples.value.empty() ? std::nan("") : samples.value[i],
    samples.xi[i], samples.position[i] };
}
} // namespace pixelexact
