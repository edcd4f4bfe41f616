// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <utility>
#include <vector>

namespace pixelexact
{
/// An object that a thread keeps from one use to the next, to save the making of it. Checked out
/// while this lives: a use within another, as when a wait takes up other work, gets one of its own.
template <class T>
class CheckedOut
{
public:
  CheckedOut()
  {
    auto& kept = Kept();
    if (kept.empty())
    {
      // Room for its way back, which must not throw.
      kept.reserve(kept.capacity() + 1);
      Mine = std::make_unique<T>();
      return;
    }
    Mine = std::move(kept.back());
    kept.pop_back();
  }
  ~CheckedOut() { Kept().push_back(std::move(Mine)); }
  CheckedOut(const CheckedOut&) = delete;
  CheckedOut& operator=(const CheckedOut&) = delete;

  T& operator*() const { return *Mine; }

private:
  static std::vector<std::unique_ptr<T>>& Kept()
  {
    thread_local std::vector<std::unique_ptr<T>> kept;
    return kept;
  }

  std::unique_ptr<T> Mine;
};
} // namespace pixelexact
