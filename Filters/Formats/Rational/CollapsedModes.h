// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Space.h"

#include <array>
#include <span>
#include <vector>

namespace pixelexact::rational
{
/// A polynomial of a prism's or tetrahedron's space on a tensor grid of points in eta.
class CollapsedModes
{
public:
  CollapsedModes(const Space& space, std::array<std::vector<long double>, 3> eta);

  struct Values
  {
    std::vector<long double> value;
    /// Sum of |coefficient| times |mode|.
    std::vector<long double> magnitude;
  };
  /// Coefficients in order of storage to values with the last direction fastest. A value is off by
  /// at most Roundings() long double roundings of its magnitude.
  [[nodiscard]] Values Evaluate(std::span<const double> coefficients) const;
  [[nodiscard]] int Roundings() const;

private:
  /// Of direction 1 by p; of 2 by p and q; of 3 by p, q and r; each with its points fastest.
  using Table = std::vector<long double>;
  [[nodiscard]] std::vector<long double> Sum(
    std::span<const double> coefficients, bool isMagnitude) const;

  Space Target;
  std::array<std::size_t, 3> Size{};
  std::array<Table, 3> Tables;
};
} // namespace pixelexact::rational
