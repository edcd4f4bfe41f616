// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

namespace pixelexact
{
/// Called from the calling thread's share of the work with the completed part, 0 to 1; returning
/// false aborts the work. May be empty.
using Progress = std::function<bool(double)>;

/// Time at which work must end.
using Deadline = std::chrono::steady_clock::time_point;
inline constexpr Deadline kNoDeadline = Deadline::max();

/// Progress and abort, shared by the tiles of a frame.
class Reporter
{
public:
  Reporter(const Progress& progress, int total, Deadline end = kNoDeadline);

  /// There is time for another tile. True for the first tile, so that repeated calls make progress.
  [[nodiscard]] bool HasTime();
  /// The progress function or the deadline has ended the work.
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
