// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace pixelexact
{
/// How far this process grows beyond what it has now: Linux's high-water mark, set back first. What
/// the heap holds free is given back before, so that nothing hides in it.
class PeakMemory
{
public:
  PeakMemory();
  /// Bytes, from the beginning on; none where the machine does not tell.
  [[nodiscard]] std::optional<double> Bytes() const;

private:
  std::optional<double> Before;
};
} // namespace pixelexact
