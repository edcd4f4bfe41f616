// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/PolynomialSystem.h"

#include <cstdint>
#include <vector>

namespace pixelexact
{
/// A part of the unit cube; its ends are dyadic numbers, exactly.
struct ParameterBox
{
  Parameters lower{ 0.0, 0.0, 0.0 };
  Parameters upper{ 1.0, 1.0, 1.0 };
};

/// A root of a system of as many equations as variables.
struct IsolatedRoot
{
  /// Holds exactly one root of every system within the coefficients' errors. It may reach out of
  /// the unit cube by its own width, and so may the root.
  ParameterIntervals enclosure;
  /// A larger box around it in which there is no other root.
  ParameterIntervals alone;
};

struct RootSearch
{
  int budget = 20000;        ///< boxes looked at
  double smallest = 0x1p-40; ///< boxes are not split below this width; at least 2^-40
  bool keepEmpty = false;    ///< whether the boxes proven empty are listed
};

struct RootSearchResult
{
  std::vector<IsolatedRoot> roots;
  /// Boxes that may hold roots that are not listed: multiple roots, roots closer to each other than
  /// the coefficients' errors can separate, and boxes left when the budget was exhausted. Touching
  /// boxes are joined. Systems of fewer equations than variables have solutions that are no points;
  /// for these and for systems of more equations the boxes are the result: all solutions lie in
  /// them.
  std::vector<ParameterBox> undecided;
  std::vector<ParameterBox> empty; ///< on request: proven to hold no root but listed ones
  std::int64_t boxes = 0;          ///< looked at
  bool budgetSpent = false;

  /// Whether `roots` are all roots in the unit cube, proven.
  [[nodiscard]] bool IsComplete() const { return undecided.empty(); }
};

/// Finds all roots of a polynomial system in the unit cube, or the boxes that could not be decided.
/// Loses no root and lists no false one: see Module/Documentation/element-tree.md for the method
/// and its proofs.
RootSearchResult FindRoots(const PolynomialSystem& system, const RootSearch& search = {});
} // namespace pixelexact
