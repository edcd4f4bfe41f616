// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

namespace pixelexact
{
/// Called from the calling thread's share of the work with the part done, 0 to 1; returning false
/// aborts the work. May be empty.
using Progress = std::function<bool(double)>;

/// When work has to end.
using Deadline = std::chrono::steady_clock::time_point;
inline constexpr Deadline kNoDeadline = Deadline::max();

/// Progress and abort, shared by the tiles of a frame.
class Reporter
{
public:
  Reporter(const Progress& progress, int total, Deadline end = kNoDeadline);

  /// Whether there is time for another tile; for the first one there always is, so that whoever
  /// asks again and again comes to an end.
  [[nodiscard]] bool HasTime();
  /// By the progress function or the time.
  [[nodiscard]] bool IsAborted() const { return Aborted; }
  void TileDone();

private:
  const Progress& progress_;
  int Total;
  Deadline End;
  std::thread::id Caller;
  std::atomic<int> Done{ 0 };
  std::atomic<bool> Begun{ false };
  std::atomic<bool> Aborted{ false };
};
} // namespace pixelexact
