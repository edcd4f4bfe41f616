// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace pixelexact
{
/// Measures the growth of this process from its construction on, by Linux's high-water mark, which
/// it resets. Free memory of the heap is returned to the system first, so that new data cannot use
/// it.
class PeakMemory
{
public:
  PeakMemory();
  /// The growth in bytes since construction; none where the system does not provide it.
  [[nodiscard]] std::optional<double> Bytes() const;

private:
  std::optional<double> Before;
};
} // namespace pixelexact
