// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/RootFinder.h"

namespace pixelexact
{
/// The isolated roots found so far, each listed once.
class RootList
{
public:
  explicit RootList(const PolynomialSystem& system)
    : System(system)
  {
  }

  /// Lists the one root that `root.alone` holds, in `root.enclosure`, unless it is listed already
  /// or lies outside the unit cube. Returns false where it cannot be separated from a listed root.
  bool Add(const IsolatedRoot& root);

  /// Whether a listed root is known to be the only one anywhere in the box.
  [[nodiscard]] bool IsSettled(const ParameterBox& box) const;

  std::vector<IsolatedRoot> Take() { return std::move(Roots); }

private:
  const PolynomialSystem& System;
  std::vector<IsolatedRoot> Roots;
};
} // namespace pixelexact
