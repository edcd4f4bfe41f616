// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <chrono>
#include <cstddef>

// Measures the time of each stage of a frame. Off by default: a stage then costs the test of a
// pointer.
namespace pixelexact
{
enum class Stage : unsigned char
{
  Rays = 0,   ///< rays and their hits with the surfaces
  Candidates, ///< hierarchy, boxes, frames
  Bounds,     ///< making what is known of an element, once
  Inversion,  ///< Newton's iteration
  Evaluation, ///< the field
  Careful,    ///< points that the fast path does not decide
  Writing,    ///< to the frame's buffers, and all the rest of the tiles
  Modules,    ///< what works on the image after the rays: colours
  Count
};
inline constexpr std::size_t kStages = static_cast<std::size_t>(Stage::Count);

/// Seconds in each stage, added up over threads.
using StageTimes = std::array<double, kStages>;

/// While one lives, the stages of its thread are timed. At most one a thread.
class StageClock
{
public:
  StageClock();
  ~StageClock();
  StageClock(const StageClock&) = delete;
  StageClock& operator=(const StageClock&) = delete;

  /// The times so far; the stage at hand is charged up to now.
  const StageTimes& Times()
  {
    Enter(Running);
    return Seconds;
  }

private:
  friend class StageScope;
  using Clock = std::chrono::steady_clock;

  /// Charges the running stage and continues in `stage`. Returns the previous stage.
  Stage Enter(Stage stage)
  {
    const auto now = Clock::now();
    Seconds[static_cast<std::size_t>(Running)] +=
      std::chrono::duration<double>(now - Since).count();
    Since = now;
    const Stage before = Running;
    Running = stage;
    return before;
  }
  static StageClock*& OfThread();

  StageTimes Seconds{};
  Clock::time_point Since;
  Stage Running = Stage::Writing;
};

/// Charges its lifetime to a stage, without that of scopes within.
class StageScope
{
public:
  explicit StageScope(Stage stage)
    : clock_(StageClock::OfThread())
    , Before(clock_ ? clock_->Enter(stage) : stage)
  {
  }
  ~StageScope()
  {
    if (clock_)
    {
      clock_->Enter(Before);
    }
  }
  StageScope(const StageScope&) = delete;
  StageScope& operator=(const StageScope&) = delete;

private:
  StageClock* clock_;
  Stage Before;
};
} // namespace pixelexact
