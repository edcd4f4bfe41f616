// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Interval.h"

#include <array>
#include <span>
#include <vector>

namespace pixelexact
{
/// Bernstein coefficients in eta over a box of some functions, one after the other, with a bound
/// of the error of each function's. What the coefficients of a function have in common is its
/// base, exactly: small numbers round by less.
struct BoxCoefficients
{
  std::vector<double> values; ///< of the functions less their bases
  std::vector<double> error;
  std::vector<double> base;

  void Add(std::span<const double> coefficients, double itsError);
  [[nodiscard]] std::span<const double> Of(std::size_t function) const;
  /// All values of a function less its base; everything where a coefficient is not finite.
  [[nodiscard]] Interval HullOf(std::size_t function) const;
  /// Moves to the bases what the coefficients have in common.
  void Recentre();
  /// Becomes those over the lower half along a direction; returns those over the upper one.
  BoxCoefficients Subdivide(const std::array<int, 3>& degree, int direction);
};
} // namespace pixelexact
