// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>
#include <utility>

namespace pixelexact
{
/// Reports how much of `count` pieces of work is done, as a part that goes from `from` to `to`,
/// about a hundred times. Any thread may do a piece; only the thread that made the object reports.
class ParallelProgress
{
public:
  ParallelProgress(std::function<void(double)> report, double from, double to, std::size_t count)
    : Report(std::move(report))
    , From(from)
    , To(to)
    , Count(count)
  {
  }

  /// One more piece is done.
  void Add()
  {
    const std::size_t done = ++Done;
    if (Report && std::this_thread::get_id() == Owner && done * 100 / Count > Reported)
    {
      Reported = done * 100 / Count;
      Report(From + (To - From) * static_cast<double>(done) / static_cast<double>(Count));
    }
  }

  /// All is done.
  void Finish()
  {
    if (Report)
    {
      Report(To);
    }
  }

private:
  std::function<void(double)> Report;
  double From;
  double To;
  std::size_t Count;
  std::atomic<std::size_t> Done{ 0 };
  std::size_t Reported = 0; ///< hundredths
  std::thread::id Owner = std::this_thread::get_id();
};
} // namespace pixelexact
