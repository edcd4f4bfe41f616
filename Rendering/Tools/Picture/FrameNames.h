// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pixelexact
{
/// Names of an animation's files: a pattern in which the picture's number, from 0, stands as %d,
/// %04d or {frame}, and a time step's as {step}; the latter with as many digits as the last one.
class FrameNames
{
public:
  /// `example`: a name as it could be. Throws UsageError for a pattern in which no number stands,
  /// or another %.
  FrameNames(const char* option, const std::string& pattern, const std::string& example);

  [[nodiscard]] std::string Of(int frame, int step, int frames, int steps) const;

private:
  std::string Pattern; ///< {frame} and {step} alone
  int Digits = 0;      ///< of a frame's number, at least; 0: as many as the last one has
};

/// Whether a name is a video's, .mp4 or .webm.
bool IsVideo(const std::string& file);
} // namespace pixelexact
