// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/ProgressiveFrame.h"

#include <array>
#include <limits>

namespace pixelexact
{
/// How long the passes of a ProgressiveFrame take, learned from those that were made, and with
/// which one a frame begins that is to be shown within a given time. All times are in seconds.
///
/// A pass whose pixels are n times as many takes at least as long, and at most n times: elements
/// cost something, and pixels do.
class FrameCost
{
public:
  /// The finest pass that is expected to be made in time; the coarsest where none is.
  [[nodiscard]] int First(double pixels, double limit) const;

  /// The part of a pass of so many pixels took so long.
  void Learn(double pixels, int step, double part, double seconds);

private:
  static constexpr double kUnknown = std::numeric_limits<double>::infinity();
  static constexpr double kFewer = ProgressiveFrame::kFiner * ProgressiveFrame::kFiner;
  /// By pass, finest first: seconds for each pixel of the frame.
  std::array<double, 3> Each{ kUnknown, kUnknown, kUnknown };
};

/// Makes passes of a frame for as long as `seconds`, or until `progress` is false; the first one
/// is what `cost` expects to be made by then, and `cost` learns from all of them. At the end some
/// pass is done, which may take longer. Infinite: all at once, of which none is done when
/// `progress` ends it.
void TracePasses(
  ProgressiveFrame& passes, FrameCost& cost, double seconds, const Progress& progress);
} // namespace pixelexact
