// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

namespace pixelexact
{
/// How many pictures are done, and how long the rest will take, on stderr where that is a terminal.
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

/// What an animation's pictures are made of: the bytes of the inputs and of options' files, this
/// program, and the words that change pictures. Throws Error for a file that cannot be read.
std::string ProvenanceOf(const RenderOptions& options, const CommonOptions& common);
/// The hash of one picture.
std::string HashOf(const std::string& provenance, int frame, int frames);
/// Whether a picture is there that says so.
bool IsThere(const std::string& file, const std::string& hash);

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
