// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/ProgressiveFrame.h"

#include <array>
#include <limits>

namespace pixelexact
{
/// Estimates the time of a ProgressiveFrame's passes from earlier passes, and chooses the first
/// pass of a frame with a time limit. All times are in seconds.
///
/// A pass with n times as many pixels takes at least as long, and at most n times as long, because
/// elements and pixels both cost time.
class FrameCost
{
public:
  /// The finest pass that is expected to end in time; the coarsest if none is.
  [[nodiscard]] int First(double pixels, double limit) const;

  /// Records that a part of a pass of `pixels` pixels took `seconds`.
  void Learn(double pixels, int step, double part, double seconds);

private:
  static constexpr double kUnknown = std::numeric_limits<double>::infinity();
  static constexpr double kFewer = ProgressiveFrame::kFiner * ProgressiveFrame::kFiner;
  /// Seconds per pixel of the frame, by pass, finest first.
  std::array<double, 3> Each{ kUnknown, kUnknown, kUnknown };
};

/// Runs passes of a frame for `seconds`, or until `progress` returns false. `cost` chooses the
/// first pass and learns from all of them. At least one pass is completed, which may take longer.
/// Infinite `seconds`: all passes at once; none is complete if `progress` ends them.
void TracePasses(
  ProgressiveFrame& passes, FrameCost& cost, double seconds, const Progress& progress);
} // namespace pixelexact
