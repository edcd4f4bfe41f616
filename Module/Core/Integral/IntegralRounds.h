// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Integral/Integrate.h"

#include <chrono>
#include <cstddef>
#include <optional>
#include <vector>

namespace pixelexact
{
/// A limit of time.
class Deadline
{
public:
  explicit Deadline(double seconds);
  [[nodiscard]] bool IsOver() const { return End && Clock::now() > *End; }

private:
  using Clock = std::chrono::steady_clock;
  std::optional<Clock::time_point> End;
};

/// Whether all widths are at most `allowed`.
bool IsWithin(const Sums& sums, const std::vector<double>& allowed);

/// The allowed errors of parts that are integrated to a common tolerance. They are relative to the
/// largest integral of a field's components, because a component may vanish.
class Rounds
{
public:
  Rounds(std::size_t quantities, const IntegralEffort& effort)
    : Magnitudes(quantities, 0.0)
    , Tolerance(effort.tolerance)
  {
  }

  /// The largest allowed width of each of `count` parts, so that their sum is within the tolerance.
  [[nodiscard]] std::vector<double> Share(std::size_t count) const;
  [[nodiscard]] bool IsMet(const Sums& total) const;

  std::vector<double> Magnitudes; ///< of the integrals, so far

private:
  [[nodiscard]] std::vector<double> Allowed(double tolerance, std::size_t count) const;
  double Tolerance;
};
} // namespace pixelexact
