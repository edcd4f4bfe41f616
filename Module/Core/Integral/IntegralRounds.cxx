// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/IntegralRounds.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Smaller magnitudes belong to a field that vanishes.
constexpr double kNothing = 1e-280;
/// The fraction of the tolerance that the parts share, so that the sum is well within it.
constexpr double kShared = 0.4;
} // namespace

Deadline::Deadline(double seconds)
  : End(std::isfinite(seconds) && seconds < 1e9
        ? std::optional(Clock::now() +
            std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds)))
        : std::nullopt)
{
}

bool IsWithin(const Sums& sums, const std::vector<double>& allowed)
{
  for (std::size_t q = 0; q < sums.size(); ++q)
  {
    if (!(sums[q].IsFinite() && sums[q].Width() <= allowed[q]))
    {
      return false;
    }
  }
  return true;
}

std::vector<double> Rounds::Share(std::size_t count) const
{
  return Allowed(kShared * Tolerance, count);
}

bool Rounds::IsMet(const Sums& total) const
{
  return IsWithin(total, Allowed(Tolerance, 1));
}

std::vector<double> Rounds::Allowed(double tolerance, std::size_t count) const
{
  std::vector<double> allowed;
  const double ofField =
    Magnitudes.size() > 1 ? *std::max_element(Magnitudes.begin() + 1, Magnitudes.end()) : 0.0;
  for (std::size_t q = 0; q < Magnitudes.size(); ++q)
  {
    const double magnitude = q == 0 ? Magnitudes[0] : ofField;
    // A width is twice the error of the middle.
    allowed.push_back(
      std::max(2.0 * tolerance * magnitude / static_cast<double>(std::max<std::size_t>(count, 1)),
        kNothing));
  }
  return allowed;
}
} // namespace pixelexact
