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
  /// Jumps up to this part of the layer's largest visible value count as rounding, that is, as 0.
  static constexpr double kRounding = 1e-12;
  /// Largest sine of the angle between the segment of two hits and the surface at either hit.
  /// Steeper segments connect different parts of the surface.
  static constexpr double kSteepest = 0.5;

  std::int64_t jumping = 0;
  std::int64_t continuous = 0;
  std::int64_t notFinite = 0;
  std::int64_t notFound = 0;      ///< no common face between the two pixels was found
  std::optional<CutJump> largest; ///< none: no pair jumps
};

/// The buffers of a frame's centres that FindCutJumps reads.
[[nodiscard]] constexpr Buffer NeedsOfCutJumps()
{
  return Buffer::Jump | Buffer::Value | Buffer::Position | Buffer::Normal | Buffer::Xi |
    Buffer::Element | Buffer::Verdict | Buffer::Layer;
}

/// Writes the buffer of jumps. A pixel gets the larger of the jumps to its right and upper
/// neighbours, if they are on the same layer and in other elements; otherwise NaN. A jump is
/// evaluated where the segment between the two hits leaves the pixel's element, found by bisection
/// to 2^-45 of its length. On a curved surface this point lies on the chord, off the surface by at
/// most the sagitta.
///
/// Parallel; the result does not depend on the number of threads. All layers must have fields.
CutJumps FindCutJumps(const Scene& scene, SampleBuffers& samples);
} // namespace pixelexact
