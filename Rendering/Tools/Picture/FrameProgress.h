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
} // namespace pixelexact
