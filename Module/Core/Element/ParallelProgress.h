// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>
#include <utility>

namespace pixelexact
{
/// Tells how much of `count` pieces of work done by several threads is done, as a part that goes
/// from `from` to `to`, about a hundred times. Told by the thread alone that made it.
class ParallelProgress
{
public:
  ParallelProgress(std::function<void(double)> tell, double from, double to, std::size_t count)
    : Tell(std::move(tell))
    , From(from)
    , To(to)
    , Count(count)
  {
  }

  /// One more piece is done.
  void Add()
  {
    const std::size_t done = ++Done;
    if (Tell && std::this_thread::get_id() == Owner && done * 100 / Count > Told)
    {
      Told = done * 100 / Count;
      Tell(From + (To - From) * static_cast<double>(done) / static_cast<double>(Count));
    }
  }

  /// All is done.
  void Finish()
  {
    if (Tell)
    {
      Tell(To);
    }
  }

private:
  std::function<void(double)> Tell;
  double From;
  double To;
  std::size_t Count;
  std::atomic<std::size_t> Done{ 0 };
  std::size_t Told = 0; ///< hundredths
  std::thread::id Owner = std::this_thread::get_id();
};
} // namespace pixelexact
