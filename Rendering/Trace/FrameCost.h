// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

namespace pixelexact
{
/// How long frames take, learned from those that were made, and what follows from it for one that
/// is to be shown within a given time. All times are in seconds.
class FrameCost
{
public:
  enum class Work
  {
    Complete, ///< trace all that is left: that will be in time
    Refine,   ///< trace the next pass of a ProgressiveFrame
    Show      ///< show what there is
  };

  /// What to do with a frame of so many pixels, of which those `step` apart are known (0: none), if
  /// `spent` of `limit` seconds have gone. Without any spent, at least a pass is made.
  [[nodiscard]] Work Next(double pixels, int step, double spent, double limit) const;

  /// The work that led from pixels `from` apart (0: none) to those `to` apart took so long. A frame
  /// made at once tells what frames cost; a pass of one, whose rays lie further apart and share
  /// less, at most what they cost: only so is an estimate that a first frame made too high ever
  /// left.
  void Learn(double pixels, int from, int to, double seconds);

private:
  double PixelSeconds = std::numeric_limits<double>::infinity();
};
} // namespace pixelexact
