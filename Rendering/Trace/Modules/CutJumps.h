// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Frame.h"
#include "Trace/Scene.h"

#include <array>
#include <cstdint>
#include <optional>

namespace pixelexact
{
/// A jump of a layer's values where its surface crosses from one element into another.
struct CutJump
{
  double jump = 0.0; ///< the larger value minus the smaller; NaN where a value is not finite
  Vec3 position{ 0.0 };
  std::array<std::int32_t, 2> elements{ -1, -1 };
  std::uint8_t layer = 0;
};

/// The jumps of a frame, by pairs of neighbouring pixels whose elements differ.
struct CutJumps
{
  /// Up to which part of the layer's largest value seen a jump is rounding, and counts as 0.
  static constexpr double kRounding = 1e-12;
  /// Sine of the angle between the segment of two hits and the surface at one of them, beyond which
  /// the hits lie on different parts of the surface.
  static constexpr double kSteepest = 0.5;

  std::int64_t jumping = 0;
  std::int64_t continuous = 0;
  std::int64_t notFinite = 0;
  std::int64_t notFound = 0;      ///< without a common face on the way from one pixel to the other
  std::optional<CutJump> largest; ///< none: no pair jumps
};

/// What a frame's centres must hold for FindCutJumps.
[[nodiscard]] constexpr Buffer NeedsOfCutJumps()
{
  return Buffer::Jump | Buffer::Value | Buffer::Position | Buffer::Normal | Buffer::Xi |
    Buffer::Element | Buffer::Verdict | Buffer::Layer;
}

/// Writes the buffer of jumps: at each pixel the larger of the jumps between it and its right and
/// upper neighbours, where both are on the same layer and in different elements; NaN where there is
/// none. The place of a jump is where the segment between the two hits leaves the pixel's element,
/// by bisection to 2^-45 of its length. Of a curved surface that is a point of the chord, off the
/// surface by its sagitta.
///
/// In parallel; the same for any number of threads. All layers must have fields.
CutJumps FindCutJumps(const Scene& scene, SampleBuffers& samples);
} // namespace pixelexact
