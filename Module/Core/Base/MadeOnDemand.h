// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>

namespace pixelexact
{
/// Numbered objects, each created on first use. Safe to use from several threads: two threads may
/// create the same object, in equal form; one of them is kept.
template <class T>
class MadeOnDemand
{
public:
  explicit MadeOnDemand(std::size_t count)
    : Count(count)
    , Made(std::make_unique<std::atomic<const T*>[]>(count))
  {
  }
  ~MadeOnDemand()
  {
    for (std::size_t k = 0; k < Count; ++k)
    {
      delete IfMade(k);
    }
  }
  MadeOnDemand(const MadeOnDemand&) = delete;
  MadeOnDemand& operator=(const MadeOnDemand&) = delete;

  [[nodiscard]] std::size_t Size() const { return Count; }
  /// make() returns a unique_ptr<const T>.
  template <class Make>
  [[nodiscard]] const T& Get(std::size_t k, const Make& make) const
  {
    std::atomic<const T*>& place = Made[k];
    if (const T* made = place.load(std::memory_order_acquire))
    {
      return *made;
    }
    std::unique_ptr<const T> mine = make();
    const T* before = nullptr;
    return place.compare_exchange_strong(before, mine.get(), std::memory_order_acq_rel)
      ? *mine.release()
      : *before;
  }
  /// Returns null before the object exists.
  [[nodiscard]] const T* IfMade(std::size_t k) const
  {
    return Made[k].load(std::memory_order_acquire);
  }
  /// The number of objects that exist.
  [[nodiscard]] std::size_t MadeCount() const
  {
    std::size_t count = 0;
    for (std::size_t k = 0; k < Count; ++k)
    {
      count += IfMade(k) != nullptr ? 1 : 0;
    }
    return count;
  }

private:
  std::size_t Count;
  std::unique_ptr<std::atomic<const T*>[]> Made;
};
} // namespace pixelexact
