// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

namespace pixelexact
{
/// Shows the number of finished pictures and the remaining time on stderr, where that is a
/// terminal.
class FrameProgress
{
public:
  FrameProgress(std::string what, int frames);
  ~FrameProgress();
  FrameProgress(const FrameProgress&) = delete;
  FrameProgress& operator=(const FrameProgress&) = delete;

  /// `made`: of those done, the ones that took time.
  void Tell(int done, int made) const;

private:
  std::string What;
  int Frames;
  bool Terminal;
  std::chrono::steady_clock::time_point Begin = std::chrono::steady_clock::now();
};

struct CommonOptions;
struct RenderOptions;

/// Identifies the sources of an animation: the bytes of the inputs and of options' files, this
/// program, and the words that affect pictures. Throws Error for a file that cannot be read.
std::string ProvenanceOf(const RenderOptions& options, const CommonOptions& common);
/// The hash of one picture.
std::string HashOf(const std::string& provenance, int frame, int frames);
/// Whether a picture with this hash exists.
bool IsThere(const std::string& file, const std::string& hash);

/// Names of an animation's files. In a pattern the picture's number, from 0, is written %d, %04d or
/// {frame}, and a time step's {step}; steps have as many digits as the last one.
class FrameNames
{
public:
  /// `example`: a possible name. Throws UsageError for a pattern without a number, or with another
  /// %.
  FrameNames(const char* option, const std::string& pattern, const std::string& example);

  [[nodiscard]] std::string Of(int frame, int step, int frames, int steps) const;

private:
  std::string Pattern; ///< only {frame} and {step}
  int Digits = 0;      ///< least number of digits of a frame; 0: that of the last frame
};

/// Whether a name is a video's, .mp4 or .webm.
bool IsVideo(const std::string& file);
} // namespace pixelexact
